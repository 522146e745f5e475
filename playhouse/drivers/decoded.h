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

inline bool is_finite(const wire::Pose2d& pose) {
  return std::isfinite(pose.px) && std::isfinite(pose.py) && std::isfinite(pose.pa);
}

}  // namespace playhouse::drivers
