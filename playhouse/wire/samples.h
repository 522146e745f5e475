#pragma once

/// For tests: random payloads of every message, as bytes, so that a law is compiled once and not once per
/// message.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace playhouse::wire {

enum class Floats {
  kFinite,   // equal to themselves
  kAnyBits,  // infinities and every kind of nan among them
};

/// One message that has a payload.
struct Sample {
  std::string_view name;  // as MessageDef::name
  /// The encoding of the value that belongs to the seed.
  std::vector<std::byte> (*encoded)(std::uint64_t seed, Floats floats);
  /// True if `body` decodes to the finite value that belongs to the seed.
  bool (*decodes_to)(std::span<const std::byte> body, std::uint64_t seed);
  /// True if `body` decodes to anything.
  bool (*decodes)(std::span<const std::byte> body);
};

/// One per message, in the order of the interfaces.
const std::vector<Sample>& samples();

/// Largest single allocation of the test program since it was last set to 0.
extern std::size_t largest_allocation;

}  // namespace playhouse::wire
