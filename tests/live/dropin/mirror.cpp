// One contact through mirror.hpp, printed. Built for spheres only and for other shapes too, it must print the same: there
// LIGGGHTS's structs have more fields, and the laws see a copy. SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <cstring>
#include <vector>
#include "mirror.hpp"

int main() {
  size_t law = 0;
  while (granlaw_law_at(law)->kind != GRANLAW_NORMAL || strcmp(granlaw_law_at(law)->keyword, "hooke/hysteresis")) law++;
  const granlaw_law &l = *granlaw_law_at(law);
  // Numbers that lie in the ranges of all properties of this law.
  std::vector<double> numbers(l.n_props, 0.5);
  std::vector<const double *> values;
  for (size_t k = 0; k < l.n_props; k++) {
    if (!strcmp(l.props[k].name, "poissonsRatio")) numbers[k] = 0.3;
    if (!strcmp(l.props[k].name, "youngsModulus")) numbers[k] = 5e6;
    if (!strcmp(l.props[k].name, "coefficientMaxElasticStiffness")) numbers[k] = 5;
    values.push_back(&numbers[k]);
  }
  const granlaw_choice choice = {law, false, nullptr, values.data(), 0};
  const granlaw_setup setup = {&choice, 1, 1, 1.0};
  granlaw_chain *chain = nullptr;
  if (granlaw_prepare(&setup, &chain) != GRANLAW_OK) return puts(granlaw_last_error()), 1;

  LIGGGHTS::ContactModels::SurfacesIntersectData s;
  LIGGGHTS::ContactModels::ForceData i, j;
  double history = 0, v[3] = {-0.5, 0, 0}, rest[3] = {0, 0, 0};
  int flags = 0;
  s.radi = s.radj = 0.005, s.radsum = 0.01, s.r = 0.0099, s.rsq = s.r * s.r, s.rinv = 1 / s.r;
  s.delta[0] = s.r, s.delta[1] = s.delta[2] = 0, s.en[0] = 1, s.en[1] = s.en[2] = 0;
  s.contact_flags = &flags, s.contact_history = &history, s.j = 1, s.itype = s.jtype = 1;
  s.v_i = v, s.v_j = s.omega_i = s.omega_j = rest, s.computeflag = s.shearupdate = 1;
  s.deltan = 1e-4, s.vn = -0.5, s.cri = s.crj = 0.00495, s.mi = s.mj = 1e-3, s.meff = 5e-4;
  s.kn = s.kt = s.gamman = s.gammat = s.wr1 = s.wr2 = s.wr3 = s.vtr1 = s.vtr2 = s.vtr3 = s.P_diss = 0;
  if (granlaw_surfaces_intersect(chain, granlaw::mirror(s), granlaw::mirror(i), granlaw::mirror(j)) != GRANLAW_OK)
    return puts(granlaw_last_error()), 1;
  printf("%.17g %.17g %.17g %.17g %.17g\n", s.Fn, s.kn, s.kt, s.gamman, s.gammat);
  printf("%.17g %.17g %.17g %d\n", i.delta_F[0], j.delta_F[0], history, flags);
  s.has_force_update = true;
  if (granlaw_surfaces_close(chain, granlaw::mirror(static_cast<LIGGGHTS::ContactModels::SurfacesCloseData &>(s)), 1e-3,
                             1e-3, granlaw::mirror(i), granlaw::mirror(j)) != GRANLAW_OK)
    return puts(granlaw_last_error()), 1;
  printf("%.17g %d %d\n", history, flags, s.has_force_update);
  granlaw_free(chain);
}
