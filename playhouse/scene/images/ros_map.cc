#include "playhouse/scene/images/ros_map.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/images/read_image.h"

namespace playhouse::scene {
namespace {

constexpr std::array<std::string_view, 7> kKeys = {"image",           "resolution",  "origin", "negate",
                                                   "occupied_thresh", "free_thresh", "mode"};
constexpr std::size_t kMostWarnings = 16;
constexpr std::array<std::string_view, 3> kModes = {"trinary", "scale", "raw"};

Error at(const YAML::Mark& mark, const std::string& text) {
  return {mark.is_null() ? "" : std::to_string(mark.line + 1), text};
}

/// A finite number, or an error.
Result<double> number(const YAML::Node& node, std::string_view key) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
    return at(node.Mark(), fmt::format("{} needs a number", in_quotes(key)));
  return value;
}

Result<void> read_origin(const YAML::Node& node, geom::Pose& to) {
  if (!node.IsSequence() || node.size() != 3) return at(node.Mark(), "\"origin\" needs [x, y, yaw]");
  double values[3] = {};
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Result<double> value = number(node[i], "origin");
    if (!value) return value.error();
    values[i] = *value;
  }
  to = {values[0], values[1], 0, geom::normalize(values[2])};
  return {};
}

Result<void> read_key(const std::string& key, const YAML::Node& node, RosMap& map) {
  if (key == "origin") return read_origin(node, map.origin);
  if (key == "image" || key == "mode") {
    if (!node.IsScalar()) return at(node.Mark(), fmt::format("{} needs a text", in_quotes(key)));
    (key == "image" ? map.image : map.mode) = node.Scalar();
    if (key == "mode" && std::ranges::find(kModes, map.mode) == kModes.end())
      return at(node.Mark(),
                fmt::format("there is no mode {}{}", in_quotes(map.mode), did_you_mean(map.mode, kModes)));
    return {};
  }
  if (key == "negate") {
    bool negate = false;  // usually 0 or 1, sometimes a word
    if (!node.IsScalar()) return at(node.Mark(), "\"negate\" needs 0 or 1");
    if (node.Scalar() != "0" && node.Scalar() != "1" && !YAML::convert<bool>::decode(node, negate))
      return at(node.Mark(), "\"negate\" needs 0 or 1");
    map.negate = negate || node.Scalar() == "1";
    return {};
  }
  const Result<double> value = number(node, key);
  if (!value) return value.error();
  (key == "resolution" ? map.resolution : key == "free_thresh" ? map.free : map.occupied) = *value;
  return {};
}

Result<RosMap> map_of(const YAML::Node& root) {
  if (!root.IsMap()) return at(root.Mark(), "is not a map of ROS: it needs lines like \"resolution: 0.05\"");
  RosMap map;
  std::set<std::string> given;
  for (const auto& entry : root) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (std::ranges::find(kKeys, key) == kKeys.end()) {  // map servers ignore it
      if (map.warnings.size() == kMostWarnings) continue;
      map.warnings.push_back(at(
          entry.first.Mark(), fmt::format("there is no key {}{}", in_quotes(key), did_you_mean(key, kKeys))));
      continue;
    }
    given.insert(key);
    if (const Result<void> read = read_key(key, entry.second, map); !read) return read.error();
  }
  for (const std::string key : {"image", "resolution", "origin"})
    if (!given.contains(key))
      return map.warnings.empty() ? Error{"", fmt::format("lacks {}", in_quotes(key))} : map.warnings.front();
  if (!(map.resolution > 0)) return at(root["resolution"].Mark(), "\"resolution\" needs a number above 0");
  if (map.free > map.occupied)
    return at(root.Mark(), "\"free_thresh\" is above \"occupied_thresh\", so a pixel might be both");
  return map;
}

}  // namespace

Result<RosMap> read_ros_map(const std::string& text) {
  try {
    return map_of(YAML::Load(text));
  } catch (const YAML::Exception& fault) {
    return at(fault.mark, fault.msg);
  }
}

MapImage image_of(const RosMap& map, const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(path).parent_path();
  const fs::path image = folder / map.image;  // absolute paths replace the folder
  const fs::path beside = folder / image.filename();
  std::error_code ignored;
  const bool is_elsewhere = fs::path(map.image).is_absolute() && !fs::exists(image, ignored);
  if (is_elsewhere && fs::exists(beside, ignored)) return {beside.string(), true};
  return {image.string(), false};
}

bool is_map_name(std::string_view name) {
  return name.ends_with(".yaml") || name.ends_with(".yml");
}

namespace {

/// State of a map cell.
struct Cell {
  bool wall = false, free = false;  // neither: unknown
};

/// Thresholds also apply to raw maps: a world has no partial occupancy.
Cell cell_of(const RosMap& map, const images::Shades& image, std::size_t pixel) {
  const bool has_alpha = !image.alpha.empty();
  const bool with_alpha = has_alpha && map.mode == "trinary";
  const double light =
      with_alpha ? (image.color[pixel] + image.alpha[pixel]) / 4.0 : image.color[pixel] / 3.0;
  if (map.mode == "raw") {
    const double percent = std::round(light);
    if (percent > 100) return {};
    return {percent > 100 * map.occupied, percent < 100 * map.free};
  }
  if (map.mode == "scale" && has_alpha && image.alpha[pixel] < 255) return {};
  const double occupied = (map.negate ? light : 255 - light) / 255;
  return {occupied > map.occupied, occupied < map.free};
}

}  // namespace

Result<Plan> plan_of_ros_map(const RosMap& map, std::string_view bytes, std::string name) {
  const auto image = images::read_image<images::Shades>(bytes, {limits::kBitmapPixels});
  if (!image) return image.error();
  Plan plan{std::move(name),
            {image->width, image->height, {}},
            {image->width, image->height, {}},
            map.resolution,
            map.origin};
  for (std::size_t pixel = 0; pixel < image->color.size(); ++pixel) {
    const Cell cell = cell_of(map, *image, pixel);
    plan.solid.solid.push_back(cell.wall);
    plan.free.solid.push_back(cell.free);
  }
  return plan;
}

bool is_plain(const Plan& plan, std::string_view bytes) {
  const Result<Bitmap> alone = decode_bitmap(bytes);
  return alone && alone->solid == plan.solid.solid;
}

std::string ros_map_of(const Plan& plan, const std::string& image) {
  return fmt::format(
      "image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, {}]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.25\n",
      image, plan.resolution, plan.X_WI.x, plan.X_WI.y, plan.X_WI.a);
}

}  // namespace playhouse::scene
