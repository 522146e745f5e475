/// The interfaces that `playhouse kinds` tells of, against the devices that a world gets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/bridge/simulated/auto_map.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/testing_expanded.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::app {
namespace {

using drivers::MappedDevice;
using scene::Index;
using scene::KindInterface;
using scene::Need;

constexpr std::size_t kRobots = 2;
constexpr const char* kWorld = R"(
define scanner ranger( sensor( samples 9 ) )
define ring ranger( sensor( ) sensor( ) )
define lidar ranger( sensor( rings 4 samples 9 ) )
define robot position( scanner( ) ring( ) ranger( sensor( ) ) ranger( ) fiducial( ) position( ) bumper( ) )
model( scanner( ) fiducial( ) )
robot( ) robot( scanner( ) )
gripper( ) actuator( ) ring( ) lidar( ) camera( ) camera( baseline 0.2 )
)";

scene::SceneDesc scene_of_every_kind() {
  config::MemoryFiles none({});
  Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "test.world", none);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().line());
  return scene ? scene::expanded(std::move(*scene)) : scene::SceneDesc{};
}

/// Itself or in a part.
bool has_contacts_or_lamps(const scene::SceneDesc& scene, std::uint32_t row) {
  const std::string& type = scene.models[row].type;
  if (type == "bumper" || type == "blinkenlight" || type == "lightindicator") return true;
  for (std::uint32_t part = 0; part < scene.models.size(); ++part)
    if (scene.models[part].parent == static_cast<std::int32_t>(row) && has_contacts_or_lamps(scene, part))
      return true;
  return false;
}

bool has(const scene::SceneDesc& scene, std::uint32_t row, Need need) {
  const scene::ModelDesc& model = scene.models[row];
  if (need == Need::kContactsOrLamps) return has_contacts_or_lamps(scene, row);
  if (need == Need::kBaseline) return model.camera && model.camera->baseline > 0;
  if (need == Need::kRobot) return model.parent < 0 && model.type == "position";
  if (need == Need::kSeveralSensors) return model.sensors.size() > 1;
  if (need == Need::kNothing) return true;
  if (need == Need::kNever) return false;
  return std::ranges::any_of(model.sensors, [need](const scene::RangerSensorDesc& sensor) {
    return (need == Need::kRings ? sensor.rings : sensor.samples) > 1;
  });
}

/// What is told of the kind of a model, if it is simulated, and of every kind.
std::vector<KindInterface> told_of(const scene::ModelDesc& model) {
  const scene::Kind& kind = *scene::find_model_type(model.type);
  std::vector<KindInterface> all;
  if (kind.simulated && kind.name != "model") all.assign(kind.interfaces.begin(), kind.interfaces.end());
  for (const KindInterface& each : scene::find_model_type("model")->interfaces) all.push_back(each);
  return all;
}

/// The interface of a mapped device, as its kind tells it.
KindInterface told(const scene::SceneDesc& scene, const MappedDevice& device) {
  const std::span<const KindInterface> of_world = scene::world_kind().interfaces;
  const auto all = device.model ? told_of(scene.models[device.model.index])
                                : std::vector<KindInterface>(of_world.begin(), of_world.end());
  const auto found = std::ranges::find(all, device.interf, &KindInterface::code);
  EXPECT_NE(found, all.end()) << device.interf << " of a model that tells of none";
  return found == all.end() ? all.front() : *found;
}

TEST(KindInterfaces, are_those_that_models_get_by_themselves) {
  const scene::SceneDesc scene = scene_of_every_kind();
  const world::World world(scene, 1);
  std::set<std::pair<std::uint16_t, std::uint32_t>> expected, found;
  for (std::uint32_t row = 0; row < scene.models.size(); ++row) {
    for (const KindInterface& interf : told_of(scene.models[row])) {
      if (has(scene, row, interf.listed)) expected.emplace(interf.code, row);
    }
  }
  drivers::AutoMap map;
  for (const MappedDevice& device : map.of_world(world)) {
    if (device.model) found.emplace(device.interf, device.model.index);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GE(found.size(), 22u);
}

TEST(KindInterfaces, are_those_that_a_configuration_may_ask_for) {
  const scene::SceneDesc scene = scene_of_every_kind();
  const world::World world(scene, 1);
  for (std::uint32_t row = 0; row < scene.models.size(); ++row) {
    for (std::uint16_t code = 1; code < 70; ++code) {
      const std::vector<KindInterface> all = told_of(scene.models[row]);
      const auto told = std::ranges::find(all, code, &KindInterface::code);
      const bool expected = told != all.end() && has(scene, row, told->when);
      EXPECT_EQ(drivers::fits(world, {row}, code), expected) << scene.models[row].name << " " << code;
    }
  }
}

TEST(KindInterfaces, have_the_indices_that_are_told) {
  const scene::SceneDesc scene = scene_of_every_kind();
  const world::World world(scene, 1);
  std::map<std::uint16_t, std::size_t> counted;
  std::map<world::ModelRow, std::size_t> robots;  // their numbers, by row
  for (std::uint32_t row = 0; row < scene.models.size(); ++row) {
    if (scene.models[row].parent < 0 && scene.models[row].type == "position")
      robots.emplace(world::ModelRow{row}, robots.size());
  }
  ASSERT_EQ(robots.size(), kRobots);
  drivers::AutoMap map;
  for (const MappedDevice& device : map.of_world(world)) {
    const Index rule = told(scene, device).index;
    if (rule == Index::kOne) EXPECT_EQ(device.index, 0);
    if (rule == Index::kCount) EXPECT_EQ(device.index, counted[device.interf]++);
    if (rule == Index::kRobot && device.index < kRobots)
      EXPECT_EQ(robots.at(world.models.root[device.model]), device.index);
  }
}

}  // namespace
}  // namespace playhouse::app
