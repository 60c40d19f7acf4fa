// What the laws ask of a wall. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_WALL_HPP
#define GRANLAW_WALL_HPP

#include <cmath>
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "neighbor.h"
#include "granlaw.h"

namespace granlaw {

// A primitive wall turns if its shear is about its axis, which LIGGGHTS keeps to itself: a derived class may look.
struct WallPeek : LAMMPS_NS::FixWallGran {
  static bool turns(LAMMPS_NS::FixWallGran *wall) { return wall->*(&WallPeek::shear_) && wall->*(&WallPeek::shearAxis_) >= 0; }
};

inline granlaw_wall look_at(LAMMPS_NS::FixWallGran *wall, const LAMMPS_NS::Neighbor *neighbor) {
  if (!wall->is_mesh_wall()) return granlaw_wall{neighbor->skin, WallPeek::turns(wall)};
  bool turns = false;
  for (int k = 0; k < wall->n_meshes(); k++) {
    LAMMPS_NS::TriMesh *mesh = wall->mesh_list()[k]->triMesh();
    turns = turns || mesh->isRotating() || mesh->isScaling() || mesh->isDeforming();
  }
  return granlaw_wall{INFINITY, turns};
}

}  // namespace granlaw
#endif
