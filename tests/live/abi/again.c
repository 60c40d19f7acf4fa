/* Prepares and frees again and again, also in vain, as every run command of a deck does; to be watched by valgrind.
 * SPDX-License-Identifier: GPL-2.0-or-later */
#include "check.h"

int main(int n, char **args) {
  same_abi();
  const bool leak = n > 1 && !strcmp(args[1], "planted");
  given deck[] = {{"youngsModulus", {5e6, 8e6}}, {"poissonsRatio", {0.3, 0.3}}, {"characteristicVelocity", {2.0}},
                  {"coefficientRestitution", {0.9, 0.9, 0.9, 0.9}}, {"coefficientFriction", {0.3, 0.4, 0.4, 0.5}}};
  const size_t laws[2] = {law(GRANLAW_NORMAL, "hooke"), law(GRANLAW_TANGENTIAL, "history")};
  const double *values[2][MOST];
  granlaw_choice choices[2];
  for (int k = 0; k < 2; k++) {
    look_up(laws[k], deck, 5, values[k]);
    const granlaw_choice choice = {laws[k], false, NULL, values[k], 0, NULL};
    choices[k] = choice;
  }
  const granlaw_setup setup = {choices, 2, TYPES, 1.0};
  for (int k = 0; k < 50; k++) {
    granlaw_chain *chain = NULL;
    deck[4].values[3] = k % 2 ? 0.5 : -0.5; /* every other time refused, after the first law was prepared */
    EXPECT((granlaw_prepare(&setup, &chain) == GRANLAW_OK) == (k % 2));
    if (!leak) granlaw_free(chain);
  }
  return verdict();
}
