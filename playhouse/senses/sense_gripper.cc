/// GripperSense: the phase in which grippers that are subscribed and due measure between
/// their paddles: two beams from paddle to paddle, and a ray along the inner face of each
/// paddle. They see only objects for grippers, at any height within the gripper's, and
/// nothing of their own tree: a held object breaks no beam, and touches both paddles.
///
/// In: poses, bodies; size, paddle size and paddle positions of each gripper.
/// Out: beams, contacts, touched.
/// Cost: six rays.
/// Source: places of beams and contacts as in Stage. A movable body is hit where a ray enters it
///   (ray_edge.h), so beams are cast in both directions, and contacts from the back of the gripper: objects
///   that overlap the base or extend beyond a paddle are found as well.

#include <algorithm>

#include "playhouse/scene/forms/gripper_body.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {
namespace {

// Distance of a beam from the front as a fraction of the size, whatever the length of the paddles.
constexpr double kInnerBeam = 0.75 * 0.66, kOuterBeam = 0.25 * 0.66;
constexpr std::uint32_t kInner = 1, kOuter = 2, kLeft = 1, kRight = 2;

class GripperSense final : public SensePhase {
 public:
  SensorTable table(world::World& world) const override {
    return {world.grippers.model, world.grippers.measured_tick};
  }
  void populate(const world::World&, const bodies::Space&) override {}

  std::uint64_t sense(world::World& world, const bodies::Space& space, std::span<const world::KindRow> due,
                      std::uint64_t, world::Workers& workers) override {
    workers.run(due.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) look(world, space, due[i]);
    });
    return 6 * due.size();
  }

 private:
  /// Ray casts in the frame of a gripper.
  struct Eye {
    const bodies::Space& space;
    geom::Pose X_WB;
    geom::Rotation rotation;  // of X_WB
    double height;            // m
    world::ModelRow root;

    /// The first model hit from p_B along the unit vector d_B, or none.
    world::ModelRow meets(geom::Vec2 p_B, geom::Vec2 d_B, double range) const {
      const bodies::Hit hit = cast(space, {X_WB.xy() + rotation * p_B, rotation * d_B, X_WB.z,
                                           X_WB.z + height, range, bit(bodies::SeenBy::kGripper), root});
      return hit.solid ? space.solids.model[hit.solid] : world::ModelRow{};
    }
  };

  static void look(world::World& world, const bodies::Space& space, world::GripperRow row) {
    world::Grippers& grippers = world.grippers;
    const world::ModelRow model = grippers.model[row];
    const scene::ModelDesc& desc = world.desc(model);
    const geom::Size& size = desc.size;
    const geom::Pose X_WB = geom::compose(world.models.X_WM[model], desc.X_MB);
    const Eye eye{space, X_WB, geom::Rotation::of(X_WB.a), size.z, world.models.root[model]};
    const double face = scene::paddle_face(*desc.gripper, size, std::clamp(grippers.paddles[row], 0.0, 1.0));

    const auto is_broken = [&](double inset) {
      const double x = (0.5 - inset) * size.x;
      const world::ModelRow from_left = eye.meets({x, face}, {0, -1}, 2 * face);
      const world::ModelRow from_right = eye.meets({x, -face}, {0, 1}, 2 * face);
      return from_left || from_right;
    };
    grippers.beams[row] = (is_broken(kInnerBeam) ? kInner : 0) | (is_broken(kOuterBeam) ? kOuter : 0);

    const world::ModelRow left = eye.meets({-size.x / 2, face}, {1, 0}, size.x);
    const world::ModelRow right = eye.meets({-size.x / 2, -face}, {1, 0}, size.x);
    const bool holds = grippers.held[row].valid();
    grippers.contacts[row] = (holds || left ? kLeft : 0) | (holds || right ? kRight : 0);
    const world::ModelRow met = left ? left : right;
    const bool takes = grippers.closing[row] > 0 && !holds && met;
    grippers.touched[row] = takes ? world.id(met) : world::ModelId{};
  }
};

}  // namespace

std::unique_ptr<SensePhase> make_gripper_sense(unsigned) {
  return std::make_unique<GripperSense>();
}

}  // namespace playhouse::senses
