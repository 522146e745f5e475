#pragma once

/// The .cfg driver "sonyevid30": Sony's EVI-D30, D31, D70 and D100, by VISCA.
///
/// One frame is out at a time: a command until its ACK, a question until its answer. A camera carries out two commands at a
/// time; the sockets of both are taken by commands until they are completed, and are cancelled where a newer one needs them.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/hardware_driver.h"
#include "playhouse/drivers/sonyevid30/visca_frames.h"
#include "playhouse/wire/generated/ptz.h"

namespace playhouse::drivers {

extern const DriverDefinition kSonyEvid30Driver;

struct SonyEvid30Options {
  HardwareOptions hardware;
  std::optional<visca::ViewRange> view;  // none: the model's
};

class SonyEvid30 final : public HardwareDriver {
 public:
  enum SonyDevice : std::size_t { kCamera };

  SonyEvid30(std::string name, Site& site, const SonyEvid30Options& options);

 private:
  /// What is out, or is to be sent; in this order.
  enum Errand : std::uint8_t {
    kVersion,
    kPower,
    kPowerOn,
    kCancelFirst,
    kCancelSecond,
    kMove,
    kZoom,
    kAskPanTilt,
    kAskZoom,
    kErrands
  };

  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override;
  void forgot() override;

  void cycle();
  void send_next();
  RawBytes frame_of(Errand errand) const;
  void free_socket();
  void lose_answer();

  void take(std::span<const std::byte> reply);
  void take_error(std::uint8_t socket, std::uint8_t error);
  void take_answer(std::span<const std::byte> answer);
  void take_version(std::span<const std::byte> answer);
  void finish_errand();
  void publish_view();

  void look(const wire::ptz::Cmd& wanted);

  const SonyEvid30Options options_;
  const visca::CameraModel* model_;
  visca::ViewRange view_;
  visca::ViscaReader reader_;
  bool model_known_ = false, has_speeds_ = false;  // is under control of velocity
  std::array<bool, kErrands> due_{};
  std::optional<Errand> out_;
  std::array<bool, 2> busy_{};  // sockets
  int lost_ = 0;                // answers, since the last one
  RawBytes move_, zoom_;        // frames of the newest commands
  visca::PanTilt direction_;    // as the camera told last
  int zoom_now_ = 0;
  double pan_speed_ = 0, tilt_speed_ = 0;  // rad/s, wanted
  std::unique_ptr<net::Timer> cycle_, patience_;
};

}  // namespace playhouse::drivers
