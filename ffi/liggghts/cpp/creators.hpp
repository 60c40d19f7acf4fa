// LIGGGHTS's own creators of the properties that it knows. Made from CREATORS in src/core/laws/prop.rs by the test
// the_table_of_creators_is_made_from_the_laws; run it with GRANLAW_BLESS=1. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_CREATORS_HPP
#define GRANLAW_CREATORS_HPP

#include <vector>
#include "global_properties.h"

namespace granlaw {

// One of the three, by the shape of the property.
struct Creator {
  const char *name;
  ScalarPropertyCreator scalar;
  VectorPropertyCreator vector;
  MatrixPropertyCreator matrix;
};
inline const std::vector<Creator> &creators() {
  using namespace MODEL_PARAMS;
  static const std::vector<Creator> all = {
      {"youngsModulus", nullptr, &createYoungsModulus, nullptr},
      {"poissonsRatio", nullptr, &createPoissonsRatio, nullptr},
      {"coefficientRestitution", nullptr, nullptr, &createCoeffRest},
      {"characteristicVelocity", &createCharacteristicVelocity, nullptr, nullptr},
      {"coefficientFriction", nullptr, nullptr, &createCoeffFrict},
      {"coefficientRollingFriction", nullptr, nullptr, &createCoeffRollFrict},
      {"FluidViscosity", nullptr, nullptr, &createCoeffMu},
      {"MaximumRestitution", nullptr, nullptr, &createCoeffRestMax},
      {"CriticalStokes", nullptr, nullptr, &createCoeffStc},
      {"coefficientMaxElasticStiffness", nullptr, nullptr, &createCoeffMaxElasticStiffness},
      {"coefficientAdhesionStiffness", nullptr, nullptr, &createCoeffAdhesionStiffness},
      {"coefficientPlasticityDepth", nullptr, nullptr, &createCoeffPlasticityDepth},
  };
  return all;
}

}  // namespace granlaw
#endif
