#include "playhouse/replicate/snapshot.h"

#include <algorithm>

#include "playhouse/base/limits.h"

namespace playhouse::replicate {
namespace {

class Capture {
 public:
  Capture(const world::World& world, const Layout& layout, const Interest& interest, Snapshot& out)
      : world_(world), layout_(layout), interest_(interest), out_(out) {}

  void models() {
    out_.models.resize(world_.models.size());
    for (std::uint32_t row = 0; row < out_.models.size(); ++row) out_.models[row] = model_state(world_, row);
  }

  void positions() {
    const world::Positions& from = world_.positions;
    out_.positions.clear();
    for (const std::uint32_t robot : interest_.selected) {
      for (const std::uint32_t row : layout_.tree_positions(robot)) {
        const geom::Twist& v = from.velocity[row];
        const geom::Pose& X_OM = from.X_OM[row];
        out_.positions.push_back({row,
                                  {quantize(v.x, 1000), quantize(v.y, 1000), quantize(v.a, 1000),
                                   quantize(X_OM.x, 1000), quantize(X_OM.y, 1000), quantize_angle(X_OM.a)}});
      }
    }
  }

  void scans() {
    out_.scans.clear();
    out_.beams.clear();
    out_.beams_full = false;
    if (nothing_to_sense()) return;
    std::size_t room_of_selected = std::min(limits::kSnapshotBeams, selected_beams());
    std::size_t room_of_others = limits::kSnapshotBeams - room_of_selected;
    for (std::uint32_t row = 0; row < layout_.sensors.size(); ++row) {
      const SensorLayout& sensor = layout_.sensors[row];
      if (!runs(sensor.model) || world_.rangers.measured_tick[sensor.ranger] == 0) continue;
      const bool is_selected = selected(sensor.model);
      if (!is_selected && !in_view(sensor.model)) continue;
      std::size_t& room = is_selected ? room_of_selected : room_of_others;
      if (sensor.beam_count > room) {
        out_.beams_full = true;
        continue;
      }
      room -= sensor.beam_count;
      copy_scan(row, sensor);
    }
  }

  void findings() {
    out_.findings.clear();
    out_.hits.clear();
    if (nothing_to_sense()) return;
    for (std::uint32_t row = 0; row < layout_.finder_model.size(); ++row) {
      const std::uint32_t model = layout_.finder_model[row];
      if (!runs(model) || world_.fiducials.measured_tick[row] == 0) continue;
      if (!selected(model) && !in_view(model)) continue;
      const auto first = static_cast<std::uint32_t>(out_.hits.size());
      for (const world::FiducialHit& hit : world_.fiducials.hits[row]) {
        out_.hits.push_back({hit.target.value, hit.id, quantize(hit.range, 1000), quantize_angle(hit.bearing),
                             quantize_angle(hit.heading)});
      }
      out_.findings.push_back({row, first, static_cast<std::uint32_t>(out_.hits.size()) - first});
    }
  }

 private:
  bool nothing_to_sense() const { return interest_.view.empty() && interest_.selected.empty(); }

  bool runs(std::uint32_t model) const {
    return world_.models.subscribers[model] > 0 || (layout_.traits[model] & kAlwaysOn) != 0;
  }

  bool selected(std::uint32_t model) const {
    return std::binary_search(interest_.selected.begin(), interest_.selected.end(), layout_.root[model]);
  }

  bool in_view(std::uint32_t model) const {
    const geom::Pose& at = world_.models.X_PM[layout_.root[model]];
    const geom::Box& view = interest_.view;
    return at.x >= view.x_min && at.x <= view.x_max && at.y >= view.y_min && at.y <= view.y_max;
  }

  std::size_t selected_beams() const {
    if (interest_.selected.empty()) return 0;
    std::size_t beams = 0;
    for (const SensorLayout& sensor : layout_.sensors) {
      if (selected(sensor.model)) beams += sensor.beam_count;
    }
    return beams;
  }

  void copy_scan(std::uint32_t row, const SensorLayout& sensor) {
    out_.scans.push_back({row, static_cast<std::uint32_t>(out_.beams.size())});
    const float* ranges = world_.sensors.ranges.data() + sensor.first_beam;
    for (std::uint32_t beam = 0; beam < sensor.beam_count; ++beam) {
      out_.beams.push_back(quantize_range(ranges[beam], sensor.range_max));
    }
  }

  const world::World& world_;
  const Layout& layout_;
  const Interest& interest_;
  Snapshot& out_;
};

}  // namespace

void capture(const world::World& world, const world::Pace& pace, const Layout& layout,
             const Interest& interest, Snapshot& out) {
  out.tick = world.tick();
  out.pace = pace;
  Capture capture(world, layout, interest, out);
  capture.models();
  capture.positions();
  capture.scans();
  capture.findings();
}

geom::Vec2 place_of(const Layout& layout, const Snapshot& snapshot, std::uint32_t row) {
  const ModelState& state = snapshot.models[layout.root[row]];
  return {state.x / 1000.0, state.y / 1000.0};
}

}  // namespace playhouse::replicate
