#pragma once

/// Plausible values of every payload of a device, made from what the definitions of the interfaces say
/// (wire_fields.h), and by the rules of plausible_rules.cc where fields depend on each other.
///
/// In: a seed, the device's address, the number of the message; nothing else.
///
/// Out: the body of a message. Numbers are within the range of their unit, of values in a frame around 0;
/// integers without a unit are below the number of elements of lists, bytes are flags, texts are printable. All
/// lists of a device have equally many elements, unless a rule says otherwise. Measurements move, each by a
/// sine of its own period; what a request can ask for or set, as a geometry, does not.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/wire/messages.h"
#include "playhouse/wire/writer.h"

namespace playhouse::drivers {

/// What numbers with a unit may be; those in a frame from -high to high.
struct UnitRange {
  std::string_view unit;
  double low, high;
};
/// None for a unit that has no entry, which a test looks for.
std::optional<UnitRange> range_of_unit(std::string_view unit);

/// What a value depends on, for rules.
struct FieldPlace {
  std::uint64_t device;  // of the seed and the address
  std::uint64_t key;     // of the value's place in the payload, too
  std::uint64_t number;  // of the message; 0 for what does not move
  std::uint32_t count;   // elements of lists

  /// In [-1, 1], from message to message along a sine; its own for each `which`.
  double wave(std::uint64_t which = 0) const;
  /// The same in [low, high].
  double between(double low, double high, std::uint64_t which = 0) const {
    return low + (high - low) * 0.5 * (1 + wave(which));
  }
};

/// Writes a struct whose fields depend on each other.
using PlausibleRule = void (*)(wire::Writer& out, const FieldPlace& place);
/// Null if there is none.
PlausibleRule find_plausible_rule(std::string_view payload);
/// The map of a device of interface map.
GridMap plausible_map(std::uint64_t device);

class Plausible {
 public:
  Plausible(std::uint64_t seed, device::Address address);

  /// The body of a message; empty for one without payload.
  std::vector<std::byte> body(const wire::MessageDef& message, std::uint64_t number) const;
  std::uint64_t device() const { return device_; }

 private:
  friend class PlausibleWriter;

  std::uint64_t device_;
  std::uint32_t count_;
  std::vector<bool>
      is_still_;  // by row of wire_structs(): what a request of the interface has as its payload
};

}  // namespace playhouse::drivers
