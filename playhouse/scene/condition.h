#pragma once

/// Conditions: what a model has to be like, as a world file says it: "kind=position color=red". Terms stand
/// between spaces, and all of them have to hold; a value with spaces is put in single quotes.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// What a term speaks of. Those up to kSays are texts, which may end with * for any rest.
enum class Property : std::uint8_t {
  kName,
  kMaterial,
  kSays,
  kKind,
  kColor,
  kLight,
  kSpeed,
  kFiducialReturn,
  kRangerReturn,
  kGripperReturn,
  kObstacleReturn,
  kMass,
};

struct Term {
  enum class Compare : std::uint8_t { kIs, kIsNot, kBelow, kAbove };

  Property property = Property::kName;
  Compare compare = Compare::kIs;
  std::string text;       // of texts; without the *
  bool prefix = false;    // it had one
  double number = 0;      // of numbers, in SI units; 1 of a light: one that is off is not on
  std::uint32_t rgb = 0;  // 0xRRGGBB
  ModelKind kind = ModelKind::kPlain;
};

using Condition = std::vector<Term>;

/// Fails with what is wrong, and the nearest valid word.
Result<Condition> read_condition(std::string_view text);

/// The properties that terms may speak of, as files have them.
std::vector<std::string_view> property_names();

}  // namespace playhouse::scene
