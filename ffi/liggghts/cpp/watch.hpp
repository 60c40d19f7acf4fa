// Sees every call of a chain: writes it down, counts it, or holds it against the Rust laws, when that is asked for.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_WATCH_HPP
#define GRANLAW_WATCH_HPP

#include <set>
#include "modes.hpp"
#include "probe.hpp"
#include "boundary.h"
#include "shadow.hpp"

namespace granlaw {

// Hands out slot numbers without asking LIGGGHTS for room: for a law that only reads its settings and properties.
struct NoSlots : IContactHistorySetup {
  int next;
  explicit NoSlots(int first) : next(first) {}
  int add_history_value(std::string, std::string) { return next++; }
};

class Watch {
 public:
  Watch(LAMMPS *lmp, IContactHistorySetup *parent, bool is_wall)
      : lmp_(lmp), given_(lmp), pair_(is_wall ? nullptr : dynamic_cast<PairGran *>(parent)), recording_(!mode().record.empty()),
        probe_(Probe::of(lmp)), shadow_(Shadow::of(lmp)), on_(recording_ || probe_ || shadow_), who_("pair"),
        recorder_(nullptr), begun_(false), n_(0) {
    if (FixWallGran *wall = is_wall ? dynamic_cast<FixWallGran *>(parent) : nullptr) who_ = std::string("wall ") + wall->id;
  }
  Watch(const Watch &) = delete;
  ~Watch() {
    if (recorder_) granlaw_record_close(recorder_);
  }

  bool on() const { return on_; }
  void rust(int32_t kind, int index, const Law *law) { laws_.push_back({kind, index, law, "", 0}); }
  void stock(int32_t kind, int index, const char *name, size_t at) {
    const Law *law = nullptr;
    if (on_ && index >= 0) {
      NoSlots slots(static_cast<int>(at));
      readers_.emplace_back(new Law(lmp_, &slots, index, true));
      law = readers_.back().get();
    }
    laws_.push_back({kind, index, law, name, at});
  }

  void registerSettings(Settings &s) {
    for (auto &law : readers_) law->registerSettings(s);
  }
  void postSettings() {
    for (auto &law : readers_) law->postSettings();
  }
  void connectToProperties(PropertyRegistry &registry, const std::vector<std::string> &slots) {
    if (!on_) return;
    for (auto &law : readers_) law->connectToProperties(registry);
    for (const Seen &seen : laws_)
      if (seen.law) given_.look_for(seen.law->descriptor());
    n_ = slots.size();
    before_.assign(n_ + 1, 0.0);
    open(registry.max_type(), slots);
  }

  // The first pass of a pair chain sees the particles before anything has moved.
  void begin() {
    if (!on_) return;
    look();
    if (probe_) probe_->begin(pass_);
    if (recording_) start(true);
  }
  void before(SurfacesIntersectData &s) {
    if (!on_) return;
    if (s.is_wall) look();
    followed_ = probe_ && mine(s) && probe_->sees(probed_, pass_, s);
    if (recording_ || shadow_ || followed_) keep(s);
  }
  void before(SurfacesCloseData &s) {
    if (on_) keep(s);
  }
  void touched(SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    if (shadow_) shadow_->call(shadowed_, call(s, true, i, j));
    if (!on_ || !mine(s)) return;
    if (probe_) probe_->touched(probed_, pass_, followed_, before_.data(), s, i, j);
    if (recording_) write(s, true, i, j);
  }
  void parted(SurfacesCloseData &s, ForceData &i, ForceData &j) {
    if (!on_) return;
    if (s.is_wall) look();
    s.omega_i = lmp_->atom->omega[s.i];
    if (!s.is_wall) s.omega_j = lmp_->atom->omega[s.j];
    // LIGGGHTS hands the larger struct through a reference to its base.
    SurfacesIntersectData &whole = static_cast<SurfacesIntersectData &>(s);
    if (shadow_) shadow_->call(shadowed_, call(whole, false, i, j));
    if (!mine(s)) return;
    if (probe_) probe_->across(probed_, call(whole, false, i, j));
    if (recording_) write(whole, false, i, j);
  }

 private:
  struct Seen {
    int32_t kind;
    int index;
    const Law *law;
    std::string name;
    size_t at;
  };

  void keep(const SurfacesCloseData &s) {
    if (n_ && s.contact_history) std::copy(s.contact_history, s.contact_history + n_, before_.begin());
  }

  void look() { pass_ = pass_of(lmp_, pair_, given_); }

  // A contact that two ranks see is written by the one that owns the lower tag.
  bool mine(const SurfacesCloseData &s) const {
    const LAMMPS_NS::Atom *atom = lmp_->atom;
    return s.is_wall || s.j < atom->nlocal || atom->tag[s.i] < atom->tag[s.j];
  }

  granlaw_recorded_call call(SurfacesIntersectData &s, bool touch, ForceData &i, ForceData &j) const {
    const double *after = n_ && s.contact_history ? s.contact_history : before_.data();
    const double mi = mass(lmp_, pair_, s.i), mj = s.is_wall ? 0.0 : mass(lmp_, pair_, s.j);
    return {&pass_, mirror(s), touch, mi, mj, before_.data(), after, mirror(i), mirror(j)};
  }

  void write(SurfacesIntersectData &s, bool touch, ForceData &i, ForceData &j) {
    if (pass_.step % static_cast<int64_t>(mode().every)) return;
    start(false);
    const granlaw_recorded_call written = call(s, touch, i, j);
    check(granlaw_record_call(recorder_, &written));
  }

  void start(bool with_particles) {
    if (begun_) return;
    begun_ = true;
    const LAMMPS_NS::Atom *a = lmp_->atom;
    const bool few = with_particles && lmp_->comm->nprocs == 1 && a->nlocal > 0 && a->nlocal <= 16 && a->rmass;
    granlaw_recorded_particles p = {};
    if (few) p = {static_cast<size_t>(a->nlocal), a->tag, a->type, a->radius, a->rmass, a->x[0], a->v[0], a->omega[0]};
    check(granlaw_record_begin(recorder_, &p));
  }

  void open(int types, const std::vector<std::string> &slots) {
    std::vector<granlaw_recorded_law> laws;
    std::vector<std::vector<const double *> > values(laws_.size());
    for (size_t k = 0; k < laws_.size(); k++) {
      const Seen &l = laws_[k];
      granlaw_recorded_law r = {l.kind, l.index, l.name.c_str(), true, l.at, nullptr, nullptr};
      if (l.law) {
        for (const auto &v : l.law->values()) values[k].push_back(v.empty() ? nullptr : v.data());
        r = {l.kind, l.index, l.law->descriptor().keyword, l.law->taken_over(), static_cast<size_t>(l.law->offset()),
             l.law->options().data(), values[k].data()};
      }
      laws.push_back(r);
    }
    std::vector<const char *> names;
    for (const std::string &s : slots) names.push_back(s.c_str());
    const std::string path = recorder_ || !recording_ ? "" : path_of();
    granlaw_recorded_chain chain = {
        path.c_str(), lmp_->universe->version, mode().deck.c_str(), lmp_->update->unit_style, who_.c_str(),
        lmp_->comm->me, lmp_->comm->nprocs, mode().every, static_cast<size_t>(types), lmp_->force->nktv2p,
        lmp_->update->dt, laws.data(), laws.size(), names.data(), names.size(), {}};
    for (size_t k = 0; k < GRANLAW_ATOM_PROPS; k++) chain.given[k] = given_.has(k);
    if (probe_) probed_ = probe_->chain(chain);
    if (shadow_) shadowed_ = shadow_->chain(chain);
    if (recording_) check(recorder_ ? granlaw_record_again(recorder_, &chain) : granlaw_record_open(&chain, &recorder_));
  }

  // trace.csv for the pair style, trace.wall-ID.csv for a wall fix, .rankN on ranks, .2 for a second of the same name.
  std::string path_of() const {
    static std::set<std::string> used;
    const std::string &base = mode().record;
    const size_t slash = base.find_last_of('/'), dot = base.find_last_of('.');
    const bool has_dot = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    const std::string stem = has_dot ? base.substr(0, dot) : base, ext = has_dot ? base.substr(dot) : "";
    std::string insert = who_ == "pair" ? "" : ".wall-" + who_.substr(5);
    if (lmp_->comm->nprocs > 1) insert += ".rank" + std::to_string(lmp_->comm->me);
    std::string path = stem + insert + ext;
    for (int k = 2; !used.insert(path).second; k++) path = stem + insert + "." + std::to_string(k) + ext;
    return path;
  }

  void check(granlaw_status status) {
    if (status != GRANLAW_OK) stop(lmp_, granlaw_last_error());
  }

  LAMMPS *lmp_;
  Given given_;
  PairGran *pair_;
  bool recording_;
  Probe *probe_;
  size_t probed_ = 0;  // this chain among those of the probe
  Shadow *shadow_;
  size_t shadowed_ = 0;  // and among those of the shadow
  bool followed_ = false;  // whether the probe wants the contact at hand
  bool on_;
  std::string who_;
  granlaw_recorder *recorder_;
  bool begun_;
  size_t n_;
  granlaw_pass pass_ = {};
  std::vector<double> before_;
  std::vector<Seen> laws_;
  std::vector<std::unique_ptr<Law> > readers_;
};

}  // namespace granlaw
#endif
