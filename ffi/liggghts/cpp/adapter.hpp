// A Rust law inside LIGGGHTS: settings, properties and history by its descriptor, contacts by granlaw.h.
// One class for all four kinds of law; it knows none by name. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_ADAPTER_HPP
#define GRANLAW_ADAPTER_HPP

#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <vector>
#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "force.h"
#include "global_properties.h"
#include "lammps.h"
#include "modify.h"
#include "pair_gran.h"
#include "property_registry.h"
#include "settings.h"
#include "update.h"
#include "creators.hpp"
#include "mirror.hpp"
#include "roll.hpp"
#include "wall.hpp"
#include "words.hpp"

// LIGGGHTS's macro would print a path of the machine that built us.
#define GRANLAW_HERE "granlaw", __LINE__

namespace granlaw {
using namespace LIGGGHTS;
using LAMMPS_NS::FixPropertyAtom;
using LAMMPS_NS::FixPropertyGlobal;
using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::LAMMPS;
using LAMMPS_NS::PairGran;

// Masses as LIGGGHTS's pair loop takes them: of a rigid body, its own.
inline double mass(LAMMPS *lmp, PairGran *pair, int i) {
  const LAMMPS_NS::Atom *atom = lmp->atom;
  if (pair && pair->fr_pair() && pair->mr_pair()[i] > 0.0) return pair->mr_pair()[i];
  return atom->rmass ? atom->rmass[i] : atom->mass[atom->type[i]];
}

// What a deck keeps for single atoms, for the laws of a chain to read or to add to.
class Given {
 public:
  explicit Given(LAMMPS *lmp) : lmp_(lmp), fixes_(), outputs_() {}

  void look_for(const granlaw_law &d) {
    for (size_t k = 0; k < d.n_atoms; k++) fixes_[d.atoms[k].place] = find(d, d.atoms[k].name);
    for (size_t k = 0; k < d.n_outputs; k++) outputs_[d.outputs[k].place] = find(d, d.outputs[k].name);
  }
  bool has(size_t place) const { return fixes_[place] != nullptr; }
  // Ghosts are new after each build of neighbour lists.
  void refresh() {
    for (FixPropertyAtom *fix : fixes_)
      if (fix && lmp_->neighbor->ago == 0) fix->do_forward_comm();
  }
  void fill(granlaw_pass &pass) const {
    for (size_t k = 0; k < GRANLAW_ATOM_PROPS; k++) pass.given[k] = fixes_[k] ? fixes_[k]->vector_atom : nullptr;
    for (size_t k = 0; k < GRANLAW_ATOM_OUTPUTS; k++) pass.outputs[k] = outputs_[k] ? outputs_[k]->vector_atom : nullptr;
  }

 private:
  FixPropertyAtom *find(const granlaw_law &d, const char *name) const {
    return static_cast<FixPropertyAtom *>(
        lmp_->modify->find_fix_property(name, "property/atom", "scalar", 0, 0, d.own_keyword, false));
  }

  LAMMPS *lmp_;
  FixPropertyAtom *fixes_[GRANLAW_ATOM_PROPS];
  FixPropertyAtom *outputs_[GRANLAW_ATOM_OUTPUTS];
};

// What holds for the contacts of a step; `pair` is NULL for a wall.
inline granlaw_pass pass_of(LAMMPS *lmp, PairGran *pair, const Given &given) {
  const LAMMPS_NS::Atom *atom = lmp->atom;
  granlaw_pass pass = {lmp->update->dt, static_cast<int64_t>(lmp->update->ntimestep), atom->x ? atom->x[0] : nullptr,
                       atom->tag, atom->mask, pair ? pair->freeze_group_bit() : 0, atom->nlocal, {}, {}};
  given.fill(pass);
  return pass;
}

// Stops the run from within the contact loop, where ranks are on their own. LIGGGHTS would lose the message: it prints on
// the first rank only, and MPI_Abort drops what standard output still holds.
inline void stop(LAMMPS *lmp, const char *text) {
  if (lmp->logfile) fprintf(lmp->logfile, "ERROR: %s\n", text), fflush(lmp->logfile);
  if (lmp->screen) setvbuf(lmp->screen, nullptr, _IOLBF, 0);
  else fprintf(stderr, "ERROR on proc %d: %s\n", lmp->comm->me, text);
  lmp->error->one(GRANLAW_HERE, text);
}

// One law with what the deck says of it.
class Law {
 public:
  Law(LAMMPS *lmp, IContactHistorySetup *history, size_t index, bool taken_over)
      : lmp_(lmp), index_(index), taken_over_(taken_over), d_(*granlaw_law_at(index)),
        on_(new bool[d_.n_settings + 1]()), options_(d_.n_settings, -1), values_(d_.n_props), places_(d_.n_slots, -1),
        history_(history) {
    // A stock law's history lies where LIGGGHTS has it, for the sake of restart files: what hangs on settings comes behind
    // what all laws always keep. A law of our own keeps its slots together.
    if (d_.stock_id >= 0) add_slots(true);
  }

  const granlaw_law &descriptor() const { return d_; }
  bool taken_over() const { return taken_over_; }
  // Where its history begins.
  int offset() const {
    for (int32_t place : places_)
      if (place >= 0) return place;
    return 0;
  }
  const char *name() const { return taken_over_ ? d_.keyword : d_.own_keyword; }
  const std::vector<int32_t> &options() const { return options_; }
  const std::vector<std::vector<double> > &values() const { return values_; }

  void registerSettings(Settings &settings) {
    for (size_t k = 0; k < d_.n_settings; k++) {
      const granlaw_setting &s = d_.settings[k];
      if (!offered(k)) continue;
      if (is_switch(k)) settings.registerOnOff(s.name, on_[k], s.default_option == 1);
      else Words::add(settings, name(), s, options_[k]);
    }
  }

  void postSettings() {
    settle();
    add_slots(false);
  }

  void settle() {
    for (size_t k = 0; k < d_.n_settings; k++) {
      if (!offered(k) || !is_switch(k)) continue;
      options_[k] = on_[k] ? 1 : 0;
      if (on_[k] && taken_over_ && d_.settings[k].support == GRANLAW_SUPPORT_STOCK_IGNORES && lmp_->comm->me == 0) {
        const std::string text = std::string(d_.keyword) + ": LIGGGHTS reads the setting " + d_.settings[k].name +
                                 " and ignores it, so it has no effect here either; use " + d_.own_keyword + " for it";
        lmp_->error->warning(GRANLAW_HERE, text.c_str());
      }
    }
  }

  // Refuses what is switched on and not done here. LIGGGHTS calls postSettings even when it did not understand the
  // settings, so what the deck has yet to choose is left to granlaw_prepare.
  void refuseSettings() {
    for (size_t k = 0; k < d_.n_settings; k++)
      if (d_.settings[k].support == GRANLAW_SUPPORT_REFUSED && options_[k] > 0 &&
          granlaw_check_settings(index_, taken_over_, options_.data()) != GRANLAW_OK)
        lmp_->error->all(GRANLAW_HERE, granlaw_last_error());
  }

  void connectToProperties(PropertyRegistry &registry) {
    if (!d_.coarse_graining && lmp_->force->cg_active())
      lmp_->error->cg(GRANLAW_HERE, (std::string("model ") + name()).c_str());
    for (size_t k = 0; k < d_.n_props; k++) {
      values_[k].clear();
      if (granlaw_needs_property(index_, taken_over_, options_.data(), k)) read(registry, d_.props[k], values_[k]);
    }
    pointers_.clear();
    for (const std::vector<double> &v : values_) pointers_.push_back(v.empty() ? nullptr : v.data());
  }

  granlaw_choice choice() const {
    return granlaw_choice{index_, taken_over_, options_.data(), pointers_.data(), 0, places_.data()};
  }

 private:
  void add_slots(bool before_settings) {
    for (size_t k = 0; k < d_.n_slots; k++) {
      if (places_[k] >= 0 || (before_settings && !d_.slots[k].always)) continue;
      if (!granlaw_needs_slot(index_, taken_over_, options_.data(), k)) continue;
      places_[k] = history_->add_history_value(d_.slots[k].name, d_.slots[k].newton);
    }
  }
  bool is_switch(size_t k) const {
    const granlaw_setting &s = d_.settings[k];
    return s.n_options == 2 && !strcmp(s.options[0], "off") && !strcmp(s.options[1], "on");
  }
  bool offered(size_t k) const { return !taken_over_ || d_.settings[k].support != GRANLAW_SUPPORT_OWN_ONLY; }

  // A property that LIGGGHTS knows is read by LIGGGHTS's own creator, so that its checks and messages hold.
  static const Creator *known(const char *name) {
    for (const Creator &c : creators())
      if (!strcmp(c.name, name)) return &c;
    return nullptr;
  }

  // Whether the deck gives a property of our own; one that it does not give stays empty, for the law to say so.
  bool given(const granlaw_prop &p, int n, const char *caller) const {
    static const char *shapes[] = {"scalar", "peratomtype", "peratomtypepair"};
    const int rows = p.shape == GRANLAW_SCALAR ? 0 : n, columns = p.shape == GRANLAW_PER_PAIR ? n : 0;
    return lmp_->modify->find_fix_property(p.name, "property/global", shapes[p.shape], rows, columns, caller, false);
  }

  void read(PropertyRegistry &registry, const granlaw_prop &p, std::vector<double> &out) const {
    const int n = registry.max_type();
    const std::string caller = std::string("model ") + name();
    const std::string key = std::string("granlaw:") + p.name;
    const Creator *k = known(p.name);
    if (!k && !given(p, n, caller.c_str())) return;
    if (p.shape == GRANLAW_SCALAR) {
      if (k) registry.registerProperty(key, k->scalar);
      out.push_back(k ? registry.getScalarProperty(key, caller.c_str())->data
                      : registry.getGlobalProperty(p.name, "property/global", "scalar", 0, 0, caller.c_str())->compute_scalar());
    } else if (p.shape == GRANLAW_PER_TYPE) {
      if (k) registry.registerProperty(key, k->vector);
      const double *v = k ? registry.getVectorProperty(key, caller.c_str())->data : nullptr;
      FixPropertyGlobal *own = k ? nullptr : registry.getGlobalProperty(p.name, "property/global", "peratomtype", n, 0, caller.c_str());
      for (int i = 1; i <= n; i++) out.push_back(k ? v[i] : own->compute_vector(i - 1));
    } else {
      if (k) registry.registerProperty(key, k->matrix);
      double **m = k ? registry.getMatrixProperty(key, caller.c_str())->data : nullptr;
      FixPropertyGlobal *own = k ? nullptr : registry.getGlobalProperty(p.name, "property/global", "peratomtypepair", n, n, caller.c_str());
      for (int i = 1; i <= n; i++)
        for (int j = 1; j <= n; j++) out.push_back(k ? m[i][j] : own->compute_array(i - 1, j - 1));
    }
  }

  LAMMPS *lmp_;
  size_t index_;
  bool taken_over_;
  const granlaw_law &d_;
  std::unique_ptr<bool[]> on_;
  std::vector<int32_t> options_;
  std::vector<std::vector<double> > values_;
  std::vector<const double *> pointers_;
  std::vector<int32_t> places_;  // of the slots in a row of history, -1 where there is none
  IContactHistorySetup *history_;
};

// Rust laws that follow each other in a chain, run by one call.
class Segment {
 public:
  // `parent` is the PairGran or FixWallGran that the contacts come from.
  Segment(LAMMPS *lmp, IContactHistorySetup *parent)
      : lmp_(lmp), pair_(dynamic_cast<PairGran *>(parent)), wall_(dynamic_cast<FixWallGran *>(parent)), given_(lmp),
        chain_(nullptr), before_() {
    all().insert(this);
  }
  Segment(const Segment &) = delete;
  ~Segment() {
    all().erase(this);
    granlaw_free(chain_);
  }

  // Every segment there is, for those who count.
  static std::set<Segment *> &all() {
    static std::set<Segment *> segments;
    return segments;
  }
  bool of(LAMMPS *lmp) const { return lmp == lmp_; }
  bool is_wall() const { return wall_ != nullptr; }
  bool has(const granlaw_law *d) const {
    for (const auto &law : laws_)
      if (&law->descriptor() == d) return true;
    return false;
  }

  Law &add(IContactHistorySetup *history, size_t index, bool taken_over) {
    laws_.emplace_back(new Law(lmp_, history, index, taken_over));
    return *laws_.back();
  }

  void connectToProperties(PropertyRegistry &registry) {
    choices_.clear();
    for (const auto &law : laws_) {
      law->connectToProperties(registry);
      choices_.push_back(law->choice());
    }
    before_ = bonds();
    granlaw_free(chain_);
    types_ = static_cast<size_t>(registry.max_type());
    const granlaw_setup all = setup();
    all_check(granlaw_prepare(&all, &chain_));
    for (size_t k = 0; lmp_->comm->me == 0 && granlaw_remark(chain_, k); k++)
      if (said_.insert(granlaw_remark(chain_, k)).second) lmp_->error->warning(GRANLAW_HERE, granlaw_remark(chain_, k));
    reach(registry);
  }

  // Begun and ended since the segment was made; those that are there, if any were counted in this step.
  granlaw_bonds bonds() const {
    granlaw_bonds now = {0, 0, 0, 0};
    if (chain_) granlaw_count_bonds(chain_, &now);
    now.begun += before_.begun;
    now.ended += before_.ended;
    return now;
  }
  // Good until the properties are read again.
  granlaw_setup setup() const { return granlaw_setup{choices_.data(), choices_.size(), types_, lmp_->force->nktv2p}; }

  void beginPass() {
    if (bonding() && lmp_->update->ntimestep == lmp_->update->firststep && roll_.renumbered(lmp_->atom))
      stop(lmp_, "pair_style gran: particles have new numbers since the last run, and LIGGGHTS hands bonds on by number; "
                 "use delete_atoms ... compress no");
    given_.refresh();
    begin();
  }
  void endPass() {
    check(granlaw_end_pass(chain_));
    if (bonding() && lmp_->update->ntimestep == lmp_->update->laststep) roll_.take(lmp_->atom);
  }

  void surfacesIntersect(SurfacesIntersectData &s, ForceData &i_forces, ForceData &j_forces) {
    if (s.is_wall) begin();  // walls never announce a pass
    check(granlaw_surfaces_intersect(chain_, mirror(s), mirror(i_forces), mirror(j_forces)));
  }

  void surfacesClose(SurfacesCloseData &s, ForceData &i_forces, ForceData &j_forces) {
    if (s.is_wall) begin();
    LAMMPS_NS::Atom *atom = lmp_->atom;
    s.omega_i = atom->omega[s.i];  // stale or unset in LIGGGHTS
    if (!s.is_wall) s.omega_j = atom->omega[s.j];
    const double mi = mass(lmp_, pair_, s.i), mj = s.is_wall ? 0.0 : mass(lmp_, pair_, s.j);
    check(granlaw_surfaces_close(chain_, mirror(s), mi, mj, mirror(i_forces), mirror(j_forces)));
  }

  const std::vector<std::unique_ptr<Law> > &laws() const { return laws_; }
  const Given &given() const { return given_; }

 private:
  bool bonding() const {
    for (const auto &law : laws_)
      if (law->descriptor().bonds) return true;
    return false;
  }
  void begin() {
    const granlaw_pass pass = pass_of(lmp_, pair_, given_);
    check(granlaw_begin_pass(chain_, &pass));
  }

  // Let LIGGGHTS look for contacts as far as the laws act, and let the laws look at the wall.
  void reach(PropertyRegistry &registry) {
    bool beyond = false;
    for (const auto &law : laws_) {
      given_.look_for(law->descriptor());
      beyond = beyond || law->descriptor().beyond_contact;
    }
    if (!beyond) return;
    const double rmin = registry.min_radius();
    double factor = 1.0;
    all_check(granlaw_contact_distance_factor(chain_, rmin, &factor));
    lmp_->neighbor->register_contact_dist_factor(factor);
    if (!wall_) return;
    const granlaw_wall wall = look_at(wall_, lmp_->neighbor);
    all_check(granlaw_check_wall(chain_, &wall, rmin));
  }

  void all_check(granlaw_status status) {
    if (status == GRANLAW_OK) return;
    const std::string who = wall_ ? std::string("fix ") + wall_->id + " wall/gran: " : "pair_style gran: ";
    lmp_->error->all(GRANLAW_HERE, (who + granlaw_last_error()).c_str());
  }
  void check(granlaw_status status) {
    if (status != GRANLAW_OK) stop(lmp_, granlaw_last_error());
  }

  LAMMPS *lmp_;
  PairGran *pair_;
  FixWallGran *wall_;
  Given given_;
  granlaw_chain *chain_;
  size_t types_ = 0;
  std::vector<granlaw_choice> choices_;
  granlaw_bonds before_;        // of the chains of runs that are over
  std::set<std::string> said_;  // remarks, each once
  Roll roll_;
  std::vector<std::unique_ptr<Law> > laws_;
};

}  // namespace granlaw
#endif
