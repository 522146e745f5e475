#include "playhouse/replicate/scene_text.h"

#include <iterator>
#include <utility>

#include "playhouse/base/formats.h"
#include "playhouse/base/version.h"
#include "playhouse/replicate/json_text.h"
#include "playhouse/scene/forms/daylight.h"

namespace playhouse::replicate {
namespace {

std::string window(const scene::WindowDesc& window) {
  return fmt::format(R"({{"center":[{},{}],"scale":{},"pitch":{},"yaw":{},"sensors":{},"follow":{}}})",
                     number(window.center.x), number(window.center.y), number(window.scale),
                     number(window.pitch), number(window.yaw), window.show_data, quoted(window.follow_model));
}

void add_model(const Layout& layout, world::ModelRow row, TellDevices devices, std::string& text) {
  if (!text.empty()) text += ",\n";
  auto out = std::back_inserter(text);
  fmt::format_to(out, R"({{"id":{},"prototype":{})", layout.id[row].value, layout.prototype[row]);
  if (layout.parent[row]) fmt::format_to(out, R"(,"parent":{})", layout.id[layout.parent[row]].value);
  const ModelState& start = layout.start[row];
  fmt::format_to(out, R"(,"start":[{},{},{},{},{},{},{}],)", start.x, start.y, start.z, start.a, start.state,
                 start.color, start.flags);
  if (start.tilt_x != 0 || start.tilt_y != 0)
    fmt::format_to(out, R"("tilt":[{},{}],)", start.tilt_x, start.tilt_y);
  const ModelWords& words = *layout.words[row];
  fmt::format_to(out, "{}{}{}}}", words.names,
                 devices == TellDevices::kYes ? words.devices : std::string_view(), words.fiducial);
}

}  // namespace

std::string light_text(const world::World& world) {
  if (!world.has_light) return "null";
  const scene::SceneDesc& scene = world.scene();
  const scene::Daylight light = scene::daylight_of(scene);
  return fmt::format(
      R"({{"to_sun":{},"sun":{},"ambient":{},"day":{},"white_lux":{},"sky":{},"fog":{},"visibility":{},"floor":{}}})",
      triple(light.to_sun.x, light.to_sun.y, light.to_sun.z), number(light.sun), number(light.ambient),
      number(light.day), number(light.white_lux), triple(scene.sky_red, scene.sky_green, scene.sky_blue),
      triple(scene.fog_red, scene.fog_green, scene.fog_blue), number(scene.fog), scene::kFloorColor);
}

std::string scene_text(const scene::SceneDesc& scene, std::string_view light, const Prototypes& prototypes,
                       const Layout& layout, TellDevices devices) {
  std::string models;
  for (const world::ModelRow row : layout.id.rows()) add_model(layout, row, devices, models);
  return fmt::format(
      "{{\"protocol\":{},\"build\":{},\"name\":{},\"interval\":{:.9g},\"window\":{},\"light\":{},"
      "\n\"shapes\":[{}],\n"
      "\"prototypes\":[\n{}],\n\"addable\":{},\n\"models\":[\n{}]}}\n",
      formats::kPage, quoted(build()), quoted(scene.name), scene.interval, window(scene.window), light,
      prototypes.shapes(), prototypes.texts(),
      list(prototypes.addable(), [](const Addable& robot) { return quoted(robot.name); }), models);
}

std::string history_text(const world::Timeline& timeline) {
  if (timeline.ticks.empty())
    return fmt::format("{{\"history\":{{\"none\":{}}}}}\n", quoted(timeline.why_none));
  std::string steps;
  for (std::size_t i = 1, times = 0; i < timeline.ticks.size(); ++i) {
    const std::uint64_t gap = timeline.ticks[i] - timeline.ticks[i - 1];
    ++times;
    if (i + 1 < timeline.ticks.size() && timeline.ticks[i + 1] - timeline.ticks[i] == gap) continue;
    fmt::format_to(std::back_inserter(steps), "{}[{},{}]", steps.empty() ? "" : ",", gap,
                   std::exchange(times, 0));
  }
  return fmt::format("{{\"history\":{{\"first\":{},\"steps\":[{}]}}}}\n", timeline.ticks.front(), steps);
}

std::string world_file_text(std::string_view name, std::string_view text) {
  return fmt::format("{{\"world\":{{\"file\":{},\"text\":{}}}}}\n", quoted(name), quoted(text));
}

std::string changes_text(const Layout& from, const Layout& to, TellDevices devices) {
  std::string gone, models;
  compare(
      from, to,
      [&](world::ModelRow row) {
        fmt::format_to(std::back_inserter(gone), "{}{}", gone.empty() ? "" : ",", from.id[row].value);
      },
      [](world::ModelRow, world::ModelRow) {},
      [&](world::ModelRow row) { add_model(to, row, devices, models); });
  if (gone.empty() && models.empty()) return {};
  return fmt::format("{{\"gone\":[{}],\n\"models\":[{}]}}\n", gone, models);
}

}  // namespace playhouse::replicate
