// Debian's LIGGGHTS with the drop-in models compiled in: LIGGGHTS's own registration over lists of models that hold ours
// too, in a program of its own. It stands for a build from source, which takes minutes. SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
#include "fix_insert_stream.h"  // must come before granular_styles.h
#include "granular_styles.h"
#include "input.h"
#include "lammps.h"

namespace LIGGGHTS {
namespace ContactModels {
static void add_names() {
  Factory &f = Factory::instance();
#define NORMAL_MODEL(constant, name, id) f.addNormalModel(#name, id);
#include "style_normal_model.h"
#undef NORMAL_MODEL
#define COHESION_MODEL(constant, name, id) f.addCohesionModel(#name, id);
#include "style_cohesion_model.h"
#undef COHESION_MODEL
#define TANGENTIAL_MODEL(constant, name, id) f.addTangentialModel(#name, id);
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
#define ROLLING_MODEL(constant, name, id) f.addRollingModel(#name, id);
#include "style_rolling_model.h"
#undef ROLLING_MODEL
}
}  // namespace ContactModels
}  // namespace LIGGGHTS

int main(int n, char **args) {
  MPI_Init(&n, &args);
  LAMMPS_NS::LAMMPS *lammps = new LAMMPS_NS::LAMMPS(n, args, MPI_COMM_WORLD);
  LIGGGHTS::ContactModels::add_names();
  LIGGGHTS::RegisterGranularStyles styles;
  lammps->input->file();
  delete lammps;
  MPI_Finalize();
}
