#include "playhouse/drivers/nd/nd.h"

#include <cmath>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;
namespace snr = wire::sonar;

namespace {

constexpr std::size_t kStatesKept = 64;  // per batch; all are forwarded
constexpr std::uint64_t kDelay = 1;      // ticks from a scan to its command

}  // namespace

Nd::Nd(device::Opener& opener, const Devices& devices, NdOptions options)
    : devices_(devices),
      options_(std::move(options)),
      client_(opener, *this, devices.count),
      position_(client_.queue(devices.input, kStatesKept)) {
  if (devices.laser) laser_ = &client_.latest(*devices.laser, lsr::kDataScan);
  if (devices.sonar) sonar_ = &client_.latest(*devices.sonar, snr::kDataRanges);
  client_.when_news([this](std::vector<device::Publication>& more) { take_news(more); });
}

Result<void> Nd::start(device::DeviceId) {
  if (const Result<void> opened = client_.open(); !opened) return opened;
  ask_geometry();
  return {};
}

void Nd::ask_geometry() {
  client_.ask(devices_.output, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) { take_body(body); });
  if (devices_.laser)
    client_.ask(*devices_.laser, lsr::kReqGetGeom, {},
                [this](const AnswerBody& body) { take_laser_geometry(body); });
  if (devices_.sonar)
    client_.ask(*devices_.sonar, snr::kReqGetGeom, {},
                [this](const AnswerBody& body) { take_sonar_geometry(body); });
}

void Nd::take_body(const AnswerBody& body) {
  const p2d::Geom geom = decoded<p2d::Geom>(body).value_or(p2d::Geom{});
  const geom::Vec2 middle{geom.pose.px, geom.pose.py}, half{geom.size.sl / 2, geom.size.sw / 2};
  const geom::Box box{middle.x - half.x, middle.y - half.y, middle.x + half.x, middle.y + half.y};
  const bool has_size = box.x_min < box.x_max && box.y_min < box.y_max && std::isfinite(dot(middle, half));
  if (!has_size) return log::warn("driver nd: its robot does not tell its size, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  body_ = box;
}

void Nd::take_laser_geometry(const AnswerBody& body) {
  const std::optional<lsr::Geom> geom = decoded<lsr::Geom>(body);
  const std::optional<geom::Pose> X_RS = geom ? planar(geom->pose) : std::nullopt;
  if (!X_RS) return log::warn("driver nd: its laser does not tell its place, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  X_RS_ = X_RS;
}

void Nd::take_sonar_geometry(const AnswerBody& body) {
  const snr::Geom geom = decoded<snr::Geom>(body).value_or(snr::Geom{});
  std::vector<geom::Pose> sonars;
  for (const wire::Pose3d& pose : geom.poses)
    if (const std::optional<geom::Pose> X_RS = planar(pose)) sonars.push_back(*X_RS);
  if (sonars.empty() || sonars.size() < geom.poses.size())
    return log::warn("driver nd: its sonars do not tell their places, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  sonars_ = std::move(sonars);
}

void Nd::stop(device::DeviceId) {
  if (set_goal(std::nullopt)) drive(0, 0);  // stop: the robot may stay open for others
  client_.close();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

void Nd::rewound(bool to_start) {
  if (to_start) set_goal(std::nullopt);
  thread_.clear();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

device::Taken Nd::command(const device::Message& message) {
  if (!client_.is_open()) return device::Taken::kNo;  // a goal must not wait for the next client
  if (message.subtype != p2d::kCmdPos) {
    const bool was_driving = set_goal(std::nullopt);
    const device::Taken taken = client_.command(devices_.output, message.subtype, message.body);
    if (was_driving && taken == device::Taken::kNo) drive(0, 0);  // stop: no longer controlled
    return taken;
  }
  const Result<p2d::CmdPos> command = wire::decode<p2d::CmdPos>(message.body);
  if (!command || !is_usable(command->pos)) return device::Taken::kNo;
  set_goal(pose_of(command->pos));
  return device::Taken::kLatest;
}

/// Replaces or clears the goal; true if there was one. A drive goes on with another goal and what it knows,
/// so that goals may come at any rate; none of its commands follows its end.
bool Nd::set_goal(std::optional<geom::Pose> X_OG) {
  bool had_one = false;
  {
    const std::lock_guard lock(mutex_);
    had_one = goal_.has_value();
    gave_up_ = false;
    if (X_OG && goal_) {
      goal_->X_OG = *X_OG;
      return true;
    }
    goal_.reset();
    if (X_OG) goal_ = {*X_OG, ++drives_};
  }
  thread_.clear();
  return had_one;
}

void Nd::request(const device::Message& message, device::Replier replier) {
  client_.forward(devices_.output, message.subtype, message.body, std::move(replier));
}

bool Nd::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  constexpr auto kCmd = static_cast<std::uint8_t>(wire::MessageType::kCmd);
  return (type == kCmd && subtype == p2d::kCmdPos) || client_.capable(devices_.output, type, subtype);
}

void Nd::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : position_.take()) {
    if (message.subtype == p2d::kDataState) take_state(message);
    message.device = device_;
    more.push_back(std::move(message));
  }
  const auto newest = [](device::Subscription* scans) {
    return scans == nullptr ? std::nullopt : scans->take_latest();
  };
  const std::optional<device::Publication> laser = newest(laser_), sonar = newest(sonar_);
  if (laser || sonar) take_scans(laser, sonar);
}

/// Its stall is 1, whatever the robot says, once a goal was given up.
void Nd::take_state(device::Publication& message) {
  Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state) return;
  const std::lock_guard lock(mutex_);
  if (is_usable(state->pos)) state_ = *state;
  if (!gave_up_) return;
  state->stall = 1;
  message.body = wire::encode(*state);
}

/// Constants of the robot, once all are known. With mutex_ held.
std::optional<NdRobot> Nd::robot() const {
  if (!body_ || (devices_.laser && !X_RS_) || (devices_.sonar && !sonars_)) return std::nullopt;
  return NdRobot{*body_, X_RS_.value_or(geom::Pose{}), sonars_.value_or(std::vector<geom::Pose>{})};
}

void Nd::take_scans(const std::optional<device::Publication>& laser,
                    const std::optional<device::Publication>& sonar) {
  NdIn in;
  std::optional<NdRobot> robot;
  std::uint64_t drive_number = 0;
  {
    const std::lock_guard lock(mutex_);
    robot = this->robot();
    if (!goal_ || !state_ || !robot) return;
    drive_number = goal_->drive;
    in.X_OG = goal_->X_OG;
    in.X_OR = pose_of(state_->pos);
    in.stall = state_->stall != 0;
  }
  if (laser) {
    const Result<lsr::Data> scan = wire::decode<lsr::Data>(laser->body);
    if (!scan) return;
    in.time = laser->timestamp;
    in.laser = NdLaserScan{scan->max_range, scan->min_angle, scan->resolution, scan->ranges};
  }
  if (sonar) {
    const Result<snr::Data> scan = wire::decode<snr::Data>(sonar->body);
    if (!scan) return;
    in.time = sonar->timestamp;
    in.sonar = scan->ranges;
  }
  thread_.post([this, drive_number, robot = std::move(*robot),
                in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const NdOut out = nd_step(options_, robot, in, memory_);
    return [this, drive_number, X_OG = in.X_OG, out] { steer(drive_number, X_OG, out); };
  });
}

void Nd::steer(std::uint64_t drive_number, const geom::Pose& X_OG, const NdOut& out) {
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || goal_->drive != drive_number) return;
    if (X_OG != goal_->X_OG && (out.done || out.stuck)) return;  // at another goal
    if (out.done || out.stuck) goal_.reset();
    gave_up_ = out.stuck;
  }
  drive(out.speed, out.turn_rate);
}

void Nd::drive(double speed, double turn_rate) {
  client_.command(devices_.output, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

namespace {

struct Required {
  Nd::Devices devices;
  std::vector<device::Address> addresses;  // of the client, by index
};

/// Input and output may be one device, which the client has once then.
Result<Required> required_devices(const scene::CfgSection& section, const Site& site) {
  std::vector<WantedDevice> wanted = {{"position2d", "output"}, {"position2d", "input"}};
  const bool has_sonar = names_device(section, "requires", "sonar");
  const bool has_laser = names_device(section, "requires", "laser") || !has_sonar;
  if (has_laser) wanted.push_back({"laser"});
  if (has_sonar) wanted.push_back({"sonar"});
  const auto named = section_devices(section, site, "requires", wanted);
  if (!named) return named.error();

  Required required{{}, *named};
  std::vector<device::Address>& addresses = required.addresses;
  if (addresses[0] == addresses[1]) {
    addresses.erase(addresses.begin() + 1);
  } else {
    required.devices.input = 1;
  }
  std::size_t& count = required.devices.count;
  count = required.devices.input + 1;
  if (has_laser) required.devices.laser = count++;
  if (has_sonar) required.devices.sonar = count++;
  return required;
}

}  // namespace

Result<std::unique_ptr<device::Driver>> make_nd(const scene::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"position2d"});
  if (!provided) return provided.error();
  const Result<Required> required = required_devices(section, site);
  if (!required) return required.error();
  const Result<NdOptions> options = nd_options(section);
  if (!options) return options.error();

  auto driver = std::make_unique<Nd>(site.surroundings(), required->devices, *options);
  const device::Address shown = provided->front(), robot = required->addresses.front();
  const Result<device::DeviceId> id = site.add_device(shown, *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  const auto connected = [&site, shown, robot, &nd = *driver]() -> Result<void> {
    Simulation* const simulation = site.simulation();
    if (simulation == nullptr) return {};
    Directory& directory = simulation->directory();
    directory.add(directory.model_of(robot), shown);
    nd.thread().follow_ticks(simulation->world().tick(), kDelay);
    simulation->add_follower([&nd](const world::World& world, const world::Change& change) {
      if (change.kind == world::Change::Kind::kReload) nd.rewound(world.tick() == 0);
    });
    simulation->add_listener(
        [&nd](const world::World& world, const world::Pace&) { nd.thread().ticked(world.tick()); });
    return {};
  };
  site.add_user(
      {driver.get(), &driver->client(), *provided, required->addresses, section.at("requires"), connected});
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
