#pragma once

/// ToRanger: a ranger of the readings of a device that is none. A source is the one definition of what it says:
///   static constexpr std::string_view kInterface;  // of the device
///   static std::optional<RangerReading> reading(const device::Publication&);
///   static void answer(Shell&);  // registers what it answers to requests

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "playhouse/drivers/algorithm/conversion.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

inline constexpr DeviceText kToRangerProvides[] = {{"ranger"}};

/// One message of a source.
struct RangerReading {
  std::vector<double> ranges;       // m
  std::vector<double> intensities;  // none, if it has none
};

template <typename Source>
class ToRanger final : public Algorithm {
 public:
  explicit ToRanger(Shell& shell) : shell_(shell), readings_(shell.client().queue(0, kStatesKept)) {
    Source::answer(shell);
  }

  void take_news(std::vector<device::Publication>& more) override {
    for (const device::Publication& message : readings_.take()) {
      const std::optional<RangerReading> reading = Source::reading(message);
      if (!reading) continue;
      more.push_back({shell_.device(0), wire::ranger::kDataRange, message.timestamp,
                      wire::encode(wire::ranger::DataRange{reading->ranges})});
      if (reading->intensities.empty()) continue;
      more.push_back({shell_.device(0), wire::ranger::kDataIntns, message.timestamp,
                      wire::encode(wire::ranger::DataIntns{reading->intensities})});
    }
  }

 private:
  Shell& shell_;
  device::Subscription& readings_;
};

/// The `make` of a source's driver.
template <typename Source>
Result<std::unique_ptr<device::Driver>> make_to_ranger(const config::CfgSection& section, Site& site) {
  return make_algorithm<ToRanger<Source>>(section, site,
                                          {.provides = {{"ranger"}}, .uses = {{Source::kInterface}}});
}

/// A request with the same body in both interfaces, as POWER.
inline void pass_request(Shell& shell, std::uint8_t subtype, std::uint8_t of_source) {
  shell.on_request(subtype, [&shell, of_source](const device::Message& message, device::Replier replier) {
    shell.client().forward(0, of_source, message.body, std::move(replier));
  });
}

}  // namespace playhouse::drivers
