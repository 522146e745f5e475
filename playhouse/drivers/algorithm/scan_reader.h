#pragma once

/// ScanReader: reads scans of a device that a driver uses and that is a laser, a ranger or sonars.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/cfg.h"
#include "playhouse/device/client.h"
#include "playhouse/drivers/algorithm/scan.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

enum class ScanInterface : std::uint8_t { kLaser, kRanger, kSonar };
inline constexpr ScanInterface kScanInterfaces[] = {ScanInterface::kLaser, ScanInterface::kRanger,
                                                    ScanInterface::kSonar};

std::string_view name_of(ScanInterface interf);

/// Those of which a section requires a device, in the order of the enumeration; laser, if it names none.
std::vector<ScanInterface> named_scans(const config::CfgSection& section);
/// A device for scans, one of the three interfaces.
WantedDevice wanted_scan(ScanInterface interf);

class ScanReader {
 public:
  /// Called with what the device lacks, e.g. "its laser does not tell its place".
  using Failed = std::function<void(const std::string& why)>;

  /// During construction of drivers.
  ScanReader(device::DeviceClient& client, std::size_t device, ScanInterface interf);
  ScanReader(const ScanReader&) = delete;
  ScanReader& operator=(const ScanReader&) = delete;

  /// Asks for what tells the places and angles of beams. Calls as DeviceClient::ask() does. Io thread.
  void ask(Failed failed);

  /// True once what ask() asks for is known. Any thread.
  bool is_ready() const;

  // Publishing thread.

  /// True if there is a new scan.
  bool take();
  /// That scan. None if it is no scan, or the reader is not ready.
  std::optional<RangeScan> scan() const;
  /// Of that scan [s].
  double time() const { return newest_.timestamp; }

 private:
  void take_places(const std::vector<wire::Pose3d>& poses, const Failed& failed);
  void take_geometry(const wire::ranger::Geom& geom, const Failed& failed);
  void take_configuration(const AnswerBody& body, const Failed& failed);
  void take_changes(const device::Publication& stamped);
  std::optional<RangeScan> ranger_scan(std::vector<float> ranges) const;

  device::DeviceClient& client_;
  const std::size_t device_;
  const ScanInterface interf_;
  device::Subscription& scans_;
  device::Subscription* stamped_ = nullptr;  // of a ranger: scans with what has changed
  device::Publication newest_;               // of the publishing thread

  mutable std::mutex mutex_;                      // guards what follows
  std::vector<ScanEye> eyes_;                     // empty until they are known
  std::optional<wire::ranger::Config> config_{};  // of a ranger, if it tells it
};

}  // namespace playhouse::drivers
