/// Grippers: paddles and lifts move a step per update; an object in contact when the paddles
/// have closed is attached in the following tick, and detached in place once they open.
///
/// In: commands, beams and contacts of the previous tick.
/// Out: grippers.paddles, closing, lift, rising, close_limit, held; attachments.
/// Source: Stage's rates and close limit; if several grippers want one object, the first row gets it.

#include <algorithm>

#include "playhouse/behaviour/generated/acts.h"
#include "playhouse/world/gripper.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/population/population.h"

namespace playhouse::behaviour {
namespace {

using world::GripperRow;
using world::Grippers;
using world::ModelRow;

constexpr double kStep = 0.05;      // share of the way from open to closed, and down to up, per update
constexpr double kRounding = 1e-9;  // tolerance for sums of steps

/// One step down, clamped to `least`.
double less(double value, double least) {
  return value - kStep < least + kRounding ? least : value - kStep;
}
double more(double value, double most) {
  return value + kStep > most - kRounding ? most : value + kStep;
}

/// True if the gripper updates in this tick; it then also measures (see DueList).
bool is_due(const world::World& world, world::GripperRow gripper) {
  const ModelRow model = world.grippers.model[gripper];
  if (world.models.subscribers[model] == 0) return false;
  return world.tick() + 1 - world.grippers.measured_tick[gripper] >= world::update_ticks(world, model);
}

/// Automatic mode: opens or closes stopped paddles by the beams.
void snatch(Grippers& grippers, world::GripperRow gripper) {
  if (grippers.closing[gripper] != 0) return;
  const bool wants_closed = grippers.beams[gripper] != 0 || grippers.held[gripper].valid();
  grippers.closing[gripper] = wants_closed ? 1 : -1;
}

void move_paddles(Grippers& grippers, world::GripperRow gripper) {
  double& paddles = grippers.paddles[gripper];
  const double limit = grippers.close_limit[gripper];
  std::int32_t& closing = grippers.closing[gripper];
  if (closing < 0) {
    paddles = less(paddles, 0);
  } else if (closing > 0 && paddles < limit) {
    paddles = more(paddles, limit);
  } else if (!grippers.touched[gripper].valid()) {
    closing = 0;  // one update after reaching the end, so that contacts there can be attached
  }
}

void move_lift(Grippers& grippers, world::GripperRow gripper) {
  double& lift = grippers.lift[gripper];
  std::int32_t& rising = grippers.rising[gripper];
  if (rising == 0) return;
  lift = rising > 0 ? more(lift, 1) : less(lift, 0);
  if (lift == (rising > 0 ? 1 : 0)) rising = 0;
}

/// The root of what is in contact, if it can be attached: loose, a root, marked for grippers.
ModelRow liftable(const world::World& world, world::ModelId met) {
  const world::Models& models = world.models;
  const ModelRow part = world.row(met);
  if (!part) return {};
  const ModelRow whole = models.root[part];
  const bool is_loose = models.mobility[whole] == world::Mobility::kLoose;
  return is_loose && world.desc(whole).gripper_return ? whole : ModelRow{};
}

void take_up(world::World& world, world::GripperRow gripper) {
  Grippers& grippers = world.grippers;
  const ModelRow by = grippers.model[gripper];
  const ModelRow thing = liftable(world, grippers.touched[gripper]);
  if (!thing || !world::attach(world, world.id(thing), world.id(by), {}).ok()) return;
  const scene::ModelDesc& desc = world.desc(by);
  const double room = desc.size.y - 0.5 * desc.gripper->paddle_width;  // m less a fraction, as in Stage
  const double limit = room > 0 ? std::clamp(1 - world.desc(thing).size.y / room, 0.0, 1.0) : 1;
  grippers.held[gripper] = world.id(thing);
  grippers.close_limit[gripper] = limit;
  grippers.paddles[gripper] = std::min(grippers.paddles[gripper], limit);
}

void let_go(world::World& world, world::GripperRow gripper) {
  const Result<void> detached = world::detach(world, world.grippers.held[gripper]);
  static_cast<void>(detached);  // it may have been detached already
  world.grippers.held[gripper] = {};
  world.grippers.close_limit[gripper] = 1;
}

class GripperAct final : public ActPhase {
 public:
  void act(world::World& world, world::Workers& workers) override {
    workers.run(world.grippers.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (const world::GripperRow gripper : world.grippers.rows().part(begin, end))
        if (is_due(world, gripper)) update(world, gripper);
    });
  }

  void change(world::World& world) override {
    Grippers& grippers = world.grippers;
    for (const world::GripperRow gripper : grippers.rows()) {
      const double paddles = grippers.paddles[gripper];
      std::int32_t& closing = grippers.closing[gripper];
      const bool holds = grippers.held[gripper].valid();
      const bool met = grippers.touched[gripper].valid() && grippers.measured_tick[gripper] == world.tick();
      if (closing > 0 && met && !holds) take_up(world, gripper);
      if (closing < 0 && holds && (paddles < grippers.close_limit[gripper] || paddles == 0))
        let_go(world, gripper);
      if (closing < 0 && paddles == 0) closing = 0;
    }
  }

 private:
  static void update(world::World& world, world::GripperRow gripper) {
    Grippers& grippers = world.grippers;
    const bool lost = grippers.held[gripper].valid() && !world::held_by(world, gripper);
    if (lost) {
      grippers.held[gripper] = {};
      grippers.close_limit[gripper] = 1;
    }
    if (world.desc(grippers.model[gripper]).gripper->autosnatch) snatch(grippers, gripper);
    move_paddles(grippers, gripper);
    move_lift(grippers, gripper);
  }
};

}  // namespace

std::unique_ptr<ActPhase> make_gripper_act() {
  return std::make_unique<GripperAct>();
}

}  // namespace playhouse::behaviour
