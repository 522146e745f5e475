#pragma once

/// ScannerDriver: what drivers of scanning range finders have in common. A scan becomes the data of a laser and of a ranger,
/// whichever the section names, and both tell where the scanner is and how it measures, and let clients choose that.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/drivers/hardware/hardware_driver.h"
#include "playhouse/drivers/scan_settings.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

/// What each of them offers.
inline constexpr DeviceText kScannerProvides[] = {
    {"laser", {}, HowMany::kSomeOfThese},
    {"ranger", {}, HowMany::kSomeOfThese, "the same scans"},
};

/// Options of every scanner.
struct ScannerOptions {
  HardwareOptions hardware;
  geom::Pose X_RS = {};  // on the robot
  geom::Size size = {};
  bool is_upside_down = false;
};

/// Reads `pose`, `size` and `invert`, and what read_hardware_options() does.
ScannerOptions read_scanner_options(SectionFields& fields, LinePlace place, const geom::Size& size);

/// As the scanner sees it, counter-clockwise.
struct LineScan {
  std::vector<float> ranges;              // m
  std::vector<std::uint8_t> intensities;  // one for each range; empty: it measures none
};

class ScannerDriver : public HardwareDriver {
 public:
  enum ScannerDevice : std::size_t { kLaser, kRanger };
  ScannerDriver(std::string name, Site& site, ScannerOptions options);

 protected:
  /// What is in effect, or will be as soon as the scanner has been told.
  virtual const ScanSettings& settings() const = 0;
  /// Turns what is wanted into what is possible, and tells the scanner. False: it cannot do that.
  virtual bool configure(const ScanSettings& wanted) = 0;

  /// To the clients of both; angles and the largest range are those of settings().
  void publish_scan(LineScan scan);
  /// Clients of the ranger are told the settings with the next scan.
  void tell_settings() { is_new_ = true; }

 private:
  void register_laser();
  void register_ranger();
  AnswerBody set_laser(const wire::laser::Config& asked);
  AnswerBody set_ranger(const wire::ranger::Config& asked);
  AnswerBody set_switch(bool ScanSettings::*which, bool on);
  void publish_laser(const LineScan& scan);
  void publish_ranger(const LineScan& scan);
  wire::ranger::Geom ranger_geometry() const;

  const ScannerOptions options_;
  bool is_new_ = false;
  std::uint32_t scans_ = 0;
};

/// For emulators: the number of the beam of a scan in a direction; the size of its ranges: it does not look there.
std::size_t beam_at(const wire::laser::Data& scan, double angle);

/// What an emulator tells of a direction.
struct BeamEcho {
  bool is_seen = false;  // within the field of view
  bool is_hit = false;   // nearer than the largest range
  double range = 0;      // m
  std::uint8_t intensity = 0;
};
BeamEcho echo_at(const wire::laser::Data& scan, double angle);

}  // namespace playhouse::drivers
