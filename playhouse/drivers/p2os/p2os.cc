#include "playhouse/drivers/p2os/p2os.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/dio.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/power.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kBauds[] = {9600, 38400, 19200, 115200, 57600};
constexpr int kTriesOfBaud = 3;
constexpr double kAnswerSeconds = 0.6;  // a robot that has heard answers at once
constexpr double kSilentSeconds = 3;    // without a packet of ten a second
constexpr int kCounts = 4096;           // of the counters of x and y
// mm from one packet to the next, beyond what its wheels did; more is a fault of the line.
constexpr double kLongestStep = 100;
constexpr int kMostWheelUnits = 126;
constexpr double kFullBattery = 12;   // V
constexpr double kAxleOffset = -0.1;  // m, of the middle of the base behind the axle

constexpr DeviceText kP2osProvides[] = {
    {"position2d", "odometry", HowMany::kSomeOfThese, "its wheels and odometry"},
    {"position2d", "compass", HowMany::kSomeOfThese, "its heading by the compass"},
    {"power", {}, HowMany::kSomeOfThese, "its battery"},
    {"sonar", {}, HowMany::kSomeOfThese},
    {"bumper", {}, HowMany::kSomeOfThese, "those in front from left to right, then those behind"},
    {"gripper", {}, HowMany::kSomeOfThese},
    {"dio", {}, HowMany::kSomeOfThese, "its eight digital inputs and outputs"},
    {"aio", {}, HowMany::kSomeOfThese, "its analog input"},
};

int whole(double value) {
  constexpr double kMost = 30000;  // also of what is no number
  return static_cast<int>(std::lround(value > -kMost ? std::min(value, kMost) : -kMost));
}

P2osOptions p2os_options(SectionFields& fields) {
  P2osOptions options;
  const LinePlace place = read_line_place(
      fields, {"port", "Serial port of the robot, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyS0", {});
  options.hardware = read_hardware_options(fields, place, true);
  options.max_speed = fields.length({"max_xspeed", "Of a wheel.", "m/s"}, 0.5, 0.001);
  options.max_turn_rate =
      fields.angle({"max_yawspeed", "With a speed and a turn rate of their own.", "deg/s"}, 100 * kDegree);
  // The original's files have slowing down with either sign.
  const auto acceleration = [&](std::string_view name, std::string_view doc) {
    return whole(1000 * std::fabs(fields.length({name, doc, "m/s^2"}, 0, SectionFields::kAnyNumber)));
  };
  options.acceleration = {acceleration("max_xaccel", "To be faster; 0: as the robot is set."),
                          acceleration("max_xdecel", "To be slower; 0: as the robot is set.")};
  const auto turning = [&](std::string_view name, std::string_view doc) {
    return whole(std::fabs(fields.angle({name, doc, "deg/s^2"}, 0, 0, SectionFields::kAnyNumber)) / kDegree);
  };
  options.turn_acceleration = {turning("max_yawaccel", "The same of turning."),
                               turning("max_yawdecel", "The same of turning.")};
  constexpr std::string_view kGains[] = {"rot_kp", "rot_kv", "rot_ki", "trans_kp", "trans_kv", "trans_ki"};
  for (std::size_t i = 0; i < options.gains.size(); ++i)
    options.gains[i] =
        fields.integer({kGains[i], "Gain of the robot's control; -1: as it is set."}, -1, -1, 65535);
  options.bump_stall = fields.integer(
      {"bumpstall",
       "Bumpers that stop the wheels: 0 none, 1 those in front, 2 behind, 3 both; -1: as it is set."},
      -1, -1, 3);
  options.pulse = fields.number(
      {"pulse",
       "Time between two signs of life, without which the robot stops after its watchdog's time; 0: none.",
       "s"},
      1, -1);
  fields.expect(options.pulse <= 0 || (options.pulse >= 0.1 && options.pulse <= 3600), "pulse",
                "is 0, or from 0.1 s to 3600 s");
  options.takes_joystick = fields.flag({"joystick", "1: a joystick at the robot may drive it."}, false);
  return options;
}

}  // namespace

P2os::P2os(std::string name, Site& site, const P2osOptions& options)
    : WheeledDriver(std::move(name), site, options.hardware, kWheels),
      options_(options),
      model_(p2os::find_robot_model("p3dx-sh")) {
  on_request<p2d::VelocityModeConfig>(
      kWheels, p2d::kReqVelocityMode,
      [this](const p2d::VelocityModeConfig& asked) { return set_velocity_mode(asked.value); });
  register_sensors();
  register_gripper();
}

// --- start-up

void P2os::began() {
  tries_ = 0;
  if (set_baud(kBauds[baud_])) ask_for_sync();  // that at which it answered the last time
}

void P2os::ask_for_sync() {
  stage_ = Stage::kSync0;
  has_closed_ = false;
  reader_.clear();
  send(p2os::encode_command(p2os::kSync0));
  wait_for_answer();
}

void P2os::wait_for_answer() {
  patience_ = after(kAnswerSeconds, [this] { ask_again(); });
}

/// At each speed of the line in turn.
void P2os::ask_again() {
  if (++tries_ % kTriesOfBaud == 0) {
    baud_ = (baud_ + 1) % std::size(kBauds);
    if (!set_baud(kBauds[baud_])) return;
  }
  if (tries_ == kTriesOfBaud * static_cast<int>(std::size(kBauds)))
    return give_up("nothing answers: is the robot on?");
  ask_for_sync();
}

void P2os::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> data = reader_.next()) take(*data);
}

void P2os::take(std::span<const std::byte> data) {
  if (stage_ == Stage::kClosed) return;
  if (stage_ != Stage::kRuns) return take_sync(data);
  if (const std::optional<p2os::Sip> sip = p2os::read_sip(data)) take_sip(*sip);
}

/// A robot that is still open from the last time is closed first.
void P2os::take_sync(std::span<const std::byte> data) {
  const std::uint8_t type = u8(data, 0);
  if (p2os::is_sip(type)) {
    if (stage_ == Stage::kSync0 && !std::exchange(has_closed_, true))
      send(p2os::encode_command(p2os::kClose));
    return;
  }
  if (stage_ == Stage::kSync0 && type == p2os::kSync0) {
    stage_ = Stage::kSync1;
    send(p2os::encode_command(p2os::kSync1));
  } else if (stage_ == Stage::kSync1 && type == p2os::kSync1) {
    stage_ = Stage::kSync2;
    send(p2os::encode_command(p2os::kSync2));
  } else if (const auto names = p2os::read_names(data); names && stage_ == Stage::kSync2) {
    return run(*names);
  } else {
    return;
  }
  wait_for_answer();
}

void P2os::run(const p2os::RobotNames& names) {
  if (const p2os::RobotModel* known = p2os::find_robot_model(names.subclass)) {
    model_ = known;
    inform(fmt::format("{}, a {} of type {}, answers at {}", names.name, names.robot_class, names.subclass,
                       line().name()));
  } else {
    warn(fmt::format("{} is a {} of type {}, which is unknown: taken for {}", line().name(),
                     names.robot_class, names.subclass, model_->subclass));
  }
  stage_ = Stage::kRuns;
  last_.reset();
  ranges_.assign(static_cast<std::size_t>(model_->sonars), 0.0F);
  send(p2os::encode_command(p2os::kOpen));
  send_options();
  pulse();
  wanted_.allow();
  started();
  patience_ = after(kSilentSeconds, [this] { give_up("the robot is silent"); });
}

void P2os::send_options() {
  send(p2os::encode_command(p2os::kPulse));
  send(p2os::encode_command(p2os::kSonar, is_open(kSonar) ? 1 : 0));
  send(p2os::encode_command(p2os::kJoydrive, options_.takes_joystick ? 1 : 0));
  send_gains();
  if (options_.bump_stall >= 0) send(p2os::encode_command(p2os::kBumpStall, options_.bump_stall));
  send(p2os::encode_command(p2os::kSetOrigin, 0));
  if (is_open(kWheels)) send(p2os::encode_command(p2os::kEnable, 1));
}

void P2os::send_gains() {
  const auto both = [this](std::uint8_t number, const std::array<int, 2>& values) {
    if (values[0] > 0) send(p2os::encode_command(number, values[0]));
    if (values[1] > 0) send(p2os::encode_command(number, -values[1]));
  };
  both(p2os::kSetAcceleration, options_.acceleration);
  both(p2os::kSetTurnAcceleration, options_.turn_acceleration);
  for (std::size_t i = 0; i < options_.gains.size(); ++i)
    if (options_.gains[i] >= 0)
      send(p2os::encode_command(static_cast<std::uint8_t>(p2os::kRotKp + i), options_.gains[i]));
}

void P2os::pulse() {
  if (options_.pulse <= 0) return;
  pulse_ = after(options_.pulse, [this] {
    send(p2os::encode_command(p2os::kPulse));
    pulse();
  });
}

void P2os::opened(std::size_t device) {
  if (stage_ != Stage::kRuns) return;
  if (device == kWheels) set_motors(true);
  if (device == kSonar) set_sonars(true);
}

void P2os::closed(std::size_t device) {
  if (stage_ != Stage::kRuns || is_open(device)) return;
  if (device == kWheels) {
    stop_wheels();
    set_motors(false);
  }
  if (device == kSonar) set_sonars(false);
}

void P2os::ending() {
  if (stage_ != Stage::kRuns) return;
  send(p2os::encode_command(p2os::kStop));
  send(p2os::encode_command(p2os::kEnable, 0));
  send(p2os::encode_command(p2os::kClose));
}

void P2os::forgot() {
  stage_ = Stage::kClosed;
  // A robot that comes back counts from where it is.
  X_CO_ = has_clients() ? geom::compose(X_CO_, X_OR_) : geom::Pose{};
  X_OR_ = {};
  wanted_.clear();
  patience_.reset();
  pulse_.reset();
  reader_.clear();
}

// --- what the robot tells

void P2os::take_sip(const p2os::Sip& sip) {
  patience_ = after(kSilentSeconds, [this] { give_up("the robot is silent"); });
  add_to_odometry(sip);
  last_ = sip;
  heard_ = now();
  wanted_.allow();
  send_wanted();
  publish_pose(sip);
  publish_compass(sip);
  publish_ranges(sip);
  publish_bumpers(sip);
  publish_gripper(sip);
  publish_inputs(sip);
}

void P2os::add_to_odometry(const p2os::Sip& sip) {
  X_OR_.a = geom::normalize(sip.heading * model_->angle_unit);
  if (!last_) return;
  const auto counted = [&](std::uint16_t now, std::uint16_t before) {
    int difference = (now - before) % kCounts;
    if (difference >= kCounts / 2) difference -= kCounts;
    if (difference < -kCounts / 2) difference += kCounts;
    return difference * model_->distance_unit;  // mm
  };
  const double x = counted(sip.x, last_->x), y = counted(sip.y, last_->y);
  const int fastest =
      std::max({std::abs(sip.left), std::abs(sip.right), std::abs(last_->left), std::abs(last_->right)});
  const double longest = kLongestStep + fastest * model_->speed_unit * (now() - heard_);
  if (std::fabs(x) > longest || std::fabs(y) > longest) return;
  X_OR_.x += x / 1000;
  X_OR_.y += y / 1000;
}

void P2os::publish_pose(const p2os::Sip& sip) {
  const double left = sip.left * model_->speed_unit, right = sip.right * model_->speed_unit;  // mm/s
  const geom::Pose X = geom::compose(X_CO_, X_OR_);
  const bool stalls = ((sip.left_stall | sip.right_stall) & 1) != 0;
  publish(
      kWheels, p2d::kDataState,
      p2d::Data{pose2d(X), {(left + right) / 2000, 0, (right - left) * model_->wheel_factor / 2}, stalls});
}

void P2os::publish_compass(const p2os::Sip& sip) {
  if (sip.compass == 0 || sip.compass == p2os::Sip::kNoCompass || sip.compass == 255) return;
  publish(kCompass, p2d::kDataState,
          p2d::Data{{0, 0, geom::normalize((sip.compass - 1) * 2 * kDegree)}, {}, 0});
}

void P2os::publish_ranges(const p2os::Sip& sip) {
  for (const p2os::SonarReading& reading : sip.sonars)
    if (reading.number < ranges_.size())
      ranges_[reading.number] = static_cast<float>(reading.range * model_->range_unit / 1000);
  publish(kSonar, wire::sonar::kDataRanges, wire::sonar::Data{ranges_});
}

/// A byte has a bumper in each of its bits from the second on, from right to left.
void P2os::publish_bumpers(const p2os::Sip& sip) {
  wire::bumper::Data data;
  const auto add = [&data](std::uint8_t bits, int count) {
    for (int bumper = count; bumper > 0; --bumper)
      data.bumpers.push_back(static_cast<std::uint8_t>(bits >> bumper & 1));
  };
  add(sip.right_stall, model_->front_bumpers);
  add(sip.left_stall, model_->rear_bumpers);
  publish(kBumper, wire::bumper::kDataState, data);
}

void P2os::publish_gripper(const p2os::Sip& sip) {
  namespace gripper = wire::gripper;
  const bool is_open = (sip.gripper & p2os::kIsOpen) != 0, is_closed = (sip.gripper & p2os::kIsClosed) != 0;
  gripper::Data data;
  if ((sip.gripper & p2os::kGripMoves) != 0)
    data.state = gripper::kStateMoving;
  else if (is_open != is_closed)
    data.state = is_open ? gripper::kStateOpen : gripper::kStateClosed;
  else
    data.state = gripper::kStateError;
  data.beams = (sip.digital_in & 0x0C) ^ 0x0C;  // an input is low where its beam is interrupted
  publish(kGripper, gripper::kDataState, data);
}

void P2os::publish_inputs(const p2os::Sip& sip) {
  const auto volts = static_cast<float>(sip.battery / 10.0);
  publish(kPower, wire::power::kDataState,
          wire::power::Data{.valid = wire::power::kMaskVolts | wire::power::kMaskPercent,
                            .volts = volts,
                            .percent = static_cast<float>(std::min(100.0, sip.battery * 10 / kFullBattery))});
  publish(kDio, wire::dio::kDataValues, wire::dio::Data{8, sip.digital_in});
  publish(kAio, wire::aio::kDataState, wire::aio::Data{{static_cast<float>(sip.analog * 5 / 255.0)}});
}

// --- what clients ask

p2d::Geom P2os::geometry() const {
  return {{kAxleOffset, 0, 0, 0, 0, 0}, {model_->width, model_->length, 0}};
}

AnswerBody P2os::set_velocity_mode(std::uint32_t mode) {
  separate_speeds_ = mode == 1;
  return mode <= 1 ? done() : std::nullopt;
}

void P2os::register_sensors() {
  namespace sonar = wire::sonar;
  on_question(kSonar, sonar::kReqGetGeom, [this]() -> AnswerBody {
    sonar::Geom geometry;
    for (const p2os::SonarPlace& place : model_->placed)
      geometry.poses.push_back({place.x, place.y, 0, 0, 0, place.direction * kDegree});
    geometry.poses.resize(static_cast<std::size_t>(model_->sonars));
    return wire::encode(geometry);
  });
  on_request<sonar::PowerConfig>(kSonar, sonar::kReqPower, [this](const sonar::PowerConfig& asked) {
    return set_sonars(asked.state != 0);
  });
  on_question(kBumper, wire::bumper::kReqGetGeom, [this]() -> AnswerBody {
    wire::bumper::Geom geometry;
    geometry.bumper_def.resize(static_cast<std::size_t>(model_->front_bumpers + model_->rear_bumpers));
    return wire::encode(geometry);
  });
  on_command<wire::dio::Cmd>(kDio, wire::dio::kCmdValues, [this](const wire::dio::Cmd& wanted) {
    const int mask = (1 << std::min<std::uint32_t>(wanted.count, 8)) - 1;
    send(p2os::encode_command_of_bytes(p2os::kDigitalOut, static_cast<int>(wanted.digout) & mask, mask));
  });
}

void P2os::register_gripper() {
  namespace gripper = wire::gripper;
  constexpr std::pair<std::uint8_t, p2os::GripperAction> kActions[] = {
      {gripper::kCmdOpen, p2os::kGripOpen},       {gripper::kCmdClose, p2os::kGripClose},
      {gripper::kCmdStop, p2os::kGripStop},       {gripper::kCmdStore, p2os::kGripStore},
      {gripper::kCmdRetrieve, p2os::kGripDeploy},
  };
  for (const auto& [subtype, action] : kActions)
    on_bare_command(kGripper, subtype, [this, action = action] { grip(action); });
  on_question(kGripper, gripper::kReqGetGeom, [this]() -> AnswerBody {
    gripper::Geom geometry;
    geometry.pose = {model_->length / 2, 0, 0, 0, 0, 0};
    geometry.outer_size = {0.315, 0.195, 0.035};
    geometry.inner_size = {0.205, 0.095, 1};
    geometry.num_beams = 2;
    return wire::encode(geometry);
  });
}

void P2os::drive(const geom::Twist& wanted) {
  wanted_.want(wanted);
  send_wanted();
}

void P2os::send_wanted() {
  const std::optional<geom::Twist> wanted = wanted_.take();
  if (!wanted) return;
  if (!separate_speeds_) return turn_wheels(1000 * wanted->x, wanted->a / model_->wheel_factor);
  const double fastest = 1000 * options_.max_speed;
  send(p2os::encode_command(p2os::kVelocity, whole(std::clamp(1000 * wanted->x, -fastest, fastest))));
  send(p2os::encode_command(
      p2os::kTurnRate,
      whole(std::clamp(wanted->a, -options_.max_turn_rate, options_.max_turn_rate) / kDegree)));
}

/// mm/s: of the robot, and of the right wheel against it. Too fast for a wheel: both are slower, on the same curve.
void P2os::turn_wheels(double speed, double difference) {
  const double fastest = std::max(std::fabs(speed - difference), std::fabs(speed + difference));
  const double most =
      std::min(1000 * options_.max_speed, static_cast<double>(kMostWheelUnits * model_->wheels_unit));
  const double scale = fastest > most ? most / fastest : 1;
  const auto units = [&](double wheel) { return whole(scale * wheel / model_->wheels_unit); };
  send(p2os::encode_command_of_bytes(p2os::kWheels, units(speed + difference), units(speed - difference)));
}

/// At once.
void P2os::stop_wheels() {
  if (stage_ != Stage::kRuns) return;
  wanted_.allow();
  drive({});
}

AnswerBody P2os::set_motors(bool on) {
  if (stage_ != Stage::kRuns) return std::nullopt;
  send(p2os::encode_command(p2os::kEnable, on ? 1 : 0));
  return done();
}

AnswerBody P2os::set_sonars(bool on) {
  if (stage_ != Stage::kRuns) return std::nullopt;
  send(p2os::encode_command(p2os::kSonar, on ? 1 : 0));
  return done();
}

void P2os::set_pose(const geom::Pose& X_CR) {
  X_CO_ = geom::compose(X_CR, geom::inverse(X_OR_));
}

void P2os::grip(p2os::GripperAction action) {
  if (stage_ == Stage::kRuns) send(p2os::encode_command(p2os::kGripper, action));
}

constinit const DriverDefinition kP2osDriver{
    .name = "p2os",
    .doc = "Pioneer, AmigoBot, PeopleBot and other bases with an ActivMedia controller.",
    .provides = kP2osProvides,
    .read_options = reading<p2os_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<P2os>(section, site, p2os_options, kP2osProvides);
    },
};

}  // namespace playhouse::drivers
