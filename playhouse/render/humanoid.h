#pragma once

/// A person: a mesh that bends with bones, made here, and how it stands and walks. Pure functions. Frame: the
/// person's own, its feet on z = 0, x ahead, y to the left; all lengths are shares of the person's height.
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
    std::array<float, 4> paint;  // linear red, green, blue; share of the colour of the person's clothes
    std::uint8_t bone[2] = {};   // it bends with both
    float share = 1;             // of the first
  };
  std::vector<Corner> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

/// The finest has the level 0; there are three.
inline constexpr int kHumanoidLevels = 3;
Humanoid make_humanoid(int level);

/// How a person stands at a moment.
struct Gait {
  double phase = 0;   // of its steps; 2 pi are a left and a right one  [rad]
  double stride = 0;  // that a left and a right step make together; below 0: backwards. Shares of the height
};

/// Turns and moves of bones, from where the mesh has them to where the gait has them: rows of 3 x 4 matrices.
using BoneRows = std::array<std::array<float, 12>, Humanoid::kBones>;
BoneRows pose_humanoid(const Gait& gait);

}  // namespace playhouse::render
