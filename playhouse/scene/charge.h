#pragma once

/// What the words of a model say of the charge of its battery.

#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

struct Charge {
  double stored = 0;    // J; below 0 it never ends
  double capacity = 0;  // J
};

/// At the start. The words count in the order joules, joules_capacity, kjoules, kjoules_capacity, wherever a
/// file has them: energy fills a battery, a capacity below it takes the rest away.
Charge charge_of(const PlainDesc& model);

}  // namespace playhouse::scene
