#include "playhouse/replicate/snapshot.h"

#include <algorithm>
#include <span>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/quantize.h"
#include "playhouse/world/drawing.h"

namespace playhouse::replicate {
namespace {

std::int32_t millimetres(float metres) {
  return quantize(static_cast<double>(metres), 1000);
}

SentCorner sent_corner(const world::DrawnCorner& corner) {
  return {millimetres(corner.x), millimetres(corner.y), millimetres(corner.z),
          corner.color,          corner.corners,        corner.layer == world::kLayer2d};
}

SentDrawing sent_drawing(const std::vector<world::DrawnCorner>& drawing) {
  std::vector<SentCorner> sent;
  sent.reserve(drawing.size());
  for (const world::DrawnCorner& corner : drawing) sent.push_back(sent_corner(corner));
  return std::make_shared<const std::vector<SentCorner>>(std::move(sent));
}

bool is_as_sent(const std::vector<world::DrawnCorner>& drawing, const std::vector<SentCorner>& sent) {
  return std::ranges::equal(drawing, sent, {}, sent_corner);
}

class Capture {
 public:
  Capture(const world::World& world, const Interest& interest, Snapshot& out)
      : world_(world), layout_(*out.layout), interest_(interest), out_(out) {
    // By root: a selected model may have been attached meanwhile.
    for (const world::ModelId id : interest.selected)
      if (const auto row = layout_.row(id)) selected_.push_back(layout_.root[row]);
    std::ranges::sort(selected_);
  }

  void models() {
    out_.models.resize(world_.models.size());
    for (const world::ModelRow row : out_.models.rows()) out_.models[row] = model_state(world_, row);
  }

  void says() {
    std::size_t count = 0;
    for (const world::ModelRow row : world_.models.rows()) {
      const std::string& text = world_.models.say[row];
      if (text.empty()) continue;
      if (count == out_.says.size()) out_.says.emplace_back();
      out_.says[count].model = row;
      out_.says[count].name = world_.name(row);
      out_.says[count++].text = text;
    }
    out_.says.resize(count);
    out_.said = world_.said();
  }

  /// One that is the same object as before needs no memory and no comparison for each viewer.
  void drawings(const Snapshot* before) {
    out_.drawings.clear();
    out_.drawn = world_.drawn();
    if (out_.drawn == 0) return;
    auto known = before == nullptr ? std::span<const ModelDrawing>() : std::span(before->drawings);
    for (const world::ModelRow row : world_.models.rows()) {
      const std::vector<world::DrawnCorner>& drawing = world_.models.drawing[row];
      if (drawing.empty()) continue;
      while (!known.empty() && known.front().model < row) known = known.subspan(1);
      const bool is_known =
          !known.empty() && known.front().model == row && is_as_sent(drawing, *known.front().drawing);
      out_.drawings.push_back({row, is_known ? known.front().drawing : sent_drawing(drawing)});
    }
  }

  void scans() {
    out_.scans.clear();
    out_.beams.clear();
    out_.beams_full = false;
    if (nothing_to_sense()) return;
    std::size_t room_of_selected = std::min(limits::kSnapshotBeams, selected_beams());
    std::size_t room_of_others = limits::kSnapshotBeams - room_of_selected;
    for (const world::SensorRow row : layout_.sensors.rows()) {
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

  void views() {
    out_.viewed.clear();
    out_.values.clear();
    for (std::uint32_t view = 0; view < layout_.viewed.size(); ++view) {
      if (replicate::views()[view].when != When::kChanged && nothing_to_sense()) continue;
      for (const world::ModelRow model : layout_.viewed[view]) this->view(view, model);
    }
  }

 private:
  bool nothing_to_sense() const { return interest_.view.empty() && selected_.empty(); }

  bool runs(world::ModelRow model) const {
    return world_.models.subscribers[model] > 0 || (layout_.traits[model] & kAlwaysOn) != 0;
  }

  bool selected(world::ModelRow model) const {
    return std::ranges::binary_search(selected_, layout_.root[model]);
  }

  bool in_view(world::ModelRow model) const {
    const geom::Pose& at = world_.models.X_PM[layout_.root[model]];
    return interest_.view.contains({at.x, at.y});
  }

  std::size_t selected_beams() const {
    if (selected_.empty()) return 0;
    std::size_t beams = 0;
    for (const SensorLayout& sensor : layout_.sensors) {
      if (selected(sensor.model)) beams += sensor.beam_count;
    }
    return beams;
  }

  void view(std::uint32_t view, world::ModelRow model) {
    const KindView& what = replicate::views()[view];
    if (what.when != When::kChanged) {
      const bool wanted = selected(model) || (what.when == When::kShown && in_view(model));
      if (!wanted || (what.measures && !runs(model))) return;
    }
    const auto first = static_cast<std::uint32_t>(out_.values.size());
    if (!what.capture(world_, what.row_of(world_, model), out_.values)) return;
    out_.viewed.push_back({view, model, first, static_cast<std::uint32_t>(out_.values.size()) - first});
  }

  void copy_scan(world::SensorRow row, const SensorLayout& sensor) {
    out_.scans.push_back({row, static_cast<std::uint32_t>(out_.beams.size())});
    const auto ranges = std::span(world_.sensors.ranges.from(sensor.first_beam), sensor.beam_count);
    out_.beams.resize(out_.beams.size() + ranges.size());
    quantize_ranges(ranges, sensor.range_max, out_.beams.data() + out_.scans.back().first);
  }

  const world::World& world_;
  const Layout& layout_;
  const Interest& interest_;
  Snapshot& out_;
  std::vector<world::ModelRow> selected_;  // roots, ascending
};

}  // namespace

void Interest::add(const Interest& other) {
  if (!other.view.empty()) {
    view.add({other.view.x_min, other.view.y_min});
    view.add({other.view.x_max, other.view.y_max});
  }
  selected.insert(selected.end(), other.selected.begin(), other.selected.end());
  std::ranges::sort(selected);
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
}

void Interest::clear() {
  view = {};
  selected.clear();
}

void capture(const world::World& world, const world::Pace& pace, std::shared_ptr<const Layout> layout,
             const Interest& interest, Snapshot& out, const Snapshot* before) {
  const bool says_the_same = out.layout == layout && out.said == world.said();
  const bool is_drawn_the_same = out.layout == layout && out.drawn == world.drawn();
  out.layout = std::move(layout);
  out.tick = world.tick();
  out.pace = pace;
  Capture capture(world, interest, out);
  capture.models();
  if (!says_the_same) capture.says();
  if (!is_drawn_the_same) capture.drawings(before);
  capture.scans();
  capture.views();
}

geom::Vec2 place_of(const Snapshot& snapshot, world::ModelRow row) {
  const ModelState& state = snapshot.models[snapshot.layout->root[row]];
  return {state.x / 1000.0, state.y / 1000.0};
}

}  // namespace playhouse::replicate
