/* Everything that crosses between the halves of the plugin, beside granlaw.h: C++ asks, Rust answers.
 *
 * C, so that the compiler and bindgen read the same text: src/boundary.rs is what bindgen makes of the structs, and a test
 * compares the two. Units are those of granlaw.h.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later */
#ifndef GRANLAW_BOUNDARY_H
#define GRANLAW_BOUNDARY_H

#include "granlaw.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- all pair contacts of a step in one call ---- */

typedef struct granlaw_batch granlaw_batch;

/* LIGGGHTS's own arrays, none copied; every field is explained at Arrays in ffi/lanes/src/arrays.rs. */
typedef struct granlaw_arrays {
  const double *x, *v, *omega;
  double *f, *torque;
  const double *radius, *mass, *rigid;
  const int *type, *mask, *tag;
  const int *ilist, *numneigh;
  const int *const *neighbours;
  int *const *flags;
  double *const *history;
  size_t rows, all, forced, row;
  double skin, dt;
  int64_t step;
  int32_t frozen;
  bool update, rebuilt;
} granlaw_arrays;

/* What a chain did so far, and what it needs. */
typedef struct granlaw_account {
  uint64_t passes, contacts, neighbours, bytes;
} granlaw_account;

/* *out stays NULL where a law of the chain has no lanes. */
granlaw_status granlaw_batch_new(const granlaw_setup *setup, const char *lanes, granlaw_batch **out);
void granlaw_batch_free(granlaw_batch *batch);
const char *granlaw_batch_name(const granlaw_batch *batch);
granlaw_account granlaw_batch_account(const granlaw_batch *batch);
granlaw_status granlaw_batch_pass(granlaw_batch *batch, const granlaw_arrays *arrays);

/* ---- what is seen of a chain: for the recorder, the probe and the shadow ---- */

/* A law of the recorded chain; index -1 where granlaw lacks it. */
typedef struct granlaw_recorded_law {
  int32_t kind, index;
  const char *keyword;
  bool taken_over;
  size_t offset;
  const int32_t *options;
  const double *const *values;
} granlaw_recorded_law;

/* What the head of a trace says. */
typedef struct granlaw_recorded_chain {
  const char *path, *liggghts, *deck, *units, *who;
  int32_t rank, ranks;
  uint64_t every;
  size_t types;
  double nktv2p, dt;
  const granlaw_recorded_law *laws;
  size_t n_laws;
  const char *const *slots;
  size_t n_slots;
  bool given[GRANLAW_ATOM_PROPS];    /* which properties of single atoms the deck gives */
} granlaw_recorded_chain;

/* The particles when the recording begins. */
typedef struct granlaw_recorded_particles {
  size_t n;
  const int *tag, *type;
  const double *radius, *mass, *x, *v, *omega;
} granlaw_recorded_particles;

/* One contact call: what went in and what came out. `before` and `after` hold n_slots numbers each. */
typedef struct granlaw_recorded_call {
  const granlaw_pass *pass;
  const granlaw_surfaces_intersect_data *contact;
  bool touch;
  double mi, mj;
  const double *before, *after;
  const granlaw_force_data *i_forces, *j_forces;
} granlaw_recorded_call;

/* What a rank has to say at its end; lives until the process ends. */
typedef struct granlaw_text {
  const char *bytes;
  size_t length;
} granlaw_text;

/* ---- recorder ---- */

typedef struct granlaw_recorder granlaw_recorder;

granlaw_status granlaw_record_open(const granlaw_recorded_chain *chain, granlaw_recorder **out);
granlaw_status granlaw_record_again(granlaw_recorder *r, const granlaw_recorded_chain *chain);
granlaw_status granlaw_record_begin(granlaw_recorder *r, const granlaw_recorded_particles *particles);
granlaw_status granlaw_record_call(granlaw_recorder *r, const granlaw_recorded_call *call);
granlaw_status granlaw_record_close(granlaw_recorder *r);

/* ---- probe ---- */

typedef struct granlaw_probe granlaw_probe;

/* Follows a sample of the contacts, or as many as there is room for. */
granlaw_probe *granlaw_probe_new(bool all);
granlaw_status granlaw_probe_chain(granlaw_probe *p, const granlaw_recorded_chain *chain, size_t *out);
/* The contacts of a pair style or wall fix that cannot be counted. */
void granlaw_probe_unseen(granlaw_probe *p, const char *who);
/* A step begins, with a new neighbour list or not. Whether granlaw_probe_sample is due. */
bool granlaw_probe_tick(granlaw_probe *p, const granlaw_pass *pass, bool listed);
granlaw_status granlaw_probe_sample(granlaw_probe *p, int64_t step, const granlaw_recorded_particles *particles);
/* Counts a contact; whether it is one of those that are followed. */
bool granlaw_probe_sees(granlaw_probe *p, size_t chain, const granlaw_pass *pass, const granlaw_surfaces_close_data *contact);
/* What came of it: wanted of all walls and of followed contacts. `place` tells apart meshes that number their triangles alike. */
granlaw_status granlaw_probe_call(granlaw_probe *p, size_t chain, const granlaw_recorded_call *call, size_t place,
                                  bool followed);
/* Surfaces that do not overlap. */
granlaw_status granlaw_probe_across(granlaw_probe *p, size_t chain, const granlaw_recorded_call *call);
/* Whether the time step is too long for a contact of the chain; once for each pair of types. */
bool granlaw_probe_alarm(granlaw_probe *p, size_t chain, granlaw_text *out);
/* The same of the bonds that the particles can have; once for each pair of types, again until there is none. */
bool granlaw_probe_bonds_alarm(granlaw_probe *p, granlaw_text *out);
/* What this rank saw; `p` is used up. */
granlaw_status granlaw_probe_pack(granlaw_probe *p, granlaw_text *out);
/* The texts of all ranks, as one file. */
granlaw_status granlaw_probe_write(const char *path, const granlaw_text *ranks, size_t n);

/* ---- shadow ---- */

typedef struct granlaw_shadow granlaw_shadow;

/* `lanes` as in GRANLAW_LANES; pairs go through the batched pass unless `contact` says one after the other. */
granlaw_status granlaw_shadow_new(const char *lanes, bool contact, granlaw_shadow **out);
granlaw_status granlaw_shadow_chain(granlaw_shadow *s, const granlaw_recorded_chain *chain, size_t *out);
/* A call with LIGGGHTS's answer. */
granlaw_status granlaw_shadow_call(granlaw_shadow *s, size_t chain, const granlaw_recorded_call *call);
/* What this rank saw; `s` is used up. */
granlaw_status granlaw_shadow_pack(granlaw_shadow *s, granlaw_text *out);
/* The parts of all ranks in words, and the exit status that they ask for. */
granlaw_status granlaw_shadow_tell(const granlaw_text *ranks, size_t n, double tolerance, granlaw_text *words, int *status);

#ifdef __cplusplus
}
#endif
#endif
