#include "playhouse/arena/physics/physics.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "playhouse/arena/physics/bullet_shapes.h"
#include "playhouse/arena/physics/contact_solver.h"
#include "playhouse/arena/physics/cylinder_contacts.h"
#include "playhouse/arena/physics/ground_contacts.h"
#include "playhouse/arena/physics/mesh_contacts.h"
#include "playhouse/arena/physics/moving.h"
#include "playhouse/arena/physics/round_contacts.h"
#include "playhouse/arena/physics/supports.h"
#include "playhouse/arena/physics/swept_world.h"
#include "playhouse/arena/physics/wheel_constraint.h"
#include "playhouse/arena/physics/wheel_ray.h"
#include "playhouse/arena/physics/wheels.h"

namespace playhouse::arena {
namespace {

// Iterations of the contact solver, which starts cold in each tick; more if vehicles stand on lighter bodies.
constexpr int kIterations = 50, kHeldIterations = 100;

constexpr double kRoot = 1e-3;  // m, tolerance for a solid that stands on the ground
constexpr double kDeep = 1;     // m by which it is extended below

constexpr double kSunk = 0.05;    // m of penetration that keeps a wheel awake
constexpr double kBeside = 0.01;  // m, tolerance for neighbours of a moving body

enum Group : int { kFixed = 1, kMoving = 2, kGround = 4 };

/// Height of the highest corner vertically above a corner; its own if there is none.
double top_above(const Hull& hull, const Vec3& p) {
  double top = p.z;
  for (const Vec3& q : hull)
    if (q.x == p.x && q.y == p.y) top = std::max(top, q.z);
  return top;
}

/// Lowest support height of a solid: the top of an upright prism, the foot of a wedge.
double lowest_top(const Hull& hull) {
  double lowest = 1e300;
  for (const Vec3& p : hull) lowest = std::min(lowest, top_above(hull, p));
  return lowest;
}

/// Extends a solid on the ground downwards, so that penetrating bodies are never pushed out through its base.
/// A sphere or capsule has none.
Hull rooted(Hull hull) {
  if (hull.round == Round::kSphere || hull.round == Round::kCapsule) return hull;
  const std::size_t corners = hull.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec3 p = hull[i];
    if (std::fabs(p.z) > kRoot) continue;
    hull.round = Round::kNot;
    if (top_above(hull, p) > kRoot)
      hull[i].z = -kDeep;
    else
      hull.push_back({p.x, p.y, -kDeep});  // the foot of a ramp
  }
  return hull;
}

/// Rotates about the z axis.
Hull turned(const Hull& hull, double angle) {
  if (angle == 0) return hull;
  const Quaternion q = geom::orientation(angle, {});
  Hull out;
  for (const Vec3& p : hull) out.push_back(q * p);
  out.round = hull.round;
  return out;
}

}  // namespace

double correction(double dt) {
  constexpr double kPerSecond = 20;  // Bullet's 0.2 of a step, in steps of 10 ms
  return std::min(kPerSecond * dt, 0.2);
}

struct Physics::Impl {
  btDefaultCollisionConfiguration configuration;
  GroundContacts on_ground{false}, under_hull{true};
  MeshContacts on_mesh;
  RoundContacts of_round{false}, with_round{true};
  CylinderContacts of_cylinder{false}, with_cylinder{true};
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  ContactSolver solver;
  SweptWorld world{&dispatcher, &broad_phase, &solver, &configuration};
  btStaticPlaneShape plane{btVector3(0, 0, 1), 0};
  std::unique_ptr<btRigidBody> ground;
  double gravity;  // m/s^2
  struct Fixed {
    std::unique_ptr<ConvexShapes> solids;  // or
    std::unique_ptr<SurfaceShape> sheet;
    std::unique_ptr<btRigidBody> body;
    double lowest_top = 0;                               // m; no wheel further below can stand on it
    Vec3 low{-1e300, -1e300, 0}, high{1e300, 1e300, 0};  // bounds for wheels that can stand on it

    bool is_beside(const Vec3& p) const { return p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y; }
  };
  std::vector<Fixed> fixed;  // of each surface, and of each mesh
  ByRow<RigidBody, std::unique_ptr<Moving>> bodies;
  bool is_in = false;

  Impl(const ContactSurface& surface, double gravity)
      : ground(make_body(0, plane, surface)), gravity(gravity) {
    // Bullet would multiply: on concrete, a ball of rubber would not bounce.
    [[maybe_unused]] static const auto set_once =
        gCalculateCombinedRestitutionCallback = [](const btCollisionObject* a, const btCollisionObject* b) {
          return std::max(a->getRestitution(), b->getRestitution());
        };
    world.setGravity({0, 0, -gravity});
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    dispatcher.registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE, &on_ground);
    dispatcher.registerCollisionCreateFunc(STATIC_PLANE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, &under_hull);
    dispatcher.registerCollisionCreateFunc(CONVEX_HULL_SHAPE_PROXYTYPE, TRIANGLE_SHAPE_PROXYTYPE, &on_mesh);
    register_round();
    world.getSolverInfo().m_numIterations = kIterations;
    world.getSolverInfo().m_restitutionVelocityThreshold = SIMD_INFINITY;  // ContactSolver restitutes
    // Along the slip and across: with one direction stacks creep.
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  }
  ~Impl() { take_out(); }
  /// Contacts of spheres, capsules and cylinders (CylinderShape).
  void register_round() {
    constexpr auto kCylinder = CUSTOM_POLYHEDRAL_SHAPE_TYPE;
    constexpr std::array kOthers{STATIC_PLANE_PROXYTYPE, TRIANGLE_MESH_SHAPE_PROXYTYPE,
                                 CONVEX_HULL_SHAPE_PROXYTYPE, kCylinder};
    for (const int other : kOthers) {
      for (const int round : {SPHERE_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE}) {
        dispatcher.registerCollisionCreateFunc(round, other, &of_round);
        dispatcher.registerCollisionCreateFunc(other, round, &with_round);
      }
      dispatcher.registerCollisionCreateFunc(other, kCylinder, &with_cylinder);
      dispatcher.registerCollisionCreateFunc(kCylinder, other, &of_cylinder);
    }
    for (const int one : {SPHERE_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE})
      for (const int other : {SPHERE_SHAPE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE})
        dispatcher.registerCollisionCreateFunc(one, other, &of_round);
  }

  /// Calls visit(body, group, mask) for all bodies in numeric order.
  template <typename Visit>
  void each_body(const Visit& visit) {
    visit(*ground, kGround, kMoving);
    for (const Fixed& part : fixed) visit(*part.body, kFixed, kMoving);
    for (const auto& moving : bodies)
      visit(*moving->body, kMoving, kFixed | kMoving | (moving->is_on_wheels() ? 0 : kGround));
  }
  /// Drops pairs of bodies with their contacts and impulses.
  void drop_pairs() {
    struct Every final : btOverlapCallback {
      bool processOverlap(btBroadphasePair&) override { return true; }
    } every;
    broad_phase.getOverlappingPairCache()->processAllOverlappingPairs(&every, &dispatcher);
  }
  /// Removes all bodies from Bullet's world, and with them cached contacts.
  void take_out() {
    if (!is_in) return;
    is_in = false;
    drop_pairs();
    for (const auto& moving : bodies) world.removeRigidBody(moving->body.get());
    for (const Fixed& part : fixed) world.removeRigidBody(part.body.get());
    world.removeRigidBody(ground.get());
  }
  /// Adds all bodies in numeric order, with fresh solver state.
  void put_in() {
    if (is_in) return;
    is_in = true;
    broad_phase.resetPool(&dispatcher);
    solver.reset();
    each_body([this](btRigidBody& body, int group, int mask) { world.addRigidBody(&body, group, mask); });
    for (const auto& moving : bodies)
      if (moving->is_vehicle()) moving->body->setGravity({0, 0, 0});  // for its wheels to integrate
  }
  /// Equivalent to take_out() and put_in(), bit-identical, without Bullet's linear searches for each body.
  void start_anew() {
    if (!is_in) return;
    drop_pairs();
    const btCollisionObjectArray& objects = world.getCollisionObjectArray();
    for (int i = 0; i < objects.size(); ++i)
      broad_phase.destroyProxy(objects[i]->getBroadphaseHandle(), &dispatcher);
    broad_phase.resetPool(&dispatcher);
    solver.reset();
    each_body([this](btRigidBody& body, int group, int mask) {
      const btCollisionShape& shape = *body.getCollisionShape();
      btVector3 low, high;
      shape.getAabb(body.getWorldTransform(), low, high);
      body.setBroadphaseHandle(
          broad_phase.createProxy(low, high, shape.getShapeType(), &body, group, mask, &dispatcher));
    });
  }
  void find_footing(Moving& moving, std::size_t i) const;
  void find_footings(RigidBodyRow own);
  void find_supports();
  void wake_neighbours(const Moving& guided);
  void find_loads();
  void wake();
  void roll(Moving& moving, double dt) const;
  bool is_pushed(const Moving& vehicle, RigidBodyRow support) const;
  void push_supports(double dt);
  void hold_wheels(Moving& moving, double dt);
  void let_wheels_go();

  std::vector<WheelConstraint> held;  // constraints of a step; Bullet keeps pointers to them
  Supports supports;
  ByRow<RigidBody, Aabb> boxes;    // scratch
  std::vector<RigidBodyRow> near;  // scratch
};

/// The ground below a wheel: the plane, or the highest static or movable body.
void Physics::Impl::find_footing(Moving& moving, std::size_t i) const {
  const Wheel& wheel = moving.desc.wheels[i];
  const Vec3 up = moving.state.q * Vec3{0, 0, 1}, p = moving.state.p + moving.state.q * wheel.p_B;
  Footing& footing = moving.footings[i];
  footing = {};
  footing.is_near = up.z > kUpright && p.z < kWheelDrop;
  footing.gap = p.z;
  footing.friction = ground->getFriction();
  const double rise = wheel.rise + kOverlap;
  const WheelRay ray{bullet(p + rise * up), bullet(p - kWheelDrop * up), rise};
  for (const Fixed& part : fixed)
    if (ray.top.z() >= part.lowest_top && !part.is_beside(p)) ray.meet(*part.body, footing);
  moving.supports[i] = {};
  for (const RigidBodyRow below : moving.below) {
    if (!ray.meet(*bodies[below]->body, footing)) continue;
    footing.v = bodies[below]->velocity_at(p);
    moving.supports[i] = below;
  }
}

/// Finds the ground of a vehicle's wheels, unless it and everything below sleeps.
void Physics::Impl::find_footings(RigidBodyRow own) {
  Moving& moving = *bodies[own];
  if (!moving.is_vehicle()) return;
  supports.find(moving.footprint(), moving.below);
  std::erase(moving.below, own);
  const auto moves = [this](RigidBodyRow below) { return !bodies[below]->is_sleeping; };
  if (moving.is_sleeping && std::ranges::none_of(moving.below, moves)) return moving.below.clear();
  for (std::size_t i = 0; i < moving.footings.size(); ++i) find_footing(moving, i);
  let_casters_give_way(moving.desc, moving.footings);
}

/// Wakes sleeping bodies on or beside a kinematic body, before it leaves them.
void Physics::Impl::wake_neighbours(const Moving& guided) {
  Aabb box = guided.box();
  box.low = box.low - Vec3{kBeside, kBeside, kBeside};
  box.high = box.high + Vec3{kBeside, kBeside, kBeside};
  supports.find(box, near);
  for (const RigidBodyRow body : near) {
    Moving& other = *bodies[body];
    if (!other.is_sleeping || other.is_guided()) continue;
    other.wake();
    other.is_woken = true;
  }
}

/// A vehicle that carries loose bodies has its wheels solved as Bullet constraints, with its load.
void Physics::Impl::find_loads() {
  for (const auto& load : bodies) {
    if (load->is_guided() || load->is_vehicle() || load->is_sleeping) continue;
    const Aabb box = load->box();
    supports.find(box, near);
    for (const RigidBodyRow body : near) {
      Moving& below = *bodies[body];
      if (!below.is_vehicle() || below.is_sleeping) continue;
      const Aabb under = below.box();
      if (box.low.z > 0.5 * (under.low.z + under.high.z)) below.is_held = true;
    }
  }
}

void Physics::Impl::find_supports() {
  boxes.clear();
  for (const auto& moving : bodies) boxes.push_back(moving->box());
  supports.set(boxes);
}

/// Propagates waking between vehicles and supports: a moving support wakes a vehicle, and a
/// moving vehicle a support that it can push. In numeric order, so that a stack wakes within
/// as many steps as it is high. Bodies woken from above have no footings in this step yet.
void Physics::Impl::wake() {
  for (const auto& moving : bodies) {
    if (moving->below.empty()) continue;
    for (const RigidBodyRow below : moving->supports) {
      if (!below || moving->is_sleeping == bodies[below]->is_sleeping) continue;
      Moving& sleeper = moving->is_sleeping ? *moving : *bodies[below];
      if (sleeper.is_guided()) continue;
      sleeper.wake();
      if (&sleeper != moving.get()) find_footings(below);
    }
  }
}

/// Applies gravity and wheel impulses to a vehicle.
void Physics::Impl::roll(Moving& moving, double dt) const {
  ChassisMotion motion{moving.state.q, from(moving.body->getLinearVelocity()),
                       from(moving.body->getAngularVelocity())};
  motion.v.z -= gravity * dt;
  solve_wheels(moving.desc, moving.inertia, moving.velocity, dt, moving.footings, moving.impulses, motion);
  if (moving.desc.is_upright) motion.w = {0, 0, moving.velocity.a};
  moving.body->setLinearVelocity(bullet(motion.v));
  moving.body->setAngularVelocity(bullet(motion.w));
}

/// True if the wheels of a vehicle act on their support.
bool Physics::Impl::is_pushed(const Moving& vehicle, RigidBodyRow support) const {
  if (!support || bodies[support]->is_guided()) return false;
  // A person's feet are beside a robot, and would load its edge.
  return !(vehicle.desc.is_upright && bodies[support]->is_vehicle());
}

/// Applies reaction impulses to supports.
void Physics::Impl::push_supports(double dt) {
  for (const auto& moving : bodies) {
    if (moving->below.empty() || moving->is_sleeping) continue;
    for (std::size_t i = 0; i < moving->supports.size(); ++i) {
      if (!is_pushed(*moving, moving->supports[i])) continue;
      moving->is_held = bodies[moving->supports[i]]->is_held = true;
      Moving& support = *bodies[moving->supports[i]];
      const Vec3 p = moving->state.p + moving->state.q * moving->desc.wheels[i].p_B;
      const Vec3 center = support.state.p + support.state.q * support.desc.center;
      support.body->applyImpulse(bullet(-1 * moving->impulses[i].total), bullet(p - center));
    }
  }
  find_loads();
  std::size_t wheels = 0;
  for (const auto& moving : bodies)
    if (moving->is_held) wheels += moving->footings.size();
  held.reserve(wheels);
  for (const auto& moving : bodies)
    if (std::exchange(moving->is_held, false)) hold_wheels(*moving, dt);
  world.getSolverInfo().m_numIterations = held.empty() ? kIterations : kHeldIterations;
}

/// Adds all wheels of a vehicle as Bullet constraints, solved with their support's contacts.
void Physics::Impl::hold_wheels(Moving& moving, double dt) {
  for (std::size_t i = 0; i < moving.footings.size(); ++i) {
    const Footing& footing = moving.footings[i];
    if (!footing.is_near) continue;
    const Wheel& wheel = moving.desc.wheels[i];
    const RigidBodyRow support = moving.supports[i];
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

Physics::Physics(const ContactSurface& ground, double gravity)
    : impl_(std::make_unique<Impl>(ground, gravity)) {}
Physics::~Physics() = default;

void Physics::set_fixed(std::span<const FixedSolid> solids) {
  impl_->take_out();
  impl_->fixed.clear();
  struct Alike {
    ContactSurface surface;
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
    same->hulls.push_back(turned(rooted(solid.hull), -heading));
  }
  for (const Alike& alike : parts) {
    Impl::Fixed part{std::make_unique<ConvexShapes>(alike.hulls, Vec3{}), nullptr, nullptr, 1e300};
    part.body = make_body(0, part.solids->shape(), alike.surface);
    part.body->setWorldTransform(btTransform(bullet(geom::orientation(alike.heading, {}))));
    for (const Hull& hull : alike.hulls) part.lowest_top = std::min(part.lowest_top, lowest_top(hull));
    impl_->fixed.push_back(std::move(part));
  }
  for (const FixedSolid& solid : solids) {
    if (solid.triangles.empty()) continue;
    Impl::Fixed part{nullptr, std::make_unique<SurfaceShape>(solid.triangles), nullptr, 1e300};
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

RigidBodyRow Physics::add(const RigidBodyDesc& desc) {
  impl_->take_out();
  const RigidBodyRow body = impl_->bodies.next();
  impl_->bodies.push_back(std::make_unique<Moving>(desc));
  impl_->bodies.back()->body->setUserIndex(static_cast<int>(body.index));
  return body;
}

void Physics::clear() {
  impl_->take_out();
  impl_->bodies.clear();
}

std::size_t Physics::size() const {
  return impl_->bodies.size();
}

void Physics::set_hulls(RigidBodyRow body, std::span<const Hull> hulls) {
  impl_->take_out();
  Moving& moving = *impl_->bodies[body];
  auto solids = std::make_unique<ConvexShapes>(hulls, moving.desc.center);
  moving.body->setCollisionShape(&solids->shape());
  moving.solids = std::move(solids);
  moving.desc.hulls.assign(hulls.begin(), hulls.end());
  moving.cores = Cores(hulls, moving.desc.center);
}

BodyState Physics::state(RigidBodyRow body) const {
  return impl_->bodies[body]->state;
}

void Physics::put(RigidBodyRow body, const BodyState& state, bool is_sleeping) {
  Moving& moving = *impl_->bodies[body];
  moving.state = state;
  moving.is_sleeping = is_sleeping;
  moving.is_woken = false;
  moving.write();
}

bool Physics::is_sleeping(RigidBodyRow body) const {
  return impl_->bodies[body]->is_sleeping;
}

bool Physics::may_sleep(RigidBodyRow body) const {
  const Moving& moving = *impl_->bodies[body];
  const auto is_sunk = [](const Footing& footing) { return footing.is_near && footing.gap < -kSunk; };
  return !moving.is_woken && std::ranges::none_of(moving.footings, is_sunk);
}

void Physics::drive(RigidBodyRow body, const geom::Twist& velocity) {
  impl_->bodies[body]->velocity = velocity;
}

void Physics::clear_contacts() {
  impl_->start_anew();
  for (const auto& moving : impl_->bodies) std::ranges::fill(moving->impulses, WheelImpulse{});
}

void Physics::step(double dt, world::Workers& workers) {
  constexpr std::size_t kGrain = 16;
  impl_->put_in();
  const auto& bodies = impl_->bodies;
  bool has_vehicles = false, has_guided = false;
  for (const auto& moving : bodies) {
    has_vehicles = has_vehicles || moving->is_vehicle();
    has_guided = has_guided || (moving->is_guided() && !moving->is_sleeping);
  }
  if (has_guided) {
    impl_->find_supports();
    for (const auto& moving : bodies) {
      if (!moving->is_guided() || moving->is_sleeping) continue;
      impl_->wake_neighbours(*moving);
      moving->advance(dt);
    }
  }
  if (has_vehicles) {
    impl_->find_supports();
    workers.run(bodies.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) impl_->find_footings(bodies.rows()[i]);
    });
    impl_->wake();
    workers.run(bodies.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Moving& moving = *bodies[bodies.rows()[i]];
        if (moving.is_vehicle() && !moving.is_sleeping) impl_->roll(moving, dt);
      }
    });
    impl_->push_supports(dt);
  }
  impl_->world.getSolverInfo().m_erp2 = correction(dt);
  impl_->world.stepSimulation(dt, 0);
  impl_->let_wheels_go();
  for (const auto& moving : bodies) moving->read();
}

std::vector<Penetration> Physics::penetrations(double depth) const {
  std::vector<Penetration> penetrations;
  const auto add = [&](const btCollisionObject& body, int hull, const btManifoldPoint& at,
                       const btVector3& out) {
    if (body.getUserIndex() < 0) return;  // static
    penetrations.push_back({{static_cast<std::uint32_t>(body.getUserIndex())},
                            {static_cast<std::uint32_t>(std::max(hull, 0))},
                            from(at.getPositionWorldOnB()),
                            from(out),
                            -at.getDistance()});
  };
  for (int i = 0; i < impl_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *impl_->dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject &a = *manifold.getBody0(), &b = *manifold.getBody1();
    if (a.isStaticOrKinematicObject() && b.isStaticOrKinematicObject()) continue;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& at = manifold.getContactPoint(k);
      if (-at.getDistance() <= depth) continue;
      add(a, at.m_index0, at, -at.m_normalWorldOnB);
      add(b, at.m_index1, at, at.m_normalWorldOnB);
    }
  }
  return penetrations;
}

}  // namespace playhouse::arena
