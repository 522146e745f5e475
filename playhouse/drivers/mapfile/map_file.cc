#include "playhouse/drivers/mapfile/map_file.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/scene/ros_map.h"
#include "playhouse/scene/source_text.h"

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

Result<GridMap> read_grid(const scene::CfgSection& section) {
  if (!section.has("filename"))
    return Error{section.at(), "driver \"mapfile\" needs a filename" + section.slip_for("filename")};
  if (!section.has("resolution"))
    return Error{section.at(), "driver \"mapfile\" needs a resolution, the size of a pixel in metres" +
                                   section.slip_for("resolution")};
  scene::RosMap map;
  map.resolution = section.length("resolution", 0);
  if (!(map.resolution >= kFinest && map.resolution <= kCoarsest))
    return Error{section.at("resolution"),
                 fmt::format("resolution is from {} to {} m per pixel", kFinest, kCoarsest)};
  map.negate = section.flag("negate", false);
  map.occupied = kOccupied;
  map.free = kFree;
  const std::string path = section.filename("filename", "");
  const Result<std::string> bytes = scene::DiskFiles().read(path);
  if (!bytes) return Error{section.at("filename"), in_quotes(path) + ": " + bytes.error().text};
  const Result<scene::Plan> plan = scene::plan_of_ros_map(map, *bytes, path);
  if (!plan) return Error{section.at("filename"), in_quotes(path) + ": " + plan.error().text};
  const auto size = [&](int pixels) { return pixels * map.resolution; };
  const wire::Pose2d origin{section.length("origin", -0.5 * size(plan->solid.width), 0),
                            section.length("origin", -0.5 * size(plan->solid.height), 1),
                            section.angle("origin", 0, 2)};
  const auto width = static_cast<std::uint32_t>(plan->solid.width),
             height = static_cast<std::uint32_t>(plan->solid.height);
  return GridMap{{static_cast<float>(map.resolution), width, height, origin}, cells_of(*plan)};
}

}  // namespace

Result<std::unique_ptr<device::Driver>> make_map_file(const scene::CfgSection& section, Site& site) {
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
