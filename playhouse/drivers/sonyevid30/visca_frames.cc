#include "playhouse/drivers/sonyevid30/visca_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers::visca {
namespace {

constexpr std::size_t kShortest = 2, kLongestFrame = 15;  // bytes, without FF

/// That of the D70 is not published as a table: the speeds of the D100, up to its own.
constexpr CameraModel kCameras[] = {
    {"d30", 0x0402, 8.8, 12, {-880, -300}, {880, 300}, 0x3FF, 48.8, 4.4, 0x18, 0x14, 80, 50},
    {"d70", 0x040E, 13.33, 13.33, {-2267, -400}, {2267, 1200}, 0x4000, 48, 2.7, 0x18, 0x17, 170, 90},
    {"d100", 0x040D, 14.4, 14.4, {-1440, -360}, {1440, 360}, 0x4000, 65, 6.6, 0x18, 0x14, 300, 125},
};
/// deg/s, of the codes of the D100.
constexpr double kSpeeds[] = {2,  2.4, 3,  3.7, 4.7, 6.1, 7.4, 9.1, 11,  14,  18,  22,
                              27, 34,  42, 52,  65,  81,  100, 125, 155, 190, 240, 300};

double speed_of(const CameraModel& model, int code, int codes, double fastest) {
  const int size = std::min(std::abs(code), codes);
  if (size == 0) return 0;
  const bool is_linear = &model == kCameras;
  const double part =
      is_linear ? static_cast<double>(size) / codes
                : kSpeeds[static_cast<std::size_t>(size) - 1] / kSpeeds[static_cast<std::size_t>(codes) - 1];
  return code < 0 ? -part * fastest : part * fastest;
}

template <typename SpeedOf>
int code_of(double speed, int codes, SpeedOf speed_of_code) {
  int best = 0;
  for (int code = 1; code <= codes; ++code)
    if (std::fabs(speed_of_code(code) - std::fabs(speed)) < std::fabs(speed_of_code(best) - std::fabs(speed)))
      best = code;
  return speed < 0 ? -best : best;
}

/// The least also of what is no number.
int rounded(double value, int least, int most) {
  return static_cast<int>(std::lround(value > least ? std::min(value, static_cast<double>(most)) : least));
}

std::uint8_t direction(int speed, std::uint8_t below, std::uint8_t above) {
  if (speed == 0) return kStill;
  return speed < 0 ? below : above;
}

}  // namespace

RawBytes frame(std::uint8_t address, std::span<const std::uint8_t> content) {
  RawBytes bytes;
  put_u8(bytes, address);
  for (const std::uint8_t each : content) put_u8(bytes, each);
  put_u8(bytes, kFrameEnd);
  return bytes;
}

RawBytes frame(std::uint8_t address, std::initializer_list<std::uint8_t> content) {
  return frame(address, std::span(content.begin(), content.size()));
}

void ViscaReader::add(std::span<const std::byte> bytes) {
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

std::optional<RawBytes> ViscaReader::next() {
  while (true) {
    const auto end = std::ranges::find(bytes_, std::byte{kFrameEnd});
    if (end == bytes_.end()) {
      if (bytes_.size() > kLongestFrame) bytes_.erase(bytes_.begin(), bytes_.end() - kLongestFrame - 1);
      return std::nullopt;
    }
    RawBytes found(bytes_.begin(), end);
    bytes_.erase(bytes_.begin(), end + 1);
    if (found.size() >= kShortest && found.size() <= kLongestFrame) return found;
  }
}

std::optional<int> number_at(std::span<const std::byte> bytes, std::size_t at) {
  constexpr std::size_t kNibbles = 4;
  if (bytes.size() < at + kNibbles) return std::nullopt;
  unsigned value = 0;
  for (const std::byte nibble : bytes.subspan(at, kNibbles)) {
    if (static_cast<unsigned>(nibble) > 0xF) return std::nullopt;
    value = value << 4 | static_cast<unsigned>(nibble);
  }
  return static_cast<std::int16_t>(value);
}

void put_number(std::vector<std::uint8_t>& content, int value) {
  for (const int shift : {12, 8, 4, 0}) content.push_back(static_cast<std::uint8_t>(value >> shift & 0xF));
}

RawBytes encode_move(int pan_speed, int tilt_speed, const PanTilt& to) {
  std::vector<std::uint8_t> content{0x01, 0x06, 0x02, static_cast<std::uint8_t>(pan_speed),
                                    static_cast<std::uint8_t>(tilt_speed)};
  put_number(content, to.pan);
  put_number(content, to.tilt);
  return frame(kToCamera, content);
}

/// Cameras refuse a speed of 0, also of an axis that is still.
RawBytes encode_drive(int pan_speed, int tilt_speed) {
  const auto size = [](int speed) { return static_cast<std::uint8_t>(std::max(1, std::abs(speed))); };
  return frame(kToCamera, {0x01, 0x06, 0x01, size(pan_speed), size(tilt_speed),
                           direction(pan_speed, kLeft, kRight), direction(tilt_speed, kDown, kUp)});
}

RawBytes encode_zoom(int zoom) {
  std::vector<std::uint8_t> content{0x01, 0x04, 0x47};
  put_number(content, zoom);
  return frame(kToCamera, content);
}

std::span<const CameraModel> camera_models() {
  return kCameras;
}

const CameraModel* find_camera(std::string_view name) {
  const auto* const found = std::ranges::find(kCameras, name, &CameraModel::name);
  return found == std::end(kCameras) ? nullptr : found;
}

const CameraModel* find_camera(int code) {
  const auto* const found = std::ranges::find(kCameras, code, &CameraModel::code);
  return found == std::end(kCameras) ? nullptr : found;
}

double pan_speed_of(const CameraModel& model, int code) {
  return speed_of(model, code, model.pan_speeds, model.fastest_pan);
}
double tilt_speed_of(const CameraModel& model, int code) {
  return speed_of(model, code, model.tilt_speeds, model.fastest_tilt);
}
int pan_code_of(const CameraModel& model, double speed) {
  return code_of(speed, model.pan_speeds, [&](int code) { return pan_speed_of(model, code); });
}
int tilt_code_of(const CameraModel& model, double speed) {
  return code_of(speed, model.tilt_speeds, [&](int code) { return tilt_speed_of(model, code); });
}

PanTilt units_of(const CameraModel& model, double pan, double tilt) {
  return {rounded(-geom::degrees(pan) * model.pan_unit, model.least.pan, model.most.pan),
          rounded(geom::degrees(tilt) * model.tilt_unit, model.least.tilt, model.most.tilt)};
}
double pan_of(const CameraModel& model, int units) {
  return geom::radians(-units / model.pan_unit);
}
double tilt_of(const CameraModel& model, int units) {
  return geom::radians(units / model.tilt_unit);
}

int zoom_units(const CameraModel& model, const ViewRange& range, double view) {
  return rounded((range.wide - view) / (range.wide - range.tele) * model.most_zoom, 0, model.most_zoom);
}
double view_of(const CameraModel& model, const ViewRange& range, int units) {
  return range.wide - (range.wide - range.tele) * std::clamp(units, 0, model.most_zoom) / model.most_zoom;
}

}  // namespace playhouse::drivers::visca
