/// Files of Stage itself, which are not in this tree: each loads with what it says,
/// or fails where the original fails, with its own line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "playhouse/base/testing/reference.h"
#include "playhouse/config/cfg.h"
#include "playhouse/config/text/syntax.h"
#include "playhouse/scene/images/bitmap.h"
#include "playhouse/scene/testing_expanded.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

const std::string kFiles = (stage_source() / "").string();

struct World {
  std::string name;
  std::map<std::string, int> models;  // by type
  std::size_t sensors, beams;
};

class OriginalWorld : public testing::TestWithParam<World> {};

TEST_P(OriginalWorld, loads_with_the_models_that_the_original_counts) {
  const World& expected = GetParam();
  const std::string path = kFiles + "worlds/" + expected.name + ".world";
  SKIP_WITHOUT_STAGE();
  const Result<SceneDesc> scene = load_world(path);
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  std::map<std::string, int> models;
  std::size_t sensors = 0, beams = 0;
  for (const ModelDesc& model : expanded(*scene).models) {
    ++models[model.type];
    sensors += model.sensors.size();
    for (const RangerSensorDesc& sensor : model.sensors) beams += sensor.samples;
  }
  EXPECT_EQ(models, expected.models);
  EXPECT_EQ(sensors, expected.sensors);
  EXPECT_EQ(beams, expected.beams);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, OriginalWorld,
    testing::Values(
        World{"simple", {{"model", 1}, {"position", 2}, {"ranger", 4}}, 34, 392},
        World{"everything",
              {{"model", 4},
               {"position", 14},
               {"ranger", 24},
               {"fiducial", 8},
               {"gripper", 1},
               {"blobfinder", 1},
               {"camera", 1},
               {"bumper", 4}},
              136,
              1568},
        World{"benchmark/cave", {{"model", 1}, {"position", 100}, {"ranger", 200}}, 1700, 19600},
        World{"benchmark/hospital", {{"model", 1}, {"position", 1000}, {"ranger", 1000}}, 12000, 12000},
        World{"SFU", {{"model", 1}, {"position", 94}, {"ranger", 94}, {"fiducial", 94}}, 752, 752},
        World{"circuit", {{"model", 1}, {"position", 94}, {"ranger", 94}, {"fiducial", 94}}, 752, 752},
        World{"large", {{"model", 1}, {"position", 10}, {"ranger", 20}}, 170, 1960},
        World{"fasr", {{"model", 51}, {"position", 20}, {"ranger", 40}, {"fiducial", 20}}, 340, 960},
        World{"fasr2", {{"model", 135}, {"position", 100}, {"ranger", 200}, {"fiducial", 100}}, 1700, 4800},
        World{"fasr_plan",
              {{"model", 19}, {"position", 5}, {"ranger", 8}, {"fiducial", 4}, {"gripper", 4}},
              68,
              784},
        World{"camera", {{"model", 1}, {"position", 1}, {"ranger", 2}, {"camera", 1}}, 17, 196},
        World{"pioneer_follow", {{"model", 1}, {"position", 1}, {"ranger", 2}}, 17, 196},
        World{"pioneer_walle", {{"model", 1}, {"position", 2}, {"ranger", 2}}, 17, 196},
        World{"sensor_noise_demo", {{"model", 1}, {"position", 1}, {"ranger", 2}}, 17, 196},
        World{"sensor_noise_module_demo", {{"model", 1}, {"position", 1}, {"ranger", 2}}, 17, 196}),
    [](const auto& about) {
      std::string name = about.param.name;
      std::replace(name.begin(), name.end(), '/', '_');
      return name;
    });

TEST(OriginalFiles, the_first_robot_of_simple_world_is_as_the_file_says) {
  const std::string path = kFiles + "worlds/simple.world";
  SKIP_WITHOUT_STAGE();
  const Result<SceneDesc> scene = load_world(path);
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  EXPECT_THAT(scene->warnings, testing::IsEmpty());
  const auto named = [&](const std::string& name) {
    const std::vector<ModelDesc> all = expanded(*scene).models;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ModelDesc& model) { return model.name == name; });
    return found == all.end() ? ModelDesc{} : *found;
  };
  const ModelDesc cave = named("cave"), robot = named("r0"), sonar = named("r0.ranger:0"),
                  laser = named("r0.ranger:1");
  EXPECT_FALSE(cave.obstacle_return);
  EXPECT_EQ(cave.ranger_return, 0.5);
  ASSERT_EQ(cave.bitmaps.size(), 1u);
  EXPECT_EQ(cave.blocks.size(), 4u) << "its boundary";
  EXPECT_EQ(robot.X_PM, (geom::Pose{-6.946, -6.947, 0, geom::kPi / 4}));
  EXPECT_EQ(robot.X_MB, (geom::Pose{-0.04, 0, 0, 0}));
  EXPECT_EQ(robot.size, (geom::Size{0.44, 0.38, 0.22}));
  EXPECT_EQ(robot.position->velocity_bounds[0].max, 0.5);
  EXPECT_THAT(robot.ctrl, testing::ElementsAre("wander"));
  EXPECT_NEAR(sonar.X_PM.z, 0.19, 1e-15);
  EXPECT_EQ(sonar.sensors.size(), 16u);
  ASSERT_EQ(laser.sensors.size(), 1u);
  EXPECT_EQ(laser.sensors[0].samples, 180u);
  EXPECT_DOUBLE_EQ(laser.sensors[0].fov, geom::kPi);
  EXPECT_EQ(laser.sensors[0].X_BS.z, 0.1);
}

TEST(OriginalFiles, bitmaps_that_are_not_where_worlds_say_are_found_in_the_search_path) {
  SKIP_WITHOUT_STAGE();
  setenv("STAGEPATH", (kFiles + "worlds").c_str(), 1);
  const Result<SceneDesc> scene = load_world(kFiles + "worlds/wifi/hosp_wifi.world");
  unsetenv("STAGEPATH");
  ASSERT_TRUE(scene.ok()) << scene.error().line();
  const std::string found = kFiles + "worlds/bitmaps/hospital_section.png";
  EXPECT_THAT(scene->warnings, testing::Contains(testing::HasSubstr("is not there, so \"" + found)));
}

TEST(OriginalFiles, worlds_that_no_stage_4_loads_fail_with_a_line) {
  SKIP_WITHOUT_STAGE();
  const std::map<std::string, std::string> expected = {
      {"worlds/wifi/wifi_ray.world", "bitmaps/cave_f.png\" cannot be opened"},
      {"examples/libplayerc/playerswarm/pss.world", "pss.world:87: included file "},
  };
  for (const auto& [name, text] : expected) {
    const Result<SceneDesc> scene = load_world(kFiles + name);
    ASSERT_FALSE(scene.ok()) << name;
    EXPECT_THAT(scene.error().line(), testing::HasSubstr(text));
  }
}

Result<config::Document> parsed(const std::string& path) {
  config::DiskFiles files;
  Result<std::string> text = files.read(path);
  return text ? config::parse_document(config::Format::kWorld, path, *text, files)
              : Result<config::Document>(text.error());
}

TEST(OriginalFiles, the_parser_tests_of_the_original_parse_or_fail_as_they_say) {
  const std::string folder = kFiles + "tests/worldfile/";
  SKIP_WITHOUT_STAGE();
  for (const char* name : {"include-01", "macro-01", "macro-02", "syntax-01"}) {
    const Result<config::Document> document = parsed(folder + name + ".world");
    EXPECT_TRUE(document.ok()) << document.error().line();
  }
  const std::map<std::string, std::string> expected = {
      {"include-02", ":9: include needs"},
      {"syntax-02", ":14: unexpected character ','"},
      {"syntax-03", ":10: \"position\" lacks"},
      {"syntax-04", ":16: \")\" without"},
      {"syntax-05", ":15: \"player\" needs"},
      {"syntax-06", ":12: \"name\" needs a value"},
      {"syntax-07", ":9: define \"sonar_p2dx\" needs the type"},
  };
  for (const auto& [name, text] : expected) {
    const Result<config::Document> document = parsed(folder + name + ".world");
    ASSERT_FALSE(document.ok()) << name;
    EXPECT_THAT(document.error().line(), testing::HasSubstr(name + ".world" + text));
  }
}

TEST(OriginalFiles, every_configuration_parses) {
  SKIP_WITHOUT_STAGE();
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kFiles)) {
    if (entry.path().extension() != ".cfg") continue;
    const Result<config::CfgFile> cfg = config::load_cfg(entry.path().string());
    EXPECT_TRUE(cfg.ok()) << cfg.error().line();
    ++files;
  }
  EXPECT_GT(files, 10);
}

TEST(OriginalFiles, simple_cfg_names_its_devices) {
  const std::string path = kFiles + "worlds/simple.cfg";
  SKIP_WITHOUT_STAGE();
  const Result<config::CfgFile> cfg = config::load_cfg(path);
  ASSERT_TRUE(cfg.ok()) << cfg.error().line();
  ASSERT_EQ(cfg->drivers.size(), 3u);
  EXPECT_EQ(cfg->drivers[0].filename("worldfile", ""), kFiles + "worlds/simple.world");
  EXPECT_EQ(cfg->drivers[1].text("model", ""), "r0");
  EXPECT_EQ(cfg->drivers[1].addresses("provides").at(2).text(), "ranger:1");
  EXPECT_EQ(cfg->drivers[2].name(), "rangertolaser");
}

/// Solid pixels of an image and the pixel edges that bound them.
struct Picture {
  std::string name;
  int width, height;
  long solid;
  int x0, x1, y0, y1;
};

class OriginalBitmap : public testing::TestWithParam<Picture> {};

TEST_P(OriginalBitmap, has_its_solid_pixels_and_their_bounding_box) {
  const Picture& expected = GetParam();
  const std::string path = kFiles + "worlds/bitmaps/" + expected.name + ".png";
  SKIP_WITHOUT_STAGE();
  const Result<std::string> image = config::DiskFiles().read(path);
  ASSERT_TRUE(image.ok()) << image.error().line();
  const Result<Bitmap> bitmap = decode_bitmap(*image);
  ASSERT_TRUE(bitmap.ok()) << bitmap.error().line();
  EXPECT_EQ(bitmap->width, expected.width);
  EXPECT_EQ(bitmap->height, expected.height);
  EXPECT_EQ(std::count(bitmap->solid.begin(), bitmap->solid.end(), 1), expected.solid);
  geom::Box box;
  double area = 0;
  const auto loops = trace_contours(*bitmap);
  ASSERT_TRUE(loops.ok());
  for (const auto& loop : *loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      box.add(loop[i]);
      area += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
    }
  }
  EXPECT_EQ(area, static_cast<double>(expected.solid));
  EXPECT_EQ(box.x_min, expected.x0);
  EXPECT_EQ(box.x_max, expected.x1);
  EXPECT_EQ(expected.height - box.y_max, expected.y0);
  EXPECT_EQ(expected.height - box.y_min, expected.y1);
}

INSTANTIATE_TEST_SUITE_P(Bitmaps, OriginalBitmap,
                         testing::Values(Picture{"889_05", 1086, 443, 16076, 4, 1086, 0, 443},
                                         Picture{"SFU_1200x615", 1200, 615, 51384, 2, 1198, 4, 613},
                                         Picture{"SRI-AIC-kwing", 856, 293, 15732, 15, 849, 44, 235},
                                         Picture{"cave", 500, 500, 5270, 0, 500, 0, 500},
                                         Picture{"cave_compact", 113, 113, 600, 0, 113, 0, 113},
                                         Picture{"cave_filled", 500, 500, 59067, 0, 500, 0, 500},
                                         Picture{"frieburg", 1000, 898, 10222, 27, 919, 30, 817},
                                         Picture{"ghost", 23, 20, 134, 4, 18, 3, 17},
                                         Picture{"hospital", 3117, 1189, 95287, 1, 3117, 1, 1189},
                                         Picture{"hospital_section", 1086, 443, 17158, 4, 1086, 0, 443},
                                         Picture{"human_outline", 200, 200, 6103, 22, 177, 2, 183},
                                         Picture{"rink", 805, 805, 11460, 6, 801, 4, 799},
                                         Picture{"sal2", 887, 407, 868, 0, 885, 60, 405},
                                         Picture{"simple_rooms", 400, 300, 36816, 0, 400, 0, 300},
                                         Picture{"space_invader", 122, 101, 3486, 13, 109, 13, 83},
                                         Picture{"submarine", 200, 99, 2631, 4, 195, 3, 98},
                                         Picture{"submarine_small", 100, 50, 615, 2, 97, 1, 49},
                                         Picture{"table", 676, 288, 3956, 2, 675, 3, 285}),
                         [](const auto& about) {
                           std::string name = about.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace playhouse::scene
