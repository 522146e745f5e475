#include "playhouse/drivers/sonyevid30/sonyevid30_emulator.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "playhouse/base/in_quotes.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace ptz = wire::ptz;

namespace {

constexpr double kWatchSeconds = 0.05;
constexpr int kNear = 4, kNearZoom = 8;  // units
constexpr int kMostStill = 8;            // looks: what stands so long is there

constexpr DeviceText kSonyEvid30EmulatorUses[] = {{"ptz", {}, HowMany::kOne, "the camera's mount"}};

SonyEvid30EmulatorOptions sonyevid30_emulator_options(SectionFields& fields) {
  SonyEvid30EmulatorOptions options;
  const int baud =
      fields.integer({"baud", "Of the camera's line; a host at another speed is not understood.", "baud"},
                     9600, 50, 4000000);
  options.place = read_emulator_place(fields, {.baud = baud});
  std::string model = fields.text({"camera", "Which camera it is: d30, d70 or d100.", {}, "d30"});
  if (model.empty()) model = "d30";
  options.model = visca::find_camera(model);
  fields.expect(options.model != nullptr, "camera", "is d30, d70 or d100, not " + in_quotes(model));
  if (options.model == nullptr) options.model = visca::camera_models().data();
  options.is_on = fields.flag({"on", "0: it is switched off at first."}, true);
  return options;
}

bool begins(std::span<const std::byte> bytes, std::initializer_list<int> with) {
  return bytes.size() >= with.size() &&
         std::equal(with.begin(), with.end(), bytes.begin(),
                    [](int a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

/// A code of a drive, with a sign for the direction; none if it is none.
std::optional<int> signed_code(std::uint8_t code, std::uint8_t direction, std::uint8_t below,
                               std::uint8_t above) {
  if (direction == visca::kStill) return 0;
  if (direction == below) return -code;
  return direction == above ? std::optional<int>(code) : std::nullopt;
}

}  // namespace

SonyEvid30Emulator::SonyEvid30Emulator(std::string name, Site& site, const SonyEvid30EmulatorOptions& options,
                                       UsedDevices used)
    : Emulator(std::move(name), site, options.place, std::move(used)),
      model_(*options.model),
      view_{geom::radians(model_.wide), geom::radians(model_.tele)},
      is_on_(options.is_on),
      least_(model_.least),
      most_(model_.most) {}

void SonyEvid30Emulator::line_received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> frame = reader_.next()) take(*frame);
}

/// Frames to cameras further down the line are not its own.
void SonyEvid30Emulator::take(std::span<const std::byte> frame) {
  const std::uint8_t to = u8(frame, 0), kind = u8(frame, 1);
  const std::span<const std::byte> content = frame.subspan(1);
  if (to == visca::kToAll) return take_from_all(content);
  if (to != visca::kToCamera) return;
  if (kind == 0x09) return answer(content);
  if (kind == 0x01) return obey(content);
  if ((kind & 0xF0) == visca::kCancel && content.size() == 1) return cancel(kind & 0x0F);
  refuse(visca::kSyntaxError);
}

/// Addresses are set from 1 on, and go back with the next one that is free.
void SonyEvid30Emulator::take_from_all(std::span<const std::byte> content) {
  if (begins(content, {0x30}) && content.size() == 2) return send(visca::frame(visca::kToAll, {0x30, 0x02}));
  if (!begins(content, {0x01, 0x00, 0x01})) return;
  sockets_ = {};
  send(visca::frame(visca::kToAll, {0x01, 0x00, 0x01}));
}

void SonyEvid30Emulator::reply(std::initializer_list<std::uint8_t> content) {
  send(visca::frame(visca::kFromCamera, content));
}

void SonyEvid30Emulator::reply_numbers(std::initializer_list<int> numbers) {
  std::vector<std::uint8_t> content{visca::kCompleted};
  for (const int number : numbers) visca::put_number(content, number);
  send(visca::frame(visca::kFromCamera, content));
}

void SonyEvid30Emulator::refuse(std::uint8_t error, std::uint8_t socket) {
  reply({static_cast<std::uint8_t>(visca::kError | socket), error});
}

// --- questions

void SonyEvid30Emulator::answer(std::span<const std::byte> question) {
  const auto is = [question](int group, int item) {
    return question.size() == 3 && begins(question, {0x09, group, item});
  };
  if (is(0x00, 0x02)) {
    constexpr std::uint8_t kVendor = 0x01, kRom = 0x01, kSockets = 0x02;
    reply({visca::kCompleted, 0x00, kVendor, static_cast<std::uint8_t>(model_.code >> 8),
           static_cast<std::uint8_t>(model_.code & 0xFF), 0x00, kRom, kSockets});
  } else if (is(0x04, 0x00)) {
    reply({visca::kCompleted, static_cast<std::uint8_t>(is_on_ ? 0x02 : 0x03)});
  } else if (is(0x04, 0x47)) {
    reply_numbers({zoom()});
  } else if (is(0x06, 0x12)) {
    const visca::PanTilt now = direction();
    reply_numbers({now.pan, now.tilt});
  } else if (is(0x06, 0x11)) {
    reply({visca::kCompleted, static_cast<std::uint8_t>(model_.pan_speeds),
           static_cast<std::uint8_t>(model_.tilt_speeds)});
  } else if (is(0x06, 0x10)) {
    reply({visca::kCompleted, 0x00, 0x00});
  } else if (is(0x04, 0x38)) {
    reply({visca::kCompleted, 0x02});  // focuses by itself
  } else if (is(0x04, 0x48)) {
    reply_numbers({0x1000});
  } else {
    refuse(visca::kSyntaxError);
  }
}

// --- commands

void SonyEvid30Emulator::obey(std::span<const std::byte> command) {
  if (begins(command, {0x01, 0x00, 0x01})) {
    sockets_ = {};
    return reply({visca::kCompleted});
  }
  if (sockets_[0] != Doing::kNothing && sockets_[1] != Doing::kNothing) return refuse(visca::kBothBusy);
  if (begins(command, {0x01, 0x04})) return obey_lens(command);
  if (begins(command, {0x01, 0x06})) return obey_mount(command);
  refuse(visca::kSyntaxError);
}

void SonyEvid30Emulator::obey_lens(std::span<const std::byte> command) {
  if (command.size() < 4) return refuse(visca::kSyntaxError);
  const std::uint8_t item = u8(command, 2), value = u8(command, 3);
  if (item == 0x00) {
    if (value != 0x02 && value != 0x03) return refuse(visca::kSyntaxError);
    is_on_ = value == 0x02;
    return accept(Doing::kNothing);
  }
  if (!is_on_) return refuse(visca::kNotExecutable);
  if (item == 0x47) {
    const std::optional<int> to = visca::number_at(command, 3);
    if (!to || *to < 0 || command.size() != 7) return refuse(visca::kSyntaxError);
    zoom_to(*to);
    return accept(Doing::kZooms);
  }
  if (item == 0x07) {
    const int way = value >= 0x20 ? value >> 4 : value;  // 2 to tele, 3 to wide
    if (way != 0 && way != 2 && way != 3) return refuse(visca::kSyntaxError);
    zoom_to(way == 0 ? zoom() : (way == 2 ? model_.most_zoom : 0));
    return accept(Doing::kNothing);
  }
  constexpr std::uint8_t kWithoutEffect[] = {0x08, 0x33, 0x35, 0x38, 0x39, 0x3F, 0x48};
  if (std::ranges::find(kWithoutEffect, item) == std::end(kWithoutEffect)) return refuse(visca::kSyntaxError);
  accept(Doing::kNothing);
}

void SonyEvid30Emulator::obey_mount(std::span<const std::byte> command) {
  if (command.size() < 3) return refuse(visca::kSyntaxError);
  if (!is_on_) return refuse(visca::kNotExecutable);
  const std::uint8_t item = u8(command, 2);
  if (item == 0x01 && command.size() == 7) {
    const auto pan = signed_code(u8(command, 3), u8(command, 5), visca::kLeft, visca::kRight);
    const auto tilt = signed_code(u8(command, 4), u8(command, 6), visca::kDown, visca::kUp);
    if (!pan || !tilt) return refuse(visca::kSyntaxError);
    turn(*pan, *tilt);
    return accept(Doing::kNothing);
  }
  if ((item == 0x02 || item == 0x03) && command.size() == 13) {
    const auto pan = visca::number_at(command, 5), tilt = visca::number_at(command, 9);
    const int pan_code = u8(command, 3), tilt_code = u8(command, 4);
    if (!pan || !tilt || pan_code == 0 || tilt_code == 0) return refuse(visca::kSyntaxError);
    const visca::PanTilt from = item == 0x03 ? direction() : visca::PanTilt{};
    move_to({from.pan + *pan, from.tilt + *tilt}, pan_code, tilt_code);
    return accept(Doing::kMoves);
  }
  if ((item == 0x04 || item == 0x05) && command.size() == 3) {
    move_to({}, model_.pan_speeds, model_.tilt_speeds);
    return accept(Doing::kMoves);
  }
  if (item == 0x07 && command.size() == 13) return set_limit(command);
  refuse(visca::kSyntaxError);
}

/// Up and to the right, or down and to the left.
void SonyEvid30Emulator::set_limit(std::span<const std::byte> command) {
  const auto pan = visca::number_at(command, 5), tilt = visca::number_at(command, 9);
  if (!pan || !tilt || u8(command, 3) > 1 || u8(command, 4) > 1) return refuse(visca::kSyntaxError);
  const bool clears = u8(command, 3) == 1, is_upper = u8(command, 4) == 1;
  const visca::PanTilt widest = is_upper ? model_.most : model_.least;
  (is_upper ? most_ : least_) = clears
                                    ? widest
                                    : visca::PanTilt{std::clamp(*pan, model_.least.pan, model_.most.pan),
                                                     std::clamp(*tilt, model_.least.tilt, model_.most.tilt)};
  accept(Doing::kNothing);
}

void SonyEvid30Emulator::cancel(std::uint8_t socket) {
  if (socket != 1 && socket != 2) return refuse(visca::kSyntaxError);
  Doing& doing = sockets_[socket - 1u];
  if (doing == Doing::kNothing) return refuse(visca::kNoSocket, socket);
  if (doing == Doing::kMoves) {
    const visca::PanTilt now = direction();
    move_to(now, model_.pan_speeds, model_.tilt_speeds);
  } else {
    zoom_to(zoom());
  }
  doing = Doing::kNothing;
  refuse(visca::kCancelled, socket);
}

void SonyEvid30Emulator::accept(Doing doing) {
  if (sockets_[next_socket_] != Doing::kNothing) next_socket_ = 1 - next_socket_;
  const std::size_t socket = std::exchange(next_socket_, 1 - next_socket_);
  reply({static_cast<std::uint8_t>(visca::kAck + 1 + socket)});
  // What it did before has come to nothing.
  for (std::size_t other = 0; other < sockets_.size(); ++other)
    if (doing != Doing::kNothing && sockets_[other] == doing) complete(other);
  sockets_[socket] = doing;
  if (doing == Doing::kNothing) return complete(socket);
  still_ = 0;
  watch_ = after(kWatchSeconds, [this] { watch(); });
}

void SonyEvid30Emulator::complete(std::size_t socket) {
  sockets_[socket] = Doing::kNothing;
  reply({static_cast<std::uint8_t>(visca::kCompleted + 1 + socket)});
}

// --- the mount

void SonyEvid30Emulator::move_to(const visca::PanTilt& to, int pan_code, int tilt_code) {
  target_ = visca::PanTilt{
      std::clamp(to.pan, std::min(least_.pan, most_.pan), std::max(least_.pan, most_.pan)),
      std::clamp(to.tilt, std::min(least_.tilt, most_.tilt), std::max(least_.tilt, most_.tilt))};
  control_speeds(false);
  wanted_.pan = static_cast<float>(visca::pan_of(model_, target_->pan));
  wanted_.tilt = static_cast<float>(visca::tilt_of(model_, target_->tilt));
  wanted_.panspeed = static_cast<float>(geom::radians(visca::pan_speed_of(model_, pan_code)));
  wanted_.tiltspeed = static_cast<float>(geom::radians(visca::tilt_speed_of(model_, tilt_code)));
  command_camera();
}

void SonyEvid30Emulator::turn(int pan_code, int tilt_code) {
  control_speeds(true);
  target_.reset();
  wanted_.panspeed = static_cast<float>(geom::radians(-visca::pan_speed_of(model_, pan_code)));
  wanted_.tiltspeed = static_cast<float>(geom::radians(visca::tilt_speed_of(model_, tilt_code)));
  command_camera();
}

void SonyEvid30Emulator::zoom_to(int zoom) {
  zoom_target_ = std::min(zoom, model_.most_zoom);
  wanted_.zoom = static_cast<float>(visca::view_of(model_, view_, zoom_target_));
  const visca::PanTilt at = target_.value_or(direction());
  wanted_.pan = static_cast<float>(visca::pan_of(model_, at.pan));
  wanted_.tilt = static_cast<float>(visca::tilt_of(model_, at.tilt));
  command_camera();
}

void SonyEvid30Emulator::command_camera() {
  command_device(kCamera, ptz::kCmdState, wanted_);
}

void SonyEvid30Emulator::control_speeds(bool on) {
  if (std::exchange(controls_speeds_, on) != on)
    ask_device(
        kCamera, ptz::kReqControlMode,
        ptz::ReqControlMode{static_cast<std::uint32_t>(on ? ptz::kVelocityControl : ptz::kPositionControl)});
}

void SonyEvid30Emulator::watch() {
  const visca::PanTilt now = direction();
  const int zoom_now = zoom();
  const bool is_still = now == before_ && zoom_now == zoom_before_;
  before_ = now;
  zoom_before_ = zoom_now;
  still_ = is_still ? still_ + 1 : 0;
  const visca::PanTilt to = target_.value_or(now);
  const bool is_there = std::abs(now.pan - to.pan) <= kNear && std::abs(now.tilt - to.tilt) <= kNear;
  const bool has_zoomed = std::abs(zoom_now - zoom_target_) <= kNearZoom;
  for (std::size_t socket = 0; socket < sockets_.size(); ++socket) {
    const bool ends =
        (sockets_[socket] == Doing::kMoves && is_there) || (sockets_[socket] == Doing::kZooms && has_zoomed);
    if (ends || (sockets_[socket] != Doing::kNothing && still_ >= kMostStill)) complete(socket);
  }
  if (sockets_ != std::array<Doing, 2>{}) watch_ = after(kWatchSeconds, [this] { watch(); });
}

visca::PanTilt SonyEvid30Emulator::direction() {
  const ptz::Data& now = camera_.value();
  return visca::units_of(model_, static_cast<double>(now.pan), static_cast<double>(now.tilt));
}

/// A mount without a view tells that which it was commanded.
int SonyEvid30Emulator::zoom() {
  const auto view = static_cast<double>(camera_.value().zoom);
  return view > 0 ? visca::zoom_units(model_, view_, view) : zoom_target_;
}

constinit const DriverDefinition kSonyEvid30EmulatorDriver{
    .name = "sonyevid30_emulator",
    .doc = "A camera of Sony's EVI series at the far end of a line, for a ptz device of this server.",
    .provides = {},
    .uses = kSonyEvid30EmulatorUses,
    .read_options = reading<sonyevid30_emulator_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_emulator<SonyEvid30Emulator>(section, site, sonyevid30_emulator_options,
                                               kSonyEvid30EmulatorUses);
    },
};

}  // namespace playhouse::drivers
