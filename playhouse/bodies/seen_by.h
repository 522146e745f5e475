#pragma once

/// Visibility masks: one bit of a solid for each of what may see it, or be blocked by it. A model's
/// properties are looked up once, when its solids are made; queries test the bit.
///
/// In: the description of a model.
/// Out: the mask of its solids.
/// Cost: constant.

#include <cstdint>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::bodies {

enum class SeenBy : std::uint8_t {
  kMotion,  // motion: it is an obstacle
  kRanger,
  kFiducial,  // it blocks a finder's line of sight
  kImage,     // cameras and blobfinders
  kGripper,   // it can be lifted
  kBumper,    // it presses the switches of a bumper
  kLight,     // it blocks light
  kRadio,     // it attenuates radio
  kCount
};

/// A mask of these.
using SeenByBits = std::uint8_t;
static_assert(static_cast<unsigned>(SeenBy::kCount) <= 8 * sizeof(SeenByBits), "one more needs wider bits");

constexpr SeenByBits bit(SeenBy who) {
  return static_cast<SeenByBits>(1u << static_cast<unsigned>(who));
}

/// The visibility mask of a model's solids.
inline SeenByBits seen_by_of(const scene::ModelDesc& model) {
  unsigned all = bit(SeenBy::kFiducial) | bit(SeenBy::kImage) | bit(SeenBy::kBumper) | bit(SeenBy::kLight) |
                 bit(SeenBy::kRadio);
  if (model.obstacle_return) all |= bit(SeenBy::kMotion);
  if (model.ranger_return >= 0) all |= bit(SeenBy::kRanger);
  if (model.gripper_return) all |= bit(SeenBy::kGripper);
  return static_cast<SeenByBits>(all);
}

}  // namespace playhouse::bodies
