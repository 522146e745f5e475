// The pose of a simulated robot as a localization.

#include "playhouse/drivers/fakelocalize/fake_localize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace lcl = wire::localize;
namespace p2d = wire::position2d;
namespace sim = wire::simulation;

constexpr device::Address kLocalize{6665, lcl::kCode, 0}, kPlace{6665, p2d::kCode, 2};

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" pose [1 2 0 90] size [0.4 0.4 0.2] localization "odom" )
)";

std::string sections(const std::string& provides, const std::string& model) {
  return "driver( name \"fakelocalize\" provides [" + provides + "] requires [\"simulation:0\"] model \"" +
         model + R"(" )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0"] model "r0" ))";
}

class FakeLocalizeTest : public ::testing::Test {
 protected:
  explicit FakeLocalizeTest(const std::string& model = "r0") : site(kWorld) {
    EXPECT_EQ(site.build(sections("\"localize:0\" \"position2d:2\"", model)), "");
    EXPECT_TRUE(site.hold(site.id(kLocalize)));
  }
  /// Somebody puts the robot there.
  void put(const wire::Pose2d& X_WR) {
    constexpr device::Address kSimulation{6665, sim::kCode, 0};
    site.driver(kSimulation)
        .request({site.id(kSimulation), 3, sim::kReqSetPose2d,
                  wire::encode(sim::Pose2dReq{wire::c_string("r0"), X_WR})},
                 device::Replier(site.recorder, 9));
  }
  template <typename T>
  T last(device::Address address) {
    for (auto each = site.recorder.published.rbegin(); each != site.recorder.published.rend(); ++each)
      if (each->device == site.id(address)) return *wire::decode<T>(each->body);
    ADD_FAILURE() << "nothing was published";
    return {};
  }

  testing::MemorySite site;
};

TEST_F(FakeLocalizeTest, tells_the_pose_in_the_world_tick_after_tick) {
  site.run(0);
  const lcl::Data at_once = last<lcl::Data>(kLocalize);
  ASSERT_EQ(at_once.hypoths.size(), 1u);
  EXPECT_EQ(at_once.hypoths[0].mean.px, 1);
  EXPECT_EQ(at_once.hypoths[0].mean.py, 2);
  EXPECT_NEAR(at_once.hypoths[0].mean.pa, geom::radians(90), 1e-9);
  EXPECT_EQ(at_once.hypoths[0].alpha, 1);
  EXPECT_THAT(at_once.hypoths[0].cov, ::testing::Each(0));
  site.run(3);
  put({-4, 0.5, 1});
  site.run(1);
  site.run(0);
  EXPECT_EQ(last<lcl::Data>(kLocalize).hypoths[0].mean, (wire::Pose2d{-4, 0.5, 1}));
  EXPECT_EQ(last<p2d::Data>(kPlace).pos, (wire::Pose2d{-4, 0.5, 1}));
  EXPECT_NEAR(site.recorder.published.back().timestamp, 0.4, 1e-9) << "the time of the pose";
}

TEST_F(FakeLocalizeTest, has_one_particle) {
  site.run(1);
  site.driver(kLocalize).request({site.id(kLocalize), 3, lcl::kReqGetParticles, {}},
                                 device::Replier(site.recorder, 1));
  const auto particles = wire::decode<lcl::GetParticles>(site.recorder.answers.at(1).body);
  ASSERT_EQ(particles->particles.size(), 1u);
  EXPECT_EQ(particles->particles[0].pose.py, 2);
  EXPECT_EQ(particles->mean.px, 1);
}

TEST_F(FakeLocalizeTest, says_nothing_while_nobody_has_it_open) {
  site.run(2);
  site.release(site.id(kLocalize));
  site.run(0);
  site.recorder.published.clear();
  site.run(3);
  EXPECT_THAT(site.recorder.published, IsEmpty());
}

class FakeLocalizeNobodyTest : public FakeLocalizeTest {
 protected:
  FakeLocalizeNobodyTest() : FakeLocalizeTest("nobody") {}
};

TEST_F(FakeLocalizeNobodyTest, has_no_pose_of_a_model_that_does_not_exist) {
  site.run(5);
  EXPECT_THAT(site.recorder.published, IsEmpty());
  site.driver(kLocalize).request({site.id(kLocalize), 3, lcl::kReqGetParticles, {}},
                                 device::Replier(site.recorder, 1));
  EXPECT_FALSE(site.recorder.answers.at(1).ack);
}

TEST(FakeLocalizeSection, says_what_is_wrong) {
  const auto fault = [](const std::string& cfg) { return testing::MemorySite(kWorld).build(cfg); };
  EXPECT_EQ(fault(sections("\"position2d:2\"", "r0")), "");
  EXPECT_EQ(fault(sections("\"localize:0\"", "r0")), "");
  EXPECT_EQ(fault(sections("\"localize:0\"", "")),
            "test.cfg:1: model is needed: the name of the robot in the world");
  EXPECT_THAT(fault(sections("\"laser:0\"", "r0")),
              HasSubstr("test.cfg:1: driver \"fakelocalize\" provides one localize"));
}

}  // namespace
}  // namespace playhouse::drivers
