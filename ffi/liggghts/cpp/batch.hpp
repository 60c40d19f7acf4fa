// All pair contacts of a step in one call: decides whether a step can be run so, and hands LIGGGHTS's arrays over.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_BATCH_HPP
#define GRANLAW_BATCH_HPP

#include <set>
#include "boundary.h"
#include "chain.hpp"

namespace granlaw {

class Batch {
 public:
  Batch(LAMMPS *lmp, Chain *chain) : lmp_(lmp), chain_(chain), batch_(nullptr), list_(nullptr), built_(-1), last_(nullptr) {}
  Batch(const Batch &) = delete;
  ~Batch() { drop(); }

  // Once per run, after the chain got its properties.
  void init() {
    drop();
    list_ = nullptr;
    if (mode().path == Path::contact || !chain_->rust()) return;
    const granlaw_setup setup = chain_->rust()->setup();
    if (granlaw_batch_new(&setup, mode().lanes.c_str(), &batch_) != GRANLAW_OK) lmp_->error->all(GRANLAW_HERE, granlaw_last_error());
  }

  // One pass over all contacts; false where this step must go contact by contact.
  bool run(PairGran *pair, bool tally, bool local) {
    // In the shadow of LIGGGHTS's laws, the path is that of the Rust laws beside them.
    if (mode().path == Path::contact || mode().shadow) return false;
    if (const char *why = obstacle(pair, tally, local)) {
      if (mode().path == Path::batched)
        lmp_->error->all(GRANLAW_HERE, (std::string("the batched path was asked for and cannot be taken: ") + why).c_str());
      if (why != last_)
        say(std::string("contact by contact at step ") + std::to_string(lmp_->update->ntimestep) + ", as " + why + " (said once)", why);
      last_ = why;
      return false;
    }
    static const char *const batched = "batched";
    if (last_ != batched) say(std::string("batched path, ") + granlaw_batch_name(batch_), batched);
    last_ = batched;
    pass(pair);
    return true;
  }

 private:
  // What the batched path does not do, in words; NULL if nothing is in its way.
  const char *obstacle(PairGran *pair, bool tally, bool local) const {
    if (chain_->watched()) return "every call is recorded, counted or compared";
    if (!chain_->rust()) return "a law of the chain is LIGGGHTS's own";
    if (!batch_) return "a law of the chain takes one contact at a time";
    if (lmp_->neighbor->contactDistanceFactor > 1.0) return "contacts reach beyond the surfaces (contact_distance_factor)";
    if (local || !pair->computeflag()) return "a compute looks at each contact (pair/gran/local)";
    if (tally) return "the virial or an energy is wanted in this step";
    if (pair->storeContactForces()) return "contact forces are stored";
    if (pair->storeContactForcesStress()) return "contact forces are stored for a stress";
    if (pair->storeSumDelta()) return "a multicontact model changes the radii";
    if (pair->store_sum_normal_force()) return "normal forces are summed";
    return nullptr;
  }

  void pass(PairGran *pair) {
    LAMMPS_NS::Atom *atom = lmp_->atom;
    LAMMPS_NS::NeighList *list = pair->list, *history = pair->listgranhistory;
    pair->evflag = pair->vflag_fdotr = 0;
    if (!list->inum) return;
    const size_t all = static_cast<size_t>(atom->nlocal + atom->nghost);
    granlaw_arrays a = {};
    a.x = atom->x[0], a.v = atom->v[0], a.omega = atom->omega[0];
    a.f = atom->f[0], a.torque = atom->torque[0];
    a.radius = atom->radius, a.mass = atom->rmass, a.rigid = pair->fr_pair() ? pair->mr_pair() : nullptr;
    a.type = atom->type, a.mask = atom->mask, a.tag = atom->tag;
    a.ilist = list->ilist, a.numneigh = list->numneigh, a.neighbours = list->firstneigh;
    a.flags = history ? history->firstneigh : nullptr, a.history = history ? history->firstdouble : nullptr;
    a.rows = static_cast<size_t>(list->inum), a.all = all;
    a.forced = lmp_->force->newton_pair ? all : static_cast<size_t>(atom->nlocal);
    a.row = static_cast<size_t>(pair->dnum());
    a.skin = lmp_->neighbor->skin, a.dt = lmp_->update->dt, a.step = static_cast<int64_t>(lmp_->update->ntimestep);
    a.frozen = pair->freeze_group_bit();
    a.update = pair->shearupdate();
    a.rebuilt = lmp_->neighbor->ncalls != built_ || lmp_->neighbor->ago == 0 || list != list_;
    built_ = lmp_->neighbor->ncalls;
    list_ = list;
    if (granlaw_batch_pass(batch_, &a) != GRANLAW_OK) stop(lmp_, granlaw_last_error());
  }

  // Runs on all ranks alike. Who asks for this path by name is told what it did; `granlaw bench` reads it.
  void drop() {
    if (batch_ && mode().path == Path::batched) {
      granlaw_account mine = granlaw_batch_account(batch_), all = mine;
      static_assert(sizeof(granlaw_account) == 4 * sizeof(uint64_t), "summed as four numbers");
      MPI_Reduce(&mine, &all, 4, MPI_UINT64_T, MPI_SUM, 0, lmp_->world);
      // A rank without particles makes no pass.
      MPI_Reduce(&mine.passes, &all.passes, 1, MPI_UINT64_T, MPI_MAX, 0, lmp_->world);
      print("batched path ends: " + std::to_string(all.passes) + " steps, " + std::to_string(all.contacts) + " contacts, " +
            std::to_string(all.neighbours) + " neighbours, " + std::to_string(all.bytes) + " bytes");
    }
    granlaw_batch_free(batch_);
    batch_ = nullptr;
  }

  void say(const std::string &text, const char *what) {
    if (said_.insert(what).second) print(text);
  }

  void print(const std::string &text) const {
    int me = 0;
    MPI_Comm_rank(lmp_->world, &me);
    if (me != 0) return;
    for (FILE *out : {lmp_->screen, lmp_->logfile})
      if (out) fprintf(out, "granlaw: %s\n", text.c_str());
  }

  LAMMPS *lmp_;
  Chain *chain_;
  granlaw_batch *batch_;
  const LAMMPS_NS::NeighList *list_;
  LAMMPS_NS::bigint built_;
  // What the last step was said to do: most steps are like the one before.
  const char *last_;
  std::set<std::string> said_;
};

}  // namespace granlaw
#endif
