#include "playhouse/drivers/amcl/amcl.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/amcl/amcl_options.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/grid_map/map_reader.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace lcl = wire::localize;
namespace p2d = wire::position2d;

namespace {

constexpr std::size_t kHistory = 4096;  // estimates, some minutes of driving

/// True if the odometry was set between two of its states: it moved by more than twice its velocity.
bool was_set(const geom::Pose& X_O0O1, const wire::Pose2d& velocity, double seconds) {
  constexpr double kLength = 0.5, kAngle = 0.5;  // m, rad; beyond that
  const double speed = std::sqrt(velocity.px * velocity.px + velocity.py * velocity.py);
  return std::sqrt(geom::dot(X_O0O1.xy(), X_O0O1.xy())) > 2 * speed * seconds + kLength ||
         std::fabs(X_O0O1.a) > 2 * std::fabs(velocity.pa) * seconds + kAngle;
}

}  // namespace

Amcl::Amcl(Shell& shell, const AmclOptions& options, ScanInterface scans)
    : shell_(shell),
      options_(options),
      odometry_(shell.client().queue(kOdometry, kStatesKept)),
      scans_(shell.client(), kScans, scans),
      start_(options.start) {
  shell.on_request(
      lcl::kReqGetParticles,
      [this](const device::Message&, device::Replier replier) { replier.ack(wire::encode(particles())); },
      kLocalize);
  shell.on_request<lcl::SetPose>(
      lcl::kReqSetPose, [this](const lcl::SetPose& pose) { return set_pose(pose); }, kLocalize);
  shell.forward_request(p2d::kReqGetGeom, kOdometry, kPosition);
}

void Amcl::opened() {
  begin_anew(options_.start, std::nullopt);
  scans_.ask([](const std::string& why) { log::warn("driver amcl: {}: it does not localize", why); });
  read_map(shell_.client(), kMap, [this](Result<GridMap> map) {
    if (!map) return log::warn("driver amcl: it does not localize, as of its map {}", map.error().text);
    const std::lock_guard lock(mutex_);
    map_ = std::make_shared<const GridMap>(std::move(*map));
  });
}

void Amcl::rewound(const Moment& moment) {
  std::optional<Estimate> then;
  {
    const std::lock_guard lock(mutex_);
    while (!history_.empty() && history_.back().time > moment.time) history_.pop_back();
    if (!history_.empty()) then = history_.back();
  }
  begin_anew(then ? then->belief : options_.start, then);
}

void Amcl::placed() {
  const std::lock_guard lock(mutex_);
  placed_ = true;
}

AnswerBody Amcl::set_pose(const lcl::SetPose& pose) {
  if (!is_usable(pose.mean)) return std::nullopt;
  const PoseBelief belief{pose_of(pose.mean), pose.cov};
  if (!is_possible(belief)) return std::nullopt;
  begin_anew(belief, std::nullopt);
  return std::vector<std::byte>();
}

/// The filter's next step begins with `start`, that `estimate` was believed with; none: believed now.
void Amcl::begin_anew(const PoseBelief& start, std::optional<Estimate> estimate) {
  const std::lock_guard lock(mutex_);
  ++run_;
  steps_ = 0;
  start_ = start;
  X_OR_stepped_.reset();
  X_OR_.reset();
  X_SR_.reset();
  X_OS_ = estimate ? estimate->X_OS : geom::Pose();
  out_ = {};
  estimate_ = std::move(estimate);
}

// --- data

void Amcl::take_news(std::vector<device::Publication>& more) {
  for (const device::Publication& message : odometry_.take())
    if (message.subtype == p2d::kDataState) take_state(message, more);
  if (!scans_.take() || !is_due()) return;
  if (const std::optional<RangeScan> scan = scans_.scan()) take_scan(*scan, scans_.time());
}

void Amcl::take_state(const device::Publication& message, std::vector<device::Publication>& more) {
  const Result<p2d::Data> state = wire::decode<p2d::Data>(message.body);
  if (!state || !is_usable(state->pos)) return;
  const std::lock_guard lock(mutex_);
  take_odometry(pose_of(state->pos), state->vel, message.timestamp);
  if (!estimate_) estimate_ = {message.timestamp, X_OS_, *X_OR_, start_};
  more.push_back(
      {shell_.device(kLocalize), lcl::kDataHypoths, message.timestamp, wire::encode(hypotheses())});
  if (!shell_.provides(kPosition)) return;
  p2d::Data corrected = *state;
  corrected.pos = pose2d(moved(estimate_->belief.mean));
  more.push_back({shell_.device(kPosition), p2d::kDataState, message.timestamp, wire::encode(corrected)});
}

/// X_OR_ goes on as if nobody had set the odometry. Locked.
void Amcl::take_odometry(const geom::Pose& X_SR, const wire::Pose2d& velocity, double time) {
  if (X_SR_) {
    const geom::Pose motion = geom::compose(geom::inverse(*X_SR_), X_SR);
    if (!placed_ && was_set(motion, velocity, std::max(0.0, time - odometry_time_)))
      X_OS_ = geom::compose(geom::compose(X_OS_, *X_SR_), geom::inverse(X_SR));
  }
  X_SR_ = X_SR;
  odometry_time_ = time;
  placed_ = false;
  X_OR_ = geom::compose(X_OS_, X_SR);
}

/// What was at X_WR by the latest estimate is there now, by odometry. Locked.
geom::Pose Amcl::moved(const geom::Pose& X_WR) const {
  return geom::compose(X_WR, geom::compose(geom::inverse(estimate_->X_OR), *X_OR_));
}

/// True if the map is known, and the robot has moved enough since the latest step of this run.
bool Amcl::is_due() const {
  const std::lock_guard lock(mutex_);
  if (!map_ || !X_OR_) return false;
  if (!X_OR_stepped_) return true;
  const geom::Pose motion = geom::compose(geom::inverse(*X_OR_stepped_), *X_OR_);
  return std::sqrt(geom::dot(motion.xy(), motion.xy())) >= options_.update_distance ||
         std::fabs(motion.a) >= options_.update_angle;
}

void Amcl::take_scan(const RangeScan& scan, double time) {
  Estimate at;
  FilterIn in;
  in.hits_R = hits_of(scan);
  std::uint64_t run = 0;
  std::shared_ptr<const GridMap> map;
  {
    const std::lock_guard lock(mutex_);
    if (!map_ || !X_OR_) return;  // not any more
    in.seed = shell_.seed();
    in.number = steps_++;
    at = {time, X_OS_, *X_OR_, {moved(estimate_->belief.mean), start_.cov}};
    X_OR_stepped_ = X_OR_;
    run = run_;
    map = map_;
  }
  shell_.post([this, run, at, map, in = std::move(in)](bool) mutable -> AlgorithmThread::Delivery {
    FilterOut out = step(run, at.belief, at.X_OR, map, std::move(in));
    return [this, run, at, out = std::move(out)]() mutable { deliver(run, at, std::move(out)); };
  });
}

/// Where beams end that hit something, in R: evenly spread ones, or all, if they are few.
std::vector<geom::Vec2> Amcl::hits_of(const RangeScan& scan) const {
  std::vector<geom::Vec2> hits;
  if (!is_usable(scan)) return hits;
  const double most = std::min(options_.max_range, scan.max_range);
  const std::size_t beams = scan.ranges.size(), used = std::min(beams, options_.max_beams);
  for (std::size_t k = 0; k < used; ++k) {
    const std::size_t i = used > 1 ? k * (beams - 1) / (used - 1) : beams / 2;
    const double range = scan.ranges[i];
    if (range > 0 && range < most) hits.push_back(end_of_beam(scan, i));
  }
  return hits;
}

/// On the thread.
FilterOut Amcl::step(std::uint64_t run, const PoseBelief& start, const geom::Pose& X_OR,
                     std::shared_ptr<const GridMap> map, FilterIn in) {
  if (field_map_ != map) {
    field_.emplace(*map, options_.sensor);
    field_map_ = std::move(map);
  }
  if (memory_run_ != run) {
    in.start = start;
  } else {
    in.motion = geom::compose(geom::inverse(memory_X_OR_), X_OR);
  }
  memory_run_ = run;
  memory_X_OR_ = X_OR;
  return filter_step(options_, *field_, in, memory_);
}

void Amcl::deliver(std::uint64_t run, Estimate at, FilterOut out) {
  const std::lock_guard lock(mutex_);
  if (run != run_) return;
  at.belief = out.hypotheses.front().belief;
  estimate_ = at;
  out_ = std::move(out);
  history_.push_back(at);
  if (history_.size() > kHistory) history_.pop_front();
}

/// Locked; the odometry is known.
lcl::Data Amcl::hypotheses() const {
  lcl::Data data;
  data.pending_time = estimate_->time;
  for (const Hypothesis& each : out_.hypotheses)
    data.hypoths.push_back({pose2d(moved(each.belief.mean)), each.belief.cov, each.weight});
  if (data.hypoths.empty())
    data.hypoths.push_back({pose2d(moved(estimate_->belief.mean)), estimate_->belief.cov, 1});
  return data;
}

lcl::GetParticles Amcl::particles() const {
  const std::lock_guard lock(mutex_);
  lcl::GetParticles answer;
  if (!estimate_ || !X_OR_) {
    answer.mean = pose2d(start_.mean);
    answer.variance = start_.cov[0] + start_.cov[1];
    return answer;
  }
  answer.mean = pose2d(moved(estimate_->belief.mean));
  answer.variance = estimate_->belief.cov[0] + estimate_->belief.cov[1];
  for (const geom::Pose& particle : out_.particles)
    answer.particles.push_back({pose2d(moved(particle)), 1 / static_cast<double>(out_.particles.size())});
  return answer;
}

// --- sections of configuration files

Result<std::unique_ptr<device::Driver>> make_amcl(const config::CfgSection& section, Site& site) {
  const ScanInterface scans = named_scans(section).front();
  WantedDevices wanted{.provides = {{"localize"}}, .uses = {{"position2d"}, wanted_scan(scans), {"map"}}};
  if (names_device(section, "provides", "position2d")) wanted.provides.push_back({"position2d"});
  const auto options = [scans](const config::CfgSection& from) { return amcl_options(from, name_of(scans)); };
  return make_algorithm<Amcl>(section, site, wanted, options, scans);
}

}  // namespace playhouse::drivers
