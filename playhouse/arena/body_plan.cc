#include "playhouse/arena/body_plan.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "playhouse/arena/solid_bodies.h"
#include "playhouse/arena/surface.h"
#include "playhouse/geom/trapezoids.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/world/population/population.h"

namespace playhouse::arena {
namespace {

using geom::Pose;
using geom::Vec2;

constexpr double kClearance = 0.03;       // m, ground clearance of a chassis,
constexpr double kClearanceShare = 0.25;  // as a share of its height at most
constexpr double kStep = 0.3;             // m, step height of a person: the collision shape begins there
constexpr double kShoe = 1;               // friction of feet on concrete
constexpr double kDensity = 200;          // kg/m^3, default: a packed box
constexpr double kLeastMass = 0.05;       // kg
constexpr double kRobotMass = 10;         // kg, default of robots
constexpr double kTyre = 0.8;             // friction of wheels on concrete
constexpr double kInset = 0.1;            // share of length or width: distance of wheels from the sides
constexpr double kCenterHeight = 0.3;     // share of the height above the clearance, of the centre of mass

struct Extent {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

Extent extent_of(std::span<const Hull> hulls) {
  Extent extent;
  for (const Hull& hull : hulls)
    for (const Vec3& p : hull) extent.add(p);
  return extent;
}

void add_prism(std::vector<Hull>& hulls, std::span<const Vec2> outline, double z_low, double z_high) {
  Hull hull;
  for (const double z : {z_low, z_high})
    for (const Vec2 p : outline) hull.push_back({p.x, p.y, z});
  hulls.push_back(std::move(hull));
}

/// Decomposes the even-odd inside of outlines into convex prisms.
void add_prisms(std::vector<Hull>& hulls, std::span<const geom::Outline> outlines, double z_low,
                double z_high) {
  for (const geom::Trapezoid& t : geom::trapezoids(outlines)) {
    std::vector<Vec2> corners{{t.left_low, t.y_low}, {t.right_low, t.y_low}};
    for (const Vec2 p : {Vec2{t.right_high, t.y_high}, Vec2{t.left_high, t.y_high}})
      if (std::ranges::find(corners, p) == corners.end()) corners.push_back(p);
    add_prism(hulls, corners, z_low, z_high);
  }
}

/// Appends the convex prisms, in F, of the solids of one body (see Solids::body).
void add_body(std::vector<Hull>& hulls, const bodies::Solids& solids, bodies::SolidRows body,
              const Pose& X_FM) {
  const bodies::SolidRow first = body.front();
  const std::vector<std::vector<Vec2>> outlines = outlines_of(solids, body, X_FM);
  const double z_low = X_FM.z + solids.z_min_M[first], z_high = X_FM.z + solids.z_max_M[first];
  if (outlines.size() == 1 && solids.convex[first]) return add_prism(hulls, outlines[0], z_low, z_high);
  const std::vector<geom::Outline> all(outlines.begin(), outlines.end());
  add_prisms(hulls, all, z_low, z_high);
}

/// Appends hulls transformed by X_FB.
void add_hulls(std::vector<Hull>& hulls, const std::vector<Hull>& of_body, const Pose& X_FB) {
  const geom::Rotation turn = geom::Rotation::of(X_FB.a);
  for (Hull hull : of_body) {
    for (Vec3& p : hull) {
      const Vec2 q = X_FB.xy() + turn * Vec2{p.x, p.y};
      p = {q.x, q.y, X_FB.z + p.z};
    }
    hulls.push_back(std::move(hull));
  }
}

/// Poses of a tree's models in its root.
std::map<world::ModelRow, geom::SpatialPose> poses_in_top(const world::World& world,
                                                          const bodies::Trees& trees, bodies::TreeRow tree,
                                                          Joints joints) {
  const world::Models& models = world.models;
  std::map<world::ModelRow, geom::SpatialPose> X_BM;
  for (const world::ModelRow row : trees.models_of(tree)) {
    if (row == trees.root[tree]) {
      X_BM[row] = {};
      continue;
    }
    geom::SpatialPose X_PM = world::pose_in_parent(models, row);
    const scene::ModelDesc& desc = world.desc(row);
    if (joints == Joints::kAtRest && world::moves(desc.kind)) X_PM = world::tilted(desc, desc.X_PM);
    X_BM[row] = geom::compose(X_BM.at(models.parent[row]), X_PM);
  }
  return X_BM;
}

/// Clips hulls at height `z`, keeping what is above.
TreeHulls above(TreeHulls all, double z) {
  TreeHulls above;
  for (const HullRow row : all.hulls.rows()) {
    Hull& hull = all.hulls[row];
    if (std::ranges::all_of(hull, [z](const Vec3& p) { return p.z <= z; })) continue;
    if (std::ranges::any_of(hull, [z](const Vec3& p) { return p.z < z; })) hull.round = Round::kNot;
    for (Vec3& p : hull) p.z = std::max(p.z, z);
    above.hulls.push_back(std::move(hull));
    above.models.push_back(all.models[row]);
  }
  return above;
}

/// Volume and centroid of a body of uniform density.
struct Content {
  double volume = 0;  // m^3
  Vec3 center;        // m
};

/// True for an upright prism, whose bottom corners come first.
bool is_prism(const Hull& hull) {
  const std::size_t n = hull.size() / 2;
  if (n < 3 || hull.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (hull[i].z != hull[0].z || hull[n + i].z != hull[n].z || hull[i].x != hull[n + i].x ||
        hull[i].y != hull[n + i].y)
      return false;
  return true;
}

Content content_of(std::span<const Hull> hulls) {
  Content all;
  for (const Hull& hull : hulls) {
    if (!is_prism(hull)) {
      const HullContent content = hull_content(hull);
      all.volume += content.volume;
      all.center = all.center + content.volume * content.center;
      continue;
    }
    const std::size_t n = hull.size() / 2;
    const double height = hull[n].z - hull[0].z;
    double area = 0;
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const Vec3 a = hull[i] - hull[0], b = hull[i + 1] - hull[0];
      const double piece = 0.5 * (a.x * b.y - a.y * b.x);
      area += piece;
      sum = sum + (piece / 3) * (hull[0] + hull[i] + hull[i + 1]);
    }
    all.volume += area * height;
    all.center = all.center + height * Vec3{sum.x, sum.y, area * (hull[0].z + 0.5 * height)};
  }
  if (all.volume > 0) all.center = (1 / all.volume) * all.center;
  return all;
}

double mass_of(const world::World& world, const bodies::Trees& trees, bodies::TreeRow tree) {
  double mass = 0;
  for (const world::ModelRow row : trees.models_of(tree)) {
    const scene::ModelDesc& desc = world.desc(row);
    const bool is_said = desc.mass > 0 || !desc.mesh || !desc.mesh->physics;
    mass += is_said ? desc.mass : desc.mesh->physics->mass.value_or(0);
  }
  return mass;
}

/// Two wheels on the axle through B's origin, and a caster ahead and behind; four wheels
/// for holonomic and car drives; for a person feet at the centre and the corners.
std::vector<Wheel> wheels_of(scene::Drive drive, const Extent& extent) {
  const double length = extent.high.x - extent.low.x, width = extent.high.y - extent.low.y;
  const double back = extent.low.x + kInset * length, front = extent.high.x - kInset * length;
  const double right = extent.low.y + kInset * width, left = extent.high.y - kInset * width;
  std::vector<Wheel> wheels;
  if (drive == scene::Drive::kWalk) {
    const Vec3 &low = extent.low, &high = extent.high, middle = 0.5 * (low + high);
    for (const Vec3& p : {middle, low, high, Vec3{low.x, high.y, 0}, Vec3{high.x, low.y, 0}})
      wheels.push_back({{p.x, p.y, 0}, kShoe, kShoe, kStep});
    return wheels;
  }
  if (drive == scene::Drive::kDiff) {
    const double axle = std::clamp(0.0, back, front), middle = 0.5 * (left + right);
    for (const double y : {right, left}) wheels.push_back({{axle, y, 0}, kTyre, kTyre});
    for (const double x : {back, front}) wheels.push_back({.p_B = {x, middle, 0}, .brake = kTyre});
    return wheels;
  }
  for (const double x : {back, front})
    for (const double y : {right, left}) wheels.push_back({{x, y, 0}, kTyre, kTyre});
  return wheels;
}

Motors motors_of(const scene::PositionDesc& position) {
  const bool is_steered = position.drive == scene::Drive::kDiff || position.drive == scene::Drive::kCar;
  return {position.max_force.value_or(Motors::kNoLimit), position.max_power.value_or(Motors::kNoLimit),
          !is_steered};
}

}  // namespace

MotionType motion_type_of(const world::World& world, const bodies::Trees& trees, const bodies::Solids& solids,
                          bodies::TreeRow tree) {
  const world::ModelRow top = trees.root[tree];
  bool is_solid = false;
  for (const bodies::SolidRow row : trees.solids_of(tree)) is_solid = is_solid || solids.is_obstacle(row);
  if (!is_solid) return MotionType::kGuided;
  if (world.models.kind[top] == scene::ModelKind::kPosition) return MotionType::kVehicle;
  return world.models.mobility[top] == world::Mobility::kLoose ? MotionType::kLoose : MotionType::kGuided;
}

TreeHulls hulls_of(const world::World& world, const bodies::Trees& trees, const bodies::Solids& solids,
                   bodies::TreeRow tree, MotionType type, Joints joints, MeshHulls& meshes) {
  const std::map<world::ModelRow, geom::SpatialPose> X_BM = poses_in_top(world, trees, tree, joints);
  TreeHulls all;
  world::ModelRow latest;  // model whose mesh was added last
  each_body(solids, trees.solids_of(tree), bodies::SeenBy::kMotion, [&](bodies::SolidRows body) {
    const world::ModelRow model = solids.model[body.front()];
    const FrameOfBody frame(X_BM.at(model));
    const std::size_t first = all.hulls.size();
    const mesh::Mesh* mesh = mesh_of(world, model);
    if (mesh == nullptr)
      add_body(all.hulls, solids, body, frame.X_FM());
    else if (std::exchange(latest, model) != model)  // its outlines are for the 2D engine
      add_hulls(all.hulls, meshes.of(*mesh), body_in(world, model, frame.X_FM()));
    for (Hull& hull : std::span(all.hulls).subspan(first)) frame.turn(hull);
    all.models.resize(all.hulls.size(), model);
  });
  if (type != MotionType::kVehicle) return all;
  const Extent extent = extent_of(all.hulls);
  const bool walks = world.desc(trees.root[tree]).position->drive == scene::Drive::kWalk;
  return above(std::move(all), std::min(walks ? kStep : kClearance,
                                        extent.low.z + kClearanceShare * (extent.high.z - extent.low.z)));
}

RigidBodyDesc plan_body(const world::World& world, const bodies::Trees& trees, bodies::TreeRow tree,
                        MotionType type, std::vector<Hull> hulls) {
  const scene::ModelDesc& top = world.desc(trees.root[tree]);
  RigidBodyDesc desc;
  desc.surface = surface_of(top);
  const Content content = content_of(hulls);
  const double mass = mass_of(world, trees, tree);
  desc.center = content.center;
  if (type == MotionType::kVehicle) {
    const Extent extent = extent_of(hulls);
    desc.mass = mass > 0 ? mass : kRobotMass;
    desc.center.z = extent.low.z + kCenterHeight * (extent.high.z - extent.low.z);
    desc.wheels = wheels_of(top.position->drive, extent);
    desc.is_upright = top.position->drive == scene::Drive::kWalk;
    desc.motors = motors_of(*top.position);
    if (desc.motors.have_limits())
      for (Wheel& wheel : desc.wheels) wheel.brake = 0;  // its motors alone slow it down
  } else if (type == MotionType::kLoose) {
    desc.mass = mass > 0 ? mass : std::max(kDensity * content.volume, kLeastMass);
  } else {
    desc.mass = 0;
    desc.center = {};
  }
  desc.hulls = std::move(hulls);
  return desc;
}

std::vector<FixedSolid> fixed_solids(const world::World& world, const bodies::Solids& solids) {
  std::vector<FixedSolid> fixed;
  std::vector<Hull> hulls;
  world::ModelRow latest;  // model whose mesh was added last
  each_body(solids, solids.fixed_rows(), bodies::SeenBy::kMotion, [&](bodies::SolidRows body) {
    const world::ModelRow model = solids.model[body.front()];
    const FrameOfBody frame(world::pose_in_world(world.models, model));
    if (const mesh::Mesh* mesh = mesh_of(world, model)) {
      if (std::exchange(latest, model) == model) return;
      const ContactSurface surface = surface_of(world.desc(model));
      const double heading = world.models.X_WM[model].a;
      FixedParts parts = fixed_parts(*mesh, body_in(world, model, frame.X_FM()));
      frame.turn(parts.triangles.p);
      for (Hull& hull : parts.hulls) {
        frame.turn(hull);
        fixed.push_back({std::move(hull), surface, heading, {}});
      }
      if (!parts.triangles.empty()) fixed.push_back({{}, surface, heading, std::move(parts.triangles)});
      return;
    }
    hulls.clear();
    add_body(hulls, solids, body, frame.X_FM());
    for (Hull& hull : hulls) {
      frame.turn(hull);
      fixed.push_back({std::move(hull), surface_of(world.desc(model)), world.models.X_WM[model].a, {}});
    }
  });
  return fixed;
}

}  // namespace playhouse::arena
