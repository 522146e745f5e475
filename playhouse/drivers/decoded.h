#pragma once

/// What drivers read of the messages of other drivers' devices.

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::drivers {

/// Limit of a queue for the STATEs of a position2d: all of one batch are to be used.
inline constexpr std::size_t kStatesKept = 64;

/// Body of an ACK; none for NACK.
using AnswerBody = std::optional<std::vector<std::byte>>;

/// Decodes an answer to T; none on NACK or an invalid body.
template <typename T>
std::optional<T> decoded(const AnswerBody& body) {
  if (!body) return std::nullopt;
  const Result<T> value = wire::decode<T>(*body);
  if (!value) return std::nullopt;
  return *value;
}

inline geom::Pose pose_of(const wire::Pose2d& pose) {
  return {pose.px, pose.py, 0, geom::normalize(pose.pa)};
}

/// True if a driver can compute with it: finite, and within 1e9 m and 1e9 rad, so that sums of some are, too.
inline bool is_usable(const wire::Pose2d& pose) {
  constexpr double kMost = 1e9;
  return std::fabs(pose.px) <= kMost && std::fabs(pose.py) <= kMost && std::fabs(pose.pa) <= kMost;
}

/// Of a sensor on its robot, without its tilt; none if it is not usable.
inline std::optional<geom::Pose> planar(const wire::Pose3d& pose) {
  if (!is_usable({pose.px, pose.py, pose.pyaw})) return std::nullopt;
  return geom::Pose{pose.px, pose.py, pose.pz, geom::normalize(pose.pyaw)};
}

}  // namespace playhouse::drivers
