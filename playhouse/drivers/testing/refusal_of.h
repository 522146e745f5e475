#pragma once

/// The property "refusal" of a device, as a client gets it (drivers/refusal.h).

#include <string>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::drivers::testing {

/// "NACK" for a device without it.
inline std::string refusal_of(MemorySite& site, device::Address address) {
  constexpr std::uint8_t kRequest = 3;
  constexpr std::uint64_t kTicket = 77;
  const std::vector<std::byte> question =
      wire::encode(wire::StrpropReq{wire::c_string("refusal"), wire::c_string("")});
  site.driver(address).request({site.id(address), kRequest, wire::kReqGetStrprop, question},
                               device::Replier(site.recorder, kTicket));
  site.run(0);
  const auto& answer = site.recorder.answers.at(kTicket);
  if (!answer.ack) return "NACK";
  return std::string(wire::text(wire::decode<wire::StrpropReq>(answer.body)->value));
}

/// A device that tells nothing, not even where it is.
class Mute final : public device::Driver {
 public:
  std::string_view name() const override { return "mute"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message&, device::Replier) override {}
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }
};

}  // namespace playhouse::drivers::testing
