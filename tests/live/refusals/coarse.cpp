// LIGGGHTS with a coarse-graining factor of 2, which no deck of it can set, from behind the deck (create_atoms refuses it). SPDX-License-Identifier: GPL-2.0-or-later
#include <mpi.h>
#include "force.h"
#include "input.h"
#include "lammps.h"

int main(int n, char **args) {
  MPI_Init(&n, &args);
  LAMMPS_NS::LAMMPS *lammps = new LAMMPS_NS::LAMMPS(n, args, MPI_COMM_WORLD);
  lammps->input->file();
  lammps->force->setCG(2.0);
  lammps->input->one("run 200");
  delete lammps;
  MPI_Finalize();
}
