// The page's decoder is tested against packets made here (web/src/protocol/golden.json). UPDATE_GOLDEN=1
// writes the file anew after a wanted change of the format.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "playhouse/base/formats.h"
#include "playhouse/base/version.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/scene_text.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/drawing.h"
#include "playhouse/world/population/population.h"

namespace playhouse::replicate {
namespace {

const std::string kGolden = PLAYHOUSE_SOURCE_DIR "/web/src/protocol/golden.json";

std::string hex(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += fmt::format("{:02x}", std::to_integer<int>(byte));
  return text;
}

/// What a page must hold afterwards, as the test there compares it: by id, and per view the bare numbers.
std::string held(const Replica& replica) {
  const Layout& layout = *replica.layout;
  std::string models, says, scans, views_text, drawings;
  for (const world::ModelRow row : replica.models.rows()) {
    const ModelState& m = replica.models[row];
    models +=
        fmt::format("{}\"{}\":[{},{},{},{},{},{},{},{},{}]", models.empty() ? "" : ",", layout.id[row].value,
                    m.x, m.y, m.z, m.a, m.state, m.color, m.flags, m.tilt_x, m.tilt_y);
  }
  for (const auto& [row, text] : replica.says) {
    says +=
        fmt::format("{}\"{}\":{}", says.empty() ? "" : ",", layout.id[row].value, replicate::quoted(text));
  }
  for (const world::SensorRow row : replica.scans.rows()) {
    if (replica.scans[row].empty()) continue;
    const SensorLayout& sensor = layout.sensors[row];
    scans += fmt::format("{}\"{}/{}\":[{}]", scans.empty() ? "" : ",", layout.id[sensor.model].value,
                         sensor.nth, fmt::join(replica.scans[row], ","));
  }
  for (const auto& [key, values] : replica.views) {
    views_text += fmt::format("{}\"{}\":[{}]", views_text.empty() ? "" : ",", layout.id[key.second].value,
                              fmt::join(values, ","));
  }
  for (const auto& [row, drawing] : replica.drawings) {
    std::string corners;
    for (const SentCorner& c : *drawing)
      corners += fmt::format("{}{},{},{},{},{},{}", corners.empty() ? "" : ",", c.x, c.y, c.z, c.color,
                             c.corners, c.flat ? 1 : 0);
    drawings += fmt::format("{}\"{}\":[{}]", drawings.empty() ? "" : ",", layout.id[row].value, corners);
  }
  return fmt::format(
      "{{\"tick\":{},\"paused\":{},\"speed\":{},\"models\":{{{}}},\n\"says\":{{{}}},\n\"scans\":{{{}}},"
      "\n\"views\":{{{}}},\n\"drawings\":{{{}}}}}",
      replica.tick, replica.pace.paused, replica.pace.speed, models, says, scans, views_text, drawings);
}

/// Wheels on the first port for every robot, and for the first a laser on another port.
std::vector<std::string> small_devices(world::ModelId model) {
  if (model.value == SmallWorld::robot(0) + 1) return {"6666:ranger:0", "6666:laser:0"};
  if (model.value % 4 != 1) return {};
  return {fmt::format("position2d:{}", model.value / 4)};
}

/// For robot k; its color tells how many corners its shapes have.
void draw(world::World& world, int k, std::uint32_t layer, std::uint32_t corners,
          const std::vector<geom::Vec3>& points) {
  const scene::Color color{corners == 1 ? 1.0f : 0, corners == 2 ? 1.0f : 0, corners == 3 ? 1.0f : 0, 0.5f};
  EXPECT_TRUE(world::draw(world, {SmallWorld::robot(k)}, {layer, corners, color, points}));
}

/// A short story: everything in view, one robot selected, nothing selected, far away, paused; then a robot
/// goes, another one and a puck come, and a robot takes the puck along. Meanwhile some say something and
/// carry flags, and clients draw.
std::string make_golden() {
  SmallWorld small(3);
  small.world.upright = false;
  auto layout = small.layout(small_devices);
  std::string scene = scene_text(small.world.scene(), light_text(small.world), small.prototypes, *layout);
  scene.replace(scene.find(build()), build().size(), "1.2.3 (abc1234)");  // the file follows no commit
  for (const world::ModelRow row : small.world.models.rows()) world::subscribe(small.world, {row});
  DeltaWriter writer;
  Replica replica(layout);
  Snapshot snapshot;
  std::vector<std::byte> packet;
  std::string frames;
  Wish wish;
  world::ModelId puck;
  for (std::uint32_t frame = 1; frame <= 9; ++frame) {
    if (frame == 1) wish = {{-50, -50, 50, 50}, true, std::nullopt};
    if (frame == 3) wish = {{-50, -50, 50, 50}, false, SmallWorld::id(1)};
    if (frame == 5) wish = {};
    if (frame == 7) wish = {{-50, -50, 50, 50}, true, SmallWorld::id(1)};
    if (frame == 7) EXPECT_TRUE(world::despawn(small.world, SmallWorld::id(0)).ok());
    if (frame == 8) EXPECT_TRUE(world::spawn(small.world, SmallWorld::robot(1), {7, 8, 0, 1}).ok());
    if (frame == 8) puck = *world::spawn(small.world, small.puck(), {1, 1, 0, 0}, "load");
    if (frame == 9) EXPECT_TRUE(world::attach(small.world, puck, SmallWorld::id(1), {0.3, 0, 0.1, 0}).ok());
    if (frame != 4) small.tick();
    if (frame == 8) world::set_spatial_pose(small.world, small.world.row(puck), {{1, 1, 0, 0}, {0.5, -3}});
    if (frame == 6)
      world::set_spatial_pose(small.world, {SmallWorld::robot(2)},
                              {{-2000.5, 300000, 1, -3.1}, {0.25, -0.125}});
    if (frame == 2) world::set_say(small.world, {SmallWorld::robot(0)}, "I go sch\u00f6n slow");
    if (frame == 2) world::set_say(small.world, {SmallWorld::robot(1)}, "\"8\"");
    if (frame == 3) world::add_flags(small.world, {SmallWorld::robot(1)}, 300);
    if (frame == 4) world::set_say(small.world, {SmallWorld::robot(1)}, "");
    if (frame == 5) world::set_say(small.world, {SmallWorld::robot(2)}, "far");
    if (frame == 8) world::set_say(small.world, small.world.row(puck), "heavy");
    if (frame == 2)
      draw(small.world, 0, world::kLayer2d, 2, {{0, 0, 0}, {1, -1, 0.0005}, {1, -1, 0}, {400, 0, 0}});
    if (frame == 2) draw(small.world, 1, world::kLayer3d, 3, {{0, 0, 0.1}, {1, 0, 0.1}, {0, -2, 0.1}});
    if (frame == 3) draw(small.world, 0, world::kLayer3d, 1, {{-0.25, 0, 0.02}});
    if (frame == 4) world::clear_drawing(small.world, {SmallWorld::robot(1)}, world::kLayer3d);
    if (frame == 5) draw(small.world, 2, world::kLayer2d, 1, {{1, 2, 3}});
    const world::Pace pace{frame == 4, frame == 5 ? 0.0 : 1.5, 0.5};
    Interest interest;
    if (wish.sensors) interest.view = wish.view;
    if (wish.selected) interest.selected = {*wish.selected};
    std::string changes;
    if (layout->population != small.world.population()) {
      const auto before = std::exchange(layout, small.layout(small_devices, layout.get()));
      changes = fmt::format("\"changes\":{},\n", changes_text(*before, *layout));
      replica.follow(layout);
    }
    capture(small.world, pace, layout, interest, snapshot);
    writer.write(snapshot, wish, frame, 100000, replica, packet);
    frames += fmt::format("{}\n{{{}\"packet\":\"{}\",\n\"after\":{}}}", frame > 1 ? "," : "", changes,
                          hex(packet), held(replica));
  }
  return fmt::format("{{\"scene\":{},\"frames\":[{}]}}\n", scene, frames);
}

TEST(Golden, the_packets_that_the_page_is_tested_with_are_current) {
  const std::string golden = make_golden();
  if (std::getenv("UPDATE_GOLDEN")) std::ofstream(kGolden) << golden;
  std::ifstream file(kGolden);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), golden) << "UPDATE_GOLDEN=1 writes " << kGolden << " anew";
}

boost::json::value parsed_scene(const SmallWorld& small, const DeviceNames& devices = {}) {
  return boost::json::parse(
      scene_text(small.world.scene(), light_text(small.world), small.prototypes, *small.layout(devices)));
}

TEST(SceneText, is_json_with_equal_shapes_and_prototypes_written_once) {
  SmallWorld small(5);
  const boost::json::value scene = parsed_scene(small);
  EXPECT_EQ(scene.at("protocol").as_int64(), formats::kPage);
  EXPECT_EQ(scene.at("build").as_string(), build());
  EXPECT_EQ(scene.at("models").as_array().size(), 22u);
  EXPECT_EQ(scene.at("shapes").as_array().size(), 3u);
  EXPECT_EQ(scene.at("prototypes").as_array().size(), 6u);
  EXPECT_EQ(boost::json::serialize(scene.at("addable")), R"(["r0","puck"])") << "and no walls";
  const auto& robot = scene.at("models").at(5);
  EXPECT_EQ(robot.at("name").as_string(), "r1");
  EXPECT_EQ(robot.at("alias").as_string(), "position:1");
  EXPECT_EQ(robot.at("start").at(0).as_int64(), small.layout()->start[{5}].x);
  EXPECT_FALSE(robot.as_object().contains("parent"));
  EXPECT_FALSE(robot.as_object().contains("devices"));
  EXPECT_EQ(scene.at("models").at(6).at("parent").as_int64(), 5);
  const auto prototype_of = [&](std::uint32_t row) {
    return scene.at("prototypes").at(scene.at("models").at(row).at("prototype").as_int64());
  };
  EXPECT_TRUE(prototype_of(5).at("movable").as_bool());
  EXPECT_FALSE(prototype_of(0).as_object().contains("movable"));
  EXPECT_TRUE(prototype_of(0).at("outline").as_bool());
  EXPECT_TRUE(prototype_of(0).at("grid").as_bool());
  EXPECT_FALSE(prototype_of(0).as_object().contains("nose"));
  EXPECT_EQ(prototype_of(6).at("sensors").at(0).at("samples").as_int64(), 5);
}

TEST(SceneText, tells_how_many_solids_of_a_body_move_with_its_state) {
  SmallWorld small(1, 1);
  const boost::json::value scene = parsed_scene(small);
  const auto& gripper = scene.at("prototypes").as_array().back();
  EXPECT_EQ(gripper.at("moving").as_int64(), 2);
  EXPECT_EQ(scene.at("shapes").at(gripper.at("shape").as_int64()).as_array().size(), 3u);
  EXPECT_EQ(gripper.at("paddle").at(1).as_double(), 0.1);
  EXPECT_FALSE(scene.at("prototypes").at(1).as_object().contains("moving"));
}

TEST(SceneText, tells_each_model_with_its_devices) {
  SmallWorld small(2);
  const boost::json::value scene = parsed_scene(small, small_devices);
  const auto devices = [&](std::uint32_t row) {
    const boost::json::object& model = scene.at("models").at(row).as_object();
    return model.contains("devices") ? boost::json::serialize(model.at("devices")) : "none";
  };
  EXPECT_EQ(devices(0), "none");
  EXPECT_EQ(devices(SmallWorld::robot(0)), R"(["position2d:0"])");
  EXPECT_EQ(devices(SmallWorld::robot(0) + 1), R"(["6666:ranger:0","6666:laser:0"])");
  EXPECT_EQ(devices(SmallWorld::robot(1)), R"(["position2d:1"])");
}

TEST(SceneText, without_devices_is_that_of_a_run_that_has_none) {
  SmallWorld small(2);
  const auto named = small.layout(small_devices), nameless = small.layout();
  const auto text = [&](const Layout& layout, TellDevices devices) {
    return scene_text(small.world.scene(), light_text(small.world), small.prototypes, layout, devices);
  };
  EXPECT_NE(text(*named, TellDevices::kYes), text(*nameless, TellDevices::kYes));
  EXPECT_EQ(text(*named, TellDevices::kNo), text(*nameless, TellDevices::kYes));
  ASSERT_TRUE(world::spawn(small.world, SmallWorld::robot(0), {1, 1, 0, 0}).ok());
  const DeviceNames devices = [](world::ModelId) { return std::vector<std::string>{"position2d:7"}; };
  const auto more = small.layout(devices, named.get()), more_nameless = small.layout({}, nameless.get());
  EXPECT_NE(changes_text(*named, *more), changes_text(*nameless, *more_nameless));
  EXPECT_EQ(changes_text(*named, *more, TellDevices::kNo), changes_text(*nameless, *more_nameless));
}

TEST(SceneText, names_from_files_cannot_break_it) {
  scene::SceneDesc desc;
  desc.name = "a \"quoted\" \\ name\n\x01";
  desc.models.emplace_back();
  desc.models[0].name = desc.models[0].alias = "</script>\"";
  const world::World world(desc, 1);
  const Prototypes prototypes(desc);
  const boost::json::value scene =
      boost::json::parse(scene_text(desc, light_text(world), prototypes, Layout(world, prototypes, {})));
  EXPECT_EQ(scene.at("name").as_string(), desc.name);
  EXPECT_EQ(scene.at("models").at(0).at("name").as_string(), desc.models[0].name);
}

TEST(ChangesText, tells_who_went_and_who_came_and_whose_parent_is_another) {
  SmallWorld small(2);
  const auto before = small.layout();
  ASSERT_TRUE(world::despawn(small.world, SmallWorld::id(0)).ok());
  const Result<world::ModelId> load = world::spawn(small.world, small.puck(), {1, 1, 0, 0}, "load");
  ASSERT_TRUE(load.ok());
  const auto after = small.layout({}, before.get());
  const boost::json::value changes = boost::json::parse(changes_text(*before, *after));
  EXPECT_EQ(boost::json::serialize(changes.at("gone")), "[1,2,3,4]");
  ASSERT_EQ(changes.at("models").as_array().size(), 1u);
  EXPECT_EQ(changes.at("models").at(0).at("name").as_string(), "load");
  EXPECT_EQ(changes.at("models").at(0).at("id").as_int64(), load->value);
  EXPECT_EQ(changes_text(*after, *after), "");
  ASSERT_TRUE(world::attach(small.world, *load, SmallWorld::id(1), {0.3, 0, 0, 0}).ok());
  const auto carried = boost::json::parse(changes_text(*after, *small.layout({}, after.get())));
  EXPECT_EQ(carried.at("gone").at(0).as_int64(), load->value);
  EXPECT_EQ(carried.at("models").at(0).at("id").as_int64(), load->value);
  EXPECT_EQ(carried.at("models").at(0).at("parent").as_int64(), SmallWorld::robot(1));
}

}  // namespace
}  // namespace playhouse::replicate
