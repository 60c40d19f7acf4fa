/* What the C programs here share: expectations, and a law found by its name. SPDX-License-Identifier: GPL-2.0-or-later */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "granlaw.h"

static int failures = 0;

/* Counts a failure; whether it is one of the first, which are worth a line. */
static inline bool worth_a_line(void) { return ++failures <= 10; }

static inline void expect(int line, const char *condition, bool holds) {
  if (!holds && worth_a_line()) fprintf(stderr, "line %d: not so: %s\n", line, condition);
}
#define EXPECT(condition) expect(__LINE__, #condition, condition)

/* `scale` is the size of the largest number of this kind; the same operations in another order differ by round-off. */
static inline void expect_near(int line, const char *what, double got, double wanted, double scale) {
  if (fabs(got - wanted) <= 1e-13 * scale) return;
  if (worth_a_line()) fprintf(stderr, "line %d: %s is %.17g, not %.17g\n", line, what, got, wanted);
}
#define EXPECT_NEAR(got, wanted, scale) expect_near(__LINE__, #got, got, wanted, scale)

/* The call must fail with this status and a message that holds this text. */
static inline void expect_refused(int line, granlaw_status got, granlaw_status wanted, const char *text) {
  const char *said = granlaw_last_error();
  if (got == wanted && strstr(said, text)) return;
  if (worth_a_line()) fprintf(stderr, "line %d: status %d \"%s\", not %d with \"%s\"\n", line, (int)got, said, (int)wanted, text);
}
#define EXPECT_REFUSED(call, status, text) expect_refused(__LINE__, call, status, text)

static inline size_t law(int32_t kind, const char *keyword) {
  for (size_t k = 0; k < granlaw_law_count(); k++) {
    const granlaw_law *l = granlaw_law_at(k);
    if (l->kind == kind && !strcmp(l->keyword, keyword)) return k;
  }
  fprintf(stderr, "no law %s\n", keyword);
  exit(2);
}

enum { MOST = 16, TYPES = 2 };

/* A property of two materials: per type, or per pair of types in the order 1-1, 1-2, 2-1, 2-2. */
typedef struct { const char *name; double values[4]; } given;

/* Fill `out` with pointers to the values of the properties of a law, NULL for those that are not given. */
static inline void look_up(size_t index, const given *all, size_t n, const double *out[MOST]) {
  const granlaw_law *l = granlaw_law_at(index);
  for (size_t p = 0; p < l->n_props; p++) {
    out[p] = NULL;
    for (size_t k = 0; k < n; k++)
      if (!strcmp(l->props[p].name, all[k].name)) out[p] = all[k].values;
  }
}

/* The index of a setting. */
static inline size_t setting(size_t index, const char *name) {
  const granlaw_law *l = granlaw_law_at(index);
  for (size_t k = 0; k < l->n_settings; k++)
    if (!strcmp(l->settings[k].name, name)) return k;
  fprintf(stderr, "%s has no setting %s\n", l->keyword, name);
  exit(2);
}

/* A program that was compiled against another header must not go on. */
static inline void same_abi(void) {
  if (granlaw_abi_version() == GRANLAW_ABI_VERSION) return;
  fprintf(stderr, "granlaw.h has ABI version %u, the library %u\n", GRANLAW_ABI_VERSION, (unsigned)granlaw_abi_version());
  exit(3);
}

static inline int verdict(void) {
  if (failures) fprintf(stderr, "%d expectations failed\n", failures);
  return failures ? 1 : 0;
}

#endif
