#pragma once

/// The .cfg driver "mapfile": a grid map from an image, for planners and programs that show maps.
///
/// In: the section's image, size of a pixel, and place.
///
/// Out: cells that are occupied (1), free (-1) or neither (0), row 0 at the bottom.
///
/// Source: thresholds of Player's driver, docs/drivers.md.

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/map.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_map_file(const scene::CfgSection& section, Site& site);

class MapFile final : public device::Driver {
 public:
  /// `cells` by rows from the bottom: info.width x info.height.
  MapFile(const wire::map::Info& info, std::vector<std::int8_t> cells)
      : info_(info), cells_(std::move(cells)) {}

  std::string_view name() const override { return "mapfile"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;

 private:
  const wire::map::Info info_;
  const std::vector<std::int8_t> cells_;
};

/// The answer to a request for a rectangle of cells, which are compressed. What is
/// beyond the map is unknown. None if the rectangle has more cells than a message.
std::optional<wire::map::Data> map_tile(const wire::map::Info& info, const std::vector<std::int8_t>& cells,
                                        const wire::map::Data& request);

}  // namespace playhouse::drivers
