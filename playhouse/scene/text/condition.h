#pragma once

/// Conditions: predicates on models in world files: "kind=position color=red". Terms are
/// separated by spaces and combined by AND; values with spaces are in single quotes.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// The property that a term tests. Those up to kSays are texts, which may end with * as a wildcard.
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
  std::string text;       // of text properties; without the *
  bool prefix = false;    // it ended with *
  double number = 0;      // of numeric properties, in SI units; of a light: 1 on
  std::uint32_t rgb = 0;  // 0xRRGGBB
  ModelKind kind = ModelKind::kPlain;
};

using Condition = std::vector<Term>;

/// Fails with a message and the nearest valid word.
Result<Condition> read_condition(std::string_view text);

/// Names of the properties, as in files.
std::vector<std::string_view> property_names();

}  // namespace playhouse::scene
