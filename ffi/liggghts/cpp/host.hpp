// What we use of LIGGGHTS, and what must hold of it. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_HOST_HPP
#define GRANLAW_HOST_HPP

#include <mpi.h>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "fix_insert_stream.h"  // must come before granular_styles.h
#include "granular_styles.h"
#include "fix_rigid.h"
#include "fix_wall_gran.h"
#include "global_properties.h"
#include "modify.h"
#include "universe.h"
#include "granlaw.h"

// LIGGGHTS's macro would print a path of the machine that built us.
#define GRANLAW_HERE "granlaw", __LINE__

namespace granlaw {
using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

// Our mirror structs lie exactly on LIGGGHTS's.
#define GRANLAW_SAME(theirs, ours, their_field, our_field)                                        \
  static_assert(offsetof(theirs, their_field) == offsetof(ours, our_field), #their_field " moved"); \
  static_assert(sizeof(theirs::their_field) == sizeof(((ours *)nullptr)->our_field), #their_field " changed its size")
#define GRANLAW_CLOSE(f) GRANLAW_SAME(SurfacesCloseData, granlaw_surfaces_close_data, f, f)
#define GRANLAW_INTERSECT(f) GRANLAW_SAME(SurfacesIntersectData, granlaw_surfaces_intersect_data, f, f)
#define GRANLAW_BASE(f) GRANLAW_SAME(SurfacesIntersectData, granlaw_surfaces_intersect_data, f, close.f)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
GRANLAW_CLOSE(radi); GRANLAW_CLOSE(radj); GRANLAW_CLOSE(radsum); GRANLAW_CLOSE(rsq); GRANLAW_CLOSE(delta);
GRANLAW_CLOSE(area_ratio); GRANLAW_CLOSE(contact_flags); GRANLAW_CLOSE(contact_history); GRANLAW_CLOSE(mesh);
GRANLAW_CLOSE(fix_mesh); GRANLAW_CLOSE(i); GRANLAW_CLOSE(j); GRANLAW_CLOSE(itype); GRANLAW_CLOSE(jtype);
GRANLAW_CLOSE(is_wall); GRANLAW_CLOSE(has_force_update); GRANLAW_CLOSE(v_i); GRANLAW_CLOSE(v_j);
GRANLAW_CLOSE(omega_i); GRANLAW_CLOSE(omega_j); GRANLAW_CLOSE(is_non_spherical); GRANLAW_CLOSE(computeflag);
GRANLAW_CLOSE(shearupdate);
GRANLAW_BASE(radi); GRANLAW_BASE(contact_history); GRANLAW_BASE(omega_j); GRANLAW_BASE(shearupdate);
GRANLAW_INTERSECT(r); GRANLAW_INTERSECT(rinv); GRANLAW_INTERSECT(en); GRANLAW_INTERSECT(kt); GRANLAW_INTERSECT(kn);
GRANLAW_INTERSECT(gammat); GRANLAW_INTERSECT(gamman); GRANLAW_INTERSECT(Fn); GRANLAW_INTERSECT(Ft);
GRANLAW_INTERSECT(vn); GRANLAW_INTERSECT(deltan); GRANLAW_INTERSECT(cri); GRANLAW_INTERSECT(crj);
GRANLAW_INTERSECT(wr1); GRANLAW_INTERSECT(wr2); GRANLAW_INTERSECT(wr3); GRANLAW_INTERSECT(vtr1);
GRANLAW_INTERSECT(vtr2); GRANLAW_INTERSECT(vtr3); GRANLAW_INTERSECT(mi); GRANLAW_INTERSECT(mj);
GRANLAW_INTERSECT(meff); GRANLAW_INTERSECT(P_diss);
GRANLAW_SAME(ForceData, granlaw_force_data, delta_F, delta_F);
GRANLAW_SAME(ForceData, granlaw_force_data, delta_torque, delta_torque);
#pragma GCC diagnostic pop
static_assert(sizeof(SurfacesIntersectData) == sizeof(granlaw_surfaces_intersect_data), "SurfacesIntersectData grew");
static_assert(sizeof(ForceData) == sizeof(granlaw_force_data), "ForceData grew");

inline granlaw_surfaces_intersect_data *mirror(SurfacesIntersectData &s) {
  return reinterpret_cast<granlaw_surfaces_intersect_data *>(&s);
}
inline granlaw_surfaces_close_data *mirror(SurfacesCloseData &s) {
  return reinterpret_cast<granlaw_surfaces_close_data *>(&s);
}
inline granlaw_force_data *mirror(ForceData &f) { return reinterpret_cast<granlaw_force_data *>(&f); }

}  // namespace granlaw
#endif
