#include "playhouse/render/humanoid.h"

#include <algorithm>
#include <cmath>

namespace playhouse::render {
namespace {

using geom::Vec3;
using Bone = Humanoid::Bone;

constexpr double kPi = geom::kPi;
constexpr double kThigh = 0.245, kShin = 0.236;                // lengths
constexpr double kHip = 0.53, kAnkle = kHip - kThigh - kShin;  // heights
constexpr double kLongestSwing = 0.75;                         // rad, of a thigh
constexpr double kStepInPlace = 0.4;                           // rad, by which a thigh is raised
constexpr double kBreaths = 0.25, kWaves = 1.7;                // Hz

struct Paint {
  float r, g, b, share;  // as Humanoid::Corner::paint
};
constexpr Paint kSkin{0.60f, 0.34f, 0.22f, 0}, kHair{0.05f, 0.03f, 0.02f, 0}, kShirt{0, 0, 0, 1};
constexpr Paint kTrousers{0.035f, 0.045f, 0.075f, 0}, kShoes{0.02f, 0.02f, 0.02f, 0};

/// A cross-section of a tube.
struct Ring {
  Vec3 middle;
  double u, v;  // half extents along the two axes of the tube
  Paint paint;
  Bone bone, other;
  double share = 1;  // weight of the first bone
};

/// A loft along rings with axes u and v; u x v points from the first ring to the last.
struct Tube {
  Vec3 u, v;
  std::vector<Ring> rings;
};

Tube torso() {
  const auto at = [](double z, double x, double deep, double wide, Paint paint, Bone bone, Bone other,
                     double share) {
    return Ring{{x, 0, z}, deep, wide, paint, bone, other, share};
  };
  return {{1, 0, 0},
          {0, 1, 0},
          {at(0.455, 0, 0.030, 0.045, kTrousers, Bone::kPelvis, Bone::kPelvis, 1),
           at(0.480, 0, 0.055, 0.085, kTrousers, Bone::kPelvis, Bone::kPelvis, 1),
           at(0.520, -0.004, 0.066, 0.098, kTrousers, Bone::kPelvis, Bone::kPelvis, 1),
           at(0.560, -0.002, 0.062, 0.092, kTrousers, Bone::kPelvis, Bone::kSpine, 0.7),
           at(0.575, -0.002, 0.062, 0.090, kShirt, Bone::kPelvis, Bone::kSpine, 0.6),
           at(0.620, 0, 0.056, 0.080, kShirt, Bone::kSpine, Bone::kPelvis, 0.8),
           at(0.680, 0.002, 0.062, 0.088, kShirt, Bone::kSpine, Bone::kChest, 0.6),
           at(0.740, 0.004, 0.070, 0.100, kShirt, Bone::kChest, Bone::kSpine, 0.9),
           at(0.785, 0.002, 0.064, 0.108, kShirt, Bone::kChest, Bone::kChest, 1),
           at(0.815, -0.002, 0.052, 0.098, kShirt, Bone::kChest, Bone::kChest, 1),
           at(0.835, -0.004, 0.038, 0.060, kShirt, Bone::kChest, Bone::kChest, 1),
           at(0.845, -0.004, 0.032, 0.036, kSkin, Bone::kChest, Bone::kHead, 0.7),
           at(0.875, 0.000, 0.029, 0.030, kSkin, Bone::kHead, Bone::kChest, 0.7)}};
}

Tube head() {
  const auto at = [](double z, double x, double deep, double wide, Paint paint) {
    return Ring{{x, 0, z}, deep, wide, paint, Bone::kHead, Bone::kHead, 1};
  };
  return {{1, 0, 0},
          {0, 1, 0},
          {at(0.866, 0.014, 0.012, 0.010, kSkin), at(0.872, 0.014, 0.034, 0.026, kSkin),
           at(0.890, 0.012, 0.046, 0.036, kSkin), at(0.915, 0.010, 0.053, 0.042, kSkin),
           at(0.940, 0.006, 0.056, 0.044, kSkin), at(0.944, 0.003, 0.059, 0.046, kHair),
           at(0.965, 0.001, 0.056, 0.044, kHair), at(0.985, 0.000, 0.043, 0.034, kHair),
           at(0.997, 0.000, 0.020, 0.016, kHair), at(1.000, 0.000, 0.004, 0.004, kHair)}};
}

/// The back of the head, covered by hair.
Tube hair() {
  const auto at = [](double z, double deep, double wide) {
    return Ring{{-0.012, 0, z}, deep, wide, kHair, Bone::kHead, Bone::kHead, 1};
  };
  return {
      {1, 0, 0},
      {0, 1, 0},
      {at(0.895, 0.010, 0.012), at(0.900, 0.034, 0.034), at(0.925, 0.045, 0.043), at(0.950, 0.046, 0.045)}};
}

/// From the hand upwards, as lofts are built; `side` is 1 for the left arm.
Tube arm(double side) {
  const Bone upper = side > 0 ? Bone::kLeftArm : Bone::kRightArm,
             fore = side > 0 ? Bone::kLeftForearm : Bone::kRightForearm;
  const Bone hand = side > 0 ? Bone::kLeftHand : Bone::kRightHand;
  const auto at = [&](double z, double y, double deep, double wide, Paint paint, Bone bone, Bone other,
                      double share) {
    return Ring{{0, side * y, z}, deep, wide, paint, bone, other, share};
  };
  return {{1, 0, 0},
          {0, 1, 0},
          {at(0.385, 0.140, 0.010, 0.006, kSkin, hand, hand, 1),
           at(0.395, 0.140, 0.021, 0.011, kSkin, hand, hand, 1),
           at(0.430, 0.139, 0.026, 0.014, kSkin, hand, hand, 1),
           at(0.460, 0.137, 0.022, 0.014, kSkin, hand, fore, 0.8),
           at(0.485, 0.136, 0.017, 0.015, kSkin, fore, hand, 0.6),
           at(0.540, 0.133, 0.023, 0.022, kSkin, fore, fore, 1),
           at(0.600, 0.129, 0.027, 0.026, kSkin, fore, fore, 1),
           at(0.632, 0.127, 0.026, 0.025, kSkin, fore, upper, 0.5),
           at(0.660, 0.126, 0.027, 0.026, kSkin, upper, fore, 0.85),
           at(0.672, 0.125, 0.033, 0.031, kShirt, upper, upper, 1),
           at(0.730, 0.120, 0.034, 0.031, kShirt, upper, upper, 1),
           at(0.785, 0.113, 0.037, 0.033, kShirt, upper, Bone::kChest, 0.8),
           at(0.815, 0.104, 0.032, 0.030, kShirt, upper, Bone::kChest, 0.5),
           at(0.828, 0.092, 0.016, 0.018, kShirt, Bone::kChest, upper, 0.7)}};
}

Tube leg(double side) {
  const Bone thigh = side > 0 ? Bone::kLeftThigh : Bone::kRightThigh,
             shin = side > 0 ? Bone::kLeftShin : Bone::kRightShin;
  const auto at = [&](double z, double x, double deep, double wide, Bone bone, Bone other, double share) {
    return Ring{{x, side * (0.050 + 0.012 * (z - kAnkle)), z}, deep, wide, kTrousers, bone, other, share};
  };
  return {
      {1, 0, 0},
      {0, 1, 0},
      {at(0.040, -0.008, 0.026, 0.024, shin, shin, 1), at(0.055, -0.008, 0.028, 0.026, shin, shin, 1),
       at(0.110, -0.008, 0.029, 0.027, shin, shin, 1), at(0.190, -0.010, 0.036, 0.033, shin, shin, 1),
       at(0.250, -0.003, 0.036, 0.034, shin, thigh, 0.85), at(0.285, 0.002, 0.037, 0.035, thigh, shin, 0.5),
       at(0.320, 0.002, 0.040, 0.037, thigh, shin, 0.9), at(0.400, 0.002, 0.050, 0.044, thigh, thigh, 1),
       at(0.470, 0.000, 0.058, 0.048, thigh, Bone::kPelvis, 0.8),
       at(0.520, 0.000, 0.056, 0.044, thigh, Bone::kPelvis, 0.5),
       at(0.550, 0.000, 0.036, 0.030, Bone::kPelvis, thigh, 0.7)}};
}

/// From heel to toes.
Tube foot(double side) {
  const Bone bone = side > 0 ? Bone::kLeftFoot : Bone::kRightFoot;
  const auto at = [&](double x, double z, double wide, double high) {
    return Ring{{x, side * 0.052, z}, wide, high, kShoes, bone, bone, 1};
  };
  return {{0, 1, 0},
          {0, 0, 1},
          {at(-0.040, 0.022, 0.012, 0.012), at(-0.034, 0.024, 0.022, 0.024), at(-0.005, 0.030, 0.026, 0.030),
           at(0.030, 0.026, 0.027, 0.026), at(0.070, 0.017, 0.029, 0.017), at(0.100, 0.013, 0.024, 0.013),
           at(0.112, 0.010, 0.010, 0.007)}};
}

class Builder {
 public:
  explicit Builder(int level) : around_(level == 0 ? 14 : level == 1 ? 9 : 6), every_(level == 2 ? 2 : 1) {}

  void add(const Tube& tube) {
    std::vector<std::uint32_t> first;
    for (std::size_t i = 0; i < tube.rings.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == tube.rings.size();
      if (!is_end && i % every_ != 0) continue;
      first.push_back(static_cast<std::uint32_t>(made.corners.size()));
      for (std::uint32_t k = 0; k < around_; ++k) add_corner(tube, tube.rings[i], 2 * kPi * k / around_);
    }
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
      for (std::uint32_t k = 0; k < around_; ++k) {
        const std::uint32_t next = (k + 1) % around_;
        add_triangle(first[i] + k, first[i] + next, first[i + 1] + next);
        add_triangle(first[i] + k, first[i + 1] + next, first[i + 1] + k);
      }
    for (std::uint32_t k = 1; k + 1 < around_; ++k) {
      add_triangle(first.front(), first.front() + k + 1, first.front() + k);
      add_triangle(first.back(), first.back() + k, first.back() + k + 1);
    }
  }

  Humanoid finish() {
    for (Humanoid::Corner& corner : made.corners) {
      float squares = 0;
      for (const float n : corner.normal) squares += n * n;
      if (squares > 0)
        for (float& n : corner.normal) n /= std::sqrt(squares);
    }
    return std::move(made);
  }

 private:
  void add_corner(const Tube& tube, const Ring& ring, double angle) {
    const geom::SinCos turn = geom::sincos(angle);
    const Vec3 p = ring.middle + ring.u * turn.cos * tube.u + ring.v * turn.sin * tube.v;
    Humanoid::Corner& corner = made.corners.emplace_back();
    corner.p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    corner.normal = {};
    corner.paint = {ring.paint.r, ring.paint.g, ring.paint.b, ring.paint.share};
    corner.bone[0] = ring.bone;
    corner.bone[1] = ring.other;
    corner.share = static_cast<float>(ring.share);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    made.triangles.push_back({a, b, c});
    const auto at = [&](std::uint32_t i) {
      const auto& p = made.corners[i].p;
      return Vec3{p[0], p[1], p[2]};
    };
    const Vec3 n = cross(at(b) - at(a), at(c) - at(a));
    for (const std::uint32_t i : {a, b, c}) {
      made.corners[i].normal[0] += static_cast<float>(n.x);
      made.corners[i].normal[1] += static_cast<float>(n.y);
      made.corners[i].normal[2] += static_cast<float>(n.z);
    }
  }

  std::uint32_t around_;
  std::size_t every_;

 public:
  Humanoid made;
};

/// Rotations about y, positive forwards for hanging limbs, x and z, in this order, and the displacement of
/// the joint.
struct Turned {
  double angle = 0, yaw = 0;  // about y, about z  [rad]
  Vec3 joint, goes_to;
  double roll = 0;  // about x  [rad]
  Vec3 operator()(const Vec3& p) const {
    const geom::SinCos pitch = geom::sincos(-angle), side = geom::sincos(roll), about = geom::sincos(yaw);
    const Vec3 q = p - joint;
    const Vec3 s{pitch.cos * q.x + pitch.sin * q.z, q.y, -pitch.sin * q.x + pitch.cos * q.z};
    const Vec3 r{s.x, side.cos * s.y - side.sin * s.z, side.sin * s.y + side.cos * s.z};
    return goes_to + Vec3{about.cos * r.x - about.sin * r.y, about.sin * r.x + about.cos * r.y, r.z};
  }
  std::array<float, 12> rows() const {
    const Vec3 o = (*this)({}), x = (*this)({1, 0, 0}) - o, y = (*this)({0, 1, 0}) - o,
               z = (*this)({0, 0, 1}) - o;
    const auto f = [](double v) { return static_cast<float>(v); };
    return {f(x.x), f(y.x), f(z.x), f(o.x), f(x.y), f(y.y), f(z.y), f(o.y), f(x.z), f(y.z), f(z.z), f(o.z)};
  }
};

/// Attaches a bone to another one: joint at `joint` of the mesh, rotated by `angle` from upright.
Turned on(const Turned& other, const Vec3& joint, double angle, double yaw, double roll = 0) {
  return {angle, yaw, joint, other(joint), roll};
}

/// Angles of an arm. [rad]
struct Arm {
  double upper = 0, fore = 0;              // forwards
  double upper_aside = 0, fore_aside = 0;  // about x
};

/// The right arm of a waving person: upper arm level, forearm up, beating.
Arm waving_arm(double age) {
  return {0.1, 0.2, -1.65, -2.85 + 0.42 * geom::sincos(2 * kPi * kWaves * age).sin};
}

}  // namespace

Humanoid make_humanoid(int level) {
  Builder builder(level);
  builder.add(torso());
  builder.add(head());
  if (level < 2) builder.add(hair());
  for (const double side : {1.0, -1.0}) {
    builder.add(arm(side));
    builder.add(leg(side));
    builder.add(foot(side));
  }
  return builder.finish();
}

BoneRows pose_humanoid(const Gait& gait) {
  // A thigh swings by a quarter of the stride to either side.
  const double reach = std::clamp(0.25 * gait.stride / (kThigh + kShin), -0.95, 0.95);
  const double swing =
      std::clamp(geom::atan2(reach, std::sqrt(1 - reach * reach)), -kLongestSwing, kLongestSwing);
  const double share = std::fabs(swing) / kLongestSwing;
  Turned pelvis{0, 0.12 * swing * geom::sincos(gait.phase).sin, {0, 0, kHip}, {0, 0, kHip}};
  const double breath = (1 - share) * 0.015 * geom::sincos(2 * kPi * kBreaths * gait.age).sin;
  const Turned spine = on(pelvis, {0, 0, 0.58}, -0.05 * share, 0);
  const Turned chest = on(spine, {0, 0, 0.68}, breath - 0.10 * share, -pelvis.yaw);
  const Turned head = on(chest, {0, 0, 0.86}, 0, 0);
  std::array<Turned, Humanoid::kBones> bones{};
  bones[Bone::kPelvis] = pelvis;
  bones[Bone::kSpine] = spine;
  bones[Bone::kChest] = chest;
  bones[Bone::kHead] = head;
  double lowest = 1e300;
  for (const double side : {1.0, -1.0}) {
    const geom::SinCos step = geom::sincos(gait.phase + (side > 0 ? 0 : kPi));
    const double raised = gait.turns ? kStepInPlace * std::max(0.0, step.cos) : 0;
    const double thigh = swing * step.sin + raised;
    // The knee bends during the swing phase, and slightly under load.
    const double ahead = swing > 0 ? step.cos : -step.cos;
    const double knee =
        0.06 + 2 * raised + share * (0.12 + 1.15 * std::max(0.0, ahead) * std::max(0.0, ahead));
    const double shin = thigh - knee;
    const double sole =
        share * (0.25 * std::max(0.0, step.sin * (swing > 0 ? 1 : -1)) - 0.5 * std::max(0.0, ahead));
    const int leg = side > 0 ? Bone::kLeftThigh : Bone::kRightThigh;
    bones[leg] = on(pelvis, {0, side * 0.055, kHip - 0.01}, thigh + 0.03, 0);
    bones[leg + 1] = on(bones[leg], {0, side * 0.053, kHip - kThigh}, shin, 0);
    bones[leg + 2] = on(bones[leg + 1], {-0.008, side * 0.052, kAnkle}, sole, 0);
    for (const double x : {-0.04, 0.11}) lowest = std::min(lowest, bones[leg + 2]({x, side * 0.052, 0}).z);
    const int arm = side > 0 ? Bone::kLeftArm : Bone::kRightArm;
    const double shoulder = -0.75 * swing * step.sin - 0.02, elbow = 0.18 + 0.35 * share * (1 - step.sin);
    const Arm pose = gait.waves && side < 0 ? waving_arm(gait.age) : Arm{shoulder, shoulder + elbow, 0, 0};
    bones[arm] = on(chest, {0, side * 0.105, 0.805}, pose.upper, 0, pose.upper_aside);
    bones[arm + 1] = on(bones[arm], {0, side * 0.127, 0.632}, pose.fore, 0, pose.fore_aside);
    bones[arm + 2] = on(bones[arm + 1], {0, side * 0.136, 0.482}, pose.fore + 0.05, 0, pose.fore_aside);
  }
  BoneRows rows;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    bones[i].goes_to.z -= lowest;  // puts the lower sole on the ground
    rows[i] = bones[i].rows();
  }
  return rows;
}

}  // namespace playhouse::render
