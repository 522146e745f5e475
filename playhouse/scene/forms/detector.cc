#include "playhouse/scene/forms/detector.h"

#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/properties.h"
#include "playhouse/scene/text/condition.h"

namespace playhouse::scene {
namespace {

void check_conditions(const Properties& properties, std::string_view key,
                      std::span<const std::string> texts) {
  for (const std::string& text : texts) {
    const Result<Condition> condition = read_condition(text);
    if (condition) continue;
    properties.state().fail(properties.where(key), in_quotes(key) + " " + condition.error().text);
  }
}

}  // namespace

std::size_t lines_of(const DetectorDesc& detector) {
  return std::size_t{detector.samples} * detector.rays * detector.layers;
}

void check_detector(const Properties& properties, const DetectorDesc& detector) {
  check_conditions(properties, "sees", detector.sees);
  check_conditions(properties, "through", detector.through);
}

}  // namespace playhouse::scene
