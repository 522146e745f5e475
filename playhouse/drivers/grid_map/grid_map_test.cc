#include "playhouse/drivers/grid_map/grid_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "playhouse/drivers/grid_map/map_reader.h"
#include "playhouse/drivers/grid_map/testing_tiles.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(MapTile, has_rows_from_the_bottom_and_nothing_known_beyond_the_map) {
  const GridMap map{{0.5f, 3, 2, {}}, {-1, 1, -1, 1, 0, -1}};
  const auto whole = map_tile(map, {0, 0, 3, 2});
  ASSERT_TRUE(whole);
  EXPECT_EQ(unpacked(*whole), map.cells);
  EXPECT_EQ(whole->data_range, 1);
  const auto corner = map_tile(map, {2, 1, 2, 2});
  ASSERT_TRUE(corner);
  EXPECT_THAT(unpacked(*corner), ElementsAre(-1, 0, 0, 0));
  EXPECT_TRUE(map_tile(map, {0xffffffff, 0xffffffff, 1, 1}));
  EXPECT_FALSE(map_tile(map, {0, 0, 0xffffffff, 0xffffffff})) << "more than a message";
}

/// A map device whose answers a test may change, and a client that has it open.
class MapDevice final : public device::Driver, private device::Opener {
 public:
  explicit MapDevice(GridMap map) : map(std::move(map)), client_(*this, *this, 1) {
    client_.use(0, {7}, *this);
  }

  /// Reads it: the map, or what is wrong.
  Result<GridMap> read() {
    Result<GridMap> result = Error{"", "no answer"};
    read_map(client_, 0, [&](Result<GridMap> map) { result = std::move(map); });
    return result;
  }

  std::string_view name() const override { return "map"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }
  void request(const device::Message& message, device::Replier replier) override {
    ++requests;
    if (message.subtype == wire::map::kReqGetInfo || !change_tile)
      return answer_map_request(map, message, std::move(replier));
    wire::map::Data tile = *map_tile(map, *wire::decode<wire::map::Data>(message.body));
    change_tile(tile);
    replier.ack(wire::encode(tile));
  }

  GridMap map;
  std::function<void(wire::map::Data&)> change_tile;
  int requests = 0;

 private:
  Result<void> hold(device::DeviceId, device::Driver*) override { return {}; }
  void release(device::DeviceId, device::Driver*) override {}

  device::DeviceClient client_;
};

TEST(ReadMap, gets_maps_of_several_tiles_as_they_are) {
  MapDevice device({{0.05f, 1100, 700, {-3, 4, 0.5}}, {}});
  for (std::uint32_t i = 0; i < 1100 * 700; ++i)
    device.map.cells.push_back(static_cast<std::int8_t>(static_cast<int>(i * 7919 % 3) - 1));
  const Result<GridMap> read = device.read();
  ASSERT_TRUE(read) << read.error().text;
  EXPECT_EQ(read->info, device.map.info);
  EXPECT_EQ(read->cells, device.map.cells);
  EXPECT_EQ(device.requests, 1 + 3 * 2);
}

TEST(ReadMap, values_count_by_their_range_and_need_not_be_compressed) {
  MapDevice device({{1, 5, 1, {}}, std::vector<std::int8_t>(5)});
  device.change_tile = [](wire::map::Data& tile) {
    tile.data_range = 100;
    tile.data = {100, 51, 50, -50, -51};
  };
  EXPECT_THAT(device.read()->cells, ElementsAre(1, 1, 0, 0, -1));
}

TEST(ReadMap, tells_what_is_wrong_with_a_map) {
  const auto fault = [](const wire::map::Info& info) {
    const Result<GridMap> read = MapDevice({info, {}}).read();
    return read ? std::string() : read.error().text;
  };
  EXPECT_THAT(fault({0, 1, 1, {}}), HasSubstr("cell size of 0 m is invalid"));
  EXPECT_THAT(fault({1, 0, 1, {}}), HasSubstr("it has no cells"));
  EXPECT_THAT(fault({1, 0xffffffff, 0xffffffff, {}}), HasSubstr("at most"));
  EXPECT_THAT(fault({1, 1, 1, {0, std::numeric_limits<double>::infinity(), 0}}), HasSubstr("not finite"));
  MapDevice device({{1, 3, 1, {}}, {0, 1, -1}});
  device.change_tile = [](wire::map::Data& tile) { tile.data.pop_back(); };
  EXPECT_THAT(device.read().error().text, HasSubstr("another size"));
}

}  // namespace
}  // namespace playhouse::drivers
