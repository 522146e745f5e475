#include "playhouse/drivers/nd/nd.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace p2d = wire::position2d;

Nd::Nd(Shell& shell, const NdOptions& options, const std::vector<ScanInterface>& scans)
    : GoalAlgorithm(shell, kOutput, kInput), options_(options) {
  for (const ScanInterface each : scans) scans_.emplace_back(shell.client(), kScans + scans_.size(), each);
}

void Nd::ask_geometry() {
  shell_.client().ask(kOutput, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) { take_body(body); });
  for (ScanReader& scans : scans_)
    scans.ask([this](const std::string& why) { drives_to_none(why + ", so it drives to no goals"); });
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

void Nd::take_scans() {
  std::vector<bool> is_new;
  for (ScanReader& scans : scans_) is_new.push_back(scans.take());
  if (std::ranges::find(is_new, true) == is_new.end()) return;
  if (!std::ranges::all_of(scans_, &ScanReader::is_ready)) return;
  std::optional<Trip> trip;
  NdRobot robot;
  {
    const std::lock_guard lock(mutex_);
    trip = this->trip();
    if (!trip || !body_) return;
    robot = {*body_};
  }
  NdIn in;
  in.X_OG = trip->X_OG;
  in.X_OR = pose_of(trip->state.pos);
  in.stall = trip->state.stall != 0;
  in.scans.resize(scans_.size());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    if (!is_new[i]) continue;
    in.time = scans_[i].time();
    in.scans[i] = scans_[i].scan();
    if (!in.scans[i]) return;
  }
  shell_.post([this, trip = *trip, robot, in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const NdOut out = nd_step(options_, robot, in, memory_);
    const DriveEnd end = out.done ? DriveEnd::kAtGoal : out.stuck ? DriveEnd::kStuck : DriveEnd::kNot;
    return [this, trip, out, end] { steer(trip, out.speed, out.turn_rate, end); };
  });
}

Result<std::unique_ptr<device::Driver>> make_nd(const config::CfgSection& section, Site& site) {
  WantedDevices wanted{.provides = {{"position2d"}},
                       .uses = {{"position2d", "output"}, {"position2d", "input"}}};
  const std::vector<ScanInterface> scans = named_scans(section);
  for (const ScanInterface each : scans)
    wanted.uses.push_back(scans.size() == 1 ? wanted_scan(each) : WantedDevice{.interf = name_of(each)});
  return make_algorithm<Nd>(section, site, wanted, nd_options, scans);
}

}  // namespace playhouse::drivers
