#pragma once

/// The .cfg driver "sonyevid30_emulator": one of Sony's cameras at the far end of a line, for a ptz device of this server.
///
/// It carries out two commands at a time, each completed once the device is there, or stands still. Lens and picture are
/// commanded without effect, but for the zoom.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/sonyevid30/visca_frames.h"
#include "playhouse/wire/generated/ptz.h"

namespace playhouse::drivers {

extern const DriverDefinition kSonyEvid30EmulatorDriver;

struct SonyEvid30EmulatorOptions {
  EmulatorPlace place;
  const visca::CameraModel* model = nullptr;
  bool is_on = true;
};

class SonyEvid30Emulator final : public Emulator {
 public:
  enum SonyUsed : std::size_t { kCamera };

  SonyEvid30Emulator(std::string name, Site& site, const SonyEvid30EmulatorOptions& options,
                     UsedDevices used);

 private:
  enum class Doing : std::uint8_t { kNothing, kMoves, kZooms };

  void line_received(std::span<const std::byte> bytes) override;
  void line_paused() override { reader_.clear(); }

  void take(std::span<const std::byte> frame);
  void take_from_all(std::span<const std::byte> content);
  void answer(std::span<const std::byte> question);
  void obey(std::span<const std::byte> command);
  void obey_lens(std::span<const std::byte> command);
  void obey_mount(std::span<const std::byte> command);
  void cancel(std::uint8_t socket);

  void reply(std::initializer_list<std::uint8_t> content);
  void reply_numbers(std::initializer_list<int> numbers);
  void refuse(std::uint8_t error, std::uint8_t socket = 0);
  /// Takes a socket for what is being done; nothing takes time: it is completed at once.
  void accept(Doing doing);
  void complete(std::size_t socket);

  void move_to(const visca::PanTilt& to, int pan_code, int tilt_code);
  void turn(int pan_code, int tilt_code);
  void zoom_to(int zoom);
  void set_limit(std::span<const std::byte> command);
  void command_camera();
  void control_speeds(bool on);
  void watch();

  visca::PanTilt direction();
  int zoom();

  const visca::CameraModel& model_;
  const visca::ViewRange view_;
  visca::ViscaReader reader_;
  bool is_on_, controls_speeds_ = false;
  visca::PanTilt least_, most_;     // limits
  std::array<Doing, 2> sockets_{};  //
  std::size_t next_socket_ = 0;
  wire::ptz::Cmd wanted_;
  std::optional<visca::PanTilt> target_;  // none: it turns at speeds, or has not moved
  visca::PanTilt before_;                 // at the last look
  int zoom_target_ = 0, zoom_before_ = 0;
  int still_ = 0;  // looks without a change
  std::unique_ptr<net::Timer> watch_;

  Latest<wire::ptz::Data> camera_{*this, kCamera, wire::ptz::kDataState};
};

}  // namespace playhouse::drivers
