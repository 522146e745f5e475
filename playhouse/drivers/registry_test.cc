// What .cfg files become: devices, or one line that says what is wrong with the file.

#include "playhouse/drivers/registry.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MemorySite;
using ::testing::StartsWith;

constexpr const char* kWorld = R"(
interval_sim 100
define sonars ranger( sensor( pose [0 0 0 0] ) sensor( pose [0 0 0 90] ) )
define laser ranger( sensor( range [0 8] fov 180 samples 3 pose [0.05 0 0 0] ) )
position( name "r0" sonars( pose [0 0 0 0] ) laser( pose [0.1 0 0 0] ) )
position( name "r1" sonars( pose [0 0 0 0] ) )
)";

constexpr const char* kStage =
    "driver( name \"stage\" provides [\"simulation:0\"] plugin \"stageplugin\" worldfile \"some.world\" "
    "usegui 0 )\n";

std::string fault(const std::string& cfg) {
  MemorySite site(kWorld);
  return site.build(cfg);
}

TEST(StageDriver, opens_its_world_beside_the_file_and_provides_what_is_named) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["position2d:0" "ranger:0" "ranger:1"] model "r0" )
driver( name "stage" provides ["6666:position2d:0"] model "r1" ))"),
            "");
  EXPECT_THAT(site.opened, ElementsAre(EndsWith("some.world")));
  EXPECT_THAT(site.devices(), ElementsAre("6665:31:0=stage", "6665:4:0=stage", "6665:62:0=stage",
                                          "6665:62:1=stage", "6666:4:0=stage"));
  EXPECT_THAT(site.site().ports(), ElementsAre(6665u, 6666u));
  EXPECT_THAT(site.site().warnings(), IsEmpty());
}

TEST(Registry, gives_a_run_without_a_file_a_blackboard_and_the_health_of_its_machine) {
  MemorySite site(kWorld);
  ASSERT_TRUE(site.site().open_world("some.world"));
  const auto drivers = make_drivers_of_program(site.site());
  ASSERT_TRUE(drivers) << drivers.error().line();
  EXPECT_THAT(site.devices(), ElementsAre("6665:64:0=localbb", "6665:59:0=health"));
}

TEST(StageDriver, gives_each_address_the_next_model_that_fits) {
  MemorySite site(kWorld);
  ASSERT_EQ(
      site.build(std::string(kStage) +
                 "driver( name \"stage\" provides [\"laser:0\" \"ranger:0\" \"ranger:1\"] model \"r0\" )"),
      "");
  // Both rangers are there, and the laser is the one with a scanner.
  site.driver({6665, 6, 0})
      .request({site.id({6665, 6, 0}), 3, wire::laser::kReqGetGeom, {}}, device::Replier(site.recorder, 1));
  EXPECT_TRUE(site.recorder.answers[1].ack);
}

TEST(StageDriver, a_sonar_is_a_ring_before_it_is_a_laser) {
  MemorySite site(R"(
position( name "r0" ranger( sensor( samples 181 ) ) ranger( sensor( ) sensor( ) ) )
)");
  ASSERT_EQ(site.build(std::string(kStage) +
                       "driver( name \"stage\" provides [\"sonar:0\" \"sonar:1\"] model \"r0\" )"),
            "");
  run::Simulation& simulation = *simulation_of(site.site());
  EXPECT_EQ(list_models(simulation.world(), model_devices_of(site.site())->directory(), 0).text,
            "0\tr0\tposition\t\t\n"
            "1\tr0.ranger:0\tranger\tr0\t6665:sonar:1\n"
            "2\tr0.ranger:1\tranger\tr0\t6665:sonar:0\n");
}

TEST(StageDriver, an_ir_is_a_ring_and_several_dios_are_of_a_model_with_contacts_or_lamps_in_any_part) {
  const char* const world = R"(
position( name "r0" ranger( sensor( samples 181 ) ) ranger( sensor( ) sensor( ) )
  model( name "mast" blinkenlight( ) ) bumper( bcount 1 bpose [0 0 0 0] blength 0.1 ) )
)";
  MemorySite site(world);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["ir:0" "dio:0" "dio:1"] model "r0" )
driver( name "stage" provides ["dio:2"] model "r0.mast" ))"),
            "");
  run::Simulation& simulation = *simulation_of(site.site());
  EXPECT_EQ(list_models(simulation.world(), model_devices_of(site.site())->directory(), 0).text,
            "0\tr0\tposition\t\t6665:dio:0 6665:dio:1\n"
            "1\tr0.ranger:0\tranger\tr0\t\n"
            "2\tr0.ranger:1\tranger\tr0\t6665:ir:0\n"
            "3\tr0.mast\tmodel\tr0\t6665:dio:2\n"
            "4\tr0.mast.blinkenlight:0\tblinkenlight\tr0.mast\t\n"
            "5\tr0.bumper:0\tbumper\tr0\t\n");
  const auto fault_of = [&](const std::string& device, const char* model) {
    MemorySite other(world);
    return other.build(std::string(kStage) + "driver( name \"stage\" provides [\"" + device + "\"] model \"" +
                       model + "\" )");
  };
  EXPECT_THAT(fault_of("dio:0", "r0.ranger:1"), EndsWith("has nothing left for \"dio:0\""));
  EXPECT_THAT(fault_of("ir:0", "r0.ranger:0"), EndsWith("has nothing left for \"ir:0\""));
}

TEST(StageDriver, speech_is_of_the_model_that_is_named_and_may_be_of_it_twice) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["speech:0" "speech:1"] model "r0.ranger:0" )
driver( name "stage" provides ["speech:2"] model "r0" ))"),
            "");
  run::Simulation& simulation = *simulation_of(site.site());
  EXPECT_EQ(list_models(simulation.world(), model_devices_of(site.site())->directory(), 0).text,
            "0\tr0\tposition\t\t6665:speech:2\n"
            "1\tr0.ranger:0\tranger\tr0\t6665:speech:0 6665:speech:1\n"
            "2\tr0.ranger:1\tranger\tr0\t\n"
            "3\tr1\tposition\t\t\n"
            "4\tr1.ranger:0\tranger\tr1\t\n");
}

TEST(StageDriver, tells_the_directory_which_model_each_device_shows) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string("driver( name \"rangertolaser\" provides [\"7000:laser:3\"] "
                                   "requires [\"ranger:1\"] )\n") +
                       kStage + R"(
driver( name "stage" provides ["position2d:0" "ranger:0" "ranger:1"] model "r0" )
driver( name "stage" provides ["6666:position2d:0"] model "r1" ))"),
            "");
  run::Simulation& simulation = *simulation_of(site.site());
  EXPECT_EQ(list_models(simulation.world(), model_devices_of(site.site())->directory(), 0).text,
            "0\tr0\tposition\t\t6665:position2d:0\n"
            "1\tr0.ranger:0\tranger\tr0\t6665:ranger:0\n"
            "2\tr0.ranger:1\tranger\tr0\t6665:ranger:1 7000:laser:3\n"
            "3\tr1\tposition\t\t6666:position2d:0\n"
            "4\tr1.ranger:0\tranger\tr1\t\n");
  const auto names = [&](std::uint32_t id) {
    return device_names(model_devices_of(site.site())->directory(), {id}, 6665);
  };
  EXPECT_THAT(names(0), ElementsAre("position2d:0"));
  EXPECT_THAT(names(2), ElementsAre("ranger:1", "7000:laser:3"));
  EXPECT_THAT(names(3), ElementsAre("6666:position2d:0"));
  EXPECT_THAT(names(4), IsEmpty());
}

TEST(StageDriver, gives_a_model_of_any_kind_as_many_devices_that_draw_as_are_named) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["graphics2d:0" "graphics2d:1" "graphics3d:0"] model "r0" )
driver( name "stage" provides ["graphics2d:2"] model "r0.ranger:0" ))"),
            "");
  const auto names = [&](std::uint32_t id) {
    return device_names(model_devices_of(site.site())->directory(), {id}, 6665);
  };
  EXPECT_THAT(names(0), ElementsAre("graphics2d:0", "graphics2d:1", "graphics3d:0"));
  EXPECT_THAT(names(1), ElementsAre("graphics2d:2"));
  EXPECT_THAT(std::vector(site.site().warnings().begin(), site.site().warnings().end()), IsEmpty());
}

TEST(StageDriver, says_what_is_wrong_and_where) {
  const std::string stage = kStage;
  EXPECT_THAT(fault("driver( name \"stage\" provides [\"simulation:0\"] )"),
              AllOf(StartsWith("test.cfg:1"), HasSubstr("worldfile")));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"position2d:0\"] )"),
              AllOf(StartsWith("test.cfg:2"), HasSubstr("model")));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"position2d:0\"] model \"robot\" )"),
              AllOf(StartsWith("test.cfg:2"), HasSubstr("no model \"robot\"")));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"fiducial:0\"] model \"r0\" )"),
              HasSubstr("nothing left for \"fiducial:0\""));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"ranger:0\" \"ranger:1\"] model \"r1\" )"),
              HasSubstr("nothing left for \"ranger:1\""));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"audio:0\"] model \"r0\" )"),
              HasSubstr("\"audio\""));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"positon2d:0\"] model \"r0\" )"),
              HasSubstr("did you mean \"position2d\"?"));
  EXPECT_THAT(fault(stage + stage), HasSubstr("test.cfg:2"));
  EXPECT_THAT(
      fault("driver( name \"stage\" provides [\"simulation:0\"] worldfil \"t.world\" )"),
      HasSubstr("needs a worldfile; test.cfg:1: \"worldfil\" is unknown (did you mean \"worldfile\"?)"));
  EXPECT_THAT(fault(stage + "driver( name \"stage\" provides [\"position2d:0\"] modle \"r0\" )"),
              HasSubstr("; test.cfg:2: \"modle\" is unknown (did you mean \"model\"?)"));
}

TEST(Registry, an_unknown_driver_gets_the_nearest_name) {
  EXPECT_THAT(fault("driver( name \"stge\" provides [\"simulation:0\"] )"),
              AllOf(StartsWith("test.cfg:1"), HasSubstr("did you mean \"stage\"?")));
}

TEST(Registry, a_field_that_no_driver_reads_is_warned_of) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) +
                       "driver( name \"stage\" provides [\"position2d:0\"] modle \"r0\" model \"r0\" )"),
            "");
  EXPECT_THAT(std::vector(site.site().warnings().begin(), site.site().warnings().end()),
              ElementsAre(AllOf(StartsWith("test.cfg:2"), HasSubstr("modle"))));
}

TEST(Registry, alwayson_devices_run_without_a_client) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) +
                       "driver( name \"stage\" provides [\"position2d:0\"] model \"r0\" alwayson 1 )"),
            "");
  EXPECT_EQ(site.held[site.id({6665, 4, 0}).row].size(), 1u);
  site.run(1);
  EXPECT_EQ(site.recorder.published.size(), 1u);
}

constexpr const char* kRangerToLaser = R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "rangertolaser" provides ["laser:0"] requires ["ranger:1"] )
driver( name "stage" provides ["ranger:0" "ranger:1"] model "r0" ))";

/// A laser made of the scanner of r0.
class RangerToLaserTest : public ::testing::Test {
 protected:
  RangerToLaserTest() : site(kWorld) { EXPECT_EQ(site.build(kRangerToLaser), ""); }
  device::DeviceId laser() const { return site.id({6665, 6, 0}); }
  device::DeviceId ranger() const { return site.id({6665, 62, 1}); }
  device::Driver& driver() const { return site.driver({6665, 6, 0}); }

  MemorySite site;
};

TEST_F(RangerToLaserTest, finds_its_ranger_wherever_it_is_in_the_file) {
  EXPECT_THAT(site.devices(),
              ElementsAre("6665:31:0=stage", "6665:6:0=rangertolaser", "6665:62:0=stage", "6665:62:1=stage"));
}

TEST_F(RangerToLaserTest, holds_the_ranger_while_the_laser_is_open_and_makes_one_scan_of_each_of_its) {
  ASSERT_TRUE(driver().start(laser()));
  EXPECT_EQ(site.held[ranger().row].size(), 1u);
  site.run(2);
  std::vector<const device::Publication*> scans;
  for (const device::Publication& publication : site.recorder.published) {
    if (publication.device == laser()) scans.push_back(&publication);
  }
  ASSERT_EQ(scans.size(), 2u);
  const auto scan = wire::decode<wire::laser::Data>(scans[1]->body);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->ranges.size(), 3u);
  EXPECT_EQ(scan->intensity.size(), 3u);
  EXPECT_EQ(scan->max_range, 8.0f);
  EXPECT_DOUBLE_EQ(scans[1]->timestamp, 0.2);
  driver().stop(laser());
  EXPECT_EQ(site.held[ranger().row].size(), 0u);
  site.recorder.published.clear();
  site.run(1);
  EXPECT_TRUE(site.recorder.published.empty());
}

TEST_F(RangerToLaserTest, has_done_what_it_was_told_when_the_ranger_has) {
  ASSERT_TRUE(driver().start(laser()));
  driver().barrier(device::Replier(site.recorder, 9));
  EXPECT_FALSE(site.recorder.answers.contains(9));
  site.run(1);
  EXPECT_TRUE(site.recorder.answers[9].ack);
}

TEST_F(RangerToLaserTest, asks_the_ranger_for_geometry_and_configuration) {
  driver().request({laser(), 3, wire::laser::kReqGetGeom, {}}, device::Replier(site.recorder, 1));
  driver().request({laser(), 3, wire::laser::kReqGetConfig, {}}, device::Replier(site.recorder, 2));
  site.run(0);
  const auto geom = wire::decode<wire::laser::Geom>(site.recorder.answers[1].body);
  ASSERT_TRUE(geom);
  EXPECT_NEAR(geom->pose.px, 0.15, 1e-12) << "the scanner is 5 cm in front of its ranger";
  const auto config = wire::decode<wire::laser::Config>(site.recorder.answers[2].body);
  ASSERT_TRUE(config);
  EXPECT_EQ(config->max_range, 8.0f);
}

TEST_F(RangerToLaserTest, follows_the_configuration_of_its_ranger) {
  ASSERT_TRUE(driver().start(laser()));
  site.run(1);
  wire::ranger::Config wanted;
  wanted.min_angle = 0;
  wanted.max_angle = 1.5;
  wanted.min_range = 0.1;
  wanted.max_range = 4;
  site.driver({6665, 62, 1})
      .request({ranger(), 3, wire::ranger::kReqSetConfig, wire::encode(wanted)},
               device::Replier(site.recorder, 1));
  site.run(0);
  ASSERT_TRUE(site.recorder.answers[1].ack);
  site.recorder.published.clear();
  site.run(2);
  const auto& published = site.recorder.published;
  const auto newest = std::find_if(published.rbegin(), published.rend(),
                                   [&](const auto& publication) { return publication.device == laser(); });
  ASSERT_NE(newest, published.rend());
  const auto scan = wire::decode<wire::laser::Data>(newest->body);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->min_angle, 0);
  EXPECT_EQ(scan->max_range, 4);
  EXPECT_EQ(scan->ranges.size(), 1u) << "the middle one";
}

TEST_F(RangerToLaserTest, sets_the_configuration_and_the_power_of_its_ranger) {
  const float quarter = 1.5708f;
  const auto set = [&](const wire::laser::Config& config) {
    driver().request({laser(), 3, wire::laser::kReqSetConfig, wire::encode(config)},
                     device::Replier(site.recorder, 1));
    site.run(0);
    site.run(0);  // it asks for what there is first
    return site.recorder.answers.at(1);
  };
  const auto now = wire::decode<wire::laser::Config>(set({-quarter, quarter, 18000, 0, 1, 1, 5}).body);
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->resolution, 2 * quarter, 1e-3) << "in hundredths of a degree";
  EXPECT_EQ(now->max_range, 8);
  EXPECT_EQ(now->range_res, 1);
  EXPECT_EQ(now->scanning_frequency, 5);
  EXPECT_FALSE(set({-2, quarter, 0, 0, 0, 1, 0}).ack) << "the ranger does not see that far round";
  driver().request({laser(), 3, wire::laser::kReqPower, wire::encode(wire::laser::PowerConfig{0})},
                   device::Replier(site.recorder, 2));
  site.run(0);
  EXPECT_TRUE(site.recorder.answers[2].ack);
}

TEST(RangerToLaser, goes_with_its_ranger_open_or_not) {
  for (const bool open : {true, false}) {
    MemorySite site(kWorld);
    ASSERT_EQ(site.build(kRangerToLaser), "");
    const device::DeviceId sonars = site.id({6665, 62, 0}), scanner = site.id({6665, 62, 1});
    const device::DeviceId its_laser = site.id({6665, 6, 0});
    if (open) ASSERT_TRUE(site.hold(its_laser));
    ASSERT_TRUE(simulation_of(site.site())->requests().post([](world::Journal& journal) {
      EXPECT_TRUE(journal.despawn(journal.world().id(journal.world().find("r0"))));
    }));
    site.run(1);
    EXPECT_THAT(site.retired, ElementsAre(sonars.row, scanner.row, its_laser.row));
    EXPECT_FALSE(site.hold(its_laser));
    EXPECT_EQ(model_devices_of(site.site())->directory().size(), 0u);
    EXPECT_EQ(site.site().device_count(), 1u) << "the simulation";
  }
}

TEST(StageDriver, devices_of_a_robot_that_goes_retire_and_one_that_comes_has_none) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["position2d:0"] model "r0" alwayson 1 )
driver( name "stage" provides ["6666:position2d:0"] model "r1" ))"),
            "");
  const device::DeviceId gone = site.id({6665, 4, 0});
  ASSERT_TRUE(simulation_of(site.site())->requests().post([](world::Journal& journal) {
    EXPECT_TRUE(journal.despawn(journal.world().id(journal.world().find("r0"))));
    EXPECT_TRUE(journal.spawn(3, {}));
  }));
  site.run(1);
  EXPECT_THAT(site.retired, ElementsAre(gone.row));
  EXPECT_EQ(site.site().device_count(), 2u);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 1u);
  site.run(1);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 0u);
}

TEST(Registry, leaves_out_drivers_that_it_lacks_and_those_that_require_them) {
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(std::string(kStage) + R"(
driver( name "stage" provides ["position2d:0" "laser:0"] model "r0" )
driver( name "rangertolaser" requires ["ranger:7"] provides ["laser:7"] )
driver( name "laserptzcloud" requires ["laser:0"] provides ["ranger:7"] speed 3 )
driver( name "writelog" requires ["laser:0"] provides ["log:0"] alwayson 1 )
driver( name "nd" requires ["position2d:0" "laser:7"] provides ["position2d:7"] ))"),
            "");
  EXPECT_THAT(site.devices(), ElementsAre("6665:31:0=stage", "6665:4:0=stage", "6665:6:0=stage"));
  EXPECT_THAT(
      site.site().warnings(),
      ElementsAre(
          AllOf(StartsWith("test.cfg:5: driver \"laserptzcloud\" is left out: this program has no such "
                           "driver; it has amcl, "),
                EndsWith(", suppressor, urglaser, urglaser_emulator, vfh, wavefront")),
          "test.cfg:6: driver \"writelog\" is left out: this program has no such driver; the option --record "
          "records a run",
          "test.cfg:4: driver \"rangertolaser\" is left out: it requires \"ranger:7\", which test.cfg:5 "
          "would "
          "provide",
          "test.cfg:7: driver \"nd\" is left out: it requires \"laser:7\", which test.cfg:4 would provide"));
  EXPECT_THAT(fault("driver( name \"writelog\" provides [\"log:0\"] )"),
              StartsWith("test.cfg:1: driver \"writelog\": this program has no such driver; "));
}

TEST(RangerToLaser, says_what_is_wrong_and_where) {
  const std::string stage = kStage;
  EXPECT_THAT(
      fault(stage + "driver( name \"rangertolaser\" provides [\"laser:0\"] requires [\"ranger:7\"] )"),
      AllOf(StartsWith("test.cfg:2"), HasSubstr("nothing provides \"ranger:7\"")));
  EXPECT_THAT(fault(stage + "driver( name \"rangertolaser\" provides [\"laser:0\"] )"),
              HasSubstr("requires one ranger"));
  EXPECT_THAT(
      fault(stage + "driver( name \"rangertolaser\" provides [\"sonar:0\"] requires [\"ranger:0\"] )"),
      HasSubstr("provides one laser"));
  EXPECT_THAT(fault(stage + "driver( name \"rangertolaser\" provides [\"laser:0\"] requirs [\"ranger:0\"] )"),
              HasSubstr("; test.cfg:2: \"requirs\" is unknown (did you mean \"requires\"?)"));
  EXPECT_THAT(fault(stage + "driver( name \"rangertolaser\" provides [\"laser:0\"] requires [\"rangr:7\"] )"),
              HasSubstr("found \"rangr:7\" (did you mean \"ranger\"?)"));
  EXPECT_THAT(fault(stage + "driver( name \"rangertolaser\" provides [\"lasr:0\"] requires [\"ranger:0\"] )"),
              HasSubstr("found \"lasr:0\" (did you mean \"laser\"?)"));
  EXPECT_THAT(fault(stage + R"(driver( name "stage" provides ["ranger:0"] model "r0" )
driver( name "rangertolaser" provides ["laser:0"] requires ["ranger:0"] ))"),
              AllOf(StartsWith("test.cfg:3"),
                    HasSubstr("\"ranger:0\" has 2 sensors, and a laser shows the scan of one")));
}

}  // namespace
}  // namespace playhouse::drivers
