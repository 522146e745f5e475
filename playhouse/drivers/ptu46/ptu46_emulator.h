#pragma once

/// The .cfg driver "ptu46_emulator": a pan-tilt unit at the far end of a line, for a ptz device of this server.
///
/// It takes commands in letters and in binary. What follows a command that waits until the axes are there, as A and R,
/// waits with it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/emulator.h"
#include "playhouse/drivers/ptu46/ptu_text.h"
#include "playhouse/wire/generated/ptz.h"

namespace playhouse::drivers {

extern const DriverDefinition kPtu46EmulatorDriver;

struct Ptu46EmulatorOptions {
  EmulatorPlace place;
  double resolution = 0;                   // arc seconds in a count
  std::array<int, 2> pan = {}, tilt = {};  // limits  [counts]
};

class Ptu46Emulator final : public Emulator {
 public:
  enum PtuUsed : std::size_t { kMount };

  Ptu46Emulator(std::string name, Site& site, const Ptu46EmulatorOptions& options, UsedDevices used);

 private:
  struct EmulatedAxis {
    std::string_view name;
    int least = 0, most = 0;    // counts
    int target = 0, speed = 0;  // counts, counts/s; of velocity mode with a sign
    int base = 0, slowest = 0, fastest = 0, acceleration = 0;  // counts/s, counts/s2
    char hold_power = 0, move_power = 0;                       // a letter: H, R, L or O
  };

  void line_received(std::span<const std::byte> bytes) override;

  void obey_waiting();
  void obey(const ptu::PtuCommand& command);
  bool obey_axis(const ptu::PtuCommand& command, EmulatedAxis& axis);
  bool obey_unit(const ptu::PtuCommand& command);
  void obey_binary(const ptu::PtuCommand& command);
  bool obey_binary_axis(const ptu::PtuCommand& command, EmulatedAxis& axis);
  bool obey_binary_switch(std::uint8_t opcode);

  void say(const std::string& text);
  void done() { say("*\r\n"); }
  void refuse(const std::string& why) { say("! " + why + "\r\n"); }
  void tell(const std::string& what, const std::string& value);
  void tell(const EmulatedAxis& axis, const std::string& what, int value);
  void answer_byte(int value);
  void answer_word(int value);
  void answer_long(std::uint32_t value);

  /// Why not; empty: it is done.
  std::string set_target(EmulatedAxis& axis, int counts);
  std::string set_speed(EmulatedAxis& axis, int counts);
  void set_velocity_mode(bool on);
  void move();
  void halt(EmulatedAxis& axis);
  void reset_axes(bool pan, bool tilt);
  void restore();
  void wait_until_there(const std::string& reply);
  void watch();

  int position(const EmulatedAxis& axis);
  int actual_speed(const EmulatedAxis& axis);

  const Ptu46EmulatorOptions options_;
  ptu::PtuCommandReader reader_;
  EmulatedAxis pan_, tilt_;
  bool has_begun_ = false;
  bool echoes_ = true, is_verbose_ = true, has_speeds_ = false, is_slaved_ = false, has_limits_ = true;
  std::string waits_;  // reply once the axes are there; empty: nothing waits
  bool waits_binary_ = false;
  std::array<int, 2> before_{};  // positions at the last look
  int still_ = 0;                // looks without a change
  std::unique_ptr<net::Timer> watch_;

  Latest<wire::ptz::Data> mount_{*this, kMount, wire::ptz::kDataState};
};

}  // namespace playhouse::drivers
