#include "playhouse/replicate/layout.h"

#include <algorithm>

#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/quantize.h"
#include "playhouse/replicate/views.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/world/population/population.h"

namespace playhouse::replicate {
namespace {

/// Rows grouped by root, ascending within a group: that of root k is rows[start[k] .. start[k + 1]).
void group(const world::ByModel<world::ModelRow>& root, world::ByModel<std::uint32_t>& start,
           std::vector<world::ModelRow>& rows) {
  start.assign(root.size() + 1, 0);
  for (const world::ModelRow key : root) ++start[key + 1];
  for (const world::ModelRow key : root.rows()) start[key + 1] += start[key];
  rows.resize(root.size());
  world::ByModel<std::uint32_t> next = start;
  for (const world::ModelRow row : root.rows()) rows[next[root[row]]++] = row;
}

std::uint8_t traits_of(const world::World& world, world::ModelRow row) {
  const scene::ModelDesc& desc = world.desc(row);
  const bool top_level = !world.models.parent[row];
  unsigned traits = 0;
  if (top_level && desc.gui_move) traits |= kMovable;
  if (desc.alwayson) traits |= kAlwaysOn;
  if (world.position(world.id(row))) traits |= kDrives;
  return static_cast<std::uint8_t>(traits);
}

ModelWords words_of(const world::World& world, world::ModelRow row, const DeviceNames& devices) {
  const std::string name = world.name(row), alias = world.alias(row);
  ModelWords words;
  words.names = R"("name":)" + quoted(name);
  if (alias != name) words.names += R"(,"alias":)" + quoted(alias);
  const std::vector<std::string> names = devices ? devices(world.id(row)) : std::vector<std::string>();
  if (!names.empty()) words.devices = R"(,"devices":)" + list(names, quoted);
  const std::int32_t fiducial = world.models.fiducial_return[row];
  if (fiducial != 0) words.fiducial = fmt::format(R"(,"fiducial":{})", fiducial);
  return words;
}

}  // namespace

ModelState model_state(const world::World& world, world::ModelRow row) {
  const world::Models& models = world.models;
  const geom::Pose& X_PM = models.X_PM[row];
  ModelState state;
  state.x = quantize(X_PM.x, 1000);
  state.y = quantize(X_PM.y, 1000);
  state.z = quantize(X_PM.z, 1000);
  state.a = quantize_angle(X_PM.a);
  state.tilt_x = quantize_angle(models.tilt_PM[row].x);
  state.tilt_y = quantize_angle(models.tilt_PM[row].y);
  state.color = scene::rgba8(models.color[row]);
  state.state = state_bits(world, row);
  state.flags = static_cast<std::uint32_t>(models.flags[row]);  // never negative
  return state;
}

Layout::Layout(const world::World& world, const Prototypes& prototypes, const DeviceNames& devices,
               const Layout* before)
    : population(world.population()), ids_given(world::Population::next_id(world)) {
  const world::Models& models = world.models;
  id = models.id;
  parent = models.parent;
  root = models.root;
  prototype.resize(models.size());
  traits.resize(models.size());
  words.resize(models.size());
  start.resize(models.size());
  viewed.resize(views().size());
  world::ModelRow known{0};  // of `before`; both are sorted by id
  for (const world::ModelRow row : models.rows()) {
    prototype[row] = prototypes.of(models.desc[row]);
    traits[row] = traits_of(world, row);
    start[row] = model_state(world, row);
    while (before && known < before->id.next() && before->id[known] < id[row]) ++known;
    const bool is_known = before && known < before->id.next() && before->id[known] == id[row];
    words[row] =
        is_known ? before->words[known] : std::make_shared<const ModelWords>(words_of(world, row, devices));
    for (std::size_t view = 0; view < views().size(); ++view)
      if (views()[view].row_of(world, row)) viewed[view].push_back(row);
  }
  group(root, tree_start_, tree_rows_);

  sensors.reserve(world.sensors.size());
  for (const world::SensorRow row : world.sensors.rows()) {
    const world::RangerRow ranger = world.sensors.ranger[row];
    const world::ModelRow model = world.rangers.model[ranger];
    const std::uint32_t nth = row - world.rangers.first_sensor[ranger];
    sensors.push_back({ranger, model, nth, world.sensors.first_beam[row], world.sensors.beam_count[row],
                       world.desc(model).sensors[nth].range_max});
  }
}

world::ModelRow Layout::row(world::ModelId model) const {
  const auto found = std::ranges::lower_bound(id, model);
  if (found == id.end() || *found != model) return {};
  return {static_cast<std::uint32_t>(found - id.begin())};
}

world::SensorRow Layout::sensor(world::ModelId model, std::uint64_t nth) const {
  const world::ModelRow of = row(model);
  if (!of) return {};
  const auto first = std::ranges::lower_bound(sensors, of, {}, &SensorLayout::model);
  if (nth >= static_cast<std::uint64_t>(sensors.end() - first)) return {};
  const world::SensorRow found = sensors.rows()[static_cast<std::uint64_t>(first - sensors.begin()) + nth];
  return sensors[found].model == of ? found : world::SensorRow{};
}

std::span<const world::ModelRow> Layout::tree(world::ModelRow root_row) const {
  return std::span(tree_rows_)
      .subspan(tree_start_[root_row], tree_start_[root_row + 1] - tree_start_[root_row]);
}

}  // namespace playhouse::replicate
