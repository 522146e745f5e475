// Payloads whose fields depend on each other in a way that no definition says.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "playhouse/drivers/dummy/plausible.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/dio.h"
#include "playhouse/wire/generated/health.h"
#include "playhouse/wire/generated/joystick.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/stereo.h"
#include "playhouse/wire/generated/wifi.h"

namespace playhouse::drivers {
namespace {

constexpr std::uint32_t kBeams = 181;
constexpr double kFirstAngle = -geom::kPi / 2, kStep = geom::kPi / (kBeams - 1);
constexpr double kMinRange = 0.1, kMaxRange = 8, kRangeStep = 0.01;  // m
constexpr std::uint32_t kWidth = 64, kHeight = 48;                   // of images [px]
constexpr std::uint32_t kCells = 40;                                 // of a side of a map
constexpr double kCell = 0.1;                                        // m

/// In [-1, 1], along a scan and from scan to scan; the same in all messages of a device.
double beam_wave(FieldPlace place, std::uint32_t beam) {
  place.key = place.device;
  return geom::sincos(geom::kPi * (0.25 * place.wave() + 6.0 * beam / kBeams)).sin;
}
template <typename Number>
std::vector<Number> ranges_of(const FieldPlace& place) {
  std::vector<Number> ranges;
  for (std::uint32_t beam = 0; beam < kBeams; ++beam)
    ranges.push_back(static_cast<Number>(0.5 * kMaxRange + 2 * beam_wave(place, beam)));
  return ranges;
}
std::vector<std::uint8_t> intensities_of(const FieldPlace& place) {
  std::vector<std::uint8_t> intensities;
  for (std::uint32_t beam = 0; beam < kBeams; ++beam)
    intensities.push_back(static_cast<std::uint8_t>(128 + 100 * beam_wave(place, beam)));
  return intensities;
}

wire::laser::Data scan_of(const FieldPlace& place) {
  wire::laser::Data scan;
  scan.min_angle = static_cast<float>(kFirstAngle);
  scan.max_angle = static_cast<float>(-kFirstAngle);
  scan.resolution = static_cast<float>(kStep);
  scan.max_range = static_cast<float>(kMaxRange);
  scan.ranges = ranges_of<float>(place);
  scan.intensity = intensities_of(place);
  scan.id = static_cast<std::uint32_t>(place.number + 1);
  return scan;
}
wire::laser::DataScanangle scan_with_angles_of(const FieldPlace& place) {
  wire::laser::Data scan = scan_of(place);
  wire::laser::DataScanangle other{
      scan.max_range, std::move(scan.ranges), {}, std::move(scan.intensity), scan.id};
  for (std::uint32_t beam = 0; beam < kBeams; ++beam)
    other.angles.push_back(static_cast<float>(kFirstAngle + kStep * beam));
  return other;
}
wire::laser::Config laser_config(const FieldPlace&) {
  wire::laser::Config config;
  config.min_angle = static_cast<float>(kFirstAngle);
  config.max_angle = static_cast<float>(-kFirstAngle);
  config.resolution = static_cast<float>(kStep);
  config.max_range = static_cast<float>(kMaxRange);
  config.range_res = static_cast<float>(kRangeStep);
  config.intensity = 1;
  config.scanning_frequency = 10;
  return config;
}

wire::ranger::DataRange ranger_ranges(const FieldPlace& place) {
  return {ranges_of<double>(place)};
}
wire::ranger::DataIntns ranger_intensities(const FieldPlace& place) {
  const std::vector<std::uint8_t> intensities = intensities_of(place);
  return {{intensities.begin(), intensities.end()}};
}
wire::ranger::Config ranger_config(const FieldPlace&) {
  return {kFirstAngle, -kFirstAngle, kStep, kMinRange, kMaxRange, kRangeStep, 10};
}
/// Of one scanner.
wire::ranger::Geom ranger_geometry(const FieldPlace&) {
  const wire::Bbox3d size{0.1, 0.1, 0.1};
  return {{0.1, 0, 0.2, 0, 0, 0}, size, {{}}, {size}};
}

/// Stripes that go past.
wire::camera::Data image_of(const FieldPlace& place) {
  wire::camera::Data image;
  image.width = kWidth;
  image.height = kHeight;
  image.bpp = 24;
  image.format = wire::camera::kFormatRgb888;
  image.fdiv = 1;
  image.compression = wire::camera::kCompressRaw;
  image.image.reserve(std::size_t{3} * kWidth * kHeight);
  for (std::uint32_t row = 0; row < kHeight; ++row) {
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      image.image.push_back(static_cast<std::uint8_t>(4 * (column + place.number)));
      image.image.push_back(static_cast<std::uint8_t>(5 * row));
      image.image.push_back(static_cast<std::uint8_t>(place.device));
    }
  }
  return image;
}

wire::blobfinder::Data blobs_of(const FieldPlace& place) {
  wire::blobfinder::Data data;
  data.width = kWidth;
  data.height = kHeight;
  for (std::uint32_t i = 0; i < place.count; ++i) {
    wire::blobfinder::Blob blob;
    blob.id = i;
    blob.color = 0xFFu << 8 * (i % 3);
    blob.x = static_cast<std::uint32_t>(place.between(4, kWidth - 5, 2 * i));
    blob.y = static_cast<std::uint32_t>(place.between(4, kHeight - 5, 2 * i + 1));
    blob.left = blob.x - 4;
    blob.right = blob.x + 4;
    blob.top = blob.y - 4;
    blob.bottom = blob.y + 4;
    blob.area = 81;
    blob.range = 2;
    data.blobs.push_back(blob);
  }
  return data;
}

wire::Color color_of(const FieldPlace& place) {
  const auto part = [&](std::uint64_t which) {
    return static_cast<std::uint8_t>(place.between(0, 255, which));
  };
  return {255, part(0), part(1), part(2)};
}
wire::stereo::Pointcloud3dStereoElement point_of(const FieldPlace& place) {
  const wire::Color color = color_of(place);
  const auto part = [&](std::uint64_t which) { return static_cast<float>(place.between(-2, 2, which)); };
  return {part(3), part(4), part(5), color.red, color.green, color.blue};
}
wire::Extent2d extent_of(const FieldPlace& place) {
  return {place.between(-4, -1, 0), place.between(-4, -1, 1), place.between(1, 4, 2), place.between(1, 4, 3)};
}

wire::map::Info map_info(const FieldPlace& place) {
  return plausible_map(place.device).info;
}
wire::map::Data whole_map(const FieldPlace& place) {
  return *map_tile(plausible_map(place.device), {0, 0, kCells, kCells, 0, {}});
}
/// Its outer walls.
wire::map::DataVector map_lines(const FieldPlace&) {
  const double end = 0.5 * kCells * kCell;
  const auto low = static_cast<float>(-end), high = static_cast<float>(end);
  return {low,
          high,
          low,
          high,
          {{-end, -end, end, -end}, {end, -end, end, end}, {end, end, -end, end}, {-end, end, -end, -end}}};
}

wire::health::Memory memory_of(const FieldPlace& place) {
  constexpr std::int64_t kTotal = 8'000'000'000;
  const auto used = static_cast<std::int64_t>(place.between(1e9, 7e9));
  return {kTotal, used, kTotal - used};
}
wire::health::Cpu load_of(const FieldPlace& place) {
  const auto user = static_cast<float>(place.between(5, 60, 0)),
             system = static_cast<float>(place.between(1, 20, 1));
  return {100 - user - system, system, user};
}

wire::joystick::Data joystick_of(const FieldPlace& place) {
  wire::joystick::Data data;
  constexpr std::int32_t kScale = 32767;
  for (std::size_t axis = 0; axis < data.pos.size(); ++axis) {
    data.scale[axis] = kScale;
    data.pos[axis] = static_cast<std::int32_t>(place.between(-kScale, kScale, axis));
  }
  data.axes_count = static_cast<std::uint32_t>(data.pos.size());
  data.buttons = place.wave(data.pos.size()) > 0 ? 1 : 0;
  return data;
}
wire::dio::Data inputs_of(const FieldPlace& place) {
  wire::dio::Data data;
  data.count = 8;
  for (std::uint32_t bit = 0; bit < data.count; ++bit) data.bits |= (place.wave(bit) > 0 ? 1u : 0u) << bit;
  return data;
}

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}
wire::wifi::Link link_of(const FieldPlace& place) {
  wire::wifi::Link link;
  link.mac = bytes_of("02:00:00:00:00:01");
  link.ip = bytes_of("192.0.2.1");
  link.essid = bytes_of("dummy");
  link.mode = wire::wifi::kModeInfra;
  link.freq = 2412;
  link.qual = static_cast<std::uint32_t>(place.between(20, 100));
  link.level = static_cast<std::int32_t>(place.between(-90, -40));
  link.noise = -100;
  return link;
}
wire::wifi::MacReq mac_of(const FieldPlace&) {
  return {bytes_of("02:00:00:00:00:02")};
}

template <auto kMake>
void write_made(wire::Writer& out, const FieldPlace& place) {
  write(out, kMake(place));
}

constexpr std::pair<std::string_view, PlausibleRule> kRules[] = {
    {"Color", write_made<color_of>},
    {"Extent2d", write_made<extent_of>},
    {"blobfinder::Data", write_made<blobs_of>},
    {"camera::Data", write_made<image_of>},
    {"dio::Data", write_made<inputs_of>},
    {"health::Cpu", write_made<load_of>},
    {"health::Memory", write_made<memory_of>},
    {"joystick::Data", write_made<joystick_of>},
    {"laser::Config", write_made<laser_config>},
    {"laser::Data", write_made<scan_of>},
    {"laser::DataScanangle", write_made<scan_with_angles_of>},
    {"map::Data", write_made<whole_map>},
    {"map::DataVector", write_made<map_lines>},
    {"map::Info", write_made<map_info>},
    {"ranger::Config", write_made<ranger_config>},
    {"ranger::DataIntns", write_made<ranger_intensities>},
    {"ranger::DataRange", write_made<ranger_ranges>},
    {"ranger::Geom", write_made<ranger_geometry>},
    {"stereo::Pointcloud3dStereoElement", write_made<point_of>},
    {"wifi::Link", write_made<link_of>},
    {"wifi::MacReq", write_made<mac_of>},
};

}  // namespace

PlausibleRule find_plausible_rule(std::string_view payload) {
  const auto found = std::ranges::find(kRules, payload, &std::pair<std::string_view, PlausibleRule>::first);
  return found == std::end(kRules) ? nullptr : found->second;
}

GridMap plausible_map(std::uint64_t device) {
  GridMap map;
  map.info = {static_cast<float>(kCell), kCells, kCells, {-0.5 * kCells * kCell, -0.5 * kCells * kCell, 0}};
  map.cells.assign(std::size_t{kCells} * kCells, -1);
  const auto fill = [&](std::uint32_t column, std::uint32_t row, std::uint32_t width, std::uint32_t height) {
    for (std::uint32_t y = row; y < row + height; ++y)
      for (std::uint32_t x = column; x < column + width; ++x) map.cells[y * kCells + x] = 1;
  };
  fill(0, 0, kCells, 1);
  fill(0, kCells - 1, kCells, 1);
  fill(0, 0, 1, kCells);
  fill(kCells - 1, 0, 1, kCells);
  // A box of its own.
  fill(5 + device % 20, 5 + (device >> 8) % 20, 8, 8);
  return map;
}

}  // namespace playhouse::drivers
