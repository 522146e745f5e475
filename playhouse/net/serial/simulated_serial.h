#pragma once

/// Serial lines of a SimulatedNetwork: a cable for each name, between the terminal that was made for it and whoever opens
/// it as a port. Bytes take their time, in random pieces; some are lost or changed, as configured, and all are wrong if the
/// two ends have other speeds. Internal to net.

#include <map>
#include <memory>
#include <string>

#include "playhouse/base/rng.h"
#include "playhouse/net/network.h"

namespace playhouse::net {

/// Chances, of each byte.
struct SerialFaults {
  double loss = 0, change = 0;
};

struct SimulatedCable;

class SimulatedSerial {
 public:
  /// `network` has the timers, and outlives it.
  SimulatedSerial(Network& network, Rng& rng) : network_(network), rng_(rng) {}

  SerialFaults faults;

  Result<std::unique_ptr<SerialLine>> open_port(const std::string& path, const SerialSettings& settings);
  Result<std::unique_ptr<SerialLine>> open_terminal(const std::string& link, const SerialSettings& settings);
  /// Ends the port, if it is open, and lets nobody open it until plug().
  void unplug(const std::string& path);
  void plug(const std::string& path);

 private:
  friend class SimulatedSerialLine;
  void carry(const std::shared_ptr<SimulatedCable>& cable, bool to_port, std::span<const std::byte> bytes);

  Network& network_;
  Rng& rng_;
  std::map<std::string, std::shared_ptr<SimulatedCable>> cables_;
};

}  // namespace playhouse::net
