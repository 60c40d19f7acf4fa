// What all ranks have to say at the end of a run. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_GATHER_HPP
#define GRANLAW_GATHER_HPP

#include <mpi.h>
#include <vector>
#include "boundary.h"

namespace granlaw {

// MPI calls `done` first thing in MPI_Finalize, while messages can still be sent: the one moment that every way to end a run
// in order has in common: the end of the deck, `quit`, and errors that all ranks agree on.
inline void at_the_end(MPI_Comm_delete_attr_function *done, void *self) {
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, done, &key, nullptr);
  MPI_Comm_set_attr(MPI_COMM_SELF, key, self);
}

// The texts of all ranks on the first one; none on the others.
class Gathered {
 public:
  explicit Gathered(const granlaw_text &mine) {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const int length = static_cast<int>(mine.length);
    std::vector<int> lengths(ranks), starts(ranks);
    MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    for (int k = 1; k < ranks; k++) starts[k] = starts[k - 1] + lengths[k - 1];
    all_.resize(rank ? 1 : starts[ranks - 1] + lengths[ranks - 1] + 1);
    MPI_Gatherv(mine.bytes, length, MPI_CHAR, all_.data(), lengths.data(), starts.data(), MPI_CHAR, 0, MPI_COMM_WORLD);
    for (int k = 0; rank == 0 && k < ranks; k++) texts_.push_back({all_.data() + starts[k], static_cast<size_t>(lengths[k])});
  }
  const std::vector<granlaw_text> &texts() const { return texts_; }

 private:
  std::vector<char> all_;
  std::vector<granlaw_text> texts_;
};

}  // namespace granlaw
#endif
