#pragma once

#include <cstdint>

#include "playhouse/geom/trig.h"

namespace playhouse::config {

/// Position in the source files.
struct SourceLine {
  std::uint32_t file = 0;  // row of the names of files
  std::uint32_t line = 0;  // from 1; 0: none (a default)
};

/// A file's unit of length in metres, of angle in radians.
struct Units {
  double length = 1;
  double angle = geom::kPi / 180;
};

}  // namespace playhouse::config
