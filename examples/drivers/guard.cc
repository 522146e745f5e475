// An algorithm over other devices: wheels that stop before what a laser sees ahead.
//
//   driver ( name "guard" plugin "guard" provides ["position2d:1"] requires ["position2d:0" "laser:0"] distance 0.5 )
//
// Clients drive position2d:1. distance: metres, of beams within 30 degrees of straight ahead.
#include <cmath>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace laser = playhouse::wire::laser;
namespace p2d = playhouse::wire::position2d;
namespace pd = playhouse::drivers;

namespace {

constexpr std::size_t kWheels = 0, kLaser = 1, kGuarded = 0;  // required, required, provided
constexpr double kAhead = 0.52;                               // rad

class Guard : public pd::Plugin {
  void configure(const pd::PluginSection& section) override {
    distance_ = section.length("distance", 0.5);
    on_command<p2d::CmdVel>(kGuarded, p2d::kCmdVel, [this](const p2d::CmdVel& wanted) {
      wanted_ = wanted;
      drive();
    });
    pass_on(kGuarded, kWheels);  // whatever else a client asks: geometry, power, odometry
    on_data<p2d::Data>(kWheels, p2d::kDataState, [this](const p2d::Data& state, double time) {
      publish(kGuarded, p2d::kDataState, state, time);
    });
    on_data<laser::Data>(kLaser, laser::kDataScan, [this](const laser::Data& scan, double) {
      const bool was_near = near_;
      near_ = is_near(scan);
      if (near_ != was_near) drive();
    });
  }

  void close() override {
    wanted_ = {};
    drive();
  }

  bool is_near(const laser::Data& scan) const {
    for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
      const float bearing = scan.min_angle + static_cast<float>(k) * scan.resolution;
      if (std::abs(bearing) < kAhead && scan.ranges[k] < distance_) return true;
    }
    return false;
  }

  void drive() {
    p2d::CmdVel now = wanted_;
    if (near_ && now.vel.px > 0) now.vel.px = 0;
    command(kWheels, p2d::kCmdVel, now);
  }

  double distance_ = 0.5;  // m
  bool near_ = false;
  p2d::CmdVel wanted_;
};

}  // namespace

PLAYHOUSE_DRIVER(Guard)
