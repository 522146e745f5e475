#include "playhouse/bridge/mapfile/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/grid_map/testing_tiles.h"

namespace playhouse::drivers {
namespace {

namespace map = wire::map;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two rows of three pixels: wall, gray, free; free, wall, free.
constexpr const char* kImage = "P2 3 2 255 0 128 255 255 0 255";

std::string image_file() {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "map_file_test.pgm";
  std::ofstream(path) << kImage;
  return path.string();
}

TEST(MapFile, reads_an_image_about_the_middle_or_at_its_origin) {
  struct Answers final : device::Outlet {
    void answer(std::uint64_t, bool ack, std::vector<std::byte> body) override {
      acks.push_back(ack);
      last = std::move(body);
    }
    std::vector<bool> acks;
    std::vector<std::byte> last;
  };
  const std::string image = image_file();
  for (const bool at_origin : {false, true}) {
    testing::MemorySite site("");
    const std::string origin = at_origin ? " origin [-8 -4 90]" : "";
    ASSERT_EQ(site.build("driver( name \"mapfile\" provides [\"map:1\"] filename \"" + image +
                         "\" resolution 0.5" + origin + " )"),
              "");
    device::Driver& driver = site.driver({6665, map::kCode, 1});
    const device::DeviceId id = site.id({6665, map::kCode, 1});
    Answers answers;
    const auto ask = [&](std::uint8_t subtype, const std::vector<std::byte>& body) {
      driver.request({id, 3, subtype, body}, device::Replier(answers, 1));
      return answers.acks.back();
    };
    ASSERT_TRUE(ask(map::kReqGetInfo, {}));
    const map::Info info = *wire::decode<map::Info>(answers.last);
    const wire::Pose2d expected =
        at_origin ? wire::Pose2d{-8, -4, geom::radians(90)} : wire::Pose2d{-0.75, -0.5, 0};
    EXPECT_EQ(info, (map::Info{0.5f, 3, 2, expected}));
    ASSERT_TRUE(ask(map::kReqGetData, wire::encode(map::Data{0, 0, 3, 2})));
    EXPECT_THAT(unpacked(*wire::decode<map::Data>(answers.last)), ElementsAre(-1, 1, -1, 1, 0, -1));
    EXPECT_FALSE(ask(map::kReqGetVector, {}));
  }
}

TEST(MapFile, reads_a_map_of_ros_with_its_thresholds_and_its_place) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "map_of_ros";
  std::filesystem::create_directories(folder);
  // Shares of black: 1, 0.2, 0; 0, 0.7, 0.3.
  std::ofstream(folder / "m.pgm") << "P2 3 2 255 0 204 255 255 76 178";
  for (const char* image : {"m.pgm", "/home/robot/maps/m.pgm"}) {
    std::ofstream(folder / "map.yaml") << "image: " << image
                                       << "\nresolution: 0.05\norigin: [-1, -2, 0.5]\nnegate: 0\n"
                                          "occupied_thresh: 0.65\nfree_thresh: 0.25\nfloor: 2\n";
    testing::MemorySite site("");
    const std::string section =
        "driver( name \"mapfile\" provides [\"map:0\"] filename \"" + (folder / "map.yaml").string() + "\"";
    ASSERT_EQ(site.build(section + " )"), "");
    struct Answers final : device::Outlet {
      void answer(std::uint64_t, bool, std::vector<std::byte> body) override { last = std::move(body); }
      std::vector<std::byte> last;
    } answers;
    const device::DeviceId id = site.id({6665, map::kCode, 0});
    const auto ask = [&](std::uint8_t subtype, const std::vector<std::byte>& body) {
      site.driver({6665, map::kCode, 0}).request({id, 3, subtype, body}, device::Replier(answers, 1));
    };
    ask(map::kReqGetInfo, {});
    EXPECT_EQ(*wire::decode<map::Info>(answers.last), (map::Info{0.05f, 3, 2, {-1, -2, 0.5}}));
    ask(map::kReqGetData, wire::encode(map::Data{0, 0, 3, 2}));
    EXPECT_THAT(unpacked(*wire::decode<map::Data>(answers.last)), ElementsAre(-1, 1, 0, 1, -1, -1));
    EXPECT_THAT(testing::MemorySite("").build(section + " resolution 0.1 )"),
                HasSubstr("test.cfg:1: \"resolution\" is what \""));
  }
  std::ofstream(folder / "map.yaml") << "image: m.pgm\nresolution: none\n";
  EXPECT_THAT(testing::MemorySite("").build("driver( name \"mapfile\" provides [\"map:0\"] filename \"" +
                                            (folder / "map.yaml").string() + "\" )"),
              HasSubstr("map.yaml\", line 2: \"resolution\" needs a number"));
}

TEST(MapFile, tells_what_is_wrong_with_a_section) {
  const auto fault = [](const std::string& fields) {
    return testing::MemorySite("").build("driver( name \"mapfile\" provides [\"map:0\"] " + fields + " )");
  };
  EXPECT_THAT(fault("resolution 1"), HasSubstr("test.cfg:1: driver \"mapfile\" needs a filename"));
  EXPECT_THAT(fault("filename \"x.png\""), HasSubstr("needs a resolution"));
  EXPECT_THAT(fault("filename \"x.png\" resolution 0"), HasSubstr("resolution is from 0.0001 to 1000"));
  EXPECT_THAT(fault("filename \"no_such.png\" resolution 1"), HasSubstr("test.cfg:1: \"no_such.png\": "));
  EXPECT_THAT(fault("filename \"/dev/null\" resolution 1"), HasSubstr("test.cfg:1: \"/dev/null\": "));
}

}  // namespace
}  // namespace playhouse::drivers
