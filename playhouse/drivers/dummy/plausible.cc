#include "playhouse/drivers/dummy/plausible.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/rng.h"
#include "playhouse/drivers/dummy/wire_fields.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

constexpr std::uint32_t kFewestElements = 2, kMostElements = 5;  // elements of lists
constexpr std::uint64_t kShortestPeriod = 20, kPeriodSpan = 80;  // messages

constexpr UnitRange kUnitRanges[] = {
    {"1", 0, 1},
    {"0.1", 5, 30},
    {"%", 0, 100},
    {"m", 0.1, 4},
    {"mm", 100, 4000},
    {"m^2", 0.01, 1},
    {"rad", 0.05, 3.1},
    {"rad^2", 0.001, 1},
    {"m rad", 0, 0.001},
    {"s", 0, 10},
    {"ms", 0, 1000},
    {"us", 0, 999999},
    {"Hz", 1, 50},
    {"MHz", 2412, 2472},
    {"1e-7 deg", 470000000, 470010000},
    {"m/s", 0, 1},
    {"rad/s", 0, 1},
    {"m/s^2", 0, 1},
    {"rad/s^2", 0, 1},
    {"V", 11, 13},
    {"A", 0, 2},
    {"W", 1, 40},
    {"J", 1000, 100000},
    {"G", 0.2, 0.6},
    {"lx", 10, 1000},
    {"degC", 15, 25},
    {"px", 0, 63},
    {"m/pixel", 0.05, 0.1},
    {"bit", 1, 32},
    {"byte", 0, 1e9},
    {"bit/s", 1e6, 5e7},
};

/// The key of a part of what `key` is of.
std::uint64_t part_of(std::uint64_t key, std::uint64_t part) {
  return mix64(key ^ mix64(part + 1));
}

std::size_t row_of(std::string_view payload) {
  const auto found = std::ranges::find(wire_structs(), payload, &WireStruct::name);
  PLAYHOUSE_ASSERT(found != wire_structs().end());
  return static_cast<std::size_t>(found - wire_structs().begin());
}

bool is_float(FieldType type) {
  return type == FieldType::kFloat32 || type == FieldType::kFloat64;
}

/// Of type char, int8 or uint8: arrays of them are raw bytes.
bool is_byte(FieldType type) {
  return type == FieldType::kChar || type == FieldType::kInt8 || type == FieldType::kUint8;
}

}  // namespace

std::optional<UnitRange> range_of_unit(std::string_view unit) {
  const auto found = std::ranges::find(kUnitRanges, unit, &UnitRange::unit);
  return found == std::end(kUnitRanges) ? std::nullopt : std::optional(*found);
}

double FieldPlace::wave(std::uint64_t which) const {
  const std::uint64_t own = part_of(key, which);
  const std::uint64_t period = kShortestPeriod + own % kPeriodSpan;
  const double turns = static_cast<double>(number % period) / static_cast<double>(period);
  return geom::sincos(geom::kTwoPi * (turns + static_cast<double>(own >> 40) * 0x1p-24)).sin;
}

/// Writes one message.
class PlausibleWriter {
 public:
  PlausibleWriter(const Plausible& values, std::uint64_t number, wire::Writer& out)
      : values_(values), number_(number), out_(out) {}

  void write_message(std::size_t row) {
    write_struct(row, {part_of(values_.device_, row), false, false, {}});
  }

 private:
  using Units = std::span<const std::string_view>;
  struct Context {
    std::uint64_t key;
    bool is_in_frame;
    bool is_still;
    Units units;  // of all numbers, or of each; empty: none, or those of the fields
  };

  FieldPlace place(const Context& context) const {
    return {values_.device_, context.key, context.is_still ? 0 : number_, values_.count_};
  }

  void write_struct(std::size_t row, Context context) {
    const WireStruct& all = wire_structs()[row];
    if (const PlausibleRule rule = find_plausible_rule(all.name)) return rule(out_, place(context));
    // The same values wherever it is.
    if (values_.is_still_[row])
      context = {part_of(values_.device_, row), context.is_in_frame, true, context.units};
    std::size_t used = 0;  // of the units
    for (std::size_t i = 0; i < all.fields.size(); ++i) {
      const WireField& field = all.fields[i];
      if (field.shape == FieldShape::kCount) {
        out_.write_length(field.name, length_of(field), field.length);
        continue;
      }
      const std::size_t numbers = field.parts * (field.shape == FieldShape::kFixed ? field.length : 1);
      Context inner{part_of(context.key, i), context.is_in_frame || field.is_in_frame, context.is_still,
                    context.units.empty() ? field.units : context.units};
      if (context.units.size() > 1)
        inner.units = context.units.subspan(std::exchange(used, used + numbers), numbers);
      if (is_direction(field, inner))
        write_number(field, direction(all, i, context));
      else
        write_field(field, inner);
    }
  }

  void write_field(const WireField& field, const Context& context) {
    if (field.shape == FieldShape::kOne) return write_element(field, context);
    const std::size_t length = length_of(field);
    if (field.shape == FieldShape::kList) out_.write_length(field.name, length, field.length);
    if (field.type == FieldType::kChar && field.shape == FieldShape::kFixed)
      return out_.write_fixed_text(field.name, text_of(field), field.length);
    if (field.type == FieldType::kChar) {
      const std::string text = wire::c_string(text_of(field));
      return out_.write_bytes(std::as_bytes(std::span(text)));
    }
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < length; ++i) {
      Context inner{part_of(context.key, i), context.is_in_frame, context.is_still, context.units};
      if (field.shape == FieldShape::kFixed && context.units.size() > 1)
        inner.units = context.units.subspan(i * field.parts, field.parts);
      if (is_byte(field.type))
        bytes.push_back(static_cast<std::byte>(number_of(field, inner)));
      else
        write_element(field, inner);
    }
    if (is_byte(field.type)) out_.write_bytes(bytes);
  }

  void write_element(const WireField& field, const Context& context) {
    if (field.type == FieldType::kStruct)
      write_struct(field.row, context);
    else
      write_number(field, number_of(field, context));
  }

  /// Elements of an array; bytes of a text, the final NUL of a list included.
  std::size_t length_of(const WireField& field) const {
    if (field.shape == FieldShape::kFixed) return field.length;
    if (field.type == FieldType::kChar) return text_of(field).size() + 1;
    return std::min(values_.count_, field.length);
  }
  std::string text_of(const WireField& field) const {
    return fmt::format("dummy-{:04x}", values_.device_ & 0xFFFF).substr(0, field.length - 1);
  }

  double number_of(const WireField& field, const Context& context) const {
    const FieldPlace here = place(context);
    if (!field.values.empty()) {
      const double choices = static_cast<double>(field.values.size());
      return field.values[static_cast<std::size_t>(std::min(here.between(0, choices), choices - 1))];
    }
    if (context.units.empty()) {
      if (is_byte(field.type)) return here.wave() > 0 ? 1 : 0;
      return static_cast<double>(context.key % values_.count_);
    }
    const std::optional<UnitRange> range = range_of_unit(context.units.front());
    PLAYHOUSE_ASSERT(range.has_value());
    const double low = context.is_in_frame ? -range->high : range->low, span = range->high - low;
    // About a middle of its own, by up to a third of the range in all.
    const double swing = span * static_cast<double>(1 + context.key % 8) / 48;
    const double middle = low + swing + (span - 2 * swing) * static_cast<double>(context.key >> 40) * 0x1p-24;
    return middle + swing * here.wave();
  }

  /// True for a plain number of a vector in a frame, as a direction is.
  bool is_direction(const WireField& field, const Context& context) const {
    return is_float(field.type) && field.shape == FieldShape::kOne && context.is_in_frame &&
           context.units.size() == 1 && context.units.front() == "1";
  }
  /// Its i-th field of a struct; those in a row are a unit vector.
  double direction(const WireStruct& all, std::size_t i, const Context& context) const {
    const auto is_one = [&](std::size_t at) {
      const WireField& field = all.fields[at];
      return is_direction(field, {0, context.is_in_frame || field.is_in_frame, false,
                                  context.units.empty() ? field.units : context.units});
    };
    std::size_t first = i, end = i + 1;
    while (first > 0 && is_one(first - 1)) --first;
    while (end < all.fields.size() && is_one(end)) ++end;
    const auto unscaled = [&](std::size_t at) {
      const double wave = place({part_of(context.key, at), true, context.is_still, {}}).wave();
      return at == first ? 1.5 + wave : wave;  // never all 0
    };
    double square = 0;
    for (std::size_t at = first; at < end; ++at) square += unscaled(at) * unscaled(at);
    return unscaled(i) / std::sqrt(square);
  }

  void write_number(const WireField& field, double value) {
    switch (field.type) {
      case FieldType::kFloat32:
        return out_.write(static_cast<float>(value));
      case FieldType::kFloat64:
        return out_.write(value);
      case FieldType::kInt64:
        return out_.write(std::int64_t{std::llround(value)});
      case FieldType::kUint8:
      case FieldType::kUint16:
      case FieldType::kUint32:
        return out_.write(static_cast<std::uint32_t>(std::llround(value)));
      default:  // all of these are a word, with its sign
        return out_.write(static_cast<std::int32_t>(std::llround(value)));
    }
  }

  const Plausible& values_;
  const std::uint64_t number_;
  wire::Writer& out_;
};

Plausible::Plausible(std::uint64_t seed, device::Address address)
    : device_(
          part_of(part_of(mix64(seed), std::uint64_t{address.robot} << 16 | address.interf), address.index)),
      count_(kFewestElements + static_cast<std::uint32_t>(device_ % (kMostElements - kFewestElements + 1))),
      is_still_(wire_structs().size()) {
  for (const wire::MessageDef& message : wire::find_interface(address.interf)->messages)
    if (message.type == wire::MessageType::kReq && message.has_payload)
      is_still_[row_of(message.payload)] = true;
}

std::vector<std::byte> Plausible::body(const wire::MessageDef& message, std::uint64_t number) const {
  std::vector<std::byte> bytes;
  if (!message.has_payload) return bytes;
  wire::Writer out(bytes);
  PlausibleWriter(*this, number, out).write_message(row_of(message.payload));
  PLAYHOUSE_ASSERT(out.ok());
  return bytes;
}

}  // namespace playhouse::drivers
