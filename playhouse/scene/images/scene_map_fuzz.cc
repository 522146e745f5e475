/// Any text as a map of ROS, with one image: it is a plan whose world loads and whose map is read the same
/// again, or fails with a text.

#include <cstdint>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/scene/images/ros_map.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scene {
namespace {

constexpr const char* kImage = "P2 4 4 255 0 0 0 0 0 255 205 0 0 100 90 0 0 0 0 0";

void expect_world_or_text(const std::string& text) {
  const Result<RosMap> map = read_ros_map(text);
  if (!map) return PLAYHOUSE_ASSERT(!map.error().text.empty());
  const Result<Plan> plan = plan_of_ros_map(*map, kImage, "plan");
  PLAYHOUSE_ASSERT(plan.ok() && plan->solid.solid.size() == 16);
  const Result<RosMap> again = read_ros_map(ros_map_of(*plan, "plan.pgm"));
  PLAYHOUSE_ASSERT(again.ok() && again->resolution == map->resolution && again->origin == map->origin);
  const Result<std::string> world = world_of_plan(*plan, "plan.pgm", 1);
  if (!world) return PLAYHOUSE_ASSERT(!world.error().text.empty());
  config::MemoryFiles files({{"plan.pgm", pgm_of(plan->solid)}});
  // Numbers may be beyond what a world can hold, but its words are right.
  const Result<SceneDesc> scene = load_world_text(*world, "plan.world", files);
  PLAYHOUSE_ASSERT(scene.ok() || !scene.error().text.empty());
}

}  // namespace
}  // namespace playhouse::scene

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  playhouse::scene::expect_world_or_text(std::string(reinterpret_cast<const char*>(bytes), size));
  return 0;
}
