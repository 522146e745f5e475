// A model: a barrier that opens on command, or when a robot approaches, and closes again. Obstacles
// stop it. It is green while fully open, and red otherwise.
//
//   custom( library "barrier NEAR" )
//
// NEAR: distance of a robot at which it opens, in metres.
//
// Command 0: 1 opens it, 0: it opens for robots only. Readings: 0 the opening angle in radians, 1 whether
// an obstacle blocks it.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "playhouse/world/custom_library.h"

namespace pw = playhouse::world;
namespace geom = playhouse::geom;

namespace {

constexpr double kOpen = 1.4;     // rad
constexpr double kSpeed = 1;      // rad/s
constexpr double kEnough = 1e-6;  // rad

class Barrier : public pw::CustomKind {
  Sizes configure(std::span<const std::string> arguments) override {
    if (arguments.size() != 1) throw std::invalid_argument("needs one argument: NEAR");
    near_ = std::stod(arguments[0]);
    return {.commands = 1, .state = 1, .readings = 2};
  }

  // The state is its heading when closed.
  void begin(const pw::CustomModel& self, std::span<double> state, std::span<double>) const override {
    state[0] = self.world.models.X_PM[self.model].a;
  }

  void act(pw::CustomActor& self) const override {
    const double angle = opened(self.world, self.model, self.state[0]);
    const double wanted = self.command[0] > 0.5 || is_robot_near(self) ? kOpen : 0;
    self.velocity.a = std::clamp((wanted - angle) / self.dt, -kSpeed, kSpeed);
    const bool open = angle > kOpen - kEnough;
    self.color = {open ? 0.f : 1.f, open ? 0.6f : 0.f, 0, 1};
  }

  void sense(pw::CustomSensor& self) const override {
    self.readings[0] = opened(self.world, self.model, self.state[0]);
    self.readings[1] = self.world.customs.stall[self.world.models.part[self.model]];
  }

  static double opened(const pw::World& world, pw::ModelRow model, double closed) {
    return geom::normalize(world.models.X_PM[model].a - closed);
  }

  bool is_robot_near(const pw::CustomModel& self) const {
    const pw::ByModel<geom::Pose>& X_WM = self.world.models.X_WM;
    return std::ranges::any_of(self.world.positions.model, [&](pw::ModelRow robot) {
      const geom::Vec2 apart = X_WM[robot].xy() - X_WM[self.model].xy();
      return geom::dot(apart, apart) < near_ * near_;
    });
  }

  double near_ = 0;
};

}  // namespace

PLAYHOUSE_CUSTOM_KIND(Barrier)
