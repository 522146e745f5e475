#pragma once

/// Conversion of values to JSON text, for messages sent once.

#include <fmt/format.h>

#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>
#include <cmath>
#include <string>
#include <string_view>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/text/values.h"

namespace playhouse::replicate {

inline std::string quoted(std::string_view text) {
  return boost::json::serialize(boost::json::string(text));
}

/// Metres and radians rounded to 1e-4: finer than a screen shows.
inline std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:g}", std::round(value * 1e4) / 1e4) : "0";
}

inline std::string pose(const geom::Pose& X) {
  return fmt::format("[{},{},{},{}]", number(X.x), number(X.y), number(X.z), number(X.a));
}

inline std::string triple(double a, double b, double c) {
  return fmt::format("[{},{},{}]", number(a), number(b), number(c));
}

inline std::string size(const geom::Size& s) {
  return triple(s.x, s.y, s.z);
}

inline std::string color(const scene::Color& c) {
  return fmt::format("[{},{},{},{}]", number(c.r), number(c.g), number(c.b), number(c.a));
}

/// A JSON array of write(item).
template <typename Range, typename Write>
std::string list(const Range& items, Write write) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ',';
    text += write(item);
  }
  return text += ']';
}

}  // namespace playhouse::replicate
