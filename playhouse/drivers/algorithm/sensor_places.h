#pragma once

/// Where a robot's laser or sonars are, for algorithms that compute with their scans.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "playhouse/device/client.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

enum class ScanSensor : std::uint8_t { kLaser, kSonar };

/// Asks a device of a client for the place of the laser, or of each sonar, on its robot, without tilts; none if
/// it does not tell them all as a driver can use them. Calls as Client::ask() does.
void ask_places(device::DeviceClient& client, std::size_t device, ScanSensor sensor,
                std::function<void(std::vector<geom::Pose> X_RS)> heard);

}  // namespace playhouse::drivers
