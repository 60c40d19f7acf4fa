/* Errors belong to the thread that made them, and chains of different threads run side by side.
 * SPDX-License-Identifier: GPL-2.0-or-later */
#define _POSIX_C_SOURCE 200112L
#include <pthread.h>
#include "check.h"

static pthread_barrier_t together;

typedef struct { double young, fn; char said[200]; } work;

static void *run(void *p) {
  work *w = p;
  given deck[] = {{"youngsModulus", {w->young, w->young}}, {"poissonsRatio", {0.3, 0.3}}, {"characteristicVelocity", {2.0}},
                  {"coefficientRestitution", {0.9, 0.9, 0.9, 0.9}}};
  const size_t hooke = law(GRANLAW_NORMAL, "hooke");
  const double *values[MOST];
  look_up(hooke, deck, 4, values);
  const granlaw_choice choice = {hooke, false, NULL, values, 0, NULL};
  const granlaw_setup setup = {&choice, 1, TYPES, 1.0};
  granlaw_chain *chain;
  const granlaw_status status = granlaw_prepare(&setup, &chain);
  pthread_barrier_wait(&together); /* every thread has failed, or not, before any asks */
  strncpy(w->said, granlaw_last_error(), sizeof w->said - 1);
  if (status != GRANLAW_OK) return NULL;
  double zero[3] = {0, 0, 0};
  granlaw_surfaces_intersect_data s;
  memset(&s, 0, sizeof s);
  s.close.radi = s.close.radj = 0.005, s.close.itype = s.close.jtype = 1;
  s.close.v_i = s.close.v_j = s.close.omega_i = s.close.omega_j = zero;
  s.en[0] = 1, s.deltan = 1e-5, s.mi = s.mj = 1e-3, s.meff = 5e-4;
  for (int k = 0; k < 10000; k++) {
    granlaw_force_data i = {{0, 0, 0}, {0, 0, 0}}, j = i;
    if (granlaw_surfaces_intersect(chain, &s, &i, &j) != GRANLAW_OK || (k && s.Fn != w->fn)) w->fn = NAN;
    else w->fn = s.Fn;
  }
  granlaw_free(chain);
  return NULL;
}

int main(void) {
  same_abi();
  work all[4] = {{-1, 0, ""}, {5e6, 0, ""}, {-2, 0, ""}, {5e6 * 32, 0, ""}};
  pthread_t threads[4];
  pthread_barrier_init(&together, NULL, 4);
  for (int k = 0; k < 4; k++) pthread_create(&threads[k], NULL, run, &all[k]);
  for (int k = 0; k < 4; k++) pthread_join(threads[k], NULL);
  EXPECT(strstr(all[0].said, "youngsModulus = -1 "));
  EXPECT(strstr(all[2].said, "youngsModulus = -2 "));
  EXPECT(!*all[1].said && !*all[3].said && !*granlaw_last_error());
  EXPECT(all[1].fn > 0);
  /* kn goes with E* to the power 4/5. */
  EXPECT_NEAR(all[3].fn, all[1].fn * 16, all[3].fn);
  return verdict();
}
