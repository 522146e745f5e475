// The mesh of people, and how it walks.

#include "playhouse/render/humanoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace playhouse::render {
namespace {

using geom::Vec3;

Vec3 at(const Humanoid& humanoid, std::uint32_t corner) {
  const auto& p = humanoid.corners[corner].p;
  return {p[0], p[1], p[2]};
}

Vec3 moved(const std::array<float, 12>& rows, const Vec3& p) {
  return {rows[0] * p.x + rows[1] * p.y + rows[2] * p.z + rows[3],
          rows[4] * p.x + rows[5] * p.y + rows[6] * p.z + rows[7],
          rows[8] * p.x + rows[9] * p.y + rows[10] * p.z + rows[11]};
}

/// Where a corner is in a gait.
Vec3 bent(const Humanoid& humanoid, const BoneRows& rows, std::uint32_t corner) {
  const Humanoid::Corner& c = humanoid.corners[corner];
  const Vec3 a = moved(rows[c.bone[0]], at(humanoid, corner)),
             b = moved(rows[c.bone[1]], at(humanoid, corner));
  return static_cast<double>(c.share) * a + (1.0 - c.share) * b;
}

/// The middle of a bone's corners in a gait.
Vec3 middle_of(const Humanoid& humanoid, const BoneRows& rows, Humanoid::Bone bone) {
  Vec3 sum;
  double count = 0;
  for (std::uint32_t i = 0; i < humanoid.corners.size(); ++i) {
    if (humanoid.corners[i].bone[0] != bone || humanoid.corners[i].bone[1] != bone) continue;
    sum = sum + bent(humanoid, rows, i);
    ++count;
  }
  return (1 / count) * sum;
}

double lowest(const Humanoid& humanoid, const BoneRows& rows) {
  double z = 1e300;
  for (std::uint32_t i = 0; i < humanoid.corners.size(); ++i) z = std::min(z, bent(humanoid, rows, i).z);
  return z;
}

TEST(Humanoid, is_closed_and_its_faces_look_outwards_at_each_level) {
  std::size_t triangles = 1u << 20;
  for (int level = 0; level < kHumanoidLevels; ++level) {
    const Humanoid humanoid = make_humanoid(level);
    EXPECT_LT(4 * humanoid.triangles.size(), 3 * triangles) << "coarser";
    triangles = humanoid.triangles.size();
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (const auto& [a, b, c] : humanoid.triangles) {
      for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) ++edges[{from, to}];
      volume += dot(at(humanoid, a), cross(at(humanoid, b), at(humanoid, c))) / 6;
    }
    for (const auto& [edge, count] : edges) EXPECT_EQ((edges[{edge.second, edge.first}]), count);
    // A person of 1.75 m and 70 kg has 0.07 m^3, or 0.013 cubes of the height.
    EXPECT_GT(volume, 0.009);
    EXPECT_LT(volume, 0.020);
    for (const Humanoid::Corner& corner : humanoid.corners) {
      EXPECT_GE(corner.p[2], -1e-3);
      EXPECT_LE(corner.p[2], 1.001);
      const auto& n = corner.normal;
      EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-4);
    }
  }
  EXPECT_LT(triangles, 1000u);
}

TEST(Humanoid, stands_as_it_is_made_and_on_the_ground_in_every_step) {
  const Humanoid humanoid = make_humanoid(1);
  EXPECT_NEAR(lowest(humanoid, pose_humanoid({})), 0, 0.01);
  for (int k = 0; k < 24; ++k)
    for (const double stride : {0.3, 0.8, 1.2, -0.5}) {
      const BoneRows rows = pose_humanoid({2 * geom::kPi * k / 24, stride});
      EXPECT_NEAR(lowest(humanoid, rows), 0, 0.02) << k << " " << stride;
      for (const auto& row : rows) {
        const Vec3 x{row[0], row[4], row[8]}, y{row[1], row[5], row[9]}, z{row[2], row[6], row[10]};
        EXPECT_NEAR(dot(x, x), 1, 1e-5);
        EXPECT_NEAR(dot(x, y), 0, 1e-5);
        EXPECT_NEAR(dot(cross(x, y), z), 1, 1e-5);
      }
    }
}

TEST(Humanoid, the_foot_that_bears_stays_where_it_is_while_the_body_goes_on) {
  // A stride is made in 2 pi; halfway, the left foot is under the body and moves back as fast as that goes
  // on.
  for (const double stride : {0.4, 0.8}) {
    const auto foot = [&](double phase) {
      return moved(pose_humanoid({phase, stride})[Humanoid::kLeftFoot], {0.02, 0.052, 0});
    };
    const double step = 0.3, way = foot(geom::kPi + step).x - foot(geom::kPi - step).x;
    EXPECT_NEAR(way, -stride * 2 * step / (2 * geom::kPi), 0.75 * stride * 2 * step / (2 * geom::kPi));
    EXPECT_LT(foot(geom::kPi).z, foot(0).z - 0.01) << "the other way it is in the air";
  }
}

TEST(Humanoid, waves_its_right_hand_beside_the_head_and_keeps_the_left_one_down) {
  const Humanoid humanoid = make_humanoid(0);
  double least = 1e300, most = -1e300;
  for (int k = 0; k < 12; ++k) {
    const BoneRows rows = pose_humanoid({.waves = true, .age = 0.05 * k});
    const Vec3 right = middle_of(humanoid, rows, Humanoid::kRightHand),
               left = middle_of(humanoid, rows, Humanoid::kLeftHand);
    EXPECT_GT(right.z, 0.95);
    EXPECT_LT(right.y, -0.15) << "not in front of the head";
    EXPECT_LT(left.z, 0.5);
    least = std::min(least, right.y);
    most = std::max(most, right.y);
  }
  EXPECT_GT(most - least, 0.1) << "it moves";
}

TEST(Humanoid, lifts_one_foot_after_the_other_when_it_turns_in_place) {
  const Humanoid humanoid = make_humanoid(0);
  double left = 0, right = 0;
  for (int k = 0; k < 24; ++k) {
    const BoneRows rows = pose_humanoid({.phase = 2 * geom::kPi * k / 24, .turns = true});
    EXPECT_NEAR(lowest(humanoid, rows), 0, 0.02) << k;
    const double of_left = middle_of(humanoid, rows, Humanoid::kLeftFoot).z,
                 of_right = middle_of(humanoid, rows, Humanoid::kRightFoot).z;
    EXPECT_LT(std::min(of_left, of_right), 0.03) << "the other one stands";
    left = std::max(left, of_left);
    right = std::max(right, of_right);
  }
  EXPECT_GT(left, 0.04);
  EXPECT_NEAR(right, left, 1e-3);
}

TEST(Humanoid, breathes_when_it_stands) {
  const Humanoid humanoid = make_humanoid(0);
  const auto head = [&](double age) {
    return middle_of(humanoid, pose_humanoid({.age = age}), Humanoid::kHead).x;
  };
  EXPECT_GT(std::fabs(head(1) - head(3)), 0.002);
}

}  // namespace
}  // namespace playhouse::render
