// That values are plausible, by what the definitions say of each field, for every message of every interface.

#include "playhouse/drivers/dummy/plausible.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <string>

#include "playhouse/base/packing.h"
#include "playhouse/drivers/dummy/wire_fields.h"
#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/imu.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/sonar.h"
#include "playhouse/wire/generated/stereo.h"

namespace playhouse::drivers {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;

constexpr int kMessages = 60;

/// Bounds of units that have obvious ones, or that robots have.
const std::map<std::string_view, std::pair<double, double>> kBounds = {
    {"rad", {-geom::kPi, geom::kPi}},
    {"%", {0, 100}},
    {"m", {-10, 10}},
    {"m/s", {-2, 2}},
    {"1", {-1, 1}},
    {"V", {0, 48}},
    {"A", {0, 10}},
    {"Hz", {0, 100}},
    {"px", {0, 640}},
    {"byte", {0, 1e10}},
};

struct Number {
  std::string where;
  std::string_view unit;
  bool is_made_by_rule;
  double value;
};

/// Reads a body by the fields of its definition: all numbers, and what is wrong with the others.
class Walk {
 public:
  Walk(std::span<const std::byte> body, std::string_view payload) : in_(body) {
    const auto found = std::ranges::find(wire_structs(), payload, &WireStruct::name);
    EXPECT_NE(found, wire_structs().end()) << payload;
    walk_struct(*found, std::string(payload), {}, false);
    if (!in_.ok()) wrong.push_back(std::string(payload) + ": " + in_.error());
    if (in_.remaining() > 0) wrong.push_back(std::string(payload) + ": bytes are left");
  }
  std::vector<Number> numbers;
  std::vector<std::string> wrong;

 private:
  using Units = std::span<const std::string_view>;

  void walk_struct(const WireStruct& all, const std::string& where, Units units, bool in_rule) {
    in_rule |= find_plausible_rule(all.name) != nullptr;
    std::size_t used = 0;
    std::uint32_t count = 0;
    for (const WireField& field : all.fields) {
      if (field.shape == FieldShape::kCount) {
        in_.read(count);
        continue;
      }
      const std::size_t parts = field.parts * (field.shape == FieldShape::kFixed ? field.length : 1);
      Units own = units.empty() ? field.units : units;
      if (units.size() > 1) own = units.subspan(std::exchange(used, used + parts), parts);
      walk_field(field, where + "." + std::string(field.name), own, count, in_rule);
    }
  }

  void walk_field(const WireField& field, const std::string& where, Units units, std::uint32_t count,
                  bool in_rule) {
    const bool is_byte =
        field.type == FieldType::kChar || field.type == FieldType::kInt8 || field.type == FieldType::kUint8;
    std::size_t length = field.shape == FieldShape::kOne ? 1 : field.length;
    if (field.shape == FieldShape::kList) length = in_.dynamic_length(field.name, count, 1);
    if (length > field.length) wrong.push_back(where + " is too long");
    if (is_byte && field.shape != FieldShape::kOne) {
      std::vector<std::uint8_t> bytes;
      in_.read_bytes(bytes, length);
      if (field.type == FieldType::kChar) return check_text(bytes, where);
      for (const std::uint8_t byte : bytes)
        if (byte > 1 && !in_rule) wrong.push_back(where + " has a byte that is no flag");
      return;
    }
    for (std::size_t i = 0; i < length; ++i) {
      Units own = units;
      if (field.shape == FieldShape::kFixed && units.size() > 1)
        own = units.subspan(i * field.parts, field.parts);
      if (field.type == FieldType::kStruct)
        walk_struct(wire_structs()[field.row], where, own, in_rule);
      else
        check_number(field, where, own.empty() ? "" : own.front(), in_rule);
    }
  }

  void check_text(const std::vector<std::uint8_t>& bytes, const std::string& where) {
    const auto end = std::ranges::find(bytes, 0);
    if (end == bytes.begin() || end == bytes.end() ||
        !std::all_of(bytes.begin(), end, [](int c) { return std::isprint(c) != 0; }))
      wrong.push_back(where + " is no printable text with a NUL");
  }

  template <typename T>
  double read() {
    T value{};
    in_.read(value);
    return static_cast<double>(value);
  }
  double read_number(FieldType type) {
    switch (type) {
      case FieldType::kFloat64:
        return read<double>();
      case FieldType::kFloat32:
        return read<float>();
      case FieldType::kInt64:
        return read<std::int64_t>();
      case FieldType::kUint8:
        return read<std::uint8_t>();
      case FieldType::kUint16:
        return read<std::uint16_t>();
      case FieldType::kUint32:
        return read<std::uint32_t>();
      default:
        return read<std::int32_t>();
    }
  }
  void check_number(const WireField& field, const std::string& where, std::string_view unit, bool in_rule) {
    const double value = read_number(field.type);
    numbers.push_back({where, unit, in_rule, value});
    // A plain number of a rule may have any scale.
    const auto bounds = in_rule && unit == "1" ? kBounds.end() : kBounds.find(unit);
    if (!std::isfinite(value)) wrong.push_back(where + " is no number");
    if (bounds != kBounds.end() && !(value >= bounds->second.first && value <= bounds->second.second))
      wrong.push_back(where + " is " + std::to_string(value) + " " + std::string(unit));
    if (!field.values.empty() && std::ranges::find(field.values, value) == field.values.end())
      wrong.push_back(where + " has no constant of value " + std::to_string(value));
    const bool is_flag = field.type == FieldType::kUint8 && unit.empty() && field.values.empty() && !in_rule;
    if (is_flag && value > 1) wrong.push_back(where + " is no flag");
  }

  wire::Reader in_;
};

/// Calls f(interface, message, values of the seed) for each message of each interface of devices.
template <typename F>
void each_message(std::uint64_t seed, F f) {
  for (const wire::InterfaceDef& interf : wire::interfaces()) {
    if (interf.code == wire::player::kCode) continue;
    const Plausible values(seed, {6665, interf.code, 0});
    for (const wire::MessageDef& message : interf.messages) f(interf, message, values);
  }
}

TEST(Plausible, every_payload_is_what_its_definition_says) {
  std::size_t seen = 0;
  for (const std::uint64_t seed : {0, 1, 2}) {
    each_message(seed, [&](const auto&, const wire::MessageDef& message, const Plausible& values) {
      for (std::uint64_t number = 0; number < kMessages; number += 13) {
        const Bytes body = values.body(message, number);
        ASSERT_EQ(message.check(body), "") << message.name;
        ASSERT_EQ(message.reencode(body), body) << message.name;
        if (!message.has_payload) continue;
        ++seen;
        ASSERT_THAT(Walk(body, message.payload).wrong, IsEmpty()) << message.name;
      }
    });
  }
  EXPECT_GT(seen, 500u);
}

TEST(Plausible, every_unit_of_a_definition_has_a_range) {
  for (const WireStruct& all : wire_structs())
    for (const WireField& field : all.fields)
      for (const std::string_view unit : field.units)
        EXPECT_TRUE(range_of_unit(unit).has_value()) << all.name << "." << field.name << ": " << unit;
}

TEST(Plausible, values_follow_from_seed_address_and_number_alone) {
  std::map<std::string_view, std::pair<Bytes, Bytes>> of_seeds;
  each_message(
      1, [&](const wire::InterfaceDef& interf, const wire::MessageDef& message, const Plausible& values) {
        const Plausible same(1, {6665, interf.code, 0}), other(2, {6665, interf.code, 0});
        // Whatever was made before.
        for (const std::uint64_t number : {5, 0, 3}) {
          const Bytes body = values.body(message, number), again = other.body(message, number);
          EXPECT_EQ(same.body(message, number), body) << message.name;
          if (message.type != wire::MessageType::kData) continue;
          auto& [first, second] = of_seeds[interf.name];
          first.insert(first.end(), body.begin(), body.end());
          second.insert(second.end(), again.begin(), again.end());
        }
      });
  // Whose data are a single flag, or the size of a map.
  of_seeds.erase("simulation");
  of_seeds.erase("map");
  for (const auto& [name, bodies] : of_seeds) EXPECT_NE(bodies.first, bodies.second) << name;
  const wire::MessageDef& state = *wire::find_message(wire::position2d::kCode, wire::MessageType::kData, 1);
  EXPECT_NE(Plausible(1, {6665, wire::position2d::kCode, 0}).body(state, 0),
            Plausible(1, {6665, wire::position2d::kCode, 1}).body(state, 0));
}

TEST(Plausible, measurements_move_and_move_smoothly) {
  int moving = 0;
  each_message(3, [&](const auto&, const wire::MessageDef& message, const Plausible& values) {
    if (message.type != wire::MessageType::kData) return;
    std::vector<Number> last = Walk(values.body(message, 0), message.payload).numbers;
    for (std::uint64_t number = 1; number < kMessages; ++number) {
      const std::vector<Number> next = Walk(values.body(message, number), message.payload).numbers;
      ASSERT_EQ(next.size(), last.size()) << message.name;
      for (std::size_t i = 0; i < next.size(); ++i) {
        const auto range = range_of_unit(next[i].unit);
        if (!range || next[i].is_made_by_rule || next[i].unit == "1") continue;
        EXPECT_LE(std::fabs(next[i].value - last[i].value), 0.06 * 2 * range->high + 1) << next[i].where;
        moving += next[i].value != last[i].value ? 1 : 0;
      }
      last = next;
    }
  });
  EXPECT_GT(moving, 5000);
}

template <typename T>
T value_of(std::uint16_t interf, wire::MessageType type, std::uint8_t subtype, std::uint64_t number) {
  const Plausible values(4, {6665, interf, 0});
  return *wire::decode<T>(values.body(*wire::find_message(interf, type, subtype), number));
}

TEST(Plausible, fields_that_depend_on_each_other_agree) {
  using wire::MessageType;
  constexpr auto kData = MessageType::kData, kReq = MessageType::kReq;
  namespace lsr = wire::laser;
  const auto scan = value_of<lsr::Data>(lsr::kCode, kData, lsr::kDataScan, 9);
  const auto config = value_of<lsr::Config>(lsr::kCode, kReq, lsr::kReqGetConfig, 0);
  EXPECT_EQ(scan.ranges.size(), std::lround((scan.max_angle - scan.min_angle) / scan.resolution) + 1);
  EXPECT_EQ(scan.intensity.size(), scan.ranges.size());
  EXPECT_EQ(scan.id, 10u);
  EXPECT_EQ(config.resolution, scan.resolution);
  EXPECT_EQ(value_of<lsr::DataScanpose>(lsr::kCode, kData, lsr::kDataScanpose, 9).scan, scan);
  EXPECT_EQ(value_of<lsr::DataScanangle>(lsr::kCode, kData, lsr::kDataScanangle, 9).ranges, scan.ranges);

  namespace rgr = wire::ranger;
  const auto stamped = value_of<rgr::DataRangestamped>(rgr::kCode, kData, rgr::kDataRangestamped, 9);
  EXPECT_EQ(stamped.config, value_of<rgr::Config>(rgr::kCode, kReq, rgr::kReqGetConfig, 0));
  EXPECT_EQ(stamped.geom, value_of<rgr::Geom>(rgr::kCode, kReq, rgr::kReqGetGeom, 0));
  EXPECT_EQ(stamped.data, value_of<rgr::DataRange>(rgr::kCode, kData, rgr::kDataRange, 9));

  const auto echoes = value_of<wire::sonar::Data>(wire::sonar::kCode, kData, wire::sonar::kDataRanges, 9);
  const auto sonars = value_of<wire::sonar::Geom>(wire::sonar::kCode, kReq, wire::sonar::kReqGetGeom, 0);
  EXPECT_EQ(echoes.ranges.size(), sonars.poses.size());
  EXPECT_THAT(echoes.ranges, Each(::testing::Gt(0)));

  const auto image_is_whole = [](const wire::camera::Data& image) {
    return image.image.size() == std::size_t{image.width} * image.height * image.bpp / 8;
  };
  EXPECT_TRUE(
      image_is_whole(value_of<wire::camera::Data>(wire::camera::kCode, kData, wire::camera::kDataState, 1)));
  const auto pair = value_of<wire::stereo::Data>(wire::stereo::kCode, kData, wire::stereo::kDataState, 1);
  EXPECT_TRUE(image_is_whole(pair.left_channel) && image_is_whole(pair.disparity));

  const auto info = value_of<wire::map::Info>(wire::map::kCode, kReq, wire::map::kReqGetInfo, 0);
  const auto whole = value_of<wire::map::Data>(wire::map::kCode, kReq, wire::map::kReqGetData, 0);
  EXPECT_EQ(unpacked(whole).size(), std::size_t{info.width} * info.height);

  // A geometry that is sent, too, is the one that a request gives.
  namespace p2d = wire::position2d;
  EXPECT_EQ(value_of<p2d::Geom>(p2d::kCode, kData, p2d::kDataGeom, 9),
            value_of<p2d::Geom>(p2d::kCode, kReq, p2d::kReqGetGeom, 0));

  const auto quat = value_of<wire::imu::DataQuat>(wire::imu::kCode, kData, wire::imu::kDataQuat, 9);
  EXPECT_NEAR(std::hypot(std::hypot(quat.q0, quat.q1), std::hypot(quat.q2, quat.q3)), 1, 1e-6);
}

}  // namespace
}  // namespace playhouse::drivers
