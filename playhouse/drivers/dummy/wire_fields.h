#pragma once

/// What the definitions of the interfaces say of every field of the wire, for drivers that make values of any
/// payload. Constant tables, generated/wire_fields.cc; any thread.

#include <cstdint>
#include <span>
#include <string_view>

namespace playhouse::drivers {

enum class FieldType : std::uint8_t {
  kChar,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kFloat32,
  kFloat64,
  kStruct,
};

enum class FieldShape : std::uint8_t {
  kOne,
  kFixed,  // `length` elements, without a count
  kList,   // at most `length` elements
  kCount,  // the count of a list, which follows later or next
};

struct WireField {
  std::string_view name;
  FieldType type;
  FieldShape shape;
  std::uint16_t row;                        // of the struct in wire_structs()
  std::uint32_t length;                     // of the array
  bool is_in_frame;                         // its value has a direction
  std::uint32_t parts;                      // numbers of one element
  std::span<const std::string_view> units;  // of all parts, or of each; empty: those of the struct, or none
  std::span<const std::int32_t> values;     // all that are valid; empty: any
};

struct WireStruct {
  std::string_view name;              // as MessageDef::payload
  std::span<const WireField> fields;  // in the order of the wire
};

/// A request for its payload, which sets nothing.
struct WireQuestion {
  std::uint16_t interf;
  std::uint8_t subtype;
};

std::span<const WireStruct> wire_structs();
std::span<const WireQuestion> wire_questions();

}  // namespace playhouse::drivers
