#include "playhouse/app/pictures/sensor_shapes.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/split.h"
#include "playhouse/world/columns.h"

namespace playhouse::app {
namespace {

using geom::Pose;
using geom::Rotation;
using geom::Vec2;

constexpr int kConeSteps = 8;
constexpr scene::Color kMark{0.88f, 0.54f, 0, 0.9f};       // lines to fiducials and tags
constexpr scene::Color kView{0.55f, 0.25f, 0.75f, 0.12f};  // camera's field of view
constexpr float kLink = 0.6f;                              // alpha of a lossless link

/// Drawing context of one model.
struct Sketch {
  const world::World& world;
  world::ModelRow model;
  double line_width;  // m
  std::vector<FilledShape>& shapes;

  Pose X_WB() const { return geom::compose(world.models.X_WM[model], world.desc(model).X_MB); }
  world::KindRow row() const { return world.models.part[model]; }

  void area(std::vector<Vec2> loop, double z, const scene::Color& color) const {
    shapes.push_back({{std::move(loop)}, z, color, false});
  }
  void line(Vec2 from, Vec2 to, double z, const scene::Color& color) const {
    const Vec2 way = to - from;
    const double length = std::sqrt(geom::dot(way, way));
    if (length == 0) return;
    const Vec2 aside = (0.5 * line_width / length) * Vec2{-way.y, way.x};
    area({from - aside, to - aside, to + aside, from + aside}, z, color);
  }
};

/// A point at a bearing and distance from X.
Vec2 point_at(const Pose& X, double bearing, double distance) {
  return X.xy() + Rotation::of(X.a + bearing) * Vec2{distance, 0};
}

void add_scans(const Sketch& sketch) {
  const world::World& world = sketch.world;
  const std::vector<scene::RangerSensorDesc>& sensors = world.desc(sketch.model).sensors;
  for (std::uint32_t i = 0; i < sensors.size(); ++i) {
    const scene::RangerSensorDesc& sensor = sensors[i];
    const world::SensorRow row = sensors_of(world.rangers, sketch.row())[i];
    const Pose X_WS = geom::compose(sketch.X_WB(), sensor.X_BS);
    const std::span<const float> ranges =
        std::span(world.sensors.ranges.from(world.sensors.first_beam[row]), world.sensors.beam_count[row]);
    // A single beam stands for the sensor's whole cone.
    const std::size_t corners = ranges.size() == 1 ? kConeSteps + 1 : ranges.size();
    std::vector<Vec2> fan{X_WS.xy()};
    for (std::size_t k = 0; k < corners; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(corners - 1) - 0.5;
      fan.push_back(
          point_at(X_WS, share * sensor.fov, static_cast<double>(ranges[ranges.size() == 1 ? 0 : k])));
    }
    sketch.area(std::move(fan), X_WS.z + sensor.size.z / 2, sensor.color);
  }
}

/// A line to each detection, by bearing and range.
template <typename Things>
void add_lines(const Sketch& sketch, const Things& things, const scene::Color& color) {
  const Pose X_WB = sketch.X_WB();
  for (const auto& thing : things)
    sketch.line(X_WB.xy(), point_at(X_WB, thing.bearing, thing.range), X_WB.z, color);
}

void add_fiducials(const Sketch& sketch) {
  add_lines(sketch, sketch.world.fiducials.hits[sketch.row()], kMark);
}

void add_links(const Sketch& sketch) {
  const world::World& world = sketch.world;
  const Pose X_WB = sketch.X_WB();
  scene::Color color = world.models.color[sketch.model];
  for (const world::WifiLink& link : world.wifis.links[sketch.row()]) {
    const world::ModelRow station = world.row(link.station);
    if (!station) continue;
    color.a = kLink * static_cast<float>(link.quality) / 100;
    sketch.line(X_WB.xy(), world.models.X_WM[station].xy(), X_WB.z, color);
  }
}

void add_tags(const Sketch& sketch) {
  const world::World& world = sketch.world;
  const Pose X_WB = sketch.X_WB();
  for (const world::TagInRange& tag : world.rfids.tags[sketch.row()])
    if (const world::ModelRow target = world.row(tag.target))
      sketch.line(X_WB.xy(), world.models.X_WM[target].xy(), X_WB.z, kMark);
}

void add_finds(const Sketch& sketch) {
  add_lines(sketch, sketch.world.detectors.finds[sketch.row()], sketch.world.models.color[sketch.model]);
}

/// Field of view between near and far planes, along the optical axis.
void add_view(const Sketch& sketch) {
  const world::World& world = sketch.world;
  const scene::CameraDesc& camera = *world.desc(sketch.model).camera;
  const Pose X_WB = sketch.X_WB();
  const Rotation looks = Rotation::of(X_WB.a + world.cameras.pan[sketch.row()]);
  const Rotation half = Rotation::of(world.cameras.zoom[sketch.row()] / 2);
  const auto corner = [&](double depth, double side) {
    return X_WB.xy() + looks * Vec2{depth, side * depth * half.s / half.c};
  };
  sketch.area({corner(camera.range_min, -1), corner(camera.range_max, -1), corner(camera.range_max, 1),
               corner(camera.range_min, 1)},
              X_WB.z, kView);
}

/// A kind of sensor that can be drawn.
struct Drawn {
  std::string_view name;
  scene::ModelKind kind;
  bool measures;  // draws measurements, nothing before the first
  void (*add)(const Sketch& sketch);
};

constexpr Drawn kDrawn[] = {
    {"ranger", scene::ModelKind::kRanger, true, add_scans},
    {"fiducial", scene::ModelKind::kFiducial, true, add_fiducials},
    {"wifi", scene::ModelKind::kWifi, true, add_links},
    {"camera", scene::ModelKind::kCamera, false, add_view},
    {"detector", scene::ModelKind::kDetector, true, add_finds},
    {"rfid", scene::ModelKind::kRfid, true, add_tags},
};

std::uint64_t measured_tick(const world::World& world, world::ModelRow model) {
  std::uint64_t tick = 0;
  const world::KindRow row = world.models.part[model];
  world::of_kind(world.models.kind[model], [&]<typename Table>(Table world::Tables::*table) {
    if constexpr (requires(Table rows) { rows.measured_tick; }) tick = (world.*table).measured_tick[row];
  });
  return tick;
}

std::vector<std::string_view> words() {
  std::vector<std::string_view> names{"all"};
  for (const Drawn& each : kDrawn) names.push_back(each.name);
  return names;
}

}  // namespace

std::string SensorShapes::names() {
  return fmt::format("{}", fmt::join(words(), ", "));
}

Result<SensorShapes> SensorShapes::parse(std::string_view text) {
  const std::vector<std::string_view> names = words();
  SensorShapes shown;
  for (const std::string_view name : split(text, ',')) {
    if (std::ranges::find(names, name) == names.end())
      return Error{"", fmt::format("invalid name {}: {} are valid{}", in_quotes(name), SensorShapes::names(),
                                   did_you_mean(name, names))};
    for (std::size_t i = 0; i < std::size(kDrawn); ++i)
      if (name == "all" || name == kDrawn[i].name) shown.drawn_.push_back(i);
  }
  std::ranges::sort(shown.drawn_);
  shown.drawn_.erase(std::unique(shown.drawn_.begin(), shown.drawn_.end()), shown.drawn_.end());
  return shown;
}

void SensorShapes::watch(world::World& world) const {
  for (const std::size_t place : drawn_) {
    if (!kDrawn[place].measures) continue;
    for (const world::ModelRow row : world.models.rows())
      if (world.models.kind[row] == kDrawn[place].kind) world::watch(world, row);
  }
}

void SensorShapes::add_to(std::vector<FilledShape>& shapes, const world::World& world,
                          double line_width) const {
  for (const std::size_t place : drawn_)
    for (const world::ModelRow row : world.models.rows())
      if (world.models.kind[row] == kDrawn[place].kind &&
          (!kDrawn[place].measures || measured_tick(world, row) > 0))
        kDrawn[place].add({world, row, line_width, shapes});
}

}  // namespace playhouse::app
