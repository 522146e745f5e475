#pragma once

/// Battery charge of a model from its description.

#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

struct Charge {
  double stored = 0;    // J; negative: unlimited
  double capacity = 0;  // J
};

/// Initial charge. Words are applied in the order joules, joules_capacity, kjoules,
/// kjoules_capacity, whatever the file's: energy fills the battery, a smaller capacity truncates it.
Charge charge_of(const PlainDesc& model);

}  // namespace playhouse::scene
