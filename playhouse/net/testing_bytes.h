#pragma once

/// Text as bytes of a network, and back, for tests.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/net/network.h"

namespace playhouse::net {

inline SharedBytes shared(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return std::make_shared<std::vector<std::byte>>(bytes.begin(), bytes.end());
}

inline std::string text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace playhouse::net
