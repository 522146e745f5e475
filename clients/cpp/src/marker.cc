#include "playhouse_client/marker.h"

#include <cmath>

namespace playhouse::client {

double Marker::distance() const {
  return std::hypot(pose.x, pose.y);
}
double Marker::bearing() const {
  return std::atan2(pose.y, pose.x);
}

}  // namespace playhouse::client
