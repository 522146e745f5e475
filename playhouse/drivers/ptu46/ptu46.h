#pragma once

/// The .cfg driver "ptu46": Directed Perception's pan-tilt units, PTU-46 and D46, in letters.
///
/// One command is out at a time, until its reply. The unit's resolutions and limits are asked first; a unit that does not
/// know them is reset.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/hardware/hardware_driver.h"
#include "playhouse/drivers/ptu46/ptu_text.h"
#include "playhouse/wire/generated/ptz.h"

namespace playhouse::drivers {

extern const DriverDefinition kPtu46Driver;

class Ptu46 final : public HardwareDriver {
 public:
  enum PtuDevice : std::size_t { kMount };

  Ptu46(std::string name, Site& site, const HardwareOptions& options);

 private:
  struct PtuAxis {
    double resolution = 0, least = 0, most = 0, slowest = 0, fastest = 0;  // arc seconds; counts; counts/s
    double position = 0, speed = 0;  // counts, counts/s: as it told last
  };
  struct PtuErrand {
    std::string command;
    double* value = nullptr;  // of the reply; null: none
    double patience = 0;      // s
  };

  void began() override;
  void received(std::span<const std::byte> bytes) override;
  void ending() override;
  void forgot() override;

  void say(const std::string& text);
  void wake();
  void ask_limits();
  void check_limits();
  void send_next();
  void take(const ptu::PtuReply& reply);
  void run();
  void cycle();
  void publish_direction();

  void look(const wire::ptz::Cmd& wanted);
  void change_mode();
  void obey(const wire::ptz::Cmd& wanted);
  void tell(const char* letters, std::optional<long> number = std::nullopt);
  long counts_within(const PtuAxis& axis, double radians) const;
  long speed_within(const PtuAxis& axis, double radians) const;

  PtuAxis pan_, tilt_;
  ptu::PtuReplyReader reader_;
  std::deque<PtuErrand> errands_;  // the first is out, if `is_out_`
  std::function<void()> then_;     // once all of them are done
  bool is_out_ = false, runs_ = false, has_reset_ = false;
  bool has_speeds_ = false;   // is to be in velocity mode
  std::optional<bool> mode_;  // as the unit is
  std::optional<wire::ptz::Cmd> wanted_;
  int lost_ = 0;  // replies, since the last one
  std::unique_ptr<net::Timer> wait_, patience_;
};

}  // namespace playhouse::drivers
