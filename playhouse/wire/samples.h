#pragma once

/// For tests: random payloads of every message as bytes, so that
/// a property is compiled once rather than once per message.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace playhouse::wire {

enum class Floats {
  kFinite,   // equal to themselves
  kAnyBits,  // including infinities and NaNs
};

/// A message with a payload.
struct Sample {
  std::string_view name;  // as MessageDef::name
  /// The encoding of the seed's random value.
  std::vector<std::byte> (*encoded)(std::uint64_t seed, Floats floats);
  /// True if `body` decodes to the seed's finite value.
  bool (*decodes_to)(std::span<const std::byte> body, std::uint64_t seed);
  /// True if `body` can be decoded.
  bool (*decodes)(std::span<const std::byte> body);
};

/// All messages, by interface.
const std::vector<Sample>& samples();

/// Largest single allocation of the test program since it was reset to 0.
extern std::size_t largest_allocation;

}  // namespace playhouse::wire
