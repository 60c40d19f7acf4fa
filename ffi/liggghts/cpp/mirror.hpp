// LIGGGHTS's contact structs as granlaw.h has them. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_MIRROR_HPP
#define GRANLAW_MIRROR_HPP

#include <cstddef>
#include <string>
#include "contact_interface.h"
#include "granlaw.h"

#define GRANLAW_CLOSE_FIELDS(F)                                                                                        \
  F(radi) F(radj) F(radsum) F(rsq) F(delta) F(area_ratio) F(contact_flags) F(contact_history) F(mesh) F(fix_mesh) F(i) \
  F(j) F(itype) F(jtype) F(is_wall) F(has_force_update) F(v_i) F(v_j) F(omega_i) F(omega_j) F(is_non_spherical)        \
  F(computeflag) F(shearupdate)
#define GRANLAW_INTERSECT_FIELDS(F)                                                                             \
  F(r) F(rinv) F(en) F(kt) F(kn) F(gammat) F(gamman) F(Fn) F(Ft) F(vn) F(deltan) F(cri) F(crj) F(wr1) F(wr2)    \
  F(wr3) F(vtr1) F(vtr2) F(vtr3) F(mi) F(mj) F(meff) F(P_diss)

namespace granlaw {
using namespace LIGGGHTS::ContactModels;

#define GRANLAW_SAME(theirs, ours, their_field, our_field)                                          \
  static_assert(offsetof(theirs, their_field) == offsetof(ours, our_field), #their_field " moved"); \
  static_assert(sizeof(theirs::their_field) == sizeof(((ours *)nullptr)->our_field), #their_field " changed its size");

static_assert(sizeof(ForceData) == sizeof(granlaw_force_data), "ForceData grew");
GRANLAW_SAME(ForceData, granlaw_force_data, delta_F, delta_F)
GRANLAW_SAME(ForceData, granlaw_force_data, delta_torque, delta_torque)
inline granlaw_force_data *mirror(ForceData &f) { return reinterpret_cast<granlaw_force_data *>(&f); }

#if defined(NONSPHERICAL_ACTIVE_FLAG) || defined(SUPERQUADRIC_ACTIVE_FLAG)

// A LIGGGHTS built for other shapes too has more fields in between: what the laws see is a copy for the time of a call.
inline void copy(double (&to)[3], const double (&from)[3]) {
  for (int k = 0; k < 3; k++) to[k] = from[k];
}
template <class T, class U>
inline void copy(T &to, const U &from) {
  to = from;
}
inline void copy_close(granlaw_surfaces_close_data &to, const SurfacesCloseData &from) {
#define GRANLAW_COPY(f) copy(to.f, from.f);
  GRANLAW_CLOSE_FIELDS(GRANLAW_COPY)
}
class CloseMirror {
 public:
  explicit CloseMirror(SurfacesCloseData &s) : theirs_(s) { copy_close(ours_, s); }
  ~CloseMirror() { theirs_.has_force_update = ours_.has_force_update; }
  operator granlaw_surfaces_close_data *() { return &ours_; }

 private:
  SurfacesCloseData &theirs_;
  granlaw_surfaces_close_data ours_;
};
class IntersectMirror {
 public:
  explicit IntersectMirror(SurfacesIntersectData &s) : theirs_(s) {
    copy_close(ours_.close, s);
    granlaw_surfaces_intersect_data &to = ours_;
    const SurfacesIntersectData &from = s;
    GRANLAW_INTERSECT_FIELDS(GRANLAW_COPY)
#undef GRANLAW_COPY
  }
  ~IntersectMirror() {
    theirs_.Fn = ours_.Fn, theirs_.kn = ours_.kn, theirs_.kt = ours_.kt;
    theirs_.gamman = ours_.gamman, theirs_.gammat = ours_.gammat;
  }
  operator granlaw_surfaces_intersect_data *() { return &ours_; }

 private:
  SurfacesIntersectData &theirs_;
  granlaw_surfaces_intersect_data ours_;
};
inline CloseMirror mirror(SurfacesCloseData &s) { return CloseMirror(s); }
inline IntersectMirror mirror(SurfacesIntersectData &s) { return IntersectMirror(s); }

#else

// Our structs lie exactly on LIGGGHTS's.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#define GRANLAW_CLOSE(f) GRANLAW_SAME(SurfacesCloseData, granlaw_surfaces_close_data, f, f)
#define GRANLAW_BASE(f) GRANLAW_SAME(SurfacesIntersectData, granlaw_surfaces_intersect_data, f, close.f)
#define GRANLAW_INTERSECT(f) GRANLAW_SAME(SurfacesIntersectData, granlaw_surfaces_intersect_data, f, f)
GRANLAW_CLOSE_FIELDS(GRANLAW_CLOSE)
GRANLAW_CLOSE_FIELDS(GRANLAW_BASE)
GRANLAW_INTERSECT_FIELDS(GRANLAW_INTERSECT)
#pragma GCC diagnostic pop
static_assert(sizeof(SurfacesIntersectData) == sizeof(granlaw_surfaces_intersect_data), "SurfacesIntersectData grew");

inline granlaw_surfaces_close_data *mirror(SurfacesCloseData &s) {
  return reinterpret_cast<granlaw_surfaces_close_data *>(&s);
}
inline granlaw_surfaces_intersect_data *mirror(SurfacesIntersectData &s) {
  return reinterpret_cast<granlaw_surfaces_intersect_data *>(&s);
}

#endif

}  // namespace granlaw
#endif
