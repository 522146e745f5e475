#include "playhouse/bridge/mapfile/map_file.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/scene/images/ros_map.h"

namespace playhouse::drivers {
namespace {

// Shares of black above which a pixel is occupied, and below which it is free.
constexpr double kOccupied = 0.95, kFree = 0.1;
constexpr double kFinest = 1e-4, kCoarsest = 1000;  // m per pixel

/// By rows from the bottom, as the interface has them.
std::vector<std::int8_t> cells_of(const scene::Plan& plan) {
  std::vector<std::int8_t> cells;
  cells.reserve(plan.solid.solid.size());
  for (int y = plan.solid.height - 1; y >= 0; --y)
    for (int x = 0; x < plan.solid.width; ++x)
      cells.push_back(plan.solid.at(x, y) ? 1 : plan.free.at(x, y) ? -1 : 0);
  return cells;
}

constexpr DeviceText kMapFileProvides[] = {{"map"}};

/// The options, apart from `origin`, whose default depends on the image.
struct MapFileOptions {
  std::string path;
  double resolution;  // m per pixel
  bool negate;
};

MapFileOptions map_file_options(SectionFields& fields) {
  MapFileOptions options;
  options.path =
      fields.filename({"filename",
                       "An image, relative to the folder of the configuration file; or the .yaml file of a "
                       "map of ROS, which says the rest: the other options are then errors.",
                       {},
                       "required"});
  options.resolution = fields.length({"resolution", "Size of a pixel, 0.0001 to 1000.", {}, "required"}, 0,
                                     SectionFields::kAnyNumber);
  options.negate = fields.flag({"negate", "1: bright pixels are occupied."}, false);
  return options;
}

wire::Pose2d origin_of(SectionFields& fields, double middle_x, double middle_y) {
  const double any = SectionFields::kAnyNumber;
  const double x = fields.length({"origin",
                                  "x, y and heading of the map's lower left corner.",
                                  {},
                                  "the origin is the middle of the map"},
                                 middle_x, any, 0),
               y = fields.length({"origin"}, middle_y, any, 1);
  return {x, y, fields.angle({"origin"}, 0, 2, any)};
}

void read_map_file(SectionFields fields) {
  map_file_options(fields);
  origin_of(fields, 0, 0);
}

/// What a section says about the image that it names; its origin apart.
Result<scene::RosMap> map_of(const config::CfgSection& section, const MapFileOptions& options) {
  if (!section.has("resolution"))
    return Error{section.at(), "driver \"mapfile\" needs a resolution, the size of a pixel in metres" +
                                   section.slip_for("resolution")};
  scene::RosMap map;
  map.image = options.path;
  map.resolution = options.resolution;
  map.negate = options.negate;
  map.occupied = kOccupied;
  map.free = kFree;
  return map;
}

/// The map of ROS that a section names, with the path of its image; it says everything itself.
Result<scene::RosMap> read_map(const config::CfgSection& section, const std::string& path) {
  for (const std::string_view key : {"resolution", "origin", "negate"})
    if (section.has(key))
      return Error{section.at(key), in_quotes(key) + " is what " + in_quotes(path) + " says: leave it out"};
  const Result<std::string> text = config::DiskFiles().read(path);
  if (!text) return Error{section.at("filename"), in_quotes(path) + ": " + text.error().text};
  Result<scene::RosMap> map = scene::read_ros_map(*text);
  if (!map) {
    const std::string line = map.error().where.empty() ? "" : ", line " + map.error().where;
    return Error{section.at("filename"), in_quotes(path) + line + ": " + map.error().text};
  }
  for (const Error& warning : map->warnings)
    log::warn("driver mapfile: {}:{}: {}; it has no effect", escaped(path), warning.where, warning.text);
  const scene::MapImage image = scene::image_of(*map, path);
  if (image.is_instead)
    log::warn("driver mapfile: there is no {}; {} is read instead", in_quotes(map->image),
              in_quotes(image.path));
  map->image = image.path;
  return map;
}

Result<GridMap> read_grid(const config::CfgSection& section) {
  if (!section.has("filename"))
    return Error{section.at(), "driver \"mapfile\" needs a filename" + section.slip_for("filename")};
  SectionFields fields(section);
  const MapFileOptions options = map_file_options(fields);
  const std::string& path = options.path;
  const bool is_of_ros = scene::is_map_name(path);
  Result<scene::RosMap> read = is_of_ros ? read_map(section, path) : map_of(section, options);
  if (!read) return read.error();
  const scene::RosMap& map = *read;
  if (!(map.resolution >= kFinest && map.resolution <= kCoarsest))
    return Error{section.at(is_of_ros ? "filename" : "resolution"),
                 fmt::format("resolution is from {} to {} m per pixel", kFinest, kCoarsest)};
  const Result<std::string> bytes = config::DiskFiles().read(map.image);
  if (!bytes) return Error{section.at("filename"), in_quotes(map.image) + ": " + bytes.error().text};
  const Result<scene::Plan> plan = scene::plan_of_ros_map(map, *bytes, path);
  if (!plan) return Error{section.at("filename"), in_quotes(map.image) + ": " + plan.error().text};
  const auto middle = [&](int pixels) { return -0.5 * (pixels * map.resolution); };
  const wire::Pose2d origin = is_of_ros
                                  ? wire::Pose2d{map.origin.x, map.origin.y, map.origin.a}
                                  : origin_of(fields, middle(plan->solid.width), middle(plan->solid.height));
  const auto width = static_cast<std::uint32_t>(plan->solid.width),
             height = static_cast<std::uint32_t>(plan->solid.height);
  return GridMap{{static_cast<float>(map.resolution), width, height, origin}, cells_of(*plan)};
}

}  // namespace

constinit const DriverDefinition kMapFileDriver{
    .name = "mapfile",
    .doc = "A grid map from an image or a map of ROS, for planners and programs that show maps.",
    .provides = kMapFileProvides,
    .read_options = read_map_file,
    .make = make_map_file,
};

Result<std::unique_ptr<device::Driver>> make_map_file(const config::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"map"});
  if (!provided) return provided.error();
  Result<GridMap> grid = read_grid(section);
  if (!grid) return grid.error();
  auto driver = std::make_unique<MapFile>(std::move(*grid));
  const Result<device::DeviceId> id = site.add_device(provided->front(), *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
