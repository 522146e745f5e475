#include "playhouse/drivers/vfh/vfh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/drivers/vfh/vfh_options.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;

namespace {

// Indices of the client's devices.
constexpr std::size_t kRobot = 0;
constexpr std::size_t kLaser = 1;

constexpr std::size_t kStatesKept = 64;  // per batch; all are forwarded
constexpr std::uint64_t kDelay = 1;      // ticks from a scan to its command

}  // namespace

Vfh::Vfh(device::Opener& opener, const VfhOptions& options)
    : options_(options),
      client_(opener, *this, 2),
      position_(client_.queue(kRobot, kStatesKept)),
      scans_(client_.latest(kLaser, lsr::kDataScan)) {
  client_.when_news([this](std::vector<device::Publication>& more) { take_news(more); });
}

Result<void> Vfh::start(device::DeviceId) {
  if (const Result<void> opened = client_.open(); !opened) return opened;
  ask_geometry();
  return {};
}

void Vfh::ask_geometry() {
  client_.ask(kRobot, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const std::optional<p2d::Geom> geom = decoded<p2d::Geom>(body);
    if (!geom) return log::warn("driver vfh: its robot does not tell its size, so it drives to no goals");
    const std::lock_guard lock(mutex_);
    radius_ = std::max(geom->size.sl, geom->size.sw) / 2;
  });
  client_.ask(kLaser, lsr::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const std::optional<lsr::Geom> geom = decoded<lsr::Geom>(body);
    const std::optional<geom::Pose> X_RS = geom ? planar(geom->pose) : std::nullopt;
    if (!X_RS) return log::warn("driver vfh: its laser does not tell its place, so it drives to no goals");
    const std::lock_guard lock(mutex_);
    X_RS_ = X_RS;
  });
}

void Vfh::stop(device::DeviceId) {
  if (set_goal(std::nullopt)) drive(0, 0);  // stop: the robot may stay open for others
  client_.close();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

void Vfh::rewound(bool to_start) {
  if (to_start) set_goal(std::nullopt);
  thread_.clear();
  const std::lock_guard lock(mutex_);
  state_.reset();
}

device::Taken Vfh::command(const device::Message& message) {
  if (!client_.is_open()) return device::Taken::kNo;  // a goal must not wait for the next client
  if (message.subtype != p2d::kCmdPos) {
    const bool was_driving = set_goal(std::nullopt);
    const device::Taken taken = client_.command(kRobot, message.subtype, message.body);
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
bool Vfh::set_goal(std::optional<geom::Pose> X_OG) {
  bool had_one = false;
  {
    const std::lock_guard lock(mutex_);
    had_one = goal_.has_value();
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

void Vfh::request(const device::Message& message, device::Replier replier) {
  client_.forward(kRobot, message.subtype, message.body, std::move(replier));
}

bool Vfh::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  constexpr auto kCmd = static_cast<std::uint8_t>(wire::MessageType::kCmd);
  return (type == kCmd && subtype == p2d::kCmdPos) || client_.capable(kRobot, type, subtype);
}

void Vfh::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : position_.take()) {
    if (message.subtype == p2d::kDataState) take_state(message);
    message.device = device_;
    more.push_back(std::move(message));
  }
  if (const std::optional<device::Publication> scan = scans_.take_latest()) take_scan(*scan);
}

void Vfh::take_state(const device::Publication& message) {
  const Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state || !is_usable(state->pos) || !std::isfinite(state->vel.px)) return;
  const std::lock_guard lock(mutex_);
  state_ = *state;
}

void Vfh::take_scan(const device::Publication& message) {
  VfhIn in;
  VfhRobot robot;
  std::uint64_t drive_number = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || !state_ || !radius_ || !X_RS_) return;
    drive_number = goal_->drive;
    robot = {*radius_, *X_RS_};
    in.X_OG = goal_->X_OG;
    in.X_OR = pose_of(state_->pos);
    in.speed = state_->vel.px;
    in.stall = state_->stall != 0;
  }
  const Result<lsr::Data> scan = wire::decode<lsr::Data>(message.body);
  if (!scan) return;
  in.time = message.timestamp;
  in.max_range = scan->max_range;
  in.first_angle = scan->min_angle;
  in.angle_step = scan->resolution;
  in.ranges = scan->ranges;
  thread_.post([this, drive_number, robot, in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const VfhOut out = vfh_step(options_, robot, in, memory_);
    return [this, drive_number, X_OG = in.X_OG, out] { steer(drive_number, X_OG, out); };
  });
}

void Vfh::steer(std::uint64_t drive_number, const geom::Pose& X_OG, const VfhOut& out) {
  {
    const std::lock_guard lock(mutex_);
    if (!goal_ || goal_->drive != drive_number) return;
    if (X_OG != goal_->X_OG && out.done) return;  // at another goal
    if (out.done) goal_.reset();
  }
  drive(out.speed, out.turn_rate);
}

void Vfh::drive(double speed, double turn_rate) {
  client_.command(kRobot, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, turn_rate}, 1}));
}

Result<std::unique_ptr<device::Driver>> make_vfh(const scene::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"position2d"});
  if (!provided) return provided.error();
  const auto required = section_devices(section, site, "requires", {"position2d", "laser"});
  if (!required) return required.error();
  const Result<VfhOptions> options = vfh_options(section);
  if (!options) return options.error();

  auto driver = std::make_unique<Vfh>(site.surroundings(), *options);
  const device::Address shown = provided->front(), robot = required->front();
  const Result<device::DeviceId> id = site.add_device(shown, *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  const auto connected = [&site, shown, robot, &vfh = *driver]() -> Result<void> {
    Simulation* const simulation = site.simulation();
    if (simulation == nullptr) return {};
    Directory& directory = simulation->directory();
    directory.add(directory.model_of(robot), shown);
    vfh.thread().follow_ticks(simulation->world().tick(), kDelay);
    simulation->add_follower([&vfh](const world::World& world, const world::Change& change) {
      if (change.kind == world::Change::Kind::kReload) vfh.rewound(world.tick() == 0);
    });
    simulation->add_listener(
        [&vfh](const world::World& world, const world::Pace&) { vfh.thread().ticked(world.tick()); });
    return {};
  };
  site.add_user({driver.get(), &driver->client(), *provided, *required, section.at("requires"), connected});
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
