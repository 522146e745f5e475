#include "playhouse/replicate/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace playhouse::replicate {
namespace {

std::uint32_t channel(float value) {
  return static_cast<std::uint32_t>(std::clamp(std::isfinite(value) ? value : 0.0f, 0.0f, 1.0f) * 255.0f +
                                    0.5f);
}

/// Rows grouped by key, ascending within a group: group k is rows[start[k] .. start[k + 1]).
void group(std::span<const std::uint32_t> key_of_row, std::size_t keys, std::vector<std::uint32_t>& start,
           std::vector<std::uint32_t>& rows) {
  start.assign(keys + 1, 0);
  for (const std::uint32_t key : key_of_row) ++start[key + 1];
  for (std::size_t key = 0; key < keys; ++key) start[key + 1] += start[key];
  rows.resize(key_of_row.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t row = 0; row < key_of_row.size(); ++row) rows[next[key_of_row[row]]++] = row;
}

}  // namespace

std::int32_t quantize(double value, double per_unit) {
  const double scaled = value * per_unit;
  if (!std::isfinite(scaled)) return 0;
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::lround(std::clamp(scaled, -kMost, kMost)));
}

std::uint16_t quantize_angle(double radians) {
  if (!std::isfinite(radians)) return 0;
  const double turns = radians / geom::kTwoPi;
  return static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536.0) & 0xFFFF);
}

std::uint16_t quantize_range(double range, double range_max) {
  if (!(range_max > 0) || std::isnan(range)) return 0xFFFF;
  return static_cast<std::uint16_t>(std::lround(std::clamp(range / range_max, 0.0, 1.0) * 65535.0));
}

ModelState model_state(const world::World& world, std::uint32_t row) {
  const world::Models& models = world.models;
  const geom::Pose& X_PM = models.X_PM[row];
  ModelState state;
  state.x = quantize(X_PM.x, 1000);
  state.y = quantize(X_PM.y, 1000);
  state.z = quantize(X_PM.z, 1000);
  state.a = quantize_angle(X_PM.a);
  const scene::Color& color = models.color[row];
  state.color = channel(color.r) << 24 | channel(color.g) << 16 | channel(color.b) << 8 | channel(color.a);
  if (models.subscribers[row] > 0) state.state |= kSubscribed;
  if (models.kind[row] == scene::ModelKind::kPosition) {
    const std::uint32_t part = models.part[row];
    if (world.positions.stall[part]) state.state |= kStalled;
    if (!world.positions.motor_on[part]) state.state |= kMotorOff;
  }
  return state;
}

Layout::Layout(const world::World& world) {
  const world::Models& models = world.models;
  root = models.root;
  traits.resize(models.size());
  start.resize(models.size());
  for (std::uint32_t row = 0; row < models.size(); ++row) {
    const bool top_level = models.parent[row] == world::ModelRow::kNone;
    if (top_level && world.desc({row}).gui_move) traits[row] |= kMovable;
    if (world.desc({row}).alwayson) traits[row] |= kAlwaysOn;
    start[row] = model_state(world, row);
  }
  group(root, models.size(), tree_start_, tree_rows_);

  std::vector<std::uint32_t> position_root;
  for (const world::ModelRow model : world.positions.model) {
    position_model.push_back(model.index);
    position_root.push_back(root[model.index]);
  }
  group(position_root, models.size(), position_start_, position_rows_);
  for (const world::ModelRow model : world.fiducials.model) finder_model.push_back(model.index);

  for (std::uint32_t row = 0; row < world.sensors.size(); ++row) {
    const std::uint32_t ranger = world.sensors.ranger[row].index;
    const world::ModelRow model = world.rangers.model[ranger];
    const std::uint32_t nth = row - world.rangers.first_sensor[ranger];
    sensors.push_back({ranger, model.index, world.sensors.first_beam[row], world.sensors.beam_count[row],
                       world.desc(model).sensors[nth].range_max});
  }
}

std::span<const std::uint32_t> Layout::tree(std::uint32_t root_row) const {
  return std::span(tree_rows_)
      .subspan(tree_start_[root_row], tree_start_[root_row + 1] - tree_start_[root_row]);
}

std::span<const std::uint32_t> Layout::tree_positions(std::uint32_t root_row) const {
  return std::span(position_rows_)
      .subspan(position_start_[root_row], position_start_[root_row + 1] - position_start_[root_row]);
}

}  // namespace playhouse::replicate
