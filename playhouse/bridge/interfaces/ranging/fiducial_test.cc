// What clients may set of a fiducial finder: a part of what it sees.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/fiducial.h"

namespace playhouse::drivers {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
namespace fid = wire::fiducial;

class FiducialView : public testing::OneDevice {
 protected:
  FiducialView()
      : OneDevice(
            "interval_sim 100\nposition( name \"r0\" "
            "fiducial( name \"finder\" range_min 0.1 range_max 6 fov 180 ) )") {
    open(fid::kCode, "r0.finder");
    world::FiducialHit ahead, aside, far;
    ahead.id = 1;
    ahead.range = 0.5;
    aside.id = 2;
    aside.range = 2;
    aside.bearing = -1.2;
    far.id = 3;
    far.range = 6;
    far.bearing = pi / 2;
    still_.world().fiducials.hits[{0}] = {ahead, aside, far};
  }
  fid::Fov fov() { return reply<fid::Fov>(ask(fid::kReqGetFov)); }
  bool set(float min_range, float max_range, float view_angle) {
    return ask_with(fid::kReqSetFov, fid::Fov{min_range, max_range, view_angle}).ack;
  }
  std::vector<std::int32_t> seen() {
    still_.run(1);
    std::vector<std::int32_t> ids;
    for (const fid::Item& item : last<fid::Data>(fid::kDataScan).fiducials) ids.push_back(item.id);
    return ids;
  }
};

TEST_F(FiducialView, markers_beyond_what_is_set_are_not_reported) {
  EXPECT_THAT(seen(), ElementsAre(1, 2, 3));
  EXPECT_EQ(reply<fid::Fov>(ask_with(fid::kReqSetFov, fid::Fov{1, 4, static_cast<float>(pi)})),
            (fid::Fov{1, 4, static_cast<float>(pi)}));
  EXPECT_EQ(fov(), (fid::Fov{1, 4, static_cast<float>(pi)}));
  EXPECT_THAT(seen(), ElementsAre(2));
  EXPECT_TRUE(set(0.1f, 6, 2));
  EXPECT_THAT(seen(), ElementsAre(1));
  EXPECT_TRUE(set_number("view_angle", 2.5));
  EXPECT_THAT(seen(), ElementsAre(1, 2));
  reopen();
  EXPECT_THAT(seen(), ElementsAre(1, 2, 3));
}

TEST_F(FiducialView, it_sees_no_more_than_its_model) {
  const fid::Fov usual = fov();
  EXPECT_TRUE(ask_with(fid::kReqSetFov, usual).ack);
  EXPECT_FALSE(set(0, 6, 1));
  EXPECT_FALSE(set(0.1f, 6.1f, 1));
  EXPECT_FALSE(set(0.1f, 6, 3.2f));
  EXPECT_FALSE(set(0.1f, 6, -1));
  EXPECT_FALSE(set(3, 2, 1));
  EXPECT_FALSE(set(std::nanf(""), 6, 1));
  EXPECT_FALSE(set(0.1f, 6, std::numeric_limits<float>::infinity()));
  EXPECT_FALSE(ask(fid::kReqSetFov).ack);
  EXPECT_EQ(fov(), usual);
}

}  // namespace
}  // namespace playhouse::drivers
