#pragma once

/// The .cfg driver "mapfile": a grid map from an image, for planners and programs that show maps.
///
/// In: the section's image, size of a pixel, and place; or its map of ROS (scene/images/ros_map.h).
///
/// Out: cells that are occupied (1), free (-1) or neither (0), row 0 at the bottom.
///
/// Source: thresholds of Player's driver, docs/drivers.md.

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_map_file(const config::CfgSection& section, Site& site);

extern const DriverDefinition kMapFileDriver;

class MapFile final : public device::Driver {
 public:
  explicit MapFile(GridMap map) : map_(std::move(map)) {}

  std::string_view name() const override { return "mapfile"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override {
    answer_map_request(map_, message, std::move(replier));
  }
  bool capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const override {
    return is_map_request(type, subtype);
  }

 private:
  const GridMap map_;
};

}  // namespace playhouse::drivers
