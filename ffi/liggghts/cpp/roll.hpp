// Who stood where at the end of a run, to see whether the particles have new numbers at the next. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_ROLL_HPP
#define GRANLAW_ROLL_HPP

#include <array>
#include <map>
#include <vector>
#include "atom.h"

namespace granlaw {

// LIGGGHTS hands history on by the numbers of the two particles. `delete_atoms` gives those that stay new numbers unless
// it is told `compress no`, and then the history of one pair would turn up at another.
class Roll {
 public:
  void take(const LAMMPS_NS::Atom *atom) {
    tags_.assign(atom->tag, atom->tag + atom->nlocal);
    places_.resize(tags_.size());
    for (size_t k = 0; k < tags_.size(); k++) places_[k] = place(atom, k);
  }

  // Whether a particle stands where one of another number stood.
  bool renumbered(const LAMMPS_NS::Atom *atom) const {
    if (std::vector<int>(atom->tag, atom->tag + atom->nlocal) == tags_) return false;
    std::map<Place, int> stood;
    for (size_t k = 0; k < tags_.size(); k++) stood[places_[k]] = tags_[k];
    for (int i = 0; i < atom->nlocal; i++) {
      const auto was = stood.find(place(atom, i));
      if (was != stood.end() && was->second != atom->tag[i]) return true;
    }
    return false;
  }

 private:
  typedef std::array<double, 3> Place;
  static Place place(const LAMMPS_NS::Atom *atom, size_t i) { return {atom->x[i][0], atom->x[i][1], atom->x[i][2]}; }

  std::vector<int> tags_;
  std::vector<Place> places_;
};

}  // namespace granlaw
#endif
