#pragma once

/// Radio, as what it receives; messages between simulated radios are those of opaque.h.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/wire/generated/wifi.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// A link to another radio.
struct Link {
  std::string mac, ip;          // its hardware and network address
  std::string essid;            // name of its network
  std::uint32_t mode = 0;       // its role, one of wire::wifi::kModeAuto, kModeAdhoc and so on
  std::uint32_t frequency = 0;  // MHz
  bool encrypted = false;
  std::uint32_t quality = 0;          // up to WifiState::max_quality
  std::int64_t level = 0, noise = 0;  // in WifiState::unit, signed in dBm
};

struct WifiState {
  std::vector<Link> links;
  std::uint32_t throughput = 0, bitrate = 0;  // bit/s: estimated and configured
  std::uint32_t mode = 0;                     // as of links
  std::uint32_t unit = 0;  // of levels, one of wire::wifi::kQualDbm, kQualRel and kQualUnknown
  std::uint32_t max_quality = 0;
  std::int64_t max_level = 0, max_noise = 0;
  std::string access_point;  // hardware address
  double time = 0;           // the server's, of these data [s]
};

class Wifi {
 public:
  static Result<Wifi> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<WifiState> state() const;
  /// Its links; empty before the first data.
  std::vector<Link> links() const;

  /// Requests the radio's own hardware address.
  Result<std::string> mac();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Wifi(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
