#include "playhouse/world/changes/packed_change.h"

#include <fmt/format.h>

#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "playhouse/base/in_quotes.h"

namespace playhouse::world {
namespace {

using State = std::shared_ptr<const std::vector<std::byte>>;

/// The numbers of a value of several, for all three forms.
template <typename Pose, typename Visit>
void each_number(Pose& X,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Pose>, geom::Pose> ||
    std::is_same_v<std::remove_const_t<Pose>, geom::Twist> {
  visit(X.x), visit(X.y), visit(X.z), visit(X.a);
}
template <typename Point, typename Visit>
void each_number(Point& p,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Point>, geom::Vec3> {
  visit(p.x), visit(p.y), visit(p.z);
}
template <typename Tilt, typename Visit>
void each_number(Tilt& tilt,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Tilt>, geom::Tilt> {
  visit(tilt.x), visit(tilt.y);
}
template <typename Spatial, typename Visit>
void each_number(
    Spatial& X, const Visit& visit) requires std::is_same_v<std::remove_const_t<Spatial>, geom::SpatialPose> {
  each_number(X.X, visit);
  each_number(X.tilt, visit);
}
template <typename Color, typename Visit>
void each_number(Color& color,
                 const Visit& visit) requires std::is_same_v<std::remove_const_t<Color>, scene::Color> {
  visit(color.r), visit(color.g), visit(color.b), visit(color.a);
}

// --- bytes

void put(Packer& to, std::uint32_t value) {
  to.varint(value);
}
void put(Packer& to, std::int32_t value) {
  to.zigzag(value);
}
void put(Packer& to, std::uint64_t value) {
  to.varint(value);
}
void put(Packer& to, double value) {
  to.f64(value);
}
void put(Packer& to, float value) {
  to.f32(value);
}
void put(Packer& to, bool value) {
  to.u8(value);
}
void put(Packer& to, GripperCommand value) {
  to.u8(static_cast<std::uint8_t>(value));
}
void put(Packer& to, std::uint8_t value) {
  to.u8(value);
}
void put(Packer& to, ModelId value) {
  to.varint(value.value);
}
void put(Packer& to, const std::string& value) {
  to.text(value);
}
void put(Packer& to, const State& value) {
  const std::span<const std::byte> bytes =
      value ? std::span<const std::byte>(*value) : std::span<const std::byte>();
  to.text({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}
template <typename Numbers>
void put(Packer& to, const Numbers& value) requires requires {
  each_number(value, [](auto) {});
}
{
  each_number(value, [&](auto number) { put(to, number); });
}
template <typename Each>
void put(Packer& to, const std::vector<Each>& values) {
  to.varint(values.size());
  for (const Each& each : values) put(to, each);
}

void get(Unpacker& in, std::uint32_t& value) {
  value = static_cast<std::uint32_t>(in.varint());
}
void get(Unpacker& in, std::int32_t& value) {
  value = static_cast<std::int32_t>(in.zigzag());
}
void get(Unpacker& in, std::uint64_t& value) {
  value = in.varint();
}
void get(Unpacker& in, double& value) {
  value = in.f64();
}
void get(Unpacker& in, float& value) {
  value = in.f32();
}
void get(Unpacker& in, bool& value) {
  value = in.u8() != 0;
}
void get(Unpacker& in, GripperCommand& value) {
  value = static_cast<GripperCommand>(in.u8() % 5);
  static_assert(static_cast<int>(GripperCommand::kStop) == 4, "the last of five");
}
void get(Unpacker& in, std::uint8_t& value) {
  value = in.u8();
}
void get(Unpacker& in, ModelId& value) {
  value.value = static_cast<std::uint32_t>(in.varint());
}
void get(Unpacker& in, std::string& value) {
  value = in.text();
}
void get(Unpacker& in, State& value) {
  const std::uint64_t size = in.varint();
  const std::span<const std::byte> bytes = in.bytes(static_cast<std::size_t>(size));
  value = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
}
template <typename Numbers>
void get(Unpacker& in, Numbers& value) requires requires {
  each_number(value, [](auto) {});
}
{
  each_number(value, [&](auto& number) { get(in, number); });
}
template <typename Each>
void get(Unpacker& in, std::vector<Each>& values) {
  for (std::uint64_t left = in.varint(); left > 0 && in.ok(); --left) get(in, values.emplace_back());
}

/// An empty change of this name; none if there is no such change.
template <std::size_t... kIndex>
std::optional<Change> named(std::string_view name, std::index_sequence<kIndex...>) {
  std::optional<Change> found;
  ((std::variant_alternative_t<kIndex, Change>::kName == name
        ? static_cast<void>(found.emplace(std::in_place_index<kIndex>))
        : void()),
   ...);
  return found;
}

// --- text

template <typename Number>
std::string text(const Number& value) requires std::is_arithmetic_v<Number> {
  return fmt::format("{}", value);
}
std::string text(ModelId model) {
  return fmt::format("{}", model.value);
}
std::string text(const std::string& value) {
  return boost::json::serialize(boost::json::string(value));
}
std::string text(GripperCommand value) {
  constexpr std::string_view kWords[] = {"open", "close", "raise", "lower", "stop"};
  return fmt::format("\"{}\"", kWords[static_cast<std::size_t>(value)]);
}
std::string text(const State& state) {
  return fmt::format("\"{} bytes\"", state ? state->size() : 0);
}
template <typename Numbers>
std::string text(const Numbers& value) requires requires {
  each_number(value, [](auto) {});
}
{
  std::string out;
  each_number(value, [&](auto number) { out += (out.empty() ? "[" : ", ") + text(number); });
  return out + "]";
}
template <typename Each>
std::string text(const std::vector<Each>& values) {
  std::string out = "[";
  for (const Each& each : values) out += (out.size() > 1 ? ", " : "") + text(each);
  return out + "]";
}

}  // namespace

std::string_view name_of(const Change& change) {
  return std::visit([](const auto& made) { return made.kName; }, change);
}

ModelId model_of(const Change& change) {
  return std::visit(
      [](const auto& made) {
        if constexpr (requires { made.model; }) return made.model;
        return ModelId{};
      },
      change);
}

void pack(const Change& change, std::vector<std::byte>& out) {
  Packer to(out);
  std::visit(
      [&to]<typename Made>(const Made& made) {
        to.text(Made::kName);
        Made::each_field(made, [&to](std::string_view, const auto& value) { put(to, value); });
      },
      change);
}

Result<Change> unpack_change(Unpacker& in) {
  const std::string name = in.text();
  std::optional<Change> change = named(name, std::make_index_sequence<std::variant_size_v<Change>>());
  if (!in.ok() || !change) return Error{{}, "has an unknown change " + in_quotes(name)};
  std::visit(
      [&in]<typename Made>(Made& made) {
        Made::each_field(made, [&in](std::string_view, auto& value) { get(in, value); });
      },
      *change);
  if (!in.ok()) return Error{{}, "has a damaged change " + in_quotes(name)};
  return *std::move(change);
}

std::string fields_text(const Change& change) {
  std::string out = "{";
  std::visit(
      [&out]<typename Made>(const Made& made) {
        Made::each_field(made, [&out](std::string_view name, const auto& value) {
          if (name != "model")
            out += fmt::format("{}\"{}\": {}", out.size() > 1 ? ", " : "", name, text(value));
        });
      },
      change);
  return out + "}";
}

}  // namespace playhouse::world
