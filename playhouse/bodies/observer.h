#pragma once

/// Visibility masks: one bit of a solid for each kind of observer. A model's
/// properties are looked up once, when its solids are made; queries test the bit.

#include <cstdint>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::bodies {

enum class Observer : std::uint8_t {
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

/// A mask of observers.
using Observers = std::uint8_t;
static_assert(static_cast<unsigned>(Observer::kCount) <= 8 * sizeof(Observers), "one more needs wider bits");

constexpr Observers bit(Observer observer) {
  return static_cast<Observers>(1u << static_cast<unsigned>(observer));
}

/// The visibility mask of a model's solids.
inline Observers observers_of(const scene::ModelDesc& model) {
  unsigned all = bit(Observer::kFiducial) | bit(Observer::kImage) | bit(Observer::kBumper) |
                 bit(Observer::kLight) | bit(Observer::kRadio);
  if (model.obstacle_return) all |= bit(Observer::kMotion);
  if (model.ranger_return >= 0) all |= bit(Observer::kRanger);
  if (model.gripper_return) all |= bit(Observer::kGripper);
  return static_cast<Observers>(all);
}

}  // namespace playhouse::bodies
