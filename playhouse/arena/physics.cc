#include "playhouse/arena/physics.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/arena/supports.h"
#include "playhouse/arena/wheels.h"

namespace playhouse::arena {
namespace {

constexpr double kMargin = 1e-3;    // m by which Bullet rounds convex solids
constexpr double kWheelDrop = 0.1;  // m below a wheel to where the ground is looked for
constexpr double kOverlap = 0.01;   // m that it climbs beyond its body: no step is in between
constexpr double kForesight = 0.1;  // s between two calls of forget(), about
constexpr double kUpright = 0.3;    // cosine of the steepest slope that bears a wheel

// What is forgotten (see forget()) leaves no contacts of earlier steps: each step finds all corners of a
// face.
constexpr int kPerturbations = 4;

// Of the solver of contacts; more where vehicles stand on what is lighter than they are.
constexpr int kIterations = 30, kHeldIterations = 50;

constexpr std::uint32_t kNobody = 0xffffffff;

enum Group : int { kFixed = 1, kMoving = 2, kGround = 4 };

btVector3 bullet(const Vec3& v) {
  return {v.x, v.y, v.z};
}
Vec3 from(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
btQuaternion bullet(const Quaternion& q) {
  return {q.x, q.y, q.z, q.w};
}

/// The lowest place of a solid that a wheel may stand on: of an upright prism its top, of a wedge its foot.
double lowest_top(const Hull& hull) {
  double lowest = 1e300;
  for (const Vec3& p : hull) {
    double top = p.z;
    for (const Vec3& q : hull)
      if (q.x == p.x && q.y == p.y) top = std::max(top, q.z);
    lowest = std::min(lowest, top);
  }
  return lowest;
}

/// About the z axis.
Hull turned(const Hull& hull, double angle) {
  if (angle == 0) return hull;
  const Quaternion q = geom::orientation(angle, {});
  Hull out;
  for (const Vec3& p : hull) out.push_back(q * p);
  return out;
}

/// Its corners are moved inwards by the margin where that leaves a solid, so that faces are where they were.
std::unique_ptr<btConvexHullShape> make_hull(const Hull& hull, const Vec3& center) {
  Vec3 low = hull.front(), high = hull.front();
  for (const Vec3& p : hull) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 middle = 0.5 * (low + high);
  const auto inwards = [](double p, double middle, double low, double high) {
    const double half = 0.5 * (high - low);
    return half > 2 * kMargin ? middle + (p - middle) * (half - kMargin) / half : p;
  };
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& p : hull)
    shape->addPoint(bullet(Vec3{inwards(p.x, middle.x, low.x, high.x), inwards(p.y, middle.y, low.y, high.y),
                                inwards(p.z, middle.z, low.z, high.z)} -
                           center),
                    false);
  shape->setMargin(kMargin);
  shape->recalcLocalAabb();
  shape->initializePolyhedralFeatures();  // faces touch in all their corners at once
  return shape;
}

/// Convex solids as one shape, about `center`.
class Solids {
 public:
  Solids(std::span<const Hull> solids, const Vec3& center) {
    for (const Hull& hull : solids) hulls_.push_back(make_hull(hull, center));
    if (hulls_.size() == 1) return;
    compound_ = std::make_unique<btCompoundShape>();
    for (const auto& hull : hulls_) compound_->addChildShape(btTransform::getIdentity(), hull.get());
    compound_->getDynamicAabbTree()->optimizeTopDown();
  }
  btCollisionShape& shape() const {
    if (compound_) return *compound_;
    return *hulls_.front();
  }

 private:
  std::vector<std::unique_ptr<btConvexHullShape>> hulls_;
  std::unique_ptr<btCompoundShape> compound_;  // of more than one
};

/// A surface of triangles that stands still.
class Sheet {
 public:
  explicit Sheet(const Triangles& triangles) {
    for (const Vec3& v : triangles.p) p_.insert(p_.end(), {v.x, v.y, v.z});
    for (const auto& corner : triangles.corner)
      for (const std::uint32_t row : corner) rows_.push_back(static_cast<int>(row));
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(triangles.corner.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(rows_.data());
    part.m_triangleIndexStride = 3 * sizeof(int);
    part.m_numVertices = static_cast<int>(triangles.p.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(p_.data());
    part.m_vertexStride = 3 * sizeof(double);
    part.m_indexType = PHY_INTEGER;
    part.m_vertexType = PHY_DOUBLE;
    mesh_.addIndexedMesh(part, PHY_INTEGER);
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
    shape_->setMargin(kMargin);
  }
  btCollisionShape& shape() const { return *shape_; }

 private:
  std::vector<double> p_;
  std::vector<int> rows_;
  btTriangleIndexVertexArray mesh_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

std::unique_ptr<btRigidBody> make_body(double mass, btCollisionShape& shape, const Surface& surface) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
  info.m_friction = surface.friction;
  info.m_restitution = surface.restitution;
  auto body = std::make_unique<btRigidBody>(info);
  if (surface.has_grain()) body->setAnisotropicFriction({surface.share_x, surface.share_y, 1});
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

/// A wheel on what may be pushed away, for Bullet to solve with the contacts of that: solved without them,
/// the reaction of a heavy vehicle throws a light thing. Rows: normal, along, left, of which friction is
/// within what the load of solve_wheels() gives. Changes of impulses that solve_wheels() found already.
class WheelConstraint final : public btTypedConstraint {
 public:
  WheelConstraint(btRigidBody& vehicle, btRigidBody& support, const Vec3& p, const WheelTarget& target,
                  const WheelImpulse& impulse)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, vehicle, support), p_(p), target_(target), impulse_(impulse) {}

  void getInfo1(btConstraintInfo1* info) override {
    info->m_numConstraintRows = target_.is_gripped() ? 3 : 1;
    info->nub = 0;
  }
  void getInfo2(btConstraintInfo2* info) override {
    put(info, 0, target_.normal, target_.v_normal);
    info->m_lowerLimit[0] = -impulse_.normal;
    info->m_upperLimit[0] = SIMD_INFINITY;
    if (!target_.is_gripped()) return;
    put(info, 1, target_.along, target_.v_along);
    limit(info, 1, target_.grip_along * impulse_.normal, impulse_.along);
    put(info, 2, target_.left, target_.v_left);
    limit(info, 2, target_.grip_left * impulse_.normal, impulse_.across);
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  void put(btConstraintInfo2* info, int row, const Vec3& direction, double velocity) const {
    const int at = row * info->rowskip;
    const btVector3 n = bullet(direction), p = bullet(p_);
    const auto write = [at](btScalar* to, const btVector3& v) {
      for (int k = 0; k < 3; ++k) to[at + k] = v[k];
    };
    write(info->m_J1linearAxis, n);
    write(info->m_J1angularAxis, (p - m_rbA.getWorldTransform().getOrigin()).cross(n));
    write(info->m_J2linearAxis, -n);
    write(info->m_J2angularAxis, -(p - m_rbB.getWorldTransform().getOrigin()).cross(n));
    info->m_constraintError[at] = velocity;
  }
  static void limit(btConstraintInfo2* info, int row, double most, double now) {
    const int at = row * info->rowskip;
    info->m_lowerLimit[at] = -most - now;
    info->m_upperLimit[at] = most - now;
  }

  Vec3 p_;  // m, of the wheel in W
  WheelTarget target_;
  WheelImpulse impulse_;
};

struct Moving {
  BodyDesc desc;
  std::unique_ptr<Solids> solids;
  std::unique_ptr<btRigidBody> body;
  Inertia inertia;
  BodyState state;
  double low = 1e300, reach = 0;  // m: its lowest corner, and how far the farthest is from its upright axis
  bool rests = false;
  geom::Twist velocity;  // driven at
  std::vector<Footing> footings;
  std::vector<WheelImpulse> impulses;
  std::vector<std::uint32_t> below;     // bodies that its wheels may stand on: scratch
  std::vector<std::uint32_t> supports;  // the body that each wheel stands on, or kNobody
  bool is_held = false;                 // its wheels are for Bullet to solve, too: it pushes one or is pushed

  explicit Moving(const BodyDesc& of) : desc(of), solids(std::make_unique<Solids>(of.hulls, of.center)) {
    body = make_body(desc.mass, solids->shape(), desc.surface);
    if (is_guided())
      body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);  // for static, it would never wake
    if (desc.is_upright) body->setMassProps(desc.mass, {0, 0, 0});      // for Bullet: cannot be turned
    inertia = {body->getInvMass(), from(body->getInvInertiaDiagLocal())};
    for (const Hull& hull : desc.hulls)
      for (const Vec3& p : hull) {
        low = std::min(low, p.z);
        reach = std::max(reach, std::sqrt(p.x * p.x + p.y * p.y));
      }
    footings.resize(desc.wheels.size());
    impulses.resize(desc.wheels.size());
    supports.resize(desc.wheels.size(), kNobody);
    write();
  }
  bool is_guided() const { return desc.mass == 0; }
  bool is_vehicle() const { return !desc.wheels.empty(); }

  Box box() const {
    btVector3 low, high;
    body->getAabb(low, high);
    return {from(low), from(high)};
  }
  /// Where the ground may be that its wheels stand on.
  Box footprint() const {
    Box box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
    for (const Wheel& wheel : desc.wheels) {
      const Vec3 p = state.p + state.q * wheel.p_B;
      const double reach = std::max(wheel.rise + kOverlap, kWheelDrop);
      box.low = {std::min(box.low.x, p.x - reach), std::min(box.low.y, p.y - reach),
                 std::min(box.low.z, p.z - reach)};
      box.high = {std::max(box.high.x, p.x + reach), std::max(box.high.y, p.y + reach),
                  std::max(box.high.z, p.z + reach)};
    }
    return box;
  }
  /// Of what of it is at p.  [m/s, both in W]
  Vec3 velocity_at(const Vec3& p) const { return state.v + cross(state.w, p - state.p); }

  /// So that nothing but its wheels can come to the ground before this is asked again.
  bool is_on_wheels() const {
    if (!is_vehicle()) return false;
    const Vec3 up = state.q * Vec3{0, 0, 1};
    const double lean = std::sqrt(std::max(0.0, 1 - up.z * up.z));
    const double leaning = std::sqrt(state.w.x * state.w.x + state.w.y * state.w.y) * kForesight;
    return up.z > 0 && state.p.z + low * up.z - reach * (lean + leaning) > 0.5 * low;
  }

  /// To Bullet, which moves the centre of mass.
  void write() {
    const Vec3 arm = state.q * desc.center;
    body->setWorldTransform(btTransform(bullet(state.q), bullet(state.p + arm)));
    body->setInterpolationWorldTransform(body->getWorldTransform());
    body->setDeactivationTime(0);
    body->forceActivationState(rests ? ISLAND_SLEEPING : DISABLE_DEACTIVATION);
    if (is_guided()) return;
    body->setLinearVelocity(bullet(state.v + cross(state.w, arm)));
    body->setAngularVelocity(bullet(state.w));
    body->updateInertiaTensor();
  }
  void read() {
    if (is_guided()) return;
    rests = !body->isActive();
    if (rests) return;
    const btTransform& X = body->getWorldTransform();
    const btQuaternion q = X.getRotation();
    state.q = {q.w(), q.x(), q.y(), q.z()};
    const Vec3 arm = state.q * desc.center;
    state.p = from(X.getOrigin()) - arm;
    state.w = from(body->getAngularVelocity());
    state.v = from(body->getLinearVelocity()) - cross(state.w, arm);
  }
  /// Of what nothing pushes: on by a step.
  void advance(double dt) {
    state.p = state.p + dt * state.v;
    const double angle = std::sqrt(dot(state.w, state.w)) * dt;
    if (angle > 0) {
      const btQuaternion turn(bullet(state.w).normalized(), angle);
      state.q = Quaternion{turn.w(), turn.x(), turn.y(), turn.z()} * state.q;
    }
    body->setWorldTransform(btTransform(bullet(state.q), bullet(state.p + state.q * desc.center)));
  }
};

}  // namespace

struct Physics::Impl {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btStaticPlaneShape plane{btVector3(0, 0, 1), 0};
  std::unique_ptr<btRigidBody> ground;
  double gravity;  // m/s^2
  struct Fixed {
    std::unique_ptr<Solids> solids;  // or
    std::unique_ptr<Sheet> sheet;
    std::unique_ptr<btRigidBody> body;
    double lowest_top = 0;                               // m; a wheel further below stands on none of it
    Vec3 low{-1e300, -1e300, 0}, high{1e300, 1e300, 0};  // no wheel beside stands on it

    bool is_beside(const Vec3& p) const { return p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y; }
  };
  std::vector<Fixed> fixed;  // of each surface, and of each sheet
  std::vector<std::unique_ptr<Moving>> bodies;
  bool is_in = false;

  Impl(const Surface& surface, double gravity) : ground(make_body(0, plane, surface)), gravity(gravity) {
    world.setGravity({0, 0, -gravity});
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    configuration.setPlaneConvexMultipointIterations(kPerturbations, kPerturbations);
    world.getSolverInfo().m_numIterations = kIterations;
  }
  ~Impl() { take_out(); }

  /// From Bullet, which keeps what it knows of contacts until then.
  void take_out() {
    if (!is_in) return;
    is_in = false;
    for (const auto& moving : bodies) world.removeRigidBody(moving->body.get());
    for (const Fixed& part : fixed) world.removeRigidBody(part.body.get());
    world.removeRigidBody(ground.get());
  }
  /// To Bullet, in the order of their numbers, as if it had never known them.
  void put_in() {
    if (is_in) return;
    is_in = true;
    broadphase.resetPool(&dispatcher);
    solver.reset();
    world.addRigidBody(ground.get(), kGround, kMoving);
    for (const Fixed& part : fixed) world.addRigidBody(part.body.get(), kFixed, kMoving);
    for (const auto& moving : bodies) {
      world.addRigidBody(moving->body.get(), kMoving,
                         kFixed | kMoving | (moving->is_on_wheels() ? 0 : kGround));
      if (moving->is_vehicle()) moving->body->setGravity({0, 0, 0});  // before its wheels
    }
  }
  void find_footing(Moving& moving, std::size_t i) const;
  void find_footings(std::uint32_t number);
  void find_supports();
  void wake();
  void roll(Moving& moving, double dt) const;
  bool is_pushed(const Moving& vehicle, std::uint32_t support) const;
  void push_supports(double dt);
  void hold_wheels(Moving& moving, double dt);
  void let_wheels_go();

  std::vector<WheelConstraint> held;  // in a step; Bullet has their addresses until then
  Supports supports;
  std::vector<Box> boxes;  // scratch
};

/// Where a ray from a wheel downwards meets a body from above.
struct Ray {
  btVector3 top, bottom;
  double rise = 0;

  /// Whether it is nearer than what `footing` has; then it has that.
  bool meet(btRigidBody& body, Footing& footing) const {
    const btTransform begin(btQuaternion::getIdentity(), top), end(btQuaternion::getIdentity(), bottom);
    btCollisionWorld::ClosestRayResultCallback hit(top, bottom);
    btCollisionWorld::rayTestSingle(begin, end, &body, body.getCollisionShape(), body.getWorldTransform(),
                                    hit);
    if (!hit.hasHit() || hit.m_closestHitFraction <= 0 || hit.m_hitNormalWorld.z() < kUpright) return false;
    const double gap = hit.m_closestHitFraction * (rise + kWheelDrop) - rise;
    if (footing.is_near && footing.gap < gap) return false;
    footing = {};
    footing.is_near = true;
    footing.gap = gap;
    footing.normal = from(hit.m_hitNormalWorld);
    footing.friction = body.getFriction();
    if (body.hasAnisotropicFriction()) add_grain(body, footing);
    return true;
  }
  static void add_grain(const btRigidBody& body, Footing& footing) {
    const btMatrix3x3& axes = body.getWorldTransform().getBasis();
    const btVector3& share = body.getAnisotropicFriction();
    footing.has_grain = true;
    footing.grain_x = from(axes.getColumn(0) * share.x());
    footing.grain_y = from(axes.getColumn(1) * share.y());
    footing.grain_z = from(axes.getColumn(2));
  }
};

/// The ground below a wheel: the plane, or what is higher, be it that it stands still or moves.
void Physics::Impl::find_footing(Moving& moving, std::size_t i) const {
  const Wheel& wheel = moving.desc.wheels[i];
  const Vec3 up = moving.state.q * Vec3{0, 0, 1}, p = moving.state.p + moving.state.q * wheel.p_B;
  Footing& footing = moving.footings[i];
  footing = {};
  footing.is_near = up.z > kUpright && p.z < kWheelDrop;
  footing.gap = p.z;
  footing.friction = ground->getFriction();
  const double rise = wheel.rise + kOverlap;
  const Ray ray{bullet(p + rise * up), bullet(p - kWheelDrop * up), rise};
  for (const Fixed& part : fixed)
    if (ray.top.z() >= part.lowest_top && !part.is_beside(p)) ray.meet(*part.body, footing);
  moving.supports[i] = kNobody;
  for (const std::uint32_t below : moving.below) {
    if (!ray.meet(*bodies[below]->body, footing)) continue;
    footing.v = bodies[below]->velocity_at(p);
    moving.supports[i] = below;
  }
}

/// Of a vehicle, unless neither it nor what may be below it moves.
void Physics::Impl::find_footings(std::uint32_t number) {
  Moving& moving = *bodies[number];
  if (!moving.is_vehicle()) return;
  supports.find(moving.footprint(), moving.below);
  std::erase(moving.below, number);
  const auto moves = [this](std::uint32_t below) { return !bodies[below]->rests; };
  if (moving.rests && std::ranges::none_of(moving.below, moves)) return moving.below.clear();
  for (std::size_t i = 0; i < moving.footings.size(); ++i) find_footing(moving, i);
  let_casters_give_way(moving.desc, moving.footings);
}

void Physics::Impl::find_supports() {
  boxes.clear();
  for (const auto& moving : bodies) boxes.push_back(moving->box());
  supports.set(boxes);
}

/// What moves below a vehicle that rests wakes it, and a vehicle that moves what it stands on, unless nothing
/// pushes that. One after the other, in the order of their numbers, each in as many steps as its stack is
/// high at most. Who is woken from above has no footings of this step yet.
void Physics::Impl::wake() {
  for (const auto& moving : bodies) {
    if (moving->below.empty()) continue;
    for (const std::uint32_t below : moving->supports) {
      if (below == kNobody || moving->rests == bodies[below]->rests) continue;
      Moving& sleeper = moving->rests ? *moving : *bodies[below];
      if (sleeper.is_guided()) continue;
      sleeper.rests = false;
      sleeper.write();
      if (&sleeper != moving.get()) find_footings(below);
    }
  }
}

/// What gravity and its wheels do to a vehicle.
void Physics::Impl::roll(Moving& moving, double dt) const {
  Motion motion{moving.state.q, from(moving.body->getLinearVelocity()),
                from(moving.body->getAngularVelocity())};
  motion.v.z -= gravity * dt;
  solve_wheels(moving.desc, moving.inertia, moving.velocity, dt, moving.footings, moving.impulses, motion);
  if (moving.desc.is_upright) motion.w = {0, 0, moving.velocity.a};
  moving.body->setLinearVelocity(bullet(motion.v));
  moving.body->setAngularVelocity(bullet(motion.w));
}

/// Whether the wheels of a vehicle push what they stand on.
bool Physics::Impl::is_pushed(const Moving& vehicle, std::uint32_t support) const {
  if (support == kNobody || bodies[support]->is_guided()) return false;
  // People put their feet beside a robot, whose edge they would weigh down.
  return !(vehicle.desc.is_upright && bodies[support]->is_vehicle());
}

/// What wheels stand on is pushed as much as they are, the other way.
void Physics::Impl::push_supports(double dt) {
  for (const auto& moving : bodies) {
    if (moving->below.empty() || moving->rests) continue;
    for (std::size_t i = 0; i < moving->supports.size(); ++i) {
      if (!is_pushed(*moving, moving->supports[i])) continue;
      moving->is_held = bodies[moving->supports[i]]->is_held = true;
      Moving& support = *bodies[moving->supports[i]];
      const Vec3 p = moving->state.p + moving->state.q * moving->desc.wheels[i].p_B;
      const Vec3 center = support.state.p + support.state.q * support.desc.center;
      support.body->applyImpulse(bullet(-1 * moving->impulses[i].total), bullet(p - center));
    }
  }
  std::size_t wheels = 0;
  for (const auto& moving : bodies)
    if (moving->is_held) wheels += moving->footings.size();
  held.reserve(wheels);
  for (const auto& moving : bodies)
    if (std::exchange(moving->is_held, false)) hold_wheels(*moving, dt);
  world.getSolverInfo().m_numIterations = held.empty() ? kIterations : kHeldIterations;
}

/// All wheels of a vehicle, for Bullet to solve with the contacts of what they stand on.
void Physics::Impl::hold_wheels(Moving& moving, double dt) {
  for (std::size_t i = 0; i < moving.footings.size(); ++i) {
    const Footing& footing = moving.footings[i];
    if (!footing.is_near) continue;
    const Wheel& wheel = moving.desc.wheels[i];
    const std::uint32_t support = moving.supports[i];
    btRigidBody& below =
        is_pushed(moving, support) ? *bodies[support]->body : btTypedConstraint::getFixedBody();
    WheelTarget target = wheel_target(wheel, footing, moving.state.q, moving.velocity, dt);
    if (&below == &btTypedConstraint::getFixedBody()) {
      target.v_normal += dot(target.normal, footing.v);
      target.v_along += dot(target.along, footing.v);
      target.v_left += dot(target.left, footing.v);
    }
    held.emplace_back(*moving.body, below, moving.state.p + moving.state.q * wheel.p_B, target,
                      moving.impulses[i]);
    world.addConstraint(&held.back());
  }
}

void Physics::Impl::let_wheels_go() {
  for (WheelConstraint& constraint : held) world.removeConstraint(&constraint);
  held.clear();
}

Physics::Physics(const Surface& ground, double gravity) : impl_(std::make_unique<Impl>(ground, gravity)) {}
Physics::~Physics() = default;

void Physics::set_fixed(std::span<const FixedSolid> solids) {
  impl_->take_out();
  impl_->fixed.clear();
  struct Alike {
    Surface surface;
    double heading = 0;
    std::vector<Hull> hulls;  // in a frame of that heading
  };
  std::vector<Alike> parts;
  for (const FixedSolid& solid : solids) {
    if (solid.hull.empty()) continue;
    const double heading = solid.surface.has_grain() ? solid.heading : 0;
    auto same = std::ranges::find_if(
        parts, [&](const Alike& part) { return part.surface == solid.surface && part.heading == heading; });
    if (same == parts.end()) same = parts.insert(same, {solid.surface, heading, {}});
    same->hulls.push_back(turned(solid.hull, -heading));
  }
  for (const Alike& alike : parts) {
    Impl::Fixed part{std::make_unique<Solids>(alike.hulls, Vec3{}), nullptr, nullptr, 1e300};
    part.body = make_body(0, part.solids->shape(), alike.surface);
    part.body->setWorldTransform(btTransform(bullet(geom::orientation(alike.heading, {}))));
    for (const Hull& hull : alike.hulls) part.lowest_top = std::min(part.lowest_top, lowest_top(hull));
    impl_->fixed.push_back(std::move(part));
  }
  for (const FixedSolid& solid : solids) {
    if (solid.triangles.empty()) continue;
    Impl::Fixed part{nullptr, std::make_unique<Sheet>(solid.triangles), nullptr, 1e300};
    part.body = make_body(0, part.sheet->shape(), solid.surface);
    part.low = {1e300, 1e300, 0};
    part.high = {-1e300, -1e300, 0};
    for (const Vec3& p : solid.triangles.p) {
      part.lowest_top = std::min(part.lowest_top, p.z);
      part.low = {std::min(part.low.x, p.x - kWheelDrop), std::min(part.low.y, p.y - kWheelDrop), 0};
      part.high = {std::max(part.high.x, p.x + kWheelDrop), std::max(part.high.y, p.y + kWheelDrop), 0};
    }
    impl_->fixed.push_back(std::move(part));
  }
}

std::uint32_t Physics::add(const BodyDesc& desc) {
  impl_->take_out();
  impl_->bodies.push_back(std::make_unique<Moving>(desc));
  return static_cast<std::uint32_t>(impl_->bodies.size() - 1);
}

void Physics::clear() {
  impl_->take_out();
  impl_->bodies.clear();
}

std::size_t Physics::size() const {
  return impl_->bodies.size();
}

void Physics::set_hulls(std::uint32_t body, std::span<const Hull> hulls) {
  impl_->take_out();
  Moving& moving = *impl_->bodies[body];
  auto solids = std::make_unique<Solids>(hulls, moving.desc.center);
  moving.body->setCollisionShape(&solids->shape());
  moving.solids = std::move(solids);
}

BodyState Physics::state(std::uint32_t body) const {
  return impl_->bodies[body]->state;
}

void Physics::put(std::uint32_t body, const BodyState& state, bool rests) {
  Moving& moving = *impl_->bodies[body];
  moving.state = state;
  moving.rests = rests;
  moving.write();
}

bool Physics::rests(std::uint32_t body) const {
  return impl_->bodies[body]->rests;
}

void Physics::drive(std::uint32_t body, const geom::Twist& velocity) {
  impl_->bodies[body]->velocity = velocity;
}

void Physics::forget() {
  impl_->take_out();
  for (const auto& moving : impl_->bodies) std::ranges::fill(moving->impulses, WheelImpulse{});
}

void Physics::step(double dt, world::Workers& workers) {
  constexpr std::size_t kGrain = 16;
  impl_->put_in();
  const auto& bodies = impl_->bodies;
  bool has_vehicles = false;
  for (const auto& moving : bodies) {
    if (moving->is_guided()) moving->advance(dt);
    has_vehicles = has_vehicles || moving->is_vehicle();
  }
  if (has_vehicles) {
    impl_->find_supports();
    workers.run(bodies.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) impl_->find_footings(static_cast<std::uint32_t>(i));
    });
    impl_->wake();
    workers.run(bodies.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (bodies[i]->is_vehicle() && !bodies[i]->rests) impl_->roll(*bodies[i], dt);
    });
    impl_->push_supports(dt);
  }
  impl_->world.stepSimulation(dt, 0);
  impl_->let_wheels_go();
  for (const auto& moving : bodies) moving->read();
}

}  // namespace playhouse::arena
