#include "playhouse/drivers/sonyevid30/sonyevid30.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers {

namespace ptz = wire::ptz;

namespace {

constexpr double kViscaCycle = 0.1;     // s between two questions for the direction
constexpr double kViscaPatience = 0.5;  // s for an answer
constexpr int kMostLost = 6;            // answers in a row

constexpr DeviceText kSonyEvid30Provides[] = {{"ptz"}};

SonyEvid30Options sonyevid30_options(SectionFields& fields) {
  SonyEvid30Options options;
  const int baud = fields.integer({"baud", "Of the camera, as it is switched.", "baud"}, 9600, 9600, 38400);
  fields.expect(baud == 9600 || baud == 38400, "baud", "is 9600 or 38400");
  const LinePlace place = read_line_place(
      fields, {"port", "Serial port of the camera, or a TCP port that passes its bytes on: tcp:lab:8101."},
      "/dev/ttyS2", {.baud = baud});
  options.hardware = read_hardware_options(fields, place, false);
  constexpr OptionText kFov{"fov", "Least and widest horizontal field of view; 0: those of the model."};
  const double tele = fields.angle(kFov, 0, 0), wide = fields.angle(kFov, 0, 1);
  fields.expect((tele == 0 && wide == 0) || (tele > 0 && tele < wide), "fov",
                "is two angles, the smaller one first");
  if (tele > 0 && tele < wide) options.view = visca::ViewRange{wide, tele};
  return options;
}

}  // namespace

SonyEvid30::SonyEvid30(std::string name, Site& site, const SonyEvid30Options& options)
    : HardwareDriver(std::move(name), site, options.hardware),
      options_(options),
      model_(visca::camera_models().data()),
      view_{geom::radians(model_->wide), geom::radians(model_->tele)} {
  on_command<ptz::Cmd>(kCamera, ptz::kCmdState, [this](const ptz::Cmd& wanted) { look(wanted); });
  on_request<ptz::ReqControlMode>(kCamera, ptz::kReqControlMode,
                                  [this](const ptz::ReqControlMode& asked) -> AnswerBody {
                                    if (asked.mode > ptz::kPositionControl) return std::nullopt;
                                    has_speeds_ = asked.mode == ptz::kVelocityControl;
                                    return done();
                                  });
  on_question(kCamera, ptz::kReqGeom, []() -> AnswerBody { return wire::encode(ptz::Geom{}); });
  on_question(kCamera, ptz::kReqStatus, []() -> AnswerBody { return wire::encode(ptz::ReqStatus{}); });
}

// --- one frame at a time

void SonyEvid30::began() {
  due_[kVersion] = due_[kPower] = true;
  cycle();
}

void SonyEvid30::forgot() {
  reader_.clear();
  model_known_ = has_speeds_ = false;
  due_ = {};
  out_.reset();
  busy_ = {};
  lost_ = 0;
  pan_speed_ = tilt_speed_ = 0;
  cycle_.reset();
  patience_.reset();
}

void SonyEvid30::ending() {
  if (pan_speed_ != 0 || tilt_speed_ != 0) send(visca::encode_drive(0, 0));
}

void SonyEvid30::cycle() {
  cycle_ = after(kViscaCycle, [this] { cycle(); });
  if (model_known_) due_[kAskPanTilt] = due_[kAskZoom] = true;
  send_next();
}

void SonyEvid30::send_next() {
  if (out_) return;
  free_socket();
  const auto* const next = std::ranges::find(due_, true);
  if (next == due_.end()) return;
  const auto errand = static_cast<Errand>(next - due_.begin());
  due_[errand] = false;
  out_ = errand;
  send(frame_of(errand));
  patience_ = after(kViscaPatience, [this] { lose_answer(); });
}

/// One for a command that waits.
void SonyEvid30::free_socket() {
  if (!busy_[0] || !busy_[1] || !(due_[kMove] || due_[kZoom])) return;
  due_[kCancelFirst] = due_[kCancelSecond] = true;
}

RawBytes SonyEvid30::frame_of(Errand errand) const {
  switch (errand) {
    case kVersion:
      return visca::frame(visca::kToCamera, {0x09, 0x00, 0x02});
    case kPower:
      return visca::frame(visca::kToCamera, {0x09, 0x04, 0x00});
    case kPowerOn:
      return visca::frame(visca::kToCamera, {0x01, 0x04, 0x00, 0x02});
    case kCancelFirst:
      return visca::frame(visca::kToCamera, {visca::kCancel | 1});
    case kCancelSecond:
      return visca::frame(visca::kToCamera, {visca::kCancel | 2});
    case kMove:
      return move_;
    case kZoom:
      return zoom_;
    case kAskPanTilt:
      return visca::frame(visca::kToCamera, {0x09, 0x06, 0x12});
    default:
      return visca::frame(visca::kToCamera, {0x09, 0x04, 0x47});
  }
}

/// What it asked, or commanded, is asked again.
void SonyEvid30::lose_answer() {
  if (++lost_ == kMostLost) return give_up("the camera does not answer");
  const Errand errand = *std::exchange(out_, std::nullopt);
  if (errand == kCancelFirst || errand == kCancelSecond)
    busy_[errand - kCancelFirst] = false;
  else
    due_[errand] = true;
  send_next();
}

void SonyEvid30::finish_errand() {
  out_.reset();
  lost_ = 0;
  patience_.reset();
  send_next();
}

// --- what the camera says

void SonyEvid30::received(std::span<const std::byte> bytes) {
  reader_.add(bytes);
  while (const std::optional<RawBytes> reply = reader_.next()) take(*reply);
}

/// Noise before a frame is left out with it, unless it ends as one.
void SonyEvid30::take(std::span<const std::byte> reply) {
  if (u8(reply, 0) != visca::kFromCamera) return;
  const std::uint8_t kind = u8(reply, 1) & 0xF0, socket = u8(reply, 1) & 0x0F;
  const bool has_socket = socket == 1 || socket == 2;
  if (u8(reply, 1) == visca::kNetworkChange) {
    send(visca::frame(visca::kToAll, {0x30, 0x01}));
  } else if (kind == visca::kAck && has_socket && reply.size() == 2) {
    busy_[socket - 1u] = true;
    if (out_ == kMove || out_ == kZoom || out_ == kPowerOn) finish_errand();
  } else if (kind == visca::kCompleted && has_socket) {
    busy_[socket - 1u] = false;
    send_next();
  } else if (kind == visca::kCompleted && socket == 0) {
    take_answer(reply.subspan(2));
  } else if (kind == visca::kError && reply.size() == 3) {
    take_error(socket, u8(reply, 2));
  }
}

/// A camera that was busy, or is off, gets the command again with the next cycle.
void SonyEvid30::take_error(std::uint8_t socket, std::uint8_t error) {
  if (socket == 1 || socket == 2) busy_[socket - 1u] = false;
  if (!out_) return;
  const Errand errand = *out_;
  const bool cancels = errand == kCancelFirst || errand == kCancelSecond;
  if (cancels) return finish_errand();
  if (error == visca::kNotExecutable) due_[kPower] = true;
  if (error == visca::kBothBusy || error == visca::kNotExecutable) {
    due_[errand] = true;
    if (error == visca::kBothBusy) busy_ = {true, true};
    out_.reset();
    lost_ = 0;
    patience_.reset();
    return;
  }
  finish_errand();
}

void SonyEvid30::take_answer(std::span<const std::byte> answer) {
  if (!out_) return;
  switch (*out_) {
    case kVersion:
      if (answer.size() < 4) return;
      take_version(answer);
      break;
    case kPower:
      if (answer.size() != 1) return;
      if (u8(answer, 0) == 0x03) due_[kPowerOn] = true;
      break;
    case kAskPanTilt: {
      const auto pan = visca::number_at(answer, 0), tilt = visca::number_at(answer, 4);
      if (!pan || !tilt || answer.size() != 8) return;
      direction_ = {*pan, *tilt};
      break;
    }
    case kAskZoom: {
      const auto zoom = visca::number_at(answer, 0);
      if (!zoom || answer.size() != 4) return;
      zoom_now_ = *zoom;
      publish_view();
      break;
    }
    default:
      return;
  }
  finish_errand();
}

void SonyEvid30::take_version(std::span<const std::byte> answer) {
  const int code = u16_be(answer, 2);
  if (const visca::CameraModel* const known = visca::find_camera(code))
    model_ = known;
  else
    warn(fmt::format("{} is a camera of model {:04x}, which is unknown: taken for {}", line().name(), code,
                     model_->name));
  view_ = options_.view.value_or(visca::ViewRange{geom::radians(model_->wide), geom::radians(model_->tele)});
  model_known_ = true;
}

void SonyEvid30::publish_view() {
  publish(kCamera, ptz::kDataState,
          ptz::Data{.pan = static_cast<float>(visca::pan_of(*model_, direction_.pan)),
                    .tilt = static_cast<float>(visca::tilt_of(*model_, direction_.tilt)),
                    .zoom = static_cast<float>(visca::view_of(*model_, view_, zoom_now_)),
                    .panspeed = static_cast<float>(pan_speed_),
                    .tiltspeed = static_cast<float>(tilt_speed_)});
}

// --- what clients command

/// A zoom of 0 keeps the field of view; speeds of 0 in a position's command are the highest ones.
void SonyEvid30::look(const ptz::Cmd& wanted) {
  if (!model_known_ || !std::isfinite(wanted.pan) || !std::isfinite(wanted.tilt) ||
      !std::isfinite(wanted.zoom) || !std::isfinite(wanted.panspeed) || !std::isfinite(wanted.tiltspeed))
    return;
  const int pan_code = visca::pan_code_of(*model_, geom::degrees(static_cast<double>(wanted.panspeed)));
  const int tilt_code = visca::tilt_code_of(*model_, geom::degrees(static_cast<double>(wanted.tiltspeed)));
  if (has_speeds_) {
    move_ = visca::encode_drive(-pan_code, tilt_code);
    pan_speed_ = geom::radians(visca::pan_speed_of(*model_, pan_code));
    tilt_speed_ = geom::radians(visca::tilt_speed_of(*model_, tilt_code));
  } else {
    move_ = visca::encode_move(
        pan_code == 0 ? model_->pan_speeds : std::abs(pan_code),
        tilt_code == 0 ? model_->tilt_speeds : std::abs(tilt_code),
        visca::units_of(*model_, static_cast<double>(wanted.pan), static_cast<double>(wanted.tilt)));
    pan_speed_ = tilt_speed_ = 0;
  }
  due_[kMove] = true;
  if (wanted.zoom > 0) {
    RawBytes zoom = visca::encode_zoom(visca::zoom_units(*model_, view_, static_cast<double>(wanted.zoom)));
    due_[kZoom] = due_[kZoom] || zoom != zoom_;
    zoom_ = std::move(zoom);
  }
  send_next();
}

constinit const DriverDefinition kSonyEvid30Driver{
    .name = "sonyevid30",
    .doc = "Sony's EVI-D30, D31, D70 and D100, cameras that pan, tilt and zoom, by VISCA.",
    .provides = kSonyEvid30Provides,
    .read_options = reading<sonyevid30_options>,
    .make = [](const config::CfgSection& section, Site& site) -> Result<std::unique_ptr<device::Driver>> {
      return make_hardware<SonyEvid30>(section, site, sonyevid30_options, kSonyEvid30Provides);
    },
};

}  // namespace playhouse::drivers
