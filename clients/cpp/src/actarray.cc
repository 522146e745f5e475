#include "playhouse_client/actarray.h"

#include <string_view>
#include <utility>

#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace act = wire::actarray;

namespace {

Joint joint_of(const act::Actuator& one) {
  const auto is = [&](std::int32_t state) { return (one.state & state) != 0; };
  Joint joint{one.position,
              one.speed,
              one.acceleration,
              {},
              is(act::kActstateMoving),
              is(act::kActstateBraked),
              is(act::kActstateStalled)};
  if (one.current != -1) joint.current = one.current;
  return joint;
}

JointGeometry geometry_of(const act::Actuatorgeom& one) {
  return {.rotary = one.type == act::kTypeRotary,
          .length = one.length,
          .orientation = {one.orientation.proll, one.orientation.ppitch, one.orientation.pyaw},
          .axis = {one.axis.px, one.axis.py, one.axis.pz},
          .lowest = one.min,
          .centre = one.centre,
          .highest = one.max,
          .home = one.home,
          .speed = one.config_speed,
          .has_brakes = one.hasbrakes != 0};
}

/// As floats; an error as of finite_floats().
Result<std::vector<float>> floats(const Device& device, std::string_view what,
                                  std::span<const double> numbers) {
  std::vector<float> floats;
  for (const double number : numbers) {
    if (const auto sound = finite_floats(device, what, {number}); !sound) return sound.error();
    floats.push_back(static_cast<float>(number));
  }
  return floats;
}

}  // namespace

Result<ActArray> ActArray::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, act::kCode, index, access);
  if (!device) return device.error();
  return ActArray(std::move(*device));
}

std::optional<ActArrayState> ActArray::state() const {
  const auto data = device_.latest<act::Data>(act::kDataState);
  if (!data) return std::nullopt;
  ActArrayState state{{}, data->motor_state != 0, device_.timestamp()};
  for (const act::Actuator& one : data->actuators) state.joints.push_back(joint_of(one));
  return state;
}

std::vector<Joint> ActArray::joints() const {
  auto newest = state();
  return newest ? std::move(newest->joints) : std::vector<Joint>();
}

Result<void> ActArray::move_to(std::int32_t joint, double position) {
  if (const auto sound = finite_floats(device_, "move_to", {position}); !sound) return sound;
  return device_.command(act::kCmdPos, act::PositionCmd{joint, static_cast<float>(position)});
}

Result<void> ActArray::move_all_to(std::span<const double> positions) {
  auto sound = floats(device_, "move_all_to", positions);
  if (!sound) return sound.error();
  return device_.command(act::kCmdMultiPos, act::MultiPositionCmd{std::move(*sound)});
}

Result<void> ActArray::move_at(std::int32_t joint, double speed) {
  if (const auto sound = finite_floats(device_, "move_at", {speed}); !sound) return sound;
  return device_.command(act::kCmdSpeed, act::SpeedCmd{joint, static_cast<float>(speed)});
}

Result<void> ActArray::move_all_at(std::span<const double> speeds) {
  auto sound = floats(device_, "move_all_at", speeds);
  if (!sound) return sound.error();
  return device_.command(act::kCmdMultiSpeed, act::MultiSpeedCmd{std::move(*sound)});
}

Result<void> ActArray::home(std::int32_t joint) {
  return device_.command(act::kCmdHome, act::HomeCmd{joint});
}

Result<void> ActArray::set_speed(std::int32_t joint, double speed) {
  if (const auto sound = finite_floats(device_, "set_speed", {speed}); !sound) return sound;
  return done(device_.request(act::kReqSpeed, act::SpeedConfig{joint, static_cast<float>(speed)}));
}

Result<void> ActArray::set_motor_power(bool on) {
  return done(device_.request(act::kReqPower, act::PowerConfig{static_cast<std::uint8_t>(on)}));
}

Result<void> ActArray::set_brakes(bool on) {
  return done(device_.request(act::kReqBrakes, act::BrakesConfig{static_cast<std::uint8_t>(on)}));
}

Result<ActArrayGeometry> ActArray::geometry() {
  const auto geom = device_.request<act::Geom>(act::kReqGetGeom);
  if (!geom) return geom.error();
  const wire::Point3d& base = geom->base_pos;
  const wire::Orientation3d& turns = geom->base_orientation;
  ActArrayGeometry made{{base.px, base.py, base.pz, turns.proll, turns.ppitch, turns.pyaw}, {}};
  for (const act::Actuatorgeom& one : geom->actuators) made.joints.push_back(geometry_of(one));
  return made;
}

}  // namespace playhouse::client
