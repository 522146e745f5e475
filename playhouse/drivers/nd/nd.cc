#include "playhouse/drivers/nd/nd.h"

#include <cmath>
#include <utility>

#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;
namespace snr = wire::sonar;

Nd::Nd(device::Opener& opener, const Devices& devices, NdOptions options)
    : GoalDriver(opener, devices.count, devices.output, devices.input),
      devices_(devices),
      options_(std::move(options)) {
  if (devices.laser) laser_ = &client_.latest(*devices.laser, lsr::kDataScan);
  if (devices.sonar) sonar_ = &client_.latest(*devices.sonar, snr::kDataRanges);
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
  if (!has_size) return drives_to_none("its robot does not tell its size, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  body_ = box;
}

void Nd::take_laser_geometry(const AnswerBody& body) {
  const std::optional<lsr::Geom> geom = decoded<lsr::Geom>(body);
  const std::optional<geom::Pose> X_RS = geom ? planar(geom->pose) : std::nullopt;
  if (!X_RS) return drives_to_none("its laser does not tell its place, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  X_RS_ = X_RS;
}

void Nd::take_sonar_geometry(const AnswerBody& body) {
  const snr::Geom geom = decoded<snr::Geom>(body).value_or(snr::Geom{});
  std::vector<geom::Pose> sonars;
  for (const wire::Pose3d& pose : geom.poses)
    if (const std::optional<geom::Pose> X_RS = planar(pose)) sonars.push_back(*X_RS);
  if (sonars.empty() || sonars.size() < geom.poses.size())
    return drives_to_none("its sonars do not tell their places, so it drives to no goals");
  const std::lock_guard lock(mutex_);
  sonars_ = std::move(sonars);
}

/// Constants of the robot, once all are known. With mutex_ held.
std::optional<NdRobot> Nd::robot() const {
  if (!body_ || (devices_.laser && !X_RS_) || (devices_.sonar && !sonars_)) return std::nullopt;
  return NdRobot{*body_, X_RS_.value_or(geom::Pose{}), sonars_.value_or(std::vector<geom::Pose>{})};
}

void Nd::take_scans() {
  const auto newest = [](device::Subscription* scans) {
    return scans == nullptr ? std::nullopt : scans->take_latest();
  };
  const std::optional<device::Publication> laser = newest(laser_), sonar = newest(sonar_);
  if (!laser && !sonar) return;
  std::optional<Trip> trip;
  std::optional<NdRobot> robot;
  {
    const std::lock_guard lock(mutex_);
    trip = this->trip();
    robot = this->robot();
    if (!trip || !robot) return;
  }
  NdIn in;
  in.X_OG = trip->X_OG;
  in.X_OR = pose_of(trip->state.pos);
  in.stall = trip->state.stall != 0;
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
  thread_.post([this, trip = *trip, robot = std::move(*robot),
                in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const NdOut out = nd_step(options_, robot, in, memory_);
    const End end = out.done ? End::kAtGoal : out.stuck ? End::kStuck : End::kNot;
    return [this, trip, out, end] { steer(trip, out.speed, out.turn_rate, end); };
  });
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

  return add_goal_driver(section, site,
                         std::make_unique<Nd>(site.surroundings(), required->devices, *options),
                         provided->front(), required->addresses);
}

}  // namespace playhouse::drivers
