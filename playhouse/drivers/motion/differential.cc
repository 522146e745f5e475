#include "playhouse/drivers/motion/differential.h"

#include <cmath>
#include <memory>
#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace p1d = wire::position1d;
namespace p2d = wire::position2d;

WheelSpeeds wheel_speeds(const geom::Twist& body, double apart) {
  return {body.x - body.a * apart / 2, body.x + body.a * apart / 2};
}

geom::Twist body_velocity(const WheelSpeeds& wheels, double apart) {
  return {(wheels.left + wheels.right) / 2, 0, 0, (wheels.right - wheels.left) / apart};
}

/// The chord of an arc has the heading of its middle.
geom::Pose moved_along(const geom::Pose& X_OR, const geom::Twist& body, double seconds) {
  const double half_turn = geom::normalize(body.a * seconds / 2);
  const double half = body.a * seconds / 2;
  const double shortened = std::fabs(half) < 1e-6 ? 1 : geom::sincos(half_turn).sin / half;
  const double chord = body.x * seconds * shortened;
  const geom::SinCos heading = geom::sincos(geom::normalize(X_OR.a + half_turn));
  return {X_OR.x + chord * heading.cos, X_OR.y + chord * heading.sin, X_OR.z,
          geom::normalize(X_OR.a + 2 * half_turn)};
}

Differential::Differential(Shell& shell, const DifferentialOptions& options)
    : shell_(shell),
      options_(options),
      data_{&shell.client().queue(kLeft, kStatesKept), &shell.client().queue(kRight, kStatesKept)} {
  shell.on_command<p2d::CmdVel>(p2d::kCmdVel, [this](const p2d::CmdVel& command) { return drive(command); });
  shell.on_request(p2d::kReqMotorPower, [this](const device::Message& message, device::Replier replier) {
    switch_motors(message, std::move(replier));
  });
  shell.on_request(p2d::kReqGetGeom, [options](const device::Message&, device::Replier replier) {
    replier.ack(wire::encode(p2d::Geom{{}, {options.apart, 0, 0}}));
  });
  shell.on_request<p2d::SetOdomReq>(p2d::kReqSetOdom, [this](const p2d::SetOdomReq& asked) -> AnswerBody {
    if (!is_usable(asked.pose)) return std::nullopt;
    set_pose(pose_of(asked.pose));
    return std::vector<std::byte>();
  });
  shell.on_request(p2d::kReqResetOdom, [this](const device::Message&, device::Replier replier) {
    set_pose({});
    replier.ack();
  });
}

void Differential::set_pose(const geom::Pose& X_OR) {
  const std::lock_guard lock(mutex_);
  X_OR_ = X_OR;
}

// --- what the wheels are told

device::Taken Differential::drive(const p2d::CmdVel& command) {
  const WheelSpeeds speeds = wheel_speeds({command.vel.px, 0, 0, command.vel.pa}, options_.apart);
  if (!is_usable({speeds.left, speeds.right, 0})) return device::Taken::kNo;
  {
    const std::lock_guard lock(mutex_);
    drives_ = command.vel.px != 0 || command.vel.pa != 0;
  }
  tell_wheels(speeds, command.state);
  return device::Taken::kLatest;
}

void Differential::tell_wheels(const WheelSpeeds& speeds, std::uint8_t state) {
  const auto tell = [&](std::size_t wheel, double speed) {
    shell_.client().command(wheel, p1d::kCmdVel, wire::encode(p1d::CmdVel{static_cast<float>(speed), state}));
  };
  tell(kLeft, speeds.left);
  tell(kRight, speeds.right);
}

/// Both are, or it is refused.
void Differential::switch_motors(const device::Message& message, device::Replier replier) {
  const auto shared = std::make_shared<device::Replier>(std::move(replier));
  const std::vector<std::byte> body(message.body.begin(), message.body.end());
  shell_.client().ask(kLeft, p1d::kReqMotorPower, body, [this, shared, body](const AnswerBody& left) {
    if (!left) return;
    shell_.client().ask(kRight, p1d::kReqMotorPower, body, [shared](const AnswerBody& right) {
      if (right) shared->ack(*right);
    });
  });
}

void Differential::closing() {
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(drives_, false)) return;
  }
  tell_wheels({}, 1);
}

// --- what they measure

void Differential::closed() {
  const std::lock_guard lock(mutex_);
  time_.reset();
  wheels_ = {};
}

void Differential::take_news(std::vector<device::Publication>& more) {
  bool is_new = false;
  for (const std::size_t wheel : {kLeft, kRight})
    for (const device::Publication& message : data_[wheel]->take())
      is_new = take_wheel(wheel, message) || is_new;
  if (!is_new) return;
  const std::lock_guard lock(mutex_);
  const geom::Twist velocity = body_velocity(measured(), options_.apart);
  const auto stall = static_cast<std::uint8_t>(wheels_[kLeft].stall != 0 || wheels_[kRight].stall != 0);
  more.push_back({shell_.device(0), p2d::kDataState, *time_,
                  wire::encode(p2d::Data{pose2d(X_OR_), pose2d(velocity), stall})});
}

/// The robot goes on to the time of the message with the velocities so far.
bool Differential::take_wheel(std::size_t wheel, const device::Publication& message) {
  if (message.subtype != p1d::kDataState) return false;
  const Result<p1d::Data> data = wire::decode<p1d::Data>(message.body);
  if (!data || !(std::fabs(data->vel) <= 1e6f)) return false;
  const std::lock_guard lock(mutex_);
  if (time_ && message.timestamp > *time_) {
    const geom::Pose X_OR =
        moved_along(X_OR_, body_velocity(measured(), options_.apart), message.timestamp - *time_);
    if (is_usable(pose2d(X_OR))) X_OR_ = X_OR;
  }
  time_ = message.timestamp;
  wheels_[wheel] = *data;
  return true;
}

WheelSpeeds Differential::measured() const {
  return {static_cast<double>(wheels_[kLeft].vel), static_cast<double>(wheels_[kRight].vel)};
}

Result<DifferentialOptions> differential_options(SectionFields fields) {
  DifferentialOptions options;
  options.apart = fields.length({"axis_length", "Of one wheel from the other."}, options.apart, 0.001);
  fields.no_effect({"period", "The pose goes on with each message of a wheel."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_differential(const config::CfgSection& section, Site& site) {
  return make_algorithm<Differential>(
      section, site,
      {.provides = {{"position2d"}}, .uses = {{"position1d", "left"}, {"position1d", "right"}}},
      differential_options);
}

constexpr DeviceText kDifferentialProvides[] = {{"position2d"}};
constexpr DeviceText kDifferentialUses[] = {{"position1d", "left", HowMany::kOne, "is the left wheel"},
                                            {"position1d", "right", HowMany::kOne, "is the right one"}};

}  // namespace

constinit const DriverDefinition kDifferentialDriver{
    .name = "differential",
    .doc = "Two wheels, each a position1d, as a robot that steers by the difference of their speeds.",
    .provides = kDifferentialProvides,
    .uses = kDifferentialUses,
    .read_options = reading<differential_options>,
    .make = make_differential,
};

}  // namespace playhouse::drivers
