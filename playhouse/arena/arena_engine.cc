#include "playhouse/arena/arena_engine.h"

#include <algorithm>
#include <cmath>

#include "playhouse/arena/sensing/camera_sense.h"
#include "playhouse/arena/sensing/lidar_sense.h"
#include "playhouse/bodies/generated/moves.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/population/rows.h"

namespace playhouse::arena {
namespace {

using geom::Pose;
using world::ModelRow;

constexpr double kLongestStep = 0.01;  // s, substep of Physics
constexpr unsigned kStepsKept = 10;    // between calls of Physics::clear_contacts(): 0.1 s at most
// Sleeping: thresholds of velocity and time.
constexpr double kSlow = 0.005;      // m/s
constexpr double kSlowTurn = 0.02;   // rad/s
constexpr double kSleepAfter = 0.5;  // s
constexpr double kLeastTilt = 1e-6;  // rad; tilts below this are set to zero
constexpr double kStalled = 0.2;     // share of the commanded motion; a robot with less stalls
// A kinematic part stalls if it penetrates deeper than this, and than the expected lag of what it pushes.
constexpr double kPressed = 0.01;  // m
constexpr double kCare = 1.5;      // safety factor on that lag

/// Steady-state penetration into a pushed body, for an approach of 1 per tick of so many steps of dt.
double lag_after(unsigned steps, double dt) {
  double left = 1;
  for (unsigned step = 0; step < steps; ++step) left *= 1 - correction(dt);
  return left / (1 - left);
}

BodyState state_of(const world::Models& models, world::ModelRow row) {
  const Pose& X = models.X_PM[row];
  const geom::SpatialVelocity& V = models.V_WM[row];
  return {{X.x, X.y, X.z}, geom::orientation(X.a, models.tilt_PM[row]), V.v, V.w};
}

double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

bool is_moving(const world::World& world, const bodies::Mover& mover) {
  return bodies::with_move(mover.kind, [&](auto move) { return move.is_moving(world, mover.part); });
}

/// True if a model is `carrier` or attached to it.
bool carries(const world::Models& models, world::ModelRow carrier, world::ModelRow model) {
  while (model != carrier && model != models.root[model]) model = models.parent[model];
  return model == carrier;
}

geom::SpatialPose moved_by(const world::World& world, const bodies::Mover& mover) {
  const double dt = world.scene().interval;
  const geom::Tilt tilt = world.models.tilt_PM[mover.model];
  if (tilt != geom::Tilt{} && mover.kind == scene::ModelKind::kActuator) {
    const double position = bodies::ActuatorMove::position_after(world, mover.part, dt);
    const geom::Pose way = scene::way_along(bodies::ActuatorMove::desc_of(world, mover.part), position);
    return geom::compose(world::joint_of(world, mover.part), {way, {}});
  }
  const Pose X_PM = bodies::with_move(mover.kind, [&](auto move) {
    return move.after(world, mover.part, world.models.X_PM[mover.model], dt);
  });
  return {X_PM, tilt};
}

bool is_tilted(const geom::SpatialPose& X) {
  return X.tilt != geom::Tilt{};
}

}  // namespace

ArenaEngine::ArenaEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers,
                         const ContactSurface& ground)
    : BodyEngine(scene, seed, workers, {.ranger = make_lidar_sense, .camera = make_camera_sense}),
      physics_(ground, scene.gravity) {
  world_.engine = "arena";
  world::tilt_as_described(world_);
  world_.has_light = true;
  populate();
}

void ArenaEngine::populated(bool fixed) {
  if (fixed) physics_.set_fixed(fixed_solids(world_, solids_));
  physics_.clear();
  bodies_.clear();
  tree_of_.clear();
  has_parts_ = false;
  for (const bodies::TreeRow tree : trees_.rows()) {
    bodies_.push_back(make_body(tree));
    if (bodies_.back().row) tree_of_.push_back(tree);
    has_parts_ = has_parts_ || !parts_of(tree).empty();
  }
}

ArenaEngine::TreeBody ArenaEngine::make_body(bodies::TreeRow tree) {
  TreeBody body;
  body.motion = motion_type_of(world_, trees_, solids_, tree);
  for (const bodies::Mover& mover : trees_.movers_of(tree))
    body.has_joints = body.has_joints || mover.model != trees_.root[tree];
  auto [hulls, models] = hulls_of(world_, trees_, solids_, tree, body.motion, Joints::kAtRest, mesh_hulls_);
  if (hulls.empty()) {
    body.motion = MotionType::kGuided;  // degenerate outline
    return body;
  }
  for (const Hull& hull : hulls)
    for (const Vec3& p : hull) body.radius = std::max(body.radius, std::sqrt(p.x * p.x + p.y * p.y));
  body.models = std::move(models);
  body.row = physics_.add(plan_body(world_, trees_, tree, body.motion, std::move(hulls)));
  // bend() moves its hulls to where the joints are.
  for (const bodies::Mover& mover : trees_.movers_of(tree)) {
    const scene::ModelDesc& desc = world_.desc(mover.model);
    body.joints.push_back(world::tilted(desc, desc.X_PM));
  }
  return body;
}

world::PhysicsShapes ArenaEngine::shapes() const {
  world::PhysicsShapes shapes;
  // Static meshes collide with their triangles: nothing to add.
  for (FixedSolid& solid : fixed_solids(world_, solids_))
    if (!solid.hull.empty()) shapes.fixed.push_back(std::move(solid.hull));
  for (const bodies::TreeRow tree : trees_.rows())
    if (bodies_[tree].row)
      shapes.bodies.push_back(
          {world_.id(trees_.root[tree]),
           hulls_of(world_, trees_, solids_, tree, bodies_[tree].motion, Joints::kNow, mesh_hulls_).hulls});
  return shapes;
}

std::span<const bodies::Mover> ArenaEngine::parts_of(bodies::TreeRow tree) const {
  const std::span<const bodies::Mover> movers = trees_.movers_of(tree);
  return bodies_[tree].motion == MotionType::kVehicle ? movers.subspan(1) : movers;
}

bool ArenaEngine::is_driven(bodies::TreeRow tree) const {
  return bodies_[tree].motion == MotionType::kVehicle && is_moving(world_, trees_.movers_of(tree)[0]);
}

void ArenaEngine::move() {
  const double dt = world_.scene().interval;
  const auto steps = static_cast<unsigned>(std::ceil(dt / kLongestStep - 1e-9));
  for (const bodies::TreeRow tree : trees_.rows()) load(tree);
  for (unsigned step = 0; step < steps; ++step) {
    if (step % kStepsKept == 0) physics_.clear_contacts();
    physics_.step(dt / steps, workers_);
  }
  find_blocked(steps);
  for (const bodies::TreeRow tree : trees_.rows()) store(tree);
  index();
}

/// Copies the state of a tree from columns to Physics: columns are authoritative.
void ArenaEngine::load(bodies::TreeRow tree) {
  TreeBody& body = bodies_[tree];
  if (!body.row) return;
  if (body.has_joints) bend(tree);
  if (body.motion == MotionType::kGuided) return load_guided(tree);
  const world::ModelRow top = trees_.root[tree];
  const double still = world_.models.still[top] * world_.scene().interval;
  physics_.put(body.row, state_of(world_.models, top), still >= kSleepAfter && !is_driven(tree));
  if (body.motion == MotionType::kVehicle)
    physics_.drive(body.row, world_.positions.velocity[world_.models.part[top]]);
}

/// A kinematic body moves through the tick with the velocity of its movers.
void ArenaEngine::load_guided(bodies::TreeRow tree) {
  const world::ModelRow top = trees_.root[tree];
  BodyState state = state_of(world_.models, top);
  state.v = state.w = {};
  bool moves = false;
  for (const bodies::Mover& mover : trees_.movers_of(tree)) {
    moves = moves || is_moving(world_, mover);
    if (mover.model != top) continue;
    const Pose &now = world_.models.X_PM[top], then = moved_by(world_, mover).X;
    const double per_second = 1 / world_.scene().interval;
    state.v = per_second * (Vec3{then.x, then.y, then.z} - state.p);
    state.w = (per_second * geom::normalize(then.a - now.a)) * (state.q * Vec3{0, 0, 1});
  }
  physics_.put(bodies_[tree].row, state, !moves);
}

/// Updates hulls of an articulated body to its joint positions.
void ArenaEngine::bend(bodies::TreeRow tree) {
  TreeBody& body = bodies_[tree];
  const std::span<const bodies::Mover> movers = trees_.movers_of(tree);
  bool is_bent = false;
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const geom::SpatialPose X_PM = world::pose_in_parent(world_.models, movers[i].model);
    if (movers[i].model == trees_.root[tree] || X_PM == body.joints[i]) continue;
    body.joints[i] = X_PM;
    is_bent = true;
  }
  if (!is_bent) return;
  TreeHulls now = hulls_of(world_, trees_, solids_, tree, body.motion, Joints::kNow, mesh_hulls_);
  if (now.hulls.empty()) return;
  body.models = std::move(now.models);
  physics_.set_hulls(body.row, now.hulls);
}

/// Marks kinematic parts that penetrate deeply and would penetrate deeper.
void ArenaEngine::find_blocked(unsigned steps) {
  blocked_.assign(trees_.movers.size(), 0);
  if (!has_parts_) return;
  const double lag = lag_after(steps, world_.scene().interval / steps);
  for (const Penetration& penetration : physics_.penetrations(kPressed)) {
    const bodies::TreeRow tree = tree_of_[penetration.body];
    for (const bodies::Mover& mover : parts_of(tree)) {
      if (!is_moving(world_, mover) ||
          !carries(world_.models, mover.model, bodies_[tree].models[penetration.hull]))
        continue;
      const double closing = dot(way_of(penetration.p, mover), penetration.out);
      if (closing > 0 && penetration.depth > kPressed + kCare * lag * closing)
        blocked_[trees_.row_of(mover)] = 1;
    }
  }
}

/// Displacement of a point in a tick by a mover.  [m, both in W]
Vec3 ArenaEngine::way_of(const Vec3& p, const bodies::Mover& mover) const {
  const world::Models& models = world_.models;
  const geom::SpatialPose now = world::pose_in_world(models, mover.model);
  geom::SpatialPose then = moved_by(world_, mover);
  if (mover.model != models.root[mover.model])
    then = geom::compose(world::pose_in_world(models, models.parent[mover.model]), then);
  if (is_tilted(now) || is_tilted(then)) {
    const Quaternion q_WM = geom::orientation(now.X.a, now.tilt);
    const Vec3 p_M = Quaternion{q_WM.w, -q_WM.x, -q_WM.y, -q_WM.z} * (p - Vec3{now.X.x, now.X.y, now.X.z});
    return Vec3{then.X.x, then.X.y, then.X.z} + geom::orientation(then.X.a, then.tilt) * p_M - p;
  }
  const geom::Vec2 p_M = geom::Rotation::of(now.X.a).inverse(geom::Vec2{p.x, p.y} - now.X.xy());
  const geom::Vec2 q = then.X.xy() + geom::Rotation::of(then.X.a) * p_M;
  return {q.x - p.x, q.y - p.y, then.X.z - now.X.z};
}

void ArenaEngine::store(bodies::TreeRow tree) {
  const TreeBody& body = bodies_[tree];
  const world::ModelRow top = trees_.root[tree];
  const Pose before = world_.models.X_PM[top];
  bool moved = body.motion != MotionType::kGuided && store_state(tree);
  moved = store_parts(tree) || moved;
  if (moved) {
    world::place_tree(world_, top);
    bodies::turn(solids_, world_.models, trees_.models_of(tree));
    bodies::place(solids_, world_.models, trees_.solids_of(tree));
  }
  if (body.motion == MotionType::kVehicle) store_drive(tree, before);
  for (const bodies::Mover& mover : parts_of(tree))
    bodies::with_move(mover.kind, [&](auto move) {
      move.stall(world_, mover.part, is_blocked(mover));
      if (move.is_moving(world_, mover.part) && !is_blocked(mover)) move.arrive(world_, mover.part);
    });
}

/// Copies the state of a body to columns. False if it slept, or left the valid range: then it stays.
bool ArenaEngine::store_state(bodies::TreeRow tree) {
  const TreeBody& body = bodies_[tree];
  if (physics_.is_sleeping(body.row)) return false;
  world::Models& models = world_.models;
  const world::ModelRow top = trees_.root[tree];
  const BodyState state = physics_.state(body.row);
  geom::SpatialPose X = geom::spatial_pose(state.p, state.q);
  if (std::fabs(X.tilt.x) < kLeastTilt && std::fabs(X.tilt.y) < kLeastTilt) X.tilt = {};
  if (!world::is_place(X.X) || !geom::is_tilt(X.tilt) || !std::isfinite(length(state.v) + length(state.w))) {
    models.V_WM.set(top, {});
    return false;
  }
  const bool is_slow = length(state.v) < kSlow && length(state.w) < kSlowTurn && !is_driven(tree) &&
                       physics_.may_sleep(body.row);
  const std::uint32_t still = is_slow ? models.still[top] + 1 : 0;
  const bool is_sleeping = still * world_.scene().interval >= kSleepAfter;
  models.still.set(top, still);
  models.X_PM.own(top) = X.X;
  models.tilt_PM.set(top, X.tilt);
  models.V_WM.set(top, is_sleeping ? geom::SpatialVelocity{} : geom::SpatialVelocity{state.v, state.w});
  return true;
}

/// Updates odometry and stall of a robot: it stalls if it neither made progress nor is about to.
void ArenaEngine::store_drive(bodies::TreeRow tree, const Pose& before) {
  const world::ModelRow top = trees_.root[tree];
  const world::PositionRow robot = world_.models.part[top];
  const geom::Twist& driven = world_.positions.velocity[robot];
  const double dt = world_.scene().interval, arm = bodies_[tree].radius;
  const Pose way = geom::compose(geom::inverse(before), world_.models.X_PM[top]);
  const geom::SpatialVelocity& V = world_.models.V_WM[top];
  const geom::Vec2 v = geom::Rotation::of(world_.models.X_PM[top].a).inverse({V.v.x, V.v.y});
  const double wanted = driven.x * driven.x + driven.y * driven.y + driven.a * driven.a * arm * arm;
  // Projection of a motion on the commanded one.
  const auto share = [&](double x, double y, double a) {
    return (x * driven.x + y * driven.y + a * driven.a * arm * arm) / wanted;
  };
  const bool stalls = wanted > 0 && share(way.x / dt, way.y / dt, geom::normalize(way.a) / dt) < kStalled &&
                      share(v.x, v.y, V.w.z) < kStalled;
  bodies::PositionMove::stall(world_, robot, stalls);
  if (wanted > 0 && !stalls) bodies::PositionMove::arrive(world_, robot);
}

/// Moves the kinematic parts of a tree. True if any moved.
bool ArenaEngine::store_parts(bodies::TreeRow tree) {
  bool moved = false;
  for (const bodies::Mover& mover : parts_of(tree)) {
    if (!is_moving(world_, mover) || is_blocked(mover)) continue;
    const geom::SpatialPose X_PM = moved_by(world_, mover);
    world_.models.X_PM.own(mover.model) = X_PM.X;
    world_.models.tilt_PM.set(mover.model, X_PM.tilt);
    moved = true;
  }
  return moved;
}

}  // namespace playhouse::arena
