#include "playhouse/drivers/vfh/vfh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/vfh/vfh_options.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

Vfh::Vfh(Shell& shell, const VfhOptions& options, ScanInterface scans)
    : GoalAlgorithm(shell, kRobot, kRobot), options_(options), scans_(shell.client(), kScans, scans) {
  offer_planner(kPlanner);
}

void Vfh::ask_geometry() {
  shell_.client().ask(kRobot, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const std::optional<p2d::Geom> geom = decoded<p2d::Geom>(body);
    if (!geom) return drives_to_none("its robot does not tell its size, so it drives to no goals");
    const std::lock_guard lock(mutex_);
    radius_ = std::max(geom->size.sl, geom->size.sw) / 2;
  });
  scans_.ask([this](const std::string& why) { drives_to_none(why + ", so it drives to no goals"); });
}

bool Vfh::is_usable_state(const p2d::Data& state) const {
  return GoalAlgorithm::is_usable_state(state) && std::isfinite(state.vel.px);
}

void Vfh::take_scans() {
  if (!scans_.take()) return;
  std::optional<Trip> trip;
  VfhRobot robot;
  {
    const std::lock_guard lock(mutex_);
    trip = this->trip();
    if (!trip || !radius_) return;
    robot = {*radius_};
  }
  std::optional<RangeScan> scan = scans_.scan();
  if (!scan) return;
  VfhIn in;
  in.X_OG = trip->X_OG;
  in.X_OR = pose_of(trip->state.pos);
  in.speed = trip->state.vel.px;
  in.stall = trip->state.stall != 0;
  in.time = scans_.time();
  in.scan = std::move(*scan);
  shell_.post([this, trip = *trip, robot, in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const VfhOut out = vfh_step(options_, robot, in, memory_);
    return [this, trip, out] {
      steer(trip, out.speed, out.turn_rate, out.done ? DriveEnd::kAtGoal : DriveEnd::kNot);
    };
  });
}

Result<std::unique_ptr<device::Driver>> make_vfh(const config::CfgSection& section, Site& site) {
  const ScanInterface scans = named_scans(section).front();
  WantedDevices wanted{.provides = {{"position2d"}}, .uses = {{"position2d"}, wanted_scan(scans)}};
  if (names_device(section, "provides", "planner")) wanted.provides.push_back({"planner"});
  return make_algorithm<Vfh>(section, site, wanted, vfh_options, scans);
}

}  // namespace playhouse::drivers
