/* Every way to be refused, with its status and its words; nothing is changed by it. SPDX-License-Identifier: GPL-2.0-or-later */
#include "check.h"

static given deck[] = {
    {"youngsModulus", {5e6, 8e6}},      {"poissonsRatio", {0.45, 0.3}},
    {"characteristicVelocity", {2.0}},  {"coefficientRestitution", {0.9, 0.7, 0.7, 0.6}},
    {"coefficientFriction", {0.3, 0.4, 0.4, 0.5}},
};
enum { GIVEN = sizeof deck / sizeof deck[0] };

/* hooke and history as a caller would set them up; the tests change one thing each. */
static const double *hooke_values[MOST], *history_values[MOST];
static int32_t hooke_options[MOST];
static granlaw_choice choices[2];
static granlaw_setup setup;
static void fresh(void) {
  const size_t hooke = law(GRANLAW_NORMAL, "hooke"), history = law(GRANLAW_TANGENTIAL, "history");
  look_up(hooke, deck, GIVEN, hooke_values);
  look_up(history, deck, GIVEN, history_values);
  for (int k = 0; k < MOST; k++) hooke_options[k] = -1;
  const granlaw_choice first = {hooke, false, hooke_options, hooke_values, 0, NULL},
                       second = {history, false, NULL, history_values, 0, NULL};
  const granlaw_setup all = {choices, 2, TYPES, 1.0};
  choices[0] = first, choices[1] = second, setup = all;
}

/* The preparation must fail, and leave no chain. */
static granlaw_status prepare(void) {
  granlaw_chain *chain = (granlaw_chain *)&setup;
  const granlaw_status status = granlaw_prepare(&setup, &chain);
  EXPECT(chain == NULL);
  fresh();
  return status;
}

static void set_ups(void) {
  granlaw_chain *chain;
  fresh();
  EXPECT_REFUSED(granlaw_prepare(NULL, &chain), GRANLAW_MISUSE, "setup or out is NULL");
  EXPECT_REFUSED(granlaw_prepare(&setup, NULL), GRANLAW_MISUSE, "setup or out is NULL");
  setup.n_laws = 0;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "there are no laws");
  setup.n_types = 0;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "n_types");
  choices[0].law = 999;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "no law has that index");
  hooke_options[0] = 7;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "no option has that index");
  choices[0] = choices[1];
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "order of the kinds");
  {
    const granlaw_choice first = choices[0];
    choices[0] = choices[1], choices[1] = first;
  }
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "order of the kinds");
  choices[0].law = law(GRANLAW_NORMAL, "hooke/hysteresis"), choices[1].history_offset = 0;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "history_offset");
  fresh();
  const int32_t nowhere[3] = {0, 1, -1};
  choices[1].history_places = nowhere;
  EXPECT_REFUSED(prepare(), GRANLAW_MISUSE, "history_places");
}

static void deck_faults(void) {
  deck[0].name = "youngsModulo";
  fresh();
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "hooke/rs: property youngsModulus was not given; set it with fix ID all property/global youngsModulus peratomtype");
  deck[0].name = "youngsModulus", deck[0].values[1] = -1;
  fresh();
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "hooke/rs: youngsModulus = -1 (type 2) must be above 0");
  choices[0].taken_over = true;
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "hooke: youngsModulus = -1 (type 2) must be above 0");
  deck[0].values[1] = 8e6, deck[3].values[1] = NAN;
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "coefficientRestitution = NaN (types 1-2)");
  deck[3].values[1] = 0.7, deck[4].values[3] = -0.5;
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "history/rs: coefficientFriction = -0.5 (types 2-2) must be at least 0");
  deck[4].values[3] = 0.5;
  hooke_options[setting(choices[0].law, "computeElasticPotential")] = 1;
  EXPECT_REFUSED(granlaw_check_settings(choices[0].law, false, hooke_options), GRANLAW_REFUSED, "computeElasticPotential on is not supported");
  EXPECT_REFUSED(prepare(), GRANLAW_REFUSED, "hooke/rs: setting computeElasticPotential on is not supported");
  EXPECT(granlaw_check_settings(choices[0].law, false, hooke_options) == GRANLAW_OK);
}

static void contacts(void) {
  granlaw_chain *chain = NULL;
  int flags = 5;
  double zero[3] = {0, 0, 0}, history[3] = {1, 2, 3};
  granlaw_surfaces_intersect_data good, s;
  granlaw_force_data i = {{1, 2, 3}, {4, 5, 6}}, j = i;
  fresh();
  EXPECT(granlaw_prepare(&setup, &chain) == GRANLAW_OK);
  memset(&good, 0, sizeof good);
  good.close.radi = good.close.radj = 0.005, good.close.itype = 1, good.close.jtype = 2;
  good.close.contact_flags = &flags, good.close.contact_history = history;
  good.close.v_i = good.close.v_j = good.close.omega_i = good.close.omega_j = zero;
  good.close.computeflag = good.close.shearupdate = 1;
  good.en[0] = 1, good.deltan = 1e-5, good.cri = good.crj = 0.005, good.mi = good.mj = 1e-3, good.meff = 5e-4;

#define TRY(change, status, text) \
  (s = good, change, EXPECT_REFUSED(granlaw_surfaces_intersect(chain, &s, &i, &j), status, text))
  TRY(s.deltan = NAN, GRANLAW_NON_FINITE, "hooke + history: the contact of particle 0 with particle 0 at step 0 is not finite");
  TRY(s.vn = INFINITY, GRANLAW_NON_FINITE, "normal velocity inf m/s");
  TRY(s.en[2] = NAN, GRANLAW_NON_FINITE, "is not finite");
  TRY(s.vtr2 = -INFINITY, GRANLAW_NON_FINITE, "is not finite");
  TRY(s.meff = NAN, GRANLAW_NON_FINITE, "is not finite");
  TRY((s.wr1 = NAN, s.close.is_wall = true), GRANLAW_NON_FINITE, "with a wall");
  TRY(s.close.itype = 0, GRANLAW_MISUSE, "itype or jtype");
  TRY(s.close.jtype = 3, GRANLAW_MISUSE, "itype or jtype");
  TRY(s.close.contact_history = NULL, GRANLAW_MISUSE, "contact_history is NULL");
  EXPECT_REFUSED(granlaw_surfaces_intersect(NULL, &good, &i, &j), GRANLAW_MISUSE, "a pointer is NULL");
  EXPECT_REFUSED(granlaw_surfaces_intersect(chain, NULL, &i, &j), GRANLAW_MISUSE, "a pointer is NULL");
  EXPECT_REFUSED(granlaw_surfaces_intersect(chain, &good, NULL, &j), GRANLAW_MISUSE, "a pointer is NULL");
  EXPECT_REFUSED(granlaw_surfaces_intersect(chain, &good, &i, NULL), GRANLAW_MISUSE, "a pointer is NULL");
  EXPECT_REFUSED(granlaw_surfaces_close(chain, NULL, 1, 1, &i, &j), GRANLAW_MISUSE, "a pointer is NULL");
  EXPECT_REFUSED(granlaw_begin_pass(chain, NULL), GRANLAW_MISUSE, "chain or pass is NULL");
  EXPECT_REFUSED(granlaw_end_pass(NULL), GRANLAW_MISUSE, "chain is NULL");
  EXPECT(flags == 5 && history[0] == 1 && history[1] == 2 && history[2] == 3);
  EXPECT(i.delta_F[0] == 1 && i.delta_torque[2] == 6 && j.delta_F[1] == 2 && j.delta_torque[0] == 4);

  /* The same contact without a fault goes through, so it was the fault that was refused. */
  s = good;
  EXPECT(granlaw_surfaces_intersect(chain, &s, &i, &j) == GRANLAW_OK);
  EXPECT(s.Fn > 0 && flags == (5 | 1 << GRANLAW_NORMAL | 1 << GRANLAW_TANGENTIAL));
  granlaw_free(chain);
  granlaw_free(NULL);
}

static void queries(void) {
  const size_t hooke = law(GRANLAW_NORMAL, "hooke");
  EXPECT(!granlaw_needs_property(999, false, NULL, 0) && strstr(granlaw_last_error(), "no law has that index"));
  EXPECT(!granlaw_needs_property(hooke, false, NULL, 999) && strstr(granlaw_last_error(), "not a property"));
}

int main(void) {
  same_abi();
  EXPECT(!strcmp(granlaw_last_error(), ""));
  set_ups();
  deck_faults();
  contacts();
  queries();
  return verdict();
}
