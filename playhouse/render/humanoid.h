#pragma once

/// A person: a procedural skinned mesh, with its poses: standing, walking, stepping in place, waving. Pure
/// functions. Frame: the person's own, feet on z = 0, x ahead, y left; lengths are fractions of the person's
/// height.
///
/// Source: proportions of limbs after Winter, "Biomechanics and Motor Control of Human Movement", figure 4.1.

#include <array>
#include <cstdint>
#include <vector>

#include "playhouse/geom/orientation.h"

namespace playhouse::render {

struct Humanoid {
  enum Bone : std::uint8_t {
    kPelvis,
    kSpine,
    kChest,
    kHead,
    kLeftArm,
    kLeftForearm,
    kLeftHand,
    kRightArm,
    kRightForearm,
    kRightHand,
    kLeftThigh,
    kLeftShin,
    kLeftFoot,
    kRightThigh,
    kRightShin,
    kRightFoot,
    kBones
  };
  struct Corner {
    std::array<float, 3> p, normal;
    std::array<float, 4> paint;  // linear RGB; weight of the clothes' colour
    std::uint8_t bone[2] = {};   // skinned to both
    float share = 1;             // weight of the first
  };
  std::vector<Corner> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

/// Levels of detail; 0 is the finest.
inline constexpr int kHumanoidLevels = 3;
Humanoid make_humanoid(int level);

/// Pose parameters of a person.
struct Gait {
  double phase = 0;    // of the gait cycle; 2 pi: a left and a right step  [rad]
  double stride = 0;   // length of a gait cycle, negative: backwards. Fraction of the height
  bool turns = false;  // steps in place
  bool waves = false;  // with the right hand
  double age = 0;      // phase of breathing and waving  [s]
};

/// Skinning matrices, from bind pose to gait: rows of 3 x 4 matrices.
using BoneRows = std::array<std::array<float, 12>, Humanoid::kBones>;
BoneRows pose_humanoid(const Gait& gait);

}  // namespace playhouse::render
