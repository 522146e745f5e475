#pragma once

/// A visible marker.

#include <cstdint>

#include "playhouse_client/pose.h"

namespace playhouse::client {

/// A visible marker: its id and its pose in the sensor's frame.
struct Marker {
  std::int32_t id = 0;
  Pose3d pose;

  double distance() const;  // m
  double bearing() const;   // rad
};

}  // namespace playhouse::client
