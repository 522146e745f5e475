#include "playhouse/drivers/nd/nd.h"

#include <cmath>
#include <string_view>
#include <utility>

#include "playhouse/drivers/algorithm/sensor_places.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;
namespace snr = wire::sonar;

Nd::Nd(Shell& shell, const NdOptions& options, const Sensors& sensors)
    : GoalAlgorithm(shell, kOutput, kInput), options_(options), sensors_(sensors) {
  if (sensors.laser) laser_ = &shell.client().latest(*sensors.laser, lsr::kDataScan);
  if (sensors.sonar) sonar_ = &shell.client().latest(*sensors.sonar, snr::kDataRanges);
}

void Nd::ask_geometry() {
  device::DeviceClient& client = shell_.client();
  client.ask(kOutput, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) { take_body(body); });
  if (sensors_.laser) {
    ask_places(client, *sensors_.laser, ScanSensor::kLaser, [this](std::vector<geom::Pose> X_RS) {
      if (X_RS.empty()) return drives_to_none("its laser does not tell its place, so it drives to no goals");
      const std::lock_guard lock(mutex_);
      X_RS_ = X_RS.front();
    });
  }
  if (sensors_.sonar) {
    ask_places(client, *sensors_.sonar, ScanSensor::kSonar, [this](std::vector<geom::Pose> X_RS) {
      if (X_RS.empty())
        return drives_to_none("its sonars do not tell their places, so it drives to no goals");
      const std::lock_guard lock(mutex_);
      sonars_ = std::move(X_RS);
    });
  }
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

/// Constants of the robot, once all are known. With mutex_ held.
std::optional<NdRobot> Nd::robot() const {
  if (!body_ || (sensors_.laser && !X_RS_) || (sensors_.sonar && !sonars_)) return std::nullopt;
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
  shell_.post([this, trip = *trip, robot = std::move(*robot),
               in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const NdOut out = nd_step(options_, robot, in, memory_);
    const DriveEnd end = out.done ? DriveEnd::kAtGoal : out.stuck ? DriveEnd::kStuck : DriveEnd::kNot;
    return [this, trip, out, end] { steer(trip, out.speed, out.turn_rate, end); };
  });
}

Result<std::unique_ptr<device::Driver>> make_nd(const scene::CfgSection& section, Site& site) {
  WantedDevices wanted{.provides = {{"position2d"}},
                       .uses = {{"position2d", "output"}, {"position2d", "input"}}};
  Nd::Sensors sensors;
  const auto use = [&wanted](std::string_view interf) {
    wanted.uses.push_back({interf});
    return wanted.uses.size() - 1;
  };
  const bool has_sonar = names_device(section, "requires", "sonar");
  if (!has_sonar || names_device(section, "requires", "laser")) sensors.laser = use("laser");
  if (has_sonar) sensors.sonar = use("sonar");
  return make_algorithm<Nd>(section, site, wanted, nd_options, sensors);
}

}  // namespace playhouse::drivers
