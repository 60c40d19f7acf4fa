// A Rust law as one of the models of a LIGGGHTS that is built from source: what every generated model header derives from.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_DROPIN_HPP
#define GRANLAW_DROPIN_HPP

#include "adapter.hpp"

namespace granlaw {

// `Base` is LIGGGHTS's base class for models of the kind; kind and number are those of the law's descriptor.
template <class Base, int32_t Kind, int Id>
class DropIn : public Base {
 public:
  DropIn(LAMMPS *lmp, IContactHistorySetup *history, LIGGGHTS::ContactModels::ContactModelBase *c)
      : Base(lmp, history, c), segment_(lmp, history), law_(segment_.add(history, index(lmp), false)) {}

  void registerSettings(Settings &settings) { law_.registerSettings(settings); }
  void postSettings(IContactHistorySetup *, LIGGGHTS::ContactModels::ContactModelBase *) { law_.postSettings(), law_.refuseSettings(); }
  void connectToProperties(PropertyRegistry &registry) { segment_.connectToProperties(registry); }
  double stressStrainExponent() { return law_.descriptor().stress_strain_exponent; }

  void beginPass(SurfacesIntersectData &, ForceData &, ForceData &) { segment_.beginPass(); }
  void endPass(SurfacesIntersectData &, ForceData &, ForceData &) { segment_.endPass(); }
  void surfacesIntersect(SurfacesIntersectData &s, ForceData &i, ForceData &j) { segment_.surfacesIntersect(s, i, j); }
  // LIGGGHTS's tangential models promise to change nothing, and ours puts back what it found.
  void surfacesIntersect(const SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    segment_.surfacesIntersect(const_cast<SurfacesIntersectData &>(s), i, j);
  }
  void endSurfacesIntersect(SurfacesIntersectData &, ForceData &, ForceData &) {}
  void surfacesClose(SurfacesCloseData &s, ForceData &i, ForceData &j) { segment_.surfacesClose(s, i, j); }

 private:
  static size_t index(LAMMPS *lmp) {
    if (granlaw_abi_version() != GRANLAW_ABI_VERSION)
      lmp->error->all(GRANLAW_HERE, "granlaw.h and libgranlaw.a have different ABI versions; run granlaw's scripts/dropin.sh again");
    if (lmp->atom->superquadric_flag) lmp->error->all(GRANLAW_HERE, "granlaw's laws are for spheres");
    for (size_t k = 0; k < granlaw_law_count(); k++)
      if (granlaw_law_at(k)->kind == Kind && granlaw_law_at(k)->id == Id) return k;
    lmp->error->all(GRANLAW_HERE, "libgranlaw.a lacks a law of this build; run granlaw's scripts/dropin.sh again");
    return 0;
  }

  Segment segment_;
  Law &law_;
};

}  // namespace granlaw
#endif
