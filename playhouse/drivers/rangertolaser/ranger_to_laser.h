#pragma once

/// The .cfg driver "rangertolaser": shows a ranger device of any driver as a laser, for programs that know no
/// rangers. Each scan becomes one message with its intensities; geometry and configuration are asked of the
/// ranger. Threads: the Driver functions on the io thread, read() where the ranger publishes, answer()
/// anywhere.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/tap.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const scene::CfgSection& section, Site& site);

/// One scan as a laser knows it. `intensities` may be empty.
wire::laser::Data laser_scan(const wire::ranger::Config& config, const wire::ranger::DataRange& ranges,
                             const wire::ranger::DataIntns& intensities, std::uint32_t id);

class RangerToLaser final : public device::Driver, private device::Outlet, private Tap::Reader {
 public:
  /// Holds `ranger` open while the laser is open.
  RangerToLaser(Surroundings& surroundings, Tap& tap) : surroundings_(surroundings) { tap.add_reader(*this); }

  void set_laser(device::DeviceId laser) { laser_ = laser; }
  void set_ranger(Site::Neighbour ranger) { ranger_ = ranger; }

  std::string_view name() const override { return "rangertolaser"; }
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { ranger_.driver->barrier(std::move(replier)); }

 private:
  /// Called with the ranger's answer; nothing for NACK.
  using Heard = std::function<void(std::optional<std::vector<std::byte>>)>;
  void ask_ranger(std::uint8_t subtype, std::span<const std::byte> body, Heard heard);
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override;
  void read(std::span<const device::Publication> batch, std::vector<device::Publication>& more) override;

  Surroundings& surroundings_;
  device::DeviceId laser_;
  Site::Neighbour ranger_;

  std::mutex mutex_;  // guards what follows
  std::map<std::uint64_t, Heard> asked_;
  std::uint64_t next_ticket_ = 0;
  std::optional<wire::ranger::Config> config_;  // known while the laser is open
  std::uint32_t scans_ = 0;
};

}  // namespace playhouse::drivers
