#include "playhouse/scene/forms/charge.h"

#include <algorithm>
#include <optional>

namespace playhouse::scene {
namespace {

constexpr double kKilo = 1000;

void fill(Charge& charge, const std::optional<double>& energy, double scale) {
  if (energy) charge = {*energy * scale, *energy * scale};
}

void limit(Charge& charge, const std::optional<double>& capacity, double scale) {
  if (capacity) charge = {std::min(charge.stored, *capacity * scale), *capacity * scale};
}

}  // namespace

Charge charge_of(const PlainDesc& model) {
  Charge charge;
  fill(charge, model.joules, 1);
  limit(charge, model.joules_capacity, 1);
  fill(charge, model.kjoules, kKilo);
  limit(charge, model.kjoules_capacity, kKilo);
  return charge;
}

}  // namespace playhouse::scene
