/* hooke/hysteresis + history + cdt for two materials, driven through a contact by hand and compared with the equations.
 * `chain planted` expects a spring that is 0.1 % too stiff and must fail. SPDX-License-Identifier: GPL-2.0-or-later */
#include "check.h"

static const given DECK[] = {
    {"youngsModulus", {5e6, 8e6}},
    {"poissonsRatio", {0.45, 0.3}},
    {"characteristicVelocity", {2.0}},
    {"coefficientRestitution", {0.9, 0.7, 0.7, 0.6}},
    {"coefficientMaxElasticStiffness", {5.0, 4.0, 4.0, 3.0}},
    {"coefficientAdhesionStiffness", {0.2, 0.5, 0.5, 0.1}},
    {"coefficientPlasticityDepth", {0.05, 0.04, 0.04, 0.02}},
    {"coefficientFriction", {0.3, 0.4, 0.4, 0.5}},
    {"coefficientRollingFriction", {0.1, 0.2, 0.2, 0.3}},
};
enum { GIVEN = sizeof DECK / sizeof DECK[0] };
static const double PI = 3.14159265358979323846, R_I = 0.005, R_J = 0.004, DENSITY = 2500.0, DT = 1e-6;

/* Slots of a contact's history: two of someone else's, then ours. */
enum { OTHERS = 2, DELTA_MAX = OTHERS, SHEAR = DELTA_MAX + 1, ROW = SHEAR + 3 };

typedef struct { double kn, k2max, kc, delta_lim, gamma, mu, mu_r, reff; } fit;

/* Mixing for types 1 (i) and 2 (j); `wall`: j is flat and heavy. */
static fit mixed(bool wall) {
  const double *e = DECK[0].values, *nu = DECK[1].values, vc = DECK[2].values[0];
  const int pair = 1;
  const double m_i = 4.0 / 3.0 * PI * R_I * R_I * R_I * DENSITY, m_j = 4.0 / 3.0 * PI * R_J * R_J * R_J * DENSITY;
  const double meff = wall ? m_i : m_i * m_j / (m_i + m_j), reff = wall ? R_I : R_I * R_J / (R_I + R_J);
  const double yeff = 1.0 / ((1.0 - nu[0] * nu[0]) / e[0] + (1.0 - nu[1] * nu[1]) / e[1]);
  const double kn = 16.0 / 15.0 * sqrt(reff) * yeff * pow(15.0 * meff * vc * vc / (16.0 * sqrt(reff) * yeff), 0.2);
  const double ratio = DECK[4].values[pair], log_e = log(DECK[3].values[pair]);
  fit f = {kn, kn * ratio, kn * DECK[5].values[pair], 0, 0, DECK[7].values[pair], DECK[8].values[pair], reff};
  f.delta_lim = f.k2max / (f.k2max - kn) * DECK[6].values[pair] * 2.0 * reff;
  f.gamma = sqrt(4.0 * meff * kn / (1.0 + PI / log_e * (PI / log_e)));
  return f;
}

/* The elastic force at an overlap; moves delta_max on. */
static double spring(const fit *f, double delta, double *delta_max) {
  if (delta > *delta_max) *delta_max = delta;
  double k2 = f->k2max, at = f->delta_lim, line;
  const bool plastic = *delta_max >= f->delta_lim;
  if (!plastic) {
    k2 = f->kn + (f->k2max - f->kn) * *delta_max / f->delta_lim;
    at = *delta_max;
  }
  line = k2 * (delta - at) + f->kn * at;
  if (!plastic && line >= f->kn * delta) return f->kn * delta;
  if (line > -f->kc * delta) return line;
  *delta_max = 0.5 * (delta + sqrt(delta * delta + 4.0 * (f->kn + f->kc) * delta * f->delta_lim / (f->k2max - f->kn)));
  return -f->kc * delta;
}

/* The force along y, with i on the x axis above j. */
static double friction(const fit *f, double normal, double speed, double *shear) {
  *shear += speed * DT;
  const double limit = f->mu * fabs(normal), elastic = f->kn * fabs(*shear);
  if (elastic <= limit) return -f->kn * *shear - f->gamma * speed;
  const double force = -limit * *shear / fabs(*shear);
  *shear = -force / f->kn;
  return force;
}

static granlaw_chain *prepare(void) {
  const size_t laws[3] = {law(GRANLAW_NORMAL, "hooke/hysteresis"), law(GRANLAW_TANGENTIAL, "history"), law(GRANLAW_ROLLING, "cdt")};
  const size_t offsets[3] = {DELTA_MAX, SHEAR, ROW};
  const double *values[3][MOST];
  granlaw_choice choices[3];
  for (int k = 0; k < 3; k++) {
    look_up(laws[k], DECK, GIVEN, values[k]);
    const granlaw_choice choice = {laws[k], false, NULL, values[k], offsets[k], NULL};
    choices[k] = choice;
  }
  const granlaw_setup setup = {choices, 3, TYPES, 1.0};
  granlaw_chain *chain = NULL;
  if (granlaw_prepare(&setup, &chain) != GRANLAW_OK) {
    fprintf(stderr, "%s\n", granlaw_last_error());
    exit(2);
  }
  return chain;
}

/* What LIGGGHTS's pair loop and surface model would fill in. The velocity is that of i; j rests. Spin about z rolls. */
static double x[6], v_i[3], v_j[3], omega_i[3], omega_j[3], history[ROW];
static int tag[2] = {7, 8}, flags;
static granlaw_surfaces_intersect_data contact(double delta, double vn, double vt, double spin, bool wall) {
  granlaw_surfaces_intersect_data s;
  memset(&s, 0, sizeof s);
  s.r = wall ? R_I - delta : R_I + R_J - delta;
  x[0] = s.close.delta[0] = s.r;
  v_i[0] = vn, v_i[1] = vt, omega_i[2] = spin;
  s.close.radi = R_I, s.close.radj = wall ? 0 : R_J, s.close.radsum = R_I + (wall ? 0 : R_J);
  s.close.rsq = s.r * s.r;
  s.close.area_ratio = wall ? 0.5 : 1.0;
  s.close.contact_flags = &flags, s.close.contact_history = history;
  s.close.i = 0, s.close.j = wall ? -1 : 1, s.close.itype = 1, s.close.jtype = 2, s.close.is_wall = wall;
  s.close.v_i = v_i, s.close.v_j = v_j, s.close.omega_i = omega_i, s.close.omega_j = wall ? NULL : omega_j;
  s.close.computeflag = s.close.shearupdate = 1;
  s.rinv = 1.0 / s.r, s.en[0] = 1.0, s.deltan = delta, s.vn = vn;
  s.cri = R_I - 0.5 * delta, s.crj = R_J - 0.5 * delta;
  s.wr3 = spin * s.cri / s.r, s.vtr2 = vt;
  s.mi = 4.0 / 3.0 * PI * R_I * R_I * R_I * DENSITY, s.mj = 4.0 / 3.0 * PI * R_J * R_J * R_J * DENSITY;
  s.meff = wall ? s.mi : s.mi * s.mj / (s.mi + s.mj);
  return s;
}

static void begin(granlaw_chain *chain, int64_t step) {
  const granlaw_pass pass = {DT, step, x, tag, NULL, 0, 2, {NULL}, {NULL}};
  EXPECT(granlaw_begin_pass(chain, &pass) == GRANLAW_OK);
}

/* Overlap along the walk, over the plastic limit: in, out into adhesion, in again past the first turn, out. */
static double overlap(int step, double lim) {
  static const double at[] = {0.001, 0.9, 0.3, 1.3, 0.05}, leg = 100;
  const int k = (int)(step / leg);
  const double share = step / leg - k;
  return lim * (at[k] + (at[k + 1] - at[k]) * share);
}

static void walk(granlaw_chain *chain, double stiffer, bool wall) {
  fit f = mixed(wall);
  f.kn *= stiffer;
  double delta_max = 0, shear = 0, most = f.kn * f.delta_lim, before = overlap(0, f.delta_lim);
  int adhesive = 0, slipping = 0;
  memset(history, 0, sizeof history);
  history[0] = 11, history[1] = 12;
  for (int step = 0; step < 400; step++) {
    const double delta = overlap(step, f.delta_lim), vn = -(delta - before) / DT * 1e-3, vt = step / 80 % 2 ? -2 : 2, spin = 20;
    granlaw_surfaces_intersect_data s = contact(delta, vn, vt, spin, wall);
    /* What other laws gave before ours must stay in the sum. */
    granlaw_force_data i = {{1, 0, 0}, {0, 0, 3e-3}}, j = {{0, 2, 0}, {0, 0, 4e-3}};
    begin(chain, step);
    EXPECT(granlaw_surfaces_intersect(chain, &s, &i, &j) == GRANLAW_OK);
    EXPECT(granlaw_end_pass(chain) == GRANLAW_OK);
    const double elastic = spring(&f, delta, &delta_max), normal = elastic - f.gamma * vn;
    const double tangential = friction(&f, normal, vt, &shear), share = wall ? 0.5 : 1.0;
    const double roll = f.mu_r * f.kn * delta * f.reff;
    adhesive += elastic < 0, slipping += fabs(f.kn * shear) >= f.mu * fabs(normal) * (1 - 1e-9);
    EXPECT_NEAR(s.Fn, normal, most);
    EXPECT_NEAR(s.kn, f.kn, f.kn);
    EXPECT_NEAR(s.gammat, f.gamma, f.gamma);
    EXPECT_NEAR(i.delta_F[0], 1 + share * normal, most);
    EXPECT_NEAR(i.delta_F[1], share * tangential, most);
    EXPECT_NEAR(i.delta_torque[2], 3e-3 + share * (-s.cri * tangential - roll), most * R_I);
    EXPECT_NEAR(j.delta_F[0], wall ? 0 : -normal, most);
    EXPECT_NEAR(j.delta_F[1], 2 - (wall ? 0 : tangential), most);
    if (!wall) EXPECT_NEAR(j.delta_torque[2], 4e-3 - s.crj * tangential + roll, most * R_I);
    EXPECT_NEAR(history[DELTA_MAX], delta_max, f.delta_lim);
    EXPECT_NEAR(history[SHEAR + 1], shear, most / f.kn);
    EXPECT(flags == (1 << GRANLAW_NORMAL | 1 << GRANLAW_TANGENTIAL));
    before = delta;
  }
  EXPECT(adhesive > 10 && slipping > 10 && slipping < 390);
  EXPECT(history[0] == 11 && history[1] == 12);
}

/* The surfaces part: history and flags of our laws go, there is no force. */
static void part(granlaw_chain *chain) {
  granlaw_surfaces_intersect_data s = contact(-1e-4, 0.1, 0, 0, false);
  granlaw_force_data i = {{1, 0, 0}, {0, 0, 0}}, j = {{0, 0, 0}, {0, 0, 0}};
  flags |= 1 << GRANLAW_COHESION;
  begin(chain, 400);
  EXPECT(granlaw_surfaces_close(chain, &s.close, s.mi, s.mj, &i, &j) == GRANLAW_OK);
  for (int k = OTHERS; k < ROW; k++) EXPECT(history[k] == 0);
  EXPECT(history[0] == 11 && history[1] == 12);
  EXPECT(flags == 1 << GRANLAW_COHESION);
  EXPECT(!s.close.has_force_update && i.delta_F[0] == 1 && j.delta_F[0] == 0);
  flags = 0;
}

/* A query between two steps leaves the shear alone. */
static void query(granlaw_chain *chain) {
  granlaw_surfaces_intersect_data s = contact(1e-4, 0, 0.1, 0, false);
  granlaw_force_data i = {{0, 0, 0}, {0, 0, 0}}, j = i;
  memset(history, 0, sizeof history);
  s.close.shearupdate = 0;
  EXPECT(granlaw_surfaces_intersect(chain, &s, &i, &j) == GRANLAW_OK);
  EXPECT(history[SHEAR + 1] == 0 && i.delta_F[1] < 0);
}

int main(int n, char **args) {
  same_abi();
  granlaw_chain *chain = prepare();
  const double stiffer = n > 1 && !strcmp(args[1], "planted") ? 1.001 : 1.0;
  walk(chain, stiffer, false);
  part(chain);
  query(chain);
  walk(chain, stiffer, true);
  granlaw_free(chain);
  return verdict();
}
