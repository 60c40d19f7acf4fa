// LIGGGHTS in which something asks the pair style to store what it works out, as only fixes that LIGGGHTS-PUBLIC lacks do. SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
#include <cstring>
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "pair_gran.h"

// Arguments: what to store, then those of LIGGGHTS, whose deck leaves out the run.
int main(int n, char **args) {
  MPI_Init(&n, &args);
  LAMMPS_NS::LAMMPS *lammps = new LAMMPS_NS::LAMMPS(n - 1, args + 1, MPI_COMM_WORLD);
  lammps->input->file();
  LAMMPS_NS::PairGran *pair = static_cast<LAMMPS_NS::PairGran *>(lammps->force->pair);
  if (!strcmp(args[1], "forces")) pair->do_store_contact_forces();
  if (!strcmp(args[1], "multicontact")) pair->do_store_multicontact_data();
  lammps->input->one("run 2000");
  delete lammps;
  MPI_Finalize();
}
