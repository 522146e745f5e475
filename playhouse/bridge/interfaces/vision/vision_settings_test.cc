// What clients may set of a blobfinder and of a camera.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/camera.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
namespace bf = wire::blobfinder;
namespace cam = wire::camera;

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0"
  blobfinder( name "two" colors_count 2 colors [ "blue" "red" "green" ] )
  blobfinder( name "all" )
  camera( name "eye" resolution [2 1] ) )
)";

class Vision : public testing::OneDevice {
 protected:
  Vision() : OneDevice(kWorld) {}

  /// Numbers of the reported blobs of a blue and a red thing, in this order.
  std::vector<std::uint32_t> seen() {
    const bool all = still_.world().models.watchers[still_.world().find("r0.all")] > 0;
    const world::BlobfinderRow row{all ? 1u : 0u};
    still_.world().blobfinders.blobs[row] = {{{0, 0, 1, 1}, 0, 10, 19, 15, 24, 2.5},
                                             {{1, 0, 0, 1}, all ? 0u : 1u, 30, 39, 15, 24, 2.5}};
    still_.run(1);
    std::vector<std::uint32_t> numbers;
    for (const bf::Blob& blob : last<bf::Data>(bf::kDataBlobs).blobs) numbers.push_back(blob.id);
    return numbers;
  }
  bool set_color(const bf::ColorConfig& range) { return ask_with(bf::kReqSetColor, range).ack; }
  bf::ColorConfig color(std::int32_t channel) {
    return reply<bf::ColorConfig>(ask_with(bf::kReqGetColor, bf::ColorConfig{.channel = channel}));
  }
};

constexpr bf::ColorConfig kReds{1, 200, 255, 0, 50, 0, 50}, kBlues{0, 0, 50, 0, 50, 200, 255};

TEST_F(Vision, a_channel_of_the_file_reports_its_color_unless_a_client_leaves_it_out) {
  open(bf::kCode, "r0.two");
  EXPECT_THAT(seen(), ElementsAre(0, 1));
  EXPECT_EQ(color(1), (bf::ColorConfig{1, 255, 255, 0, 0, 0, 0}));
  EXPECT_TRUE(set_color(kReds));
  EXPECT_EQ(color(1), kReds);
  EXPECT_THAT(seen(), ElementsAre(0, 1));
  bf::ColorConfig other = kBlues;
  other.channel = 1;
  EXPECT_TRUE(set_color(other));
  EXPECT_THAT(seen(), ElementsAre(0)) << "the red one is no blue";
  other.channel = -1;
  other.bmax = 210;
  EXPECT_TRUE(set_color(other));
  EXPECT_THAT(seen(), ElementsAre());
  EXPECT_EQ(color(0).bmax, 210u);
  reopen();
  EXPECT_THAT(seen(), ElementsAre(0, 1));
}

TEST_F(Vision, channels_of_all_colors_are_a_clients) {
  open(bf::kCode, "r0.all");
  EXPECT_THAT(seen(), ElementsAre(0, 0));
  EXPECT_TRUE(set_color(kReds));
  EXPECT_THAT(seen(), ElementsAre(0, 0)) << "channel 0 has them all";
  EXPECT_TRUE(set_color(kBlues));
  EXPECT_THAT(seen(), ElementsAre(0, 1));
}

TEST_F(Vision, channels_and_colors_that_cannot_be_are_refused) {
  open(bf::kCode, "r0.two");
  const auto is_refused = [&](auto member, auto value) {
    bf::ColorConfig wanted = kReds;
    wanted.*member = value;
    return !set_color(wanted);
  };
  EXPECT_TRUE(is_refused(&bf::ColorConfig::channel, 2)) << "not one of the first two";
  EXPECT_TRUE(is_refused(&bf::ColorConfig::channel, -2));
  EXPECT_TRUE(is_refused(&bf::ColorConfig::channel, 1 << 30));
  EXPECT_TRUE(is_refused(&bf::ColorConfig::rmax, 256u));
  EXPECT_TRUE(is_refused(&bf::ColorConfig::gmin, 51u)) << "above its maximum";
  EXPECT_TRUE(is_refused(&bf::ColorConfig::bmin, ~0u));
  EXPECT_FALSE(ask_with(bf::kReqGetColor, bf::ColorConfig{.channel = 2}).ack);
  EXPECT_FALSE(ask_with(bf::kReqGetColor, bf::ColorConfig{.channel = -1}).ack);
  EXPECT_FALSE(ask(bf::kReqSetColor).ack);
  EXPECT_EQ(color(1).rmin, 255u);
}

TEST_F(Vision, a_blobfinder_keeps_what_is_set_of_its_imager) {
  open(bf::kCode, "r0.two");
  const auto integer = [&](const char* name) {
    return reply<wire::IntpropReq>(ask_with(wire::kReqGetIntprop, wire::IntpropReq{wire::c_string(name), 0}))
        .value;
  };
  EXPECT_TRUE(ask_with(bf::kReqSetImagerParams, bf::ImagerConfig{200, -1, 2, 1}).ack);
  EXPECT_EQ(integer("brightness"), 200);
  EXPECT_EQ(integer("contrast"), 128) << "-1 leaves it";
  EXPECT_EQ(integer("colormode"), 2);
  EXPECT_EQ(integer("autogain"), 1);
  EXPECT_FALSE(ask_with(bf::kReqSetImagerParams, bf::ImagerConfig{256, -1, -1, -1}).ack);
  EXPECT_FALSE(ask_with(bf::kReqSetImagerParams, bf::ImagerConfig{-1, -2, -1, -1}).ack);
  EXPECT_FALSE(ask_with(bf::kReqSetImagerParams, bf::ImagerConfig{-1, -1, 4, -1}).ack);
  EXPECT_FALSE(ask_with(bf::kReqSetImagerParams, bf::ImagerConfig{7, -1, -1, 2}).ack);
  EXPECT_EQ(integer("brightness"), 200) << "all or nothing";
}

TEST_F(Vision, a_camera_has_one_source_and_keeps_a_norm) {
  open(cam::kCode, "r0.eye");
  const auto source = [&] { return reply<cam::Source>(ask_with(cam::kReqGetSource, cam::Source{})); };
  EXPECT_EQ(source(), (cam::Source{wire::c_string(""), 0}));
  EXPECT_TRUE(ask_with(cam::kReqSetSource, cam::Source{wire::c_string("NTSC"), 0}).ack);
  EXPECT_EQ(source(), (cam::Source{wire::c_string("NTSC"), 0}));
  EXPECT_FALSE(ask_with(cam::kReqSetSource, cam::Source{wire::c_string("PAL"), 1}).ack);
  EXPECT_FALSE(ask_with(cam::kReqSetSource, cam::Source{wire::c_string(std::string(33, 'x')), 0}).ack);
  EXPECT_EQ(source(), (cam::Source{wire::c_string("NTSC"), 0}));
  reopen();
  EXPECT_EQ(source(), (cam::Source{wire::c_string(""), 0}));
}

}  // namespace
}  // namespace playhouse::drivers
