#include "playhouse/drivers/maps/gridmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

namespace {

constexpr int kHit = 3, kPass = -1, kSure = 100;  // of a balance
constexpr double kFarthest = 1e6;  // cells from the map's corner, where beams may begin and end

void weigh(std::int8_t& balance, int by) {
  balance = static_cast<std::int8_t>(std::clamp(balance + by, -kSure, kSure));
}

/// The cells along one axis that a line passes: where it is, which way, and how much of the line until the next cell.
struct AxisWalk {
  std::int64_t at = 0, end = 0, way = 0;
  double next = 0, each = 0;  // parts of the line

  AxisWalk(double from, double to)
      : at(static_cast<std::int64_t>(std::floor(from))), end(static_cast<std::int64_t>(std::floor(to))) {
    const double length = to - from;
    way = end > at ? 1 : -1;
    each = length != 0 ? 1 / std::fabs(length) : std::numeric_limits<double>::infinity();
    const double edge = way > 0 ? static_cast<double>(at) + 1 - from : from - static_cast<double>(at);
    next = at == end ? std::numeric_limits<double>::infinity() : edge * each;
  }
  void step() {
    at += way;
    next = at == end ? std::numeric_limits<double>::infinity() : next + each;
  }
};

bool is_in_reach(geom::Vec2 point) {
  return std::fabs(point.x) <= kFarthest && std::fabs(point.y) <= kFarthest;
}

}  // namespace

BeamMap::BeamMap(const GridMapOptions& options)
    : info_{static_cast<float>(options.scale),
            static_cast<std::uint32_t>(options.width),
            static_cast<std::uint32_t>(options.height),
            {-options.width * options.scale / 2, -options.height * options.scale / 2, 0}},
      balance_(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height)) {}

std::int8_t* BeamMap::cell(std::int64_t column, std::int64_t row) {
  if (column < 0 || row < 0 || column >= std::int64_t{info_.width} || row >= std::int64_t{info_.height})
    return nullptr;
  return &balance_[static_cast<std::size_t>(row) * info_.width + static_cast<std::size_t>(column)];
}

void BeamMap::add(geom::Vec2 from, geom::Vec2 to) {
  const double per_metre = 1 / static_cast<double>(info_.scale);
  const geom::Vec2 corner{info_.origin.px, info_.origin.py};
  const geom::Vec2 begin = per_metre * (from - corner), end = per_metre * (to - corner);
  if (!is_in_reach(begin) || !is_in_reach(end)) return;
  AxisWalk x(begin.x, end.x), y(begin.y, end.y);
  while (x.at != x.end || y.at != y.end) {
    if (std::int8_t* const passed = cell(x.at, y.at)) weigh(*passed, kPass);
    (x.next <= y.next ? x : y).step();
  }
  if (std::int8_t* const hit = cell(x.at, y.at)) weigh(*hit, kHit);
}

void BeamMap::clear() {
  std::ranges::fill(balance_, std::int8_t{0});
}

GridMap BeamMap::map() const {
  GridMap map{info_, balance_};
  for (std::int8_t& each : map.cells) each = static_cast<std::int8_t>((each > 0) - (each < 0));
  return map;
}

GridMapper::GridMapper(Shell& shell, const GridMapOptions& options, ScanInterface scans)
    : options_(options),
      states_(shell.client().queue(kOdometry, kStatesKept)),
      scans_(shell.client(), kScans, scans),
      beams_(options) {
  for (const std::uint8_t subtype : {wire::map::kReqGetInfo, wire::map::kReqGetData})
    shell.on_request(subtype, [this](const device::Message& message, device::Replier replier) {
      GridMap map;
      {
        const std::lock_guard lock(mutex_);
        map = beams_.map();
      }
      answer_map_request(map, message, std::move(replier));
    });
}

void GridMapper::opened() {
  scans_.ask([](const std::string& why) { log::warn("driver gridmap: {}: it makes no map", why); });
}

/// The map stays.
void GridMapper::closed() {
  const std::lock_guard lock(mutex_);
  poses_ = {};
}

void GridMapper::rewound(const Moment&) {
  const std::lock_guard lock(mutex_);
  poses_ = {};
  beams_.clear();
}

void GridMapper::take_news(std::vector<device::Publication>&) {
  for (const device::Publication& message : states_.take()) {
    if (message.subtype != wire::position2d::kDataState) continue;
    const Result<wire::position2d::Data> state = wire::decode<wire::position2d::Data>(message.body);
    const std::lock_guard lock(mutex_);
    if (state && is_usable(state->pos)) poses_.add(message.timestamp, pose_of(state->pos));
  }
  if (!scans_.take()) return;
  const std::optional<RangeScan> scan = scans_.scan();
  if (!scan || !is_usable(*scan)) return;
  const std::lock_guard lock(mutex_);
  std::optional<geom::Pose> X_WR = poses_.at(scans_.time());
  if (!X_WR) return;
  X_WR->x += options_.start_x * options_.scale;
  X_WR->y += options_.start_y * options_.scale;
  add(*scan, *X_WR);
}

/// Locked.
void GridMapper::add(const RangeScan& scan, const geom::Pose& X_WR) {
  for (std::size_t i = 0; i < scan.eyes.size() * scan.beams(); ++i) {
    const double range = static_cast<double>(scan.ranges[i]);
    if (!(range > 0 && range <= options_.farthest && range < scan.max_range)) continue;
    const geom::Vec2 eye = scan.eyes[i / scan.beams()].X_RS.xy();
    beams_.add(geom::transform(X_WR, eye), geom::transform(X_WR, end_of_beam(scan, i)));
  }
}

Result<GridMapOptions> grid_map_options(SectionFields fields) {
  constexpr int kMostSideCells = 8192, kFarStart = 100000;
  GridMapOptions options;
  options.width = fields.integer({"width", "Cells along x."}, options.width, 1, kMostSideCells);
  options.height = fields.integer({"height", "Cells along y."}, options.height, 1, kMostSideCells);
  options.start_x =
      fields.integer({"startx", "Cells from the middle of the map to where the pose of the robot is 0."},
                     options.start_x, -kFarStart, kFarStart);
  options.start_y = fields.integer({"starty", "The same along y."}, options.start_y, -kFarStart, kFarStart);
  options.scale = fields.length({"scale", "Size of a cell."}, options.scale, 0.001);
  options.farthest =
      fields.length({"sonartreshold", "Longer ranges are left out, as those of beams that hit nothing."},
                    options.farthest, 0);
  fields.expect(options.scale <= 1000, "scale", "is 1000 m at most");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_grid_map(const config::CfgSection& section, Site& site) {
  const ScanInterface scans = named_scans(section).front();
  return make_algorithm<GridMapper>(section, site,
                                    {.provides = {{"map"}}, .uses = {{"position2d"}, wanted_scan(scans)}},
                                    grid_map_options, scans);
}

constexpr DeviceText kGridMapProvides[] = {{"map"}};
constexpr DeviceText kGridMapUses[] = {{"position2d", {}, HowMany::kOne, "is the odometry"},
                                       {"laser", {}, HowMany::kOneOfThese, "on the robot"},
                                       {"ranger", {}, HowMany::kOneOfThese, "on the robot"},
                                       {"sonar", {}, HowMany::kOneOfThese, "on the robot"}};

}  // namespace

constinit const DriverDefinition kGridMapDriver{
    .name = "gridmap",
    .doc = "A map of what a robot's sonars, laser or ranger have hit and passed.",
    .provides = kGridMapProvides,
    .uses = kGridMapUses,
    .read_options = reading<grid_map_options>,
    .make = make_grid_map,
};

}  // namespace playhouse::drivers
