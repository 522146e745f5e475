#include "playhouse/replicate/scene_text.h"

#include <fmt/format.h>

#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>
#include <cmath>
#include <iterator>
#include <map>

namespace playhouse::replicate {
namespace {

std::string quoted(std::string_view text) {
  return boost::json::serialize(boost::json::string(text));
}

/// "wander" of "wander 3 fast".
std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find(' '));
}

/// Metres and radians to a tenth of a millimetre: what a screen can show.
std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:g}", std::round(value * 1e4) / 1e4) : "0";
}

std::string pose(const geom::Pose& X) {
  return fmt::format("[{},{},{},{}]", number(X.x), number(X.y), number(X.z), number(X.a));
}

std::string size(const geom::Size& s) {
  return fmt::format("[{},{},{}]", number(s.x), number(s.y), number(s.z));
}

std::string color(const scene::Color& c) {
  return fmt::format("[{},{},{},{}]", number(c.r), number(c.g), number(c.b), number(c.a));
}

template <typename Range, typename Write>
std::string list(const Range& items, Write write) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ',';
    text += write(item);
  }
  return text += ']';
}

std::string polygon(const std::vector<geom::Vec2>& points) {
  return list(points, [](geom::Vec2 p) { return number(p.x) + ',' + number(p.y); });
}

/// {"solids": [{"z": [min, max], "loops": [[x, y, ...], ...]}]}: a block has one loop.
std::string shape(const scene::ModelDesc& model) {
  const auto solid = [](double z_min, double z_max, const std::string& loops) {
    return fmt::format(R"({{"z":[{},{}],"loops":{}}})", number(z_min), number(z_max), loops);
  };
  std::string text = list(model.blocks, [&](const scene::Block& block) {
    return solid(block.z_min, block.z_max, fmt::format("[{}]", polygon(block.points)));
  });
  const std::string traced = list(model.bitmaps, [&](const scene::Contours& bitmap) {
    return solid(bitmap.z_min, bitmap.z_max, list(bitmap.loops, polygon));
  });
  if (text == "[]") return traced;
  if (traced == "[]") return text;
  text.back() = ',';
  return text + traced.substr(1);
}

std::string sensors(const scene::ModelDesc& model) {
  return list(model.sensors, [](const scene::RangerSensorDesc& sensor) {
    return fmt::format(R"({{"pose":{},"size":{},"range":[{},{}],"fov":{},"samples":{},"color":{}}})",
                       pose(sensor.X_BS), size(sensor.size), number(sensor.range_min),
                       number(sensor.range_max), number(sensor.fov), sensor.samples, color(sensor.color));
  });
}

/// Texts in order of first use; equal texts are one.
class Texts {
 public:
  std::size_t row(const std::string& text) {
    const auto [it, fresh] = rows_.try_emplace(text, rows_.size());
    if (fresh) {
      if (!all_.empty()) all_ += ',';
      all_ += text;
    }
    return it->second;
  }
  const std::string& all() const { return all_; }

 private:
  std::map<std::string, std::size_t> rows_;
  std::string all_;
};

std::string window(const scene::WindowDesc& window) {
  return fmt::format(R"({{"center":[{},{}],"scale":{},"pitch":{},"yaw":{},"sensors":{},"follow":{}}})",
                     number(window.center.x), number(window.center.y), number(window.scale),
                     number(window.pitch), number(window.yaw), window.show_data, quoted(window.follow_model));
}

const char* kind(scene::ModelKind kind) {
  switch (kind) {
    case scene::ModelKind::kPosition:
      return "position";
    case scene::ModelKind::kRanger:
      return "ranger";
    case scene::ModelKind::kFiducial:
      return "fiducial";
    case scene::ModelKind::kPlain:
      break;
  }
  return "plain";
}

std::string model(const world::World& world, const Layout& layout, const DeviceNames& devices,
                  std::uint32_t row, Texts& shapes, Texts& sensor_sets) {
  const scene::ModelDesc& desc = world.desc({row});
  const ModelState& start = layout.start[row];
  std::string text =
      fmt::format(R"({{"name":{},"type":{},"kind":"{}","parent":{},"start":[{},{},{},{},{},{}])",
                  quoted(desc.name), quoted(desc.type), kind(desc.kind), desc.parent, start.x, start.y,
                  start.z, start.a, start.state, start.color);
  auto out = std::back_inserter(text);
  if (desc.alias != desc.name) fmt::format_to(out, R"(,"alias":{})", quoted(desc.alias));
  if (row < devices.size() && !devices[row].empty())
    fmt::format_to(out, R"(,"devices":{})", list(devices[row], quoted));
  if (!desc.ctrl.empty())
    fmt::format_to(out, R"(,"controllers":{})",
                   list(desc.ctrl, [](const std::string& line) { return quoted(first_word(line)); }));
  if (desc.X_MB != geom::Pose{}) fmt::format_to(out, R"(,"origin":{})", pose(desc.X_MB));
  fmt::format_to(out, R"(,"size":{})", size(desc.size));
  if (!desc.blocks.empty() || !desc.bitmaps.empty())
    fmt::format_to(out, R"(,"shape":{})", shapes.row(shape(desc)));
  if (layout.traits[row] & kMovable) text += R"(,"movable":true)";
  const std::int32_t fiducial = world.models.fiducial_return[row];
  if (fiducial != 0) fmt::format_to(out, R"(,"fiducial":{})", fiducial);
  if (desc.kind == scene::ModelKind::kPosition) {
    fmt::format_to(out, R"(,"position":{},"trail":{})", world.models.part[row], desc.trail_length);
  }
  if (desc.kind == scene::ModelKind::kRanger) {
    const std::uint32_t ranger = world.models.part[row];
    fmt::format_to(out, R"(,"first_sensor":{},"sensors":{})", world.rangers.first_sensor[ranger],
                   sensor_sets.row(sensors(desc)));
  }
  if (desc.kind == scene::ModelKind::kFiducial && desc.fiducial) {
    fmt::format_to(out, R"(,"finder":{},"range":{},"fov":{})", world.models.part[row],
                   number(desc.fiducial->range_max), number(desc.fiducial->fov));
  }
  return text += '}';
}

}  // namespace

std::string scene_text(const world::World& world, const Layout& layout, const DeviceNames& devices) {
  Texts shapes, sensor_sets;
  std::string models;
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    if (row > 0) models += ",\n";
    models += model(world, layout, devices, row, shapes, sensor_sets);
  }
  const scene::SceneDesc& scene = world.scene();
  return fmt::format(
      "{{\"protocol\":1,\"name\":{},\"interval\":{:.9g},\"window\":{},\n\"shapes\":[{}],\n\"sensors\":[{}],\n"
      "\"models\":[\n{}]}}\n",
      quoted(scene.name), scene.interval, window(scene.window), shapes.all(), sensor_sets.all(), models);
}

}  // namespace playhouse::replicate
