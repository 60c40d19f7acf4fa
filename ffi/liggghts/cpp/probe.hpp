// The probe of a run: what all chains of this rank are counted into; the other half is src/probe.rs.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_PROBE_HPP
#define GRANLAW_PROBE_HPP

#include <unistd.h>
#include <set>
#include "gather.hpp"
#include "host.hpp"
#include "modes.hpp"
#include "boundary.h"

namespace granlaw {

// What all chains of this rank are counted into, and written when the run ends in order.
class Probe {
 public:
  // The one of this process, or nullptr if none is asked for.
  static Probe *of(LAMMPS *lmp) {
    static Probe *const one = mode().probe.empty() && !mode().alarm ? nullptr : new Probe(lmp);
    if (!one) return nullptr;
    if (lmp->universe->nworlds > 1) lmp->error->all(GRANLAW_HERE, "granlaw cannot probe a run in partitions; leave -partition out");
    one->lmp_ = lmp;
    return one;
  }

  // A run that LIGGGHTS ends well without a probe does not end well for who asked for one.
  static void judge_the_end() {
    on_exit([](int status, void *) {
      if (status != 0 || made()) return;
      fprintf(stderr, "granlaw: no probe was written, as no contact could be counted: no pair style or wall of the deck has a law that "
                      "granlaw has a twin of (granlaw laws lists them)\n");
      fflush(nullptr);
      _exit(2);
    }, nullptr);
  }

  size_t chain(const granlaw_recorded_chain &chain) {
    size_t at = 0;
    check(granlaw_probe_chain(probe_, &chain, &at));
    known_.insert(chain.who);
    return at;
  }

  // A step begins.
  void begin(const granlaw_pass &pass) {
    if (mode().steps && pass.step != last_ && ++seen_ > mode().steps + 1) enough();
    last_ = pass.step;
    const bool listed = lmp_->neighbor->ago == 0;
    if (listed && !mode().probe.empty()) look_for_others();
    if (!granlaw_probe_tick(probe_, &pass, listed)) return;
    const LAMMPS_NS::Atom *a = lmp_->atom;
    granlaw_recorded_particles p = {};
    if (a->nlocal > 0 && a->rmass)
      p = {static_cast<size_t>(a->nlocal), a->tag, a->type, a->radius, a->rmass, a->x[0], a->v[0], a->omega[0]};
    check(granlaw_probe_sample(probe_, pass.step, &p));
    granlaw_text text = {};
    while (mode().alarm && granlaw_probe_bonds_alarm(probe_, &text)) warn(std::string(text.bytes, text.length));
  }

  // A contact is about to be evaluated. Whether it is one of those that are followed.
  bool sees(size_t chain, const granlaw_pass &pass, SurfacesCloseData &s) {
    return granlaw_probe_sees(probe_, chain, &pass, mirror(s));
  }

  void touched(size_t chain, const granlaw_pass &pass, bool followed, const double *before, SurfacesIntersectData &s,
               ForceData &i, ForceData &j) {
    if (!followed && !s.is_wall) return;
    const granlaw_recorded_call call = {&pass, mirror(s), true, s.mi, s.mj, before, before, mirror(i), mirror(j)};
    check(granlaw_probe_call(probe_, chain, &call, reinterpret_cast<size_t>(s.fix_mesh), followed));
    granlaw_text text = {};
    if (mode().alarm && granlaw_probe_alarm(probe_, chain, &text)) warn(std::string(text.bytes, text.length));
  }

  void across(size_t chain, const granlaw_recorded_call &call) { check(granlaw_probe_across(probe_, chain, &call)); }

 private:
  explicit Probe(LAMMPS *lmp) : probe_(granlaw_probe_new(mode().follow_all)), lmp_(lmp) {
    made() = true;
    if (mode().probe.empty()) return;
    // At the end of the run it would be too late to say that the file cannot be written.
    const std::string part = mode().probe + ".part";
    FILE *file = lmp->comm->me ? nullptr : fopen(part.c_str(), "w");
    if (!lmp->comm->me && !file) lmp->error->one(GRANLAW_HERE, ("granlaw cannot write the probe " + part).c_str());
    if (file) fclose(file);
    at_the_end(&Probe::finish, this);
  }

  static bool &made() {
    static bool is = false;
    return is;
  }

  static int finish(MPI_Comm, int, void *self, void *) {
    granlaw_text mine = {nullptr, 0};
    Probe *const probe = static_cast<Probe *>(self);
    if (!probe->known_.count("pair")) granlaw_probe_unseen(probe->probe_, "pair");
    granlaw_status status = granlaw_probe_pack(probe->probe_, &mine);
    const Gathered all(mine);
    if (!all.texts().empty() && status == GRANLAW_OK)
      status = granlaw_probe_write(mode().probe.c_str(), all.texts().data(), all.texts().size());
    if (status != GRANLAW_OK) fprintf(stderr, "granlaw: %s\n", granlaw_last_error());
    return MPI_SUCCESS;
  }

  // Walls without any law of ours have chains of LIGGGHTS's own, which nobody sees.
  void look_for_others() {
    for (int k = 0; k < lmp_->modify->nfix; k++) {
      const auto *wall = dynamic_cast<LAMMPS_NS::FixWallGran *>(lmp_->modify->fix[k]);
      const std::string who = wall ? std::string("wall ") + wall->id : "";
      if (!wall || !known_.insert(who).second) continue;
      granlaw_probe_unseen(probe_, who.c_str());
      warn("the contacts of fix " + std::string(wall->id) + " are not in the probe, as granlaw has a twin of none of its laws");
    }
  }

  // LIGGGHTS prints warnings on the first rank only.
  void warn(const std::string &text) {
    if (lmp_->screen || lmp_->logfile) lmp_->error->warning(GRANLAW_HERE, text.c_str());
    else fprintf(stderr, "WARNING: granlaw: %s\n", text.c_str());
  }

  // Enough steps were seen: ends the run in order, on all ranks alike.
  static void enough() {
    fflush(nullptr);
    MPI_Finalize();
    _exit(0);
  }

  void check(granlaw_status status) {
    if (status != GRANLAW_OK) stop(lmp_, granlaw_last_error());
  }

  granlaw_probe *probe_;
  LAMMPS *lmp_;
  std::set<std::string> known_;  // pair style and walls, seen or told to be unseen
  int64_t last_ = INT64_MIN;
  uint64_t seen_ = 0;  // steps, the set-up among them
};

}  // namespace granlaw
#endif
