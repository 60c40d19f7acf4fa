// Registers granlaw's laws with LIGGGHTS when the library is preloaded. SPDX-License-Identifier: GPL-2.0-or-later
#include <errno.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include "batch.hpp"

namespace granlaw {
namespace {

// The pair style or wall of LIGGGHTS over our chain.
template <class Style, class Parent>
class Over : public Style {
 public:
  Over(LAMMPS *lmp, Parent *parent, int64_t hash) : Style(lmp, parent, hash), error_(lmp->error) {}
  void settings(int n, char **args, IContactHistorySetup *history) {
    // LIGGGHTS would read beyond the end of the command.
    if (n % 2) error_->all(GRANLAW_HERE, (std::string("Setting ") + args[n - 1] + " has no value").c_str());
    Style::settings(n, args, history);
  }

 private:
  LAMMPS_NS::Error *error_;
};
using Wall = Over<Walls::Granular<Chain>, FixWallGran>;

// Takes all contacts of a step at once where it can.
class PairStyle : public Over<PairStyles::Granular<Chain>, PairGran> {
 public:
  PairStyle(LAMMPS *lmp, PairGran *parent, int64_t hash) : Over(lmp, parent, hash), batch_(lmp, Chain::latest()) {}
  void init_granular() {
    Granular::init_granular();
    batch_.init();
  }
  void compute_force(PairGran *pair, int eflag, int vflag, int addflag) {
    if (!batch_.run(pair, eflag || vflag, addflag)) Granular::compute_force(pair, eflag, vflag, addflag);
  }

 private:
  Batch batch_;
};

PairStyles::IGranularPairStyle *make_pair(LAMMPS *lmp, PairGran *parent, const int64_t hash) {
  return new PairStyle(lmp, parent, hash);
}
Walls::IGranularWall *make_wall(LAMMPS *lmp, FixWallGran *parent, const int64_t hash) {
  return new Wall(lmp, parent, hash);
}

// All numbers of a kind: switched off, stock, taken over, our own.
std::vector<int> numbers(int32_t kind) {
  std::vector<int> all(1, off(kind));
  for (const Stock &s : stock_laws())
    if (s.kind == kind) all.push_back(s.id);
  for (size_t k = 0; k < granlaw_law_count(); k++) {
    const granlaw_law &d = *granlaw_law_at(k);
    if (d.kind != kind) continue;
    all.push_back(d.id);
    if (d.stock_id >= 0 && mode().laws != Laws::own) all.push_back(d.stock_id + TAKEN);
  }
  return all;
}
bool ours(int id) { return id >= TAKEN; }

void add_name(int32_t kind, const char *name, int id) {
  ContactModels::Factory &f = ContactModels::Factory::instance();
  switch (kind) {
    case GRANLAW_NORMAL: return f.addNormalModel(name, id);
    case GRANLAW_COHESION: return f.addCohesionModel(name, id);
    case GRANLAW_TANGENTIAL: return f.addTangentialModel(name, id);
    default: return f.addRollingModel(name, id);
  }
}

void register_names() {
  for (size_t k = 0; k < granlaw_law_count(); k++) {
    const granlaw_law &d = *granlaw_law_at(k);
    add_name(d.kind, d.own_keyword, d.id);
    if (d.stock_id < 0) add_name(d.kind, d.keyword, d.id);  // LIGGGHTS has none of that name
    else if (mode().laws != Laws::own) add_name(d.kind, d.keyword, d.stock_id + TAKEN);
  }
}

// LIGGGHTS looks a chain up by its exact hash code, so every chain with one of our laws in it needs an entry.
void register_chains() {
  const std::vector<int> surfaces = {SURFACE_DEFAULT, SURFACE_MULTICONTACT};
  const auto N = numbers(GRANLAW_NORMAL), C = numbers(GRANLAW_COHESION), T = numbers(GRANLAW_TANGENTIAL), R = numbers(GRANLAW_ROLLING);
  for (int n : N) for (int c : C) for (int t : T) for (int r : R) {
    if (!ours(n) && !ours(c) && !ours(t) && !ours(r)) continue;
    for (int s : surfaces) {
      const int hash = static_cast<int>(Utils::generate_gran_hashcode(n, t, c, r, s));
      PairStyles::Factory::instance().addStyle("gran", hash, &make_pair);
      Walls::Factory::instance().addStyle("gran", hash, &make_wall);
    }
  }
}

// Whether the file that LIGGGHTS's code was loaded from holds a text.
bool host_says(const char *text) {
  Dl_info info;
  if (!dladdr(reinterpret_cast<void *>(&MODEL_PARAMS::createYoungsModulus), &info)) return false;
  const int fd = open(info.dli_fname, O_RDONLY);
  struct stat st;
  if (fd < 0 || fstat(fd, &st)) return false;
  void *map = mmap(nullptr, st.st_size, PROT_READ, MAP_PRIVATE, fd, 0);
  close(fd);
  if (map == MAP_FAILED) return false;
  const bool found = memmem(map, st.st_size, text, strlen(text)) != nullptr;
  munmap(map, st.st_size);
  return found;
}

// Builds for other particle shapes lay LIGGGHTS's structs out otherwise.
bool host_has(const char *symbol) { return dlsym(RTLD_DEFAULT, symbol) != nullptr; }

std::string host_trouble() {
  if (!mode().trouble.empty()) return mode().trouble;
  if (granlaw_abi_version() != GRANLAW_ABI_VERSION) return "the plugin and its laws have different ABI versions; rebuild both";
  if (!host_says("LIGGGHTS-PUBLIC 3.8.0"))
    return "this plugin is made for LIGGGHTS-PUBLIC 3.8.0 (Debian package liggghts); build it against your LIGGGHTS's headers";
  for (const char *symbol : {"_ZN9LAMMPS_NS19AtomVecSuperquadricC1EPNS_6LAMMPSE", "_ZN9LAMMPS_NS17AtomVecConvexHullC1EPNS_6LAMMPSE"})
    if (host_has(symbol)) return "this LIGGGHTS is built for non-spherical particles, whose structs are laid out otherwise";
  return "";
}

// LD_PRELOAD must not reach the programs that LIGGGHTS starts, but it must get through those that start LIGGGHTS (env,
// timeout, perf): else the stock laws would run without a word.
bool in_liggghts() {
  const std::string program = program_invocation_short_name;
  return program.find("liggghts") != std::string::npos || program.find("lmp") == 0;
}
void forget_preload() {
  const char *list = getenv("LD_PRELOAD");
  if (!list || !in_liggghts()) return;
  std::string rest, item;
  for (const char *p = list;; p++) {
    if (*p && *p != ':' && *p != ' ') {
      item += *p;
      continue;
    }
    if (!item.empty() && item.find("libgranlaw_liggghts") == std::string::npos) rest += (rest.empty() ? "" : ":") + item;
    item.clear();
    if (!*p) break;
  }
  if (rest.empty()) unsetenv("LD_PRELOAD");
  else setenv("LD_PRELOAD", rest.c_str(), 1);
}

struct Start {
  Start() {
    forget_preload();
    const std::string trouble = host_trouble();
    if (!trouble.empty()) {
      // Running on with other laws than asked for would be worse than stopping.
      fprintf(stderr, "granlaw: %s\n", trouble.c_str());
      _exit(2);
    }
    register_names();
    register_chains();
    if (mode().shadow && in_liggghts()) Shadow::judge_the_end();
    if (!mode().probe.empty() && in_liggghts()) Probe::judge_the_end();
  }
} start;

}  // namespace
}  // namespace granlaw
