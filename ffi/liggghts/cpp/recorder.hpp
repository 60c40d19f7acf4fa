// The recorder's half of the boundary; the other half is src/recorder.rs. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_RECORDER_HPP
#define GRANLAW_RECORDER_HPP

#include "adapter.hpp"

extern "C" {
struct granlaw_recorder;
// A law of the recorded chain; index -1 where granlaw lacks it.
struct granlaw_recorded_law {
  int32_t kind, index;
  const char *keyword;
  bool taken_over;
  size_t offset;
  const int32_t *options;
  const double *const *values;
};
// What the head of a trace says.
struct granlaw_recorded_chain {
  const char *path, *liggghts, *deck, *units, *who;
  int32_t rank, ranks;
  uint64_t every;
  size_t types;
  double nktv2p, dt;
  const granlaw_recorded_law *laws;
  size_t n_laws;
  const char *const *slots;
  size_t n_slots;
  bool given[GRANLAW_ATOM_PROPS];  // which properties of single atoms the deck gives
};
// The particles when the recording begins.
struct granlaw_recorded_particles {
  size_t n;
  const int *tag, *type;
  const double *radius, *mass, *x, *v, *omega;
};
// One contact call: what went in and what came out. `before` and `after` hold n_slots numbers each.
struct granlaw_recorded_call {
  const granlaw_pass *pass;
  const granlaw_surfaces_intersect_data *contact;
  bool touch;
  double mi, mj;
  const double *before, *after;
  const granlaw_force_data *i_forces, *j_forces;
};
granlaw_status granlaw_record_open(const granlaw_recorded_chain *chain, granlaw_recorder **out);
granlaw_status granlaw_record_again(granlaw_recorder *r, const granlaw_recorded_chain *chain);
granlaw_status granlaw_record_begin(granlaw_recorder *r, const granlaw_recorded_particles *particles);
granlaw_status granlaw_record_call(granlaw_recorder *r, const granlaw_recorded_call *call);
granlaw_status granlaw_record_close(granlaw_recorder *r);
}
#endif
