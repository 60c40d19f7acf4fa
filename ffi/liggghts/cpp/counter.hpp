// compute ID group <law>/counter: how many bonds there are, began and ended. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_COUNTER_HPP
#define GRANLAW_COUNTER_HPP

#include <map>
#include "compute.h"
#include "adapter.hpp"

namespace granlaw {

// Pair bonds that began, ended, are there; then the same of wall bonds. Counted since the pair style or wall was made.
class Counter : public LAMMPS_NS::Compute {
 public:
  Counter(LAMMPS *lmp, int &iarg, int narg, char **arg) : Compute(lmp, iarg, narg, arg) {
    if (narg > iarg) lmp->error->all(GRANLAW_HERE, (std::string("compute ") + arg[2] + " takes no arguments").c_str());
    vector_flag = 1;
    extvector = 0;
    size_vector = 6;
    vector = new double[size_vector];
  }
  ~Counter() { delete[] vector; }
  void init() {}

  void compute_vector() {
    invoked_vector = update->ntimestep;
    double own[6] = {};
    for (const Segment *segment : Segment::all()) {
      if (!segment->of(lmp) || !segment->has(law(style))) continue;
      const granlaw_bonds b = segment->bonds();
      double *out = own + (segment->is_wall() ? 3 : 0);
      out[0] += static_cast<double>(b.begun);
      out[1] += static_cast<double>(b.ended);
      out[2] += b.step == update->ntimestep ? static_cast<double>(b.there) : 0.0;
    }
    MPI_Allreduce(own, vector, 6, MPI_DOUBLE, MPI_SUM, world);
  }

  // LIGGGHTS makes its table of computes after a preloaded library was initialised, so the first chain enters ours.
  static void enter(LAMMPS *lmp);

 private:
  static std::string style_of(const granlaw_law &d) { return std::string(d.keyword) + "/counter"; }
  static const granlaw_law *law(const char *style) {
    for (size_t k = 0; k < granlaw_law_count(); k++)
      if (granlaw_law_at(k)->bonds && style_of(*granlaw_law_at(k)) == style) return granlaw_law_at(k);
    return nullptr;
  }
};

typedef LAMMPS_NS::Compute *(*MakeCompute)(LAMMPS *, int, int, char **);
typedef std::map<std::string, MakeCompute> Computes;
// A template argument may name a private member.
template <Computes *LAMMPS_NS::Modify::*Table>
struct ComputesOpener {
  friend Computes &computes_of(LAMMPS_NS::Modify &modify) { return *(modify.*Table); }
};
template struct ComputesOpener<&LAMMPS_NS::Modify::compute_map>;
Computes &computes_of(LAMMPS_NS::Modify &modify);

inline LAMMPS_NS::Compute *make_counter(LAMMPS *lmp, int iarg, int narg, char **arg) {
  return new Counter(lmp, iarg, narg, arg);
}
inline void Counter::enter(LAMMPS *lmp) {
  for (size_t k = 0; k < granlaw_law_count(); k++)
    if (granlaw_law_at(k)->bonds) computes_of(*lmp->modify)[style_of(*granlaw_law_at(k))] = &make_counter;
}

}  // namespace granlaw
#endif
