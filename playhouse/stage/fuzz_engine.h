#pragma once

/// Fuzzing of engines. Any world that loads, within small limits, runs for some
/// ticks. Input: the text of the world file, a NUL, commands between ticks.
/// Checked: poses stay finite, ranges within 0 and the sensor's maximum.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/gripper.h"

namespace playhouse::stage::fuzz {

inline constexpr scene::WorldLimits kSmall{.models = 64,
                                           .fields = 4096,
                                           .pixels = 4096,
                                           .corners = 4096,
                                           .beams = 4096,
                                           .sensors = 256,
                                           .text_bytes = 1 << 16};
inline constexpr int kTicks = 12;

inline void ask(world::World& world, FuzzScript& script) {
  const std::uint8_t what = script.byte();
  const world::ModelRow model{script.byte() % static_cast<std::uint32_t>(world.models.size())};
  const auto pose = [&] {
    return geom::Pose{script.number(), script.number(), script.number(), script.number()};
  };
  const auto twist = [&] {
    return geom::Twist{script.number(), script.number(), script.number(), script.number()};
  };
  const world::PositionRow robot = world.models.part[model];
  const bool is_robot = world.models.kind[model] == scene::ModelKind::kPosition;
  if (world.models.kind[model] == scene::ModelKind::kGripper && what % 8 > 2)
    return world::command_gripper(world, world.models.part[model],
                                  static_cast<world::GripperCommand>(what % 8 - 3));
  switch (what % 8) {
    case 0:
      world::set_pose(world, model, pose());
      return;
    case 1:
      return world::subscribe(world, model);
    case 2:
      if (world.models.subscribers[model] > 0) world::unsubscribe(world, model);
      return;
    default:
      if (!is_robot) return;
  }
  switch (what % 8) {
    case 3:
      world::command_velocity(world, robot, twist());
      return;
    case 4:
      world::command_position(world, robot, pose());
      return;
    case 5:
      world::command_heading(world, robot, script.number(), script.number());
      return;
    case 6:
      world::command_acceleration(world, robot, twist());
      return;
    default:
      world::set_odometry(world, robot, pose());
  }
}

inline bool finite(const geom::Pose& X) {
  return std::isfinite(X.x) && std::isfinite(X.y) && std::isfinite(X.z) && std::isfinite(X.a);
}

inline void expect_sense(const world::World& world) {
  for (const geom::Pose& X_WM : world.models.X_WM) PLAYHOUSE_ASSERT(finite(X_WM));
  for (const geom::Pose& X_OM : world.positions.X_OM) PLAYHOUSE_ASSERT(finite(X_OM));
  for (const world::RangerRow row : world.rangers.rows()) {
    if (world.rangers.measured_tick[row] == 0) continue;
    world::SensorRow sensor = world.rangers.first_sensor[row];
    for (const scene::RangerSensorDesc& desc : world.desc(world.rangers.model[row]).sensors) {
      const float* const ranges = world.sensors.ranges.from(world.sensors.first_beam[sensor]);
      ++sensor;
      const auto most = static_cast<float>(std::max(desc.range_min, desc.range_max));
      for (std::uint32_t beam = 0; beam < desc.samples; ++beam)
        PLAYHOUSE_ASSERT(ranges[beam] >= 0 && ranges[beam] <= most);
    }
  }
}

/// `make(scene)` returns a Result of an engine.
template <typename Make>
void run(const Make& make, const std::string& text, FuzzScript script) {
  config::MemoryFiles files({{"w/plan", "P1 4 3 1111 1001 1101"}});
  const auto scene = scene::load_world_text(text, "w/t.world", files, kSmall);
  if (!scene || scene->models.empty()) return;
  const auto engine = make(*scene);
  if (!engine) return PLAYHOUSE_ASSERT(!engine.error().text.empty());
  world::World& world = (*engine)->world();
  for (const world::ModelRow row : world.models.rows()) world::subscribe(world, row);
  for (int tick = 0; tick < kTicks; ++tick) {
    for (int asked = 0; asked < 4 && !script.done(); ++asked) ask(world, script);
    (*engine)->step();
    expect_sense(world);
  }
}

template <typename Make>
int fuzz_engine(const std::uint8_t* bytes, std::size_t size, const Make& make) {
  log::silence();
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = std::min(text.find('\0'), size);
  const auto rest = std::as_bytes(std::span(text)).subspan(std::min(end + 1, size));
  run(make, text.substr(0, end), FuzzScript(rest));
  return 0;
}

}  // namespace playhouse::stage::fuzz
