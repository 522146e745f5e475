#include "playhouse/record/frames.h"

namespace playhouse::record {
namespace {

using geom::Quaternion;
using geom::SpatialPose;
using geom::Vec3;

Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

SpatialPose body_in_world(const world::World& world, world::ModelRow model) {
  return geom::compose(world::pose_in_world(world.models, model), {world.desc(model).X_MB, {}});
}

SpatialPose lens_in_world(const world::World& world, world::ModelRow model) {
  constexpr Quaternion kOptical{0.5, -0.5, 0.5, -0.5};  // from x ahead, y left, z up
  const world::CameraRow camera = world.models.part[model];
  const double height = 0.5 * world.desc(model).size.z;  // of the lens in the body
  const Quaternion q_BL =
      geom::orientation(world.cameras.pan[camera], {0, -world.cameras.tilt[camera]}) * kOptical;
  return geom::compose(body_in_world(world, model), geom::spatial_pose({0, 0, height}, q_BL));
}

/// Of a robot that knows its pose the origin of its estimates, of another where its drift has brought that.
SpatialPose odometry_in_world(const world::World& world, world::ModelRow model) {
  const world::PositionRow robot = world.models.part[model];
  const bool is_exact = world.desc(model).position->localization == scene::Localization::kGps;
  geom::Pose X_WO = world.positions.X_WO[robot];
  if (!is_exact) X_WO = geom::compose(world.models.X_WM[model], geom::inverse(world.positions.X_OM[robot]));
  return {{X_WO.x, X_WO.y, 0, X_WO.a}, {}};
}

}  // namespace

std::string frame_name(const std::string& label, FrameKind kind, std::uint32_t sensor) {
  switch (kind) {
    case FrameKind::kRangerSensor:
      return label + "/" + std::to_string(sensor);
    case FrameKind::kLens:
      return label + "_optical";
    case FrameKind::kOdometry:
      return label + "/odom";
    case FrameKind::kModel:
    case FrameKind::kBody:
      break;
  }
  return label;
}

SpatialPose frame_in_world(const world::World& world, world::ModelRow model, FrameKind kind,
                           std::uint32_t sensor) {
  switch (kind) {
    case FrameKind::kRangerSensor:
      return geom::compose(body_in_world(world, model), {world.desc(model).sensors[sensor].X_BS, {}});
    case FrameKind::kBody:
      return body_in_world(world, model);
    case FrameKind::kLens:
      return lens_in_world(world, model);
    case FrameKind::kOdometry:
      return odometry_in_world(world, model);
    case FrameKind::kModel:
      break;
  }
  return world::pose_in_world(world.models, model);
}

SpatialPose pose_in(const SpatialPose& X_WP, const SpatialPose& X_WF) {
  if (X_WP.tilt == geom::Tilt{}) return {geom::compose(geom::inverse(X_WP.X), X_WF.X), X_WF.tilt};
  const Quaternion q_PW = inverse(geom::orientation(X_WP.X.a, X_WP.tilt));
  const Vec3 p_PF_W{X_WF.X.x - X_WP.X.x, X_WF.X.y - X_WP.X.y, X_WF.X.z - X_WP.X.z};
  return geom::spatial_pose(q_PW * p_PF_W, q_PW * geom::orientation(X_WF.X.a, X_WF.tilt));
}

SpatialPose estimated_pose(const world::World& world, world::ModelRow model) {
  const SpatialPose truth = world::pose_in_world(world.models, model);
  geom::Pose X_OM = world.positions.X_OM[world.models.part[model]];
  X_OM.z = truth.X.z;
  return {X_OM, truth.tilt};
}

}  // namespace playhouse::record
