#include "playhouse/drivers/vfh/vfh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/drivers/vfh/vfh_options.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace p2d = wire::position2d;

namespace {

// Indices of the client's devices.
constexpr std::size_t kRobot = 0;
constexpr std::size_t kLaser = 1;

}  // namespace

Vfh::Vfh(device::Opener& opener, const VfhOptions& options)
    : GoalDriver(opener, 2, kRobot, kRobot),
      options_(options),
      scans_(client_.latest(kLaser, lsr::kDataScan)) {}

void Vfh::ask_geometry() {
  client_.ask(kRobot, p2d::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const std::optional<p2d::Geom> geom = decoded<p2d::Geom>(body);
    if (!geom) return drives_to_none("its robot does not tell its size, so it drives to no goals");
    const std::lock_guard lock(mutex_);
    radius_ = std::max(geom->size.sl, geom->size.sw) / 2;
  });
  client_.ask(kLaser, lsr::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const std::optional<lsr::Geom> geom = decoded<lsr::Geom>(body);
    const std::optional<geom::Pose> X_RS = geom ? planar(geom->pose) : std::nullopt;
    if (!X_RS) return drives_to_none("its laser does not tell its place, so it drives to no goals");
    const std::lock_guard lock(mutex_);
    X_RS_ = X_RS;
  });
}

bool Vfh::is_usable_state(const p2d::Data& state) const {
  return GoalDriver::is_usable_state(state) && std::isfinite(state.vel.px);
}

void Vfh::take_scans() {
  const std::optional<device::Publication> message = scans_.take_latest();
  if (!message) return;
  std::optional<Trip> trip;
  VfhRobot robot;
  {
    const std::lock_guard lock(mutex_);
    trip = this->trip();
    if (!trip || !radius_ || !X_RS_) return;
    robot = {*radius_, *X_RS_};
  }
  const Result<lsr::Data> scan = wire::decode<lsr::Data>(message->body);
  if (!scan) return;
  VfhIn in;
  in.X_OG = trip->X_OG;
  in.X_OR = pose_of(trip->state.pos);
  in.speed = trip->state.vel.px;
  in.stall = trip->state.stall != 0;
  in.time = message->timestamp;
  in.max_range = scan->max_range;
  in.first_angle = scan->min_angle;
  in.angle_step = scan->resolution;
  in.ranges = scan->ranges;
  thread_.post([this, trip = *trip, robot, in = std::move(in)](bool fresh) -> AlgorithmThread::Delivery {
    if (fresh) memory_ = {};
    const VfhOut out = vfh_step(options_, robot, in, memory_);
    return [this, trip, out] { steer(trip, out.speed, out.turn_rate, out.done ? End::kAtGoal : End::kNot); };
  });
}

Result<std::unique_ptr<device::Driver>> make_vfh(const scene::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"position2d"});
  if (!provided) return provided.error();
  const auto required = section_devices(section, site, "requires", {"position2d", "laser"});
  if (!required) return required.error();
  const Result<VfhOptions> options = vfh_options(section);
  if (!options) return options.error();

  return add_goal_driver(section, site, std::make_unique<Vfh>(site.surroundings(), *options),
                         provided->front(), *required);
}

}  // namespace playhouse::drivers
