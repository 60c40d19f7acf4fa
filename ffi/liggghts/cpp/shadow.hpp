// The shadow of a run, which holds every call against the Rust laws; the other half is src/shadow.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_SHADOW_HPP
#define GRANLAW_SHADOW_HPP

#include <unistd.h>
#include "gather.hpp"
#include "modes.hpp"
#include "boundary.h"

namespace granlaw {

// Holds every call of all chains of this rank against the Rust laws.
class Shadow {
 public:
  // The one of this process, or nullptr if none is asked for.
  static Shadow *of(LAMMPS *lmp) {
    static Shadow *const one = mode().shadow ? new Shadow(lmp) : nullptr;
    if (!one) return nullptr;
    if (lmp->universe->nworlds > 1) lmp->error->all(GRANLAW_HERE, "granlaw cannot shadow a run in partitions; leave -partition out");
    one->lmp_ = lmp;
    return one;
  }

  // A run that LIGGGHTS ends well has its exit status from the shadow.
  static void judge_the_end() {
    on_exit([](int status, void *) {
      if (status != 0 || verdict() == 0) return;
      if (verdict() < 0) fprintf(stderr, "granlaw: nothing was compared, as no pair_style gran or fix wall/gran was made\n");
      fflush(nullptr);
      _exit(verdict() < 0 ? 2 : verdict());
    }, nullptr);
  }

  size_t chain(const granlaw_recorded_chain &chain) {
    size_t at = 0;
    check(granlaw_shadow_chain(shadow_, &chain, &at));
    return at;
  }
  void call(size_t chain, const granlaw_recorded_call &call) { check(granlaw_shadow_call(shadow_, chain, &call)); }

 private:
  explicit Shadow(LAMMPS *lmp) : shadow_(nullptr), lmp_(lmp) {
    if (granlaw_shadow_new(mode().lanes.c_str(), mode().path == Path::contact, &shadow_) != GRANLAW_OK)
      lmp->error->all(GRANLAW_HERE, granlaw_last_error());
    at_the_end(&Shadow::finish, this);
  }

  // The exit status; below 0 as long as there is no shadow.
  static int &verdict() {
    static int status = -1;
    return status;
  }

  static int finish(MPI_Comm, int, void *self, void *) {
    granlaw_text mine = {nullptr, 0}, words = {nullptr, 0};
    granlaw_status status = granlaw_shadow_pack(static_cast<Shadow *>(self)->shadow_, &mine);
    const Gathered all(mine);
    verdict() = 0;
    if (all.texts().empty()) return MPI_SUCCESS;
    if (status == GRANLAW_OK) status = granlaw_shadow_tell(all.texts().data(), all.texts().size(), mode().tolerance, &words, &verdict());
    if (status == GRANLAW_OK) {
      fwrite(words.bytes, 1, words.length, stdout);
      return MPI_SUCCESS;
    }
    fprintf(stderr, "granlaw: %s\n", granlaw_last_error());
    verdict() = 2;
    return MPI_SUCCESS;
  }

  void check(granlaw_status status) {
    if (status != GRANLAW_OK) stop(lmp_, granlaw_last_error());
  }

  granlaw_shadow *shadow_;
  LAMMPS *lmp_;
};

}  // namespace granlaw
#endif
