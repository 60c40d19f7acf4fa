/* granlaw: contact laws for granular simulation behind a C interface.
 *
 * The verbs and their order are those of a LIGGGHTS model header:
 *   descriptor -> prepare (registerSettings + connectToProperties) -> begin_pass -> surfaces_intersect | surfaces_close
 *   -> end_pass -> free.
 * Units are SI unless the deck says otherwise (nktv2p). Nothing here throws, aborts or prints.
 * Every call that can fail returns a granlaw_status; granlaw_last_error() then says what, which, allowed and what to do.
 * Strings and descriptors live as long as the library. A chain belongs to one thread at a time.
 *
 * SPDX-License-Identifier: GPL-2.0-or-later */
#ifndef GRANLAW_H
#define GRANLAW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Goes up whenever a struct or the meaning of a call changes. Compare with granlaw_abi_version(). */
#define GRANLAW_ABI_VERSION 3

/* How a call ended. */
typedef int32_t granlaw_status;
enum {
  GRANLAW_OK = 0,         /* done */
  GRANLAW_REFUSED = 1,    /* the set-up makes no sense: a property, a setting, a combination */
  GRANLAW_NON_FINITE = 2, /* a contact with NaN or infinite kinematics; nothing was changed */
  GRANLAW_MISUSE = 3,     /* a null pointer or an index out of range */
  GRANLAW_BUG = 4         /* an internal error that was stopped at the boundary; please report it */
};

/* ---- descriptor: what a law says of itself ---- */

/* Kinds of law, in the order in which they run over a contact. The contact flag of kind k is 1 << k. */
enum { GRANLAW_NORMAL = 0, GRANLAW_COHESION = 1, GRANLAW_TANGENTIAL = 2, GRANLAW_ROLLING = 3 };

/* For how many types a property is given. */
enum { GRANLAW_SCALAR = 0, GRANLAW_PER_TYPE = 1, GRANLAW_PER_PAIR = 2 };

/* How far a setting is supported. */
enum {
  GRANLAW_SUPPORT_FULL = 0,          /* under both names */
  GRANLAW_SUPPORT_OWN_ONLY = 1,      /* not offered under a stock name that was taken over */
  GRANLAW_SUPPORT_STOCK_IGNORES = 2, /* no effect under a stock name that was taken over, as in stock; warn */
  GRANLAW_SUPPORT_REFUSED = 3        /* known to LIGGGHTS; refused unless at option 0 */
};

/* A material property. */
typedef struct granlaw_prop {
  const char *name;                  /* as in fix property/global */
  const char *symbol;                /* for people */
  const char *unit;                  /* SI */
  const char *doc;                   /* for people */
  int32_t shape;                     /* GRANLAW_SCALAR, ... */
  double lo, hi;                     /* allowed range; may be infinite */
  bool open_lo, open_hi;             /* whether the ends themselves are refused */
  double usual_lo, usual_hi;         /* what people use; never a reason to refuse */
} granlaw_prop;

/* A setting: a word followed by one of its options. */
typedef struct granlaw_setting {
  const char *name;
  const char *const *options;        /* n_options strings; options[0] is "off" for a switch */
  size_t n_options;
  int32_t default_option;            /* index, or -1 where the deck must choose */
  int32_t support;                   /* GRANLAW_SUPPORT_... */
  const char *doc;                   /* what it does, or why it is refused */
} granlaw_setting;

/* One number of contact history. */
typedef struct granlaw_slot {
  const char *name;
  const char *newton;                /* "0": even; "1": changes sign when i and j change places */
  const char *unit;
  bool always;                       /* whether there is room for it whatever the settings; else ask granlaw_needs_slot */
} granlaw_slot;

/* How many numbers per atom there are room for in granlaw_pass: those that laws read, and those that they add to. */
enum { GRANLAW_ATOM_PROPS = 1, GRANLAW_ATOM_OUTPUTS = 1 };

/* A number per atom. */
typedef struct granlaw_atom_prop {
  const char *name;                  /* as in fix property/atom */
  const char *doc;
  size_t place;                      /* where it stands in granlaw_pass.given or granlaw_pass.outputs */
} granlaw_atom_prop;

/* A law. */
typedef struct granlaw_law {
  int32_t kind;                      /* GRANLAW_NORMAL, ... */
  const char *keyword;               /* LIGGGHTS's name */
  const char *own_keyword;           /* ours: keyword + "/rs" */
  int32_t id;                        /* number of own_keyword, 48 to 63 */
  int32_t stock_id;                  /* number of LIGGGHTS's law of that name, or -1 */
  const char *summary;
  double stress_strain_exponent;     /* n of F ~ delta^n for a normal law, else 0 */
  bool beyond_contact;               /* whether surfaces_close may return a force */
  bool coarse_graining;              /* whether it is consistent under LIGGGHTS's coarse-graining */
  const granlaw_prop *props;
  size_t n_props;
  const granlaw_setting *settings;
  size_t n_settings;
  const granlaw_atom_prop *atoms;    /* what it reads of each atom where the deck gives it */
  size_t n_atoms;
  const granlaw_atom_prop *outputs;  /* what it adds to each atom in every evaluation */
  size_t n_outputs;
  bool anchors;                      /* whether it holds particles to a point of a wall */
  const char *bonds;                 /* what it calls the bonds that it keeps; NULL if it keeps none */
  const granlaw_slot *slots;
  size_t n_slots;
} granlaw_law;

/* The version that the library was built with: GRANLAW_ABI_VERSION of its own header. */
uint32_t granlaw_abi_version(void);
/* The version of the package, for instance "0.1.0". */
const char *granlaw_version(void);
/* How many laws there are. */
size_t granlaw_law_count(void);
/* The law with index `law`; NULL beyond the last. */
const granlaw_law *granlaw_law_at(size_t law);
/* Whether property `prop` must be given when the settings stand at `options` (one index per setting, -1: default). */
bool granlaw_needs_property(size_t law, bool taken_over, const int32_t *options, size_t prop);

/* Whether the law does what the settings ask for, before its properties are known; granlaw_prepare checks it again. */
granlaw_status granlaw_check_settings(size_t law, bool taken_over, const int32_t *options);
/* Whether there is room for slot `slot` in a row of history when the settings stand at `options`. */
bool granlaw_needs_slot(size_t law, bool taken_over, const int32_t *options, size_t slot);

/* ---- prepare ---- */

/* One law of a chain, with what the deck says of it. */
typedef struct granlaw_choice {
  size_t law;                        /* index for granlaw_law_at */
  bool taken_over;                   /* stands in for LIGGGHTS's law of the same name */
  const int32_t *options;            /* one index per setting, -1: default; NULL: all default */
  const double *const *values;       /* per property: 1, n_types or n_types^2 numbers (row by row), NULL if not given */
  size_t history_offset;             /* first slot of this law in a contact's row of history; no two may overlap */
  const int32_t *history_places;     /* place of each slot of the descriptor in the row, -1 where it has none;
                                        NULL: one behind the other from history_offset */
} granlaw_choice;

/* A chain to be prepared. Everything is copied; nothing needs to outlive the call. */
typedef struct granlaw_setup {
  const granlaw_choice *laws;        /* in the order of the kinds, at most one of each */
  size_t n_laws;
  size_t n_types;                    /* atom types; type t of the simulation is index t - 1 here */
  double nktv2p;                     /* pressure to force per area in the deck's units; 1 in SI */
} granlaw_setup;

/* Laws prepared for all pairs of types. */
typedef struct granlaw_chain granlaw_chain;

/* Prepare a chain into *out. On failure *out is NULL. */
granlaw_status granlaw_prepare(const granlaw_setup *setup, granlaw_chain **out);
/* Free a chain; NULL is allowed. */
void granlaw_free(granlaw_chain *chain);

/* What the user should know of a set-up that is allowed but asks for trouble; NULL beyond the last. Lives as the chain. */
const char *granlaw_remark(const granlaw_chain *chain, size_t k);
/* Up to which multiple of the sum of radii contacts must be found, 1 to 10; `rmin` is the smallest radius [m]. */
granlaw_status granlaw_contact_distance_factor(const granlaw_chain *chain, double rmin, double *out);

/* What is known of a wall before the run. */
typedef struct granlaw_wall {
  double skin;                       /* gap beyond which it lists no particle [m]; infinite if it looks as far as asked */
  bool turns;                        /* whether it turns or changes its shape */
} granlaw_wall;

/* Whether the wall lets the laws do what they do. */
granlaw_status granlaw_check_wall(const granlaw_chain *chain, const granlaw_wall *wall, double rmin);

/* ---- contacts: these structs mirror LIGGGHTS 3.8's contact_interface.h, field by field ---- */

/* LIGGGHTS: SurfacesCloseData. */
typedef struct granlaw_surfaces_close_data {
  double radi;                       /* radius of i [m] */
  double radj;                       /* radius of j [m]; not read for a wall */
  double radsum;                     /* their sum [m] */
  double rsq;                        /* squared distance [m2] */
  double delta[3];                   /* from j to i [m] */
  double area_ratio;                 /* share of a wall contact that counts; 1 for a pair */
  int *contact_flags;                /* in and out; may be NULL */
  double *contact_history;           /* in and out; NULL if the chain has none */
  void *mesh;                        /* not read */
  void *fix_mesh;                    /* not read */
  int i, j;                          /* indices into the arrays of granlaw_pass; j < 0 or a triangle for a wall */
  int itype, jtype;                  /* atom types, from 1 */
  bool is_wall;
  bool has_force_update;             /* out: surfaces_close has a force */
  double *v_i, *v_j;                 /* velocities [m/s] */
  double *omega_i, *omega_j;         /* spins [rad/s]; omega_j is not read for a wall */
  bool is_non_spherical;             /* not read */
  int computeflag, shearupdate;      /* history is written only when both are set */
} granlaw_surfaces_close_data;

/* LIGGGHTS: SurfacesIntersectData, which extends SurfacesCloseData. */
typedef struct granlaw_surfaces_intersect_data {
  granlaw_surfaces_close_data close;
  double r, rinv;                    /* distance [m] and its inverse */
  double en[3];                      /* unit normal, from j to i */
  double kt, kn;                     /* stiffnesses [N/m]: out by a normal law, in for the others */
  double gammat, gamman;             /* dampings [N s/m]: likewise */
  double Fn, Ft;                     /* normal force [N]: likewise; Ft is not used */
  double vn;                         /* normal relative velocity [m/s], negative while approaching */
  double deltan;                     /* overlap [m] */
  double cri, crj;                   /* distance of the contact from either centre [m] */
  double wr1, wr2, wr3;              /* spin of the surfaces over the distance [rad/s] */
  double vtr1, vtr2, vtr3;           /* tangential relative velocity [m/s] */
  double mi, mj, meff;               /* masses and effective mass [kg] */
  double P_diss;                     /* not used */
} granlaw_surfaces_intersect_data;

/* LIGGGHTS: ForceData: what the laws of this contact have given so far. Added to; a law that keeps bonds may replace it. */
typedef struct granlaw_force_data {
  double delta_F[3];                 /* [N] */
  double delta_torque[3];            /* [N m] */
} granlaw_force_data;

/* What holds for a whole pass over the contacts. The arrays must stay valid until the next begin_pass. */
typedef struct granlaw_pass {
  double dt;                         /* time step [s] */
  int64_t step;                      /* its number */
  const double *x;                   /* positions, 3 per particle [m] */
  const int *tag;                    /* numbers of the particles */
  const int *mask;                   /* group bits of the particles; not read where frozen is 0 */
  int frozen;                        /* group bit of the particles that are held in place; 0 for none */
  int n_local;                       /* particles of this rank: lower indices; a pair with another is counted once */
  const double *given[GRANLAW_ATOM_PROPS]; /* one number per particle, NULL where the deck gives none */
  double *outputs[GRANLAW_ATOM_OUTPUTS];   /* one number per particle, added to; NULL where nobody wants them */
} granlaw_pass;

/* Once before the contacts of a step, and before any single wall contact. */
granlaw_status granlaw_begin_pass(granlaw_chain *chain, const granlaw_pass *pass);
/* The surfaces overlap: run the laws, add to the forces, write kn, kt, gamman, gammat, Fn, history and flags. */
granlaw_status granlaw_surfaces_intersect(granlaw_chain *chain, granlaw_surfaces_intersect_data *contact,
                                          granlaw_force_data *i_forces, granlaw_force_data *j_forces);
/* They do not. `mi` and `mj` are the masses [kg], which SurfacesCloseData lacks; `mj` is not read for a wall. */
granlaw_status granlaw_surfaces_close(granlaw_chain *chain, granlaw_surfaces_close_data *gap, double mi, double mj,
                                      granlaw_force_data *i_forces, granlaw_force_data *j_forces);
/* After the contacts of a step. */
granlaw_status granlaw_end_pass(granlaw_chain *chain);

/* The bonds that a chain has seen since it was prepared. */
typedef struct granlaw_bonds {
  uint64_t begun, ended;             /* how many began and ended */
  uint64_t there;                    /* how many there were in step `step` */
  int64_t step;                      /* the step that was counted last */
} granlaw_bonds;
granlaw_status granlaw_count_bonds(const granlaw_chain *chain, granlaw_bonds *out);

/* Why the last failing call of this thread failed; never NULL, valid until the next failing call of the thread. */
const char *granlaw_last_error(void);

#ifdef __cplusplus
}
#endif
#endif
