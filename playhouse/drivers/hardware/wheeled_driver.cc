#include "playhouse/drivers/hardware/wheeled_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace playhouse::drivers {

namespace p2d = wire::position2d;

WheeledDriver::WheeledDriver(std::string name, Site& site, HardwareOptions options, std::size_t wheels)
    : HardwareDriver(std::move(name), site, std::move(options)) {
  on_command<p2d::CmdVel>(wheels, p2d::kCmdVel, [this](const p2d::CmdVel& wanted) { take(wanted.vel); });
  on_question(wheels, p2d::kReqGetGeom, [this]() -> AnswerBody { return wire::encode(geometry()); });
  on_request<p2d::PowerConfig>(wheels, p2d::kReqMotorPower, [this](const p2d::PowerConfig& asked) {
    return set_motors(asked.state != 0);
  });
  on_request<p2d::SetOdomReq>(wheels, p2d::kReqSetOdom, [this](const p2d::SetOdomReq& asked) -> AnswerBody {
    if (!is_usable(asked.pose)) return std::nullopt;
    set_pose(pose_of(asked.pose));
    return done();
  });
  on_question(wheels, p2d::kReqResetOdom, [this] {
    set_pose({});
    return done();
  });
}

void WheeledDriver::take(const wire::Pose2d& velocity) {
  constexpr double kMost = 1000;
  if (!std::isfinite(velocity.px) || !std::isfinite(velocity.pa)) return;
  feed_watchdog();
  if (!motors_on_) return drive({});
  drive({std::clamp(velocity.px, -kMost, kMost), 0, 0, std::clamp(velocity.pa, -kMost, kMost)});
}

AnswerBody WheeledDriver::set_motors(bool on) {
  motors_on_ = on;
  if (!on) stop_wheels();
  return done();
}

}  // namespace playhouse::drivers
