#pragma once

/// LaserFilter: a laser whose scans and configuration are functions of those of another laser, which answers all else.
/// A filter is the options of its driver, with
///   std::optional<wire::laser::Data> scan(const wire::laser::Data&) const;
///   wire::laser::Config config(const wire::laser::Config&) const;

#include <memory>
#include <optional>
#include <utility>

#include "playhouse/drivers/algorithm/conversion.h"
#include "playhouse/drivers/algorithm/forwarder.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

inline constexpr DeviceText kLaserFilterProvides[] = {{"laser"}};
inline constexpr DeviceText kLaserFilterUses[] = {{"laser", {}, HowMany::kOne, "has the scans"}};

template <typename Filter>
class LaserFilter final : public Forwarder {
 public:
  LaserFilter(Shell& shell, const Filter& filter) : Forwarder(shell), filter_(filter) {
    const auto config = [filter](const wire::laser::Config& config) { return filter.config(config); };
    convert_answers<wire::laser::Config>(shell, kForwarded, wire::laser::kReqGetConfig,
                                         wire::laser::kReqGetConfig, config);
    convert_setting<wire::laser::Config>(shell, kForwarded, wire::laser::kReqSetConfig, config);
  }

 private:
  /// Scans with an angle per beam are no scans at equal angles.
  std::optional<device::Publication> passed(device::Publication message) override {
    if (message.subtype == wire::laser::kDataScan)
      return converted<wire::laser::Data>(
          std::move(message), [](wire::laser::Data & data) -> auto& { return data; });
    if (message.subtype == wire::laser::kDataScanpose)
      return converted<wire::laser::DataScanpose>(
          std::move(message), [](wire::laser::DataScanpose & data) -> auto& { return data.scan; });
    return std::nullopt;
  }

  template <typename Body, typename ScanOf>
  std::optional<device::Publication> converted(device::Publication message, ScanOf scan_of) const {
    Result<Body> body = wire::decode<Body>(message.body);
    if (!body) return std::nullopt;
    wire::laser::Data& scan = scan_of(*body);
    std::optional<wire::laser::Data> made = filter_.scan(scan);
    if (!made) return std::nullopt;
    scan = std::move(*made);
    message.body = wire::encode(*body);
    return message;
  }

  const Filter filter_;
};

/// The `make` of a filter's driver.
template <auto kReadOptions, typename Filter>
Result<std::unique_ptr<device::Driver>> make_laser_filter(const config::CfgSection& section, Site& site) {
  return make_algorithm<LaserFilter<Filter>>(section, site, {.provides = {{"laser"}}, .uses = {{"laser"}}},
                                             kReadOptions);
}

}  // namespace playhouse::drivers
