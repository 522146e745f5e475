// The page's decoder is tested against packets made here (web/src/protocol/golden.json). UPDATE_GOLDEN=1
// writes the file anew after a wanted change of the format.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/scene_text.h"
#include "playhouse/replicate/small_world.h"

namespace playhouse::replicate {
namespace {

const std::string kGolden = PLAYHOUSE_SOURCE_DIR "/web/src/protocol/golden.json";

std::string hex(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) text += fmt::format("{:02x}", std::to_integer<int>(byte));
  return text;
}

/// What a page must hold afterwards, as the test there compares it.
std::string held(const Replica& replica) {
  std::string models, positions, scans, findings;
  for (const ModelState& m : replica.models) {
    models +=
        fmt::format("{}[{},{},{},{},{},{}]", models.empty() ? "" : ",", m.x, m.y, m.z, m.a, m.state, m.color);
  }
  for (const PositionState& p : replica.positions) {
    positions += fmt::format("{}[{},{},{},{},{},{}]", positions.empty() ? "" : ",", p.vx, p.vy, p.va, p.ox,
                             p.oy, p.oa);
  }
  for (std::size_t row = 0; row < replica.scans.size(); ++row) {
    if (replica.scans[row].empty()) continue;
    scans += fmt::format("{}\"{}\":[{}]", scans.empty() ? "" : ",", row, fmt::join(replica.scans[row], ","));
  }
  for (const auto& [row, hits] : replica.findings) {
    std::string list;
    for (const HitState& h : hits) {
      list += fmt::format("{}[{},{},{},{},{}]", list.empty() ? "" : ",", h.target, h.id, h.range, h.bearing,
                          h.heading);
    }
    findings += fmt::format("{}\"{}\":[{}]", findings.empty() ? "" : ",", row, list);
  }
  return fmt::format(
      "{{\"tick\":{},\"paused\":{},\"speed\":{},\"models\":[{}],\n\"positions\":[{}],\n\"scans\":{{{}}},"
      "\n\"findings\":{{{}}}}}",
      replica.tick, replica.pace.paused, replica.pace.speed, models, positions, scans, findings);
}

/// Wheels on the first port for every robot, and for the first a laser on another port.
DeviceNames small_devices(const SmallWorld& small) {
  DeviceNames devices(small.world.models.size());
  for (std::uint32_t k = 0; k < small.world.positions.size(); ++k)
    devices[SmallWorld::robot(static_cast<int>(k))] = {fmt::format("position2d:{}", k)};
  devices[SmallWorld::robot(0) + 1] = {"6666:ranger:0", "6666:laser:0"};
  return devices;
}

/// Packets of a short story: everything in view, one robot selected, nothing selected, far away, paused.
std::string make_golden() {
  SmallWorld small(3);
  const Layout layout(small.world);
  for (std::uint32_t row = 0; row < small.world.models.size(); ++row) world::subscribe(small.world, {row});
  DeltaWriter writer(layout);
  Replica replica(layout);
  Snapshot snapshot;
  std::vector<std::byte> packet;
  std::string frames;
  Wish wish;
  for (std::uint32_t frame = 1; frame <= 6; ++frame) {
    if (frame == 1) wish = {{-50, -50, 50, 50}, true, std::nullopt};
    if (frame == 3) wish = {{-50, -50, 50, 50}, false, SmallWorld::robot(1)};
    if (frame == 5) wish = {};
    if (frame != 4) small.tick();
    if (frame == 6) world::set_pose(small.world, {SmallWorld::robot(2)}, {-2000.5, 300000, 1, -3.1});
    const world::Pace pace{frame == 4, frame == 5 ? 0.0 : 1.5, 0.5};
    Interest interest;
    if (wish.sensors) interest.view = wish.view;
    if (wish.selected) interest.selected = {*wish.selected};
    capture(small.world, pace, layout, interest, snapshot);
    writer.write(snapshot, wish, frame, 100000, replica, packet);
    frames += fmt::format("{}\n{{\"packet\":\"{}\",\n\"after\":{}}}", frame > 1 ? "," : "", hex(packet),
                          held(replica));
  }
  return fmt::format("{{\"scene\":{},\"frames\":[{}]}}\n", scene_text(small.world, layout, small_devices(small)), frames);
}

TEST(Golden, the_packets_that_the_page_is_tested_with_are_current) {
  const std::string golden = make_golden();
  if (std::getenv("UPDATE_GOLDEN")) std::ofstream(kGolden) << golden;
  std::ifstream file(kGolden);
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), golden) << "UPDATE_GOLDEN=1 writes " << kGolden << " anew";
}

TEST(SceneText, is_json_with_equal_shapes_and_sensors_written_once) {
  SmallWorld small(5);
  const Layout layout(small.world);
  const boost::json::value scene = boost::json::parse(scene_text(small.world, layout, {}));
  EXPECT_EQ(scene.at("protocol").as_int64(), 1);
  EXPECT_EQ(scene.at("models").as_array().size(), 21u);
  EXPECT_EQ(scene.at("shapes").as_array().size(), 2u);
  EXPECT_EQ(scene.at("sensors").as_array().size(), 2u);
  const auto& robot = scene.at("models").at(5);
  EXPECT_EQ(robot.at("name").as_string(), "r1");
  EXPECT_EQ(robot.at("alias").as_string(), "position:1");
  EXPECT_EQ(robot.at("start").at(0).as_int64(), layout.start[5].x);
  EXPECT_TRUE(robot.at("movable").as_bool());
  EXPECT_FALSE(scene.at("models").at(0).as_object().contains("movable"));
  EXPECT_FALSE(robot.as_object().contains("devices"));
}

TEST(SceneText, tells_each_model_with_its_devices) {
  SmallWorld small(2);
  const boost::json::value scene =
      boost::json::parse(scene_text(small.world, Layout(small.world), small_devices(small)));
  const auto devices = [&](std::uint32_t row) {
    const boost::json::object& model = scene.at("models").at(row).as_object();
    return model.contains("devices") ? boost::json::serialize(model.at("devices")) : "none";
  };
  EXPECT_EQ(devices(0), "none");
  EXPECT_EQ(devices(SmallWorld::robot(0)), R"(["position2d:0"])");
  EXPECT_EQ(devices(SmallWorld::robot(0) + 1), R"(["6666:ranger:0","6666:laser:0"])");
  EXPECT_EQ(devices(SmallWorld::robot(1)), R"(["position2d:1"])");
}

TEST(SceneText, names_from_files_cannot_break_it) {
  scene::SceneDesc desc;
  desc.name = "a \"quoted\" \\ name\n\x01";
  desc.models.emplace_back();
  desc.models[0].name = desc.models[0].alias = "</script>\"";
  const world::World world(desc, 1);
  const boost::json::value scene = boost::json::parse(scene_text(world, Layout(world), {}));
  EXPECT_EQ(scene.at("name").as_string(), desc.name);
  EXPECT_EQ(scene.at("models").at(0).at("name").as_string(), desc.models[0].name);
}

}  // namespace
}  // namespace playhouse::replicate
