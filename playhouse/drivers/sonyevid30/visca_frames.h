#pragma once

/// Frames of Sony's cameras, VISCA, and what a camera's units are: both ends use these.
///
/// 80 + the camera's address to it, 90 for the first one from it, what is said, FF; no byte before is FF, and a frame has 3
/// to 16. Numbers are four bytes with a nibble each. A command is answered by ACK with the number of a socket, 4y, and by 5y
/// when it is carried out; a question by 50 and what was asked.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "playhouse/drivers/hardware/bytes.h"

namespace playhouse::drivers::visca {

inline constexpr std::uint8_t kToCamera = 0x81, kToAll = 0x88, kFromCamera = 0x90, kFrameEnd = 0xFF;

/// First byte of a reply after kFromCamera, with the number of the socket added.
inline constexpr std::uint8_t kAck = 0x40, kCompleted = 0x50, kError = 0x60;
inline constexpr std::uint8_t kSyntaxError = 0x02, kBothBusy = 0x03, kCancelled = 0x04, kNoSocket = 0x05,
                              kNotExecutable = 0x41;
inline constexpr std::uint8_t kNetworkChange = 0x38, kCancel = 0x20;

/// Directions of a drive.
inline constexpr std::uint8_t kLeft = 1, kRight = 2, kUp = 1, kDown = 2, kStill = 3;

/// A frame of these bytes, with FF.
RawBytes frame(std::uint8_t address, std::span<const std::uint8_t> content);
RawBytes frame(std::uint8_t address, std::initializer_list<std::uint8_t> content);

/// Takes frames out of bytes, without FF; what is shorter or longer than one is left out.
class ViscaReader {
 public:
  void add(std::span<const std::byte> bytes);
  std::optional<RawBytes> next();
  void clear() { bytes_.clear(); }

 private:
  RawBytes bytes_;
};

/// A number as four nibbles at a place; none if these are not there.
std::optional<int> number_at(std::span<const std::byte> bytes, std::size_t at);
void put_number(std::vector<std::uint8_t>& content, int value);

/// Pan in units of the camera, positive to the right, and tilt, upwards.
struct PanTilt {
  int pan = 0, tilt = 0;
  friend bool operator==(const PanTilt&, const PanTilt&) = default;
};
/// 01 06 02: to a direction, at the speeds of these codes.
RawBytes encode_move(int pan_speed, int tilt_speed, const PanTilt& to);
/// 01 06 01: at speeds of codes with a sign, pan to the right; 0: still.
RawBytes encode_drive(int pan_speed, int tilt_speed);
RawBytes encode_zoom(int zoom);

/// Units of a model of camera.
struct CameraModel {
  std::string_view name;
  int code;                          // of the answer to the version's question
  double pan_unit, tilt_unit;        // units in a degree
  PanTilt least, most;               //
  int most_zoom;                     // units, at the least view
  double wide, tele;                 // deg, of the horizontal field of view
  int pan_speeds, tilt_speeds;       // codes, from 1 on
  double fastest_pan, fastest_tilt;  // deg/s, of the highest code
};
std::span<const CameraModel> camera_models();
const CameraModel* find_camera(std::string_view name);
const CameraModel* find_camera(int code);

/// Of a code of either sign, in deg/s, and back: the nearest one; 0 is still.
double pan_speed_of(const CameraModel& model, int code);
double tilt_speed_of(const CameraModel& model, int code);
int pan_code_of(const CameraModel& model, double speed);
int tilt_code_of(const CameraModel& model, double speed);

/// Directions in rad, pan to the left, and back, within what the camera reaches.
PanTilt units_of(const CameraModel& model, double pan, double tilt);
double pan_of(const CameraModel& model, int units);
double tilt_of(const CameraModel& model, int units);

/// Field of view in rad, and back: units are as many for each degree.
struct ViewRange {
  double wide, tele;  // rad
};
int zoom_units(const CameraModel& model, const ViewRange& range, double view);
double view_of(const CameraModel& model, const ViewRange& range, int units);

}  // namespace playhouse::drivers::visca
