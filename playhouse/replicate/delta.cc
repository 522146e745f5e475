#include "playhouse/replicate/delta.h"

#include <algorithm>
#include <tuple>

#include "playhouse/base/assert.h"
#include "playhouse/base/packing.h"
#include "playhouse/replicate/drawing_code.h"
#include "playhouse/replicate/importance.h"
#include "playhouse/replicate/row_code.h"
#include "playhouse/replicate/scene_text.h"

namespace playhouse::replicate {
namespace {

/// Writes one packet; functions of sections return false when the budget is used up.
class PacketWriter {
 public:
  PacketWriter(const Snapshot& snapshot, const Wish& wish, std::size_t budget, Replica& replica,
               std::vector<std::byte>& out)
      : layout_(*snapshot.layout),
        snapshot_(snapshot),
        wish_(wish),
        budget_(budget),
        replica_(replica),
        out_(out),
        pack_(out) {
    if (!wish.selected) return;
    if (const world::ModelRow row = layout_.row(*wish.selected)) selected_ = layout_.root[row];
  }

  void head(std::uint32_t frame) {
    const world::Pace& pace = snapshot_.pace;
    pack_.u8(packet::kFirst);
    pack_.u8(static_cast<std::uint8_t>((pace.paused ? packet::kPaused : 0) |
                                       (snapshot_.beams_full ? packet::kBeamsFull : 0)));
    pack_.varint(frame);
    pack_.varint(snapshot_.tick);
    pack_.f32(static_cast<float>(pace.speed));
    pack_.f32(static_cast<float>(pace.real_time_factor));
    changed_ = replica_.tick != snapshot_.tick || replica_.pace.paused != pace.paused ||
               replica_.pace.speed != pace.speed;
    replica_.tick = snapshot_.tick;
    replica_.pace = pace;
  }

  /// The selected robot, then what is in view, then all; by priority after a frame without room for all.
  void models(Deferred& deferred) {
    id_ = 0;
    if (selected_) {
      for (const world::ModelRow row : layout_.tree(selected_)) model(row);
    }
    if (deferred.gathered.empty()) {
      const bool room = walk([&](world::ModelRow row) { return in_view(row); }) &&
                        walk([](world::ModelRow) { return true; });
      if (!room) deferred.gathered.resize(replica_.models.size());
    } else if (models_by_priority(deferred)) {
      deferred.gathered.clear();
    }
    pack_.u8(packet::kEnd);
  }

  /// Changed texts.
  void says(world::ModelRow& next) {
    id_ = 0;
    if (replica_.said != snapshot_.said &&
        send_some(unheard(), next, [this](const Utterance& each) { return say(each); }))
      replica_.said = snapshot_.said;
    pack_.u8(packet::kEnd);
  }

  void scans(world::SensorRow& next) {
    id_ = 0;
    for (const SensorScan& scan : snapshot_.scans) {
      if (selected(layout_.sensors[scan.sensor].model) && !held(scan)) this->scan(scan);
    }
    drop_scans();
    // Round robin from the sensor where the last frame stopped.
    const auto begin = snapshot_.scans.begin(), end = snapshot_.scans.end();
    const auto from = std::lower_bound(
        begin, end, next, [](const SensorScan& s, world::SensorRow row) { return s.sensor < row; });
    auto stopped = walk_scans(from, end);
    if (stopped == end) {
      stopped = walk_scans(begin, from);
      next = stopped == from ? world::SensorRow{0} : stopped->sensor;
    } else {
      next = stopped->sensor;
    }
    pack_.u8(packet::kEnd);
  }

  void views() {
    id_ = 0;
    for (const Viewed& viewed : snapshot_.viewed)
      if (wanted(viewed)) view(viewed);
    drop_views();
    pack_.u8(packet::kEnd);
  }

  /// Changed drawings. As the sections before may fill every packet, `one_is_due` after a packet without room
  /// for any: it is sent whatever this one holds.
  void drawings(world::ModelRow& next, bool& one_is_due) {
    id_ = 0;
    if (replica_.drawn != snapshot_.drawn) {
      bool has_sent = false;
      const bool all = send_some(unseen(), next, [&](const ModelDrawing& each) {
        if (!std::exchange(one_is_due, false) && full(budget_)) return false;
        drawing(each);
        return has_sent = true;
      });
      one_is_due = !all && !has_sent;
      if (all) replica_.drawn = snapshot_.drawn;
    }
    pack_.u8(packet::kEnd);
  }

  Sent finish() {
    if (waiting_) out_[1] |= std::byte{packet::kWaiting};
    return waiting_ ? Sent::kPart : changed_ ? Sent::kAll : Sent::kNothing;
  }

 private:
  struct Utterance {
    world::ModelRow model;
    std::string_view text;  // empty: removed
  };

  /// True, and noted for kWaiting, if the packet has reached `budget`.
  bool full(std::size_t budget) {
    const bool full = out_.size() >= budget;
    waiting_ = waiting_ || full;
    return full;
  }

  void item(unsigned tag, world::ModelRow model) {
    const std::uint32_t id = layout_.id[model].value;
    pack_.u8(static_cast<std::uint8_t>(tag));
    pack_.zigzag(static_cast<std::int64_t>(id) - static_cast<std::int64_t>(id_));
    id_ = id;
    changed_ = true;
  }

  void scan_item(std::uint8_t tag, world::SensorRow sensor) {
    item(tag, layout_.sensors[sensor].model);
    pack_.varint(layout_.sensors[sensor].nth);
  }

  bool selected(world::ModelRow model) const { return selected_ && layout_.root[model] == selected_; }

  bool in_view(world::ModelRow model) const { return wish_.view.contains(place_of(snapshot_, model)); }

  bool wanted(world::ModelRow model) const { return selected(model) || (wish_.sensors && in_view(model)); }

  bool wanted(const Viewed& viewed) const {
    switch (replicate::views()[viewed.view].when) {
      case When::kChanged:
        return true;
      case When::kSelected:
        return selected(viewed.model);
      case When::kShown:
        return wanted(viewed.model);
    }
    return false;
  }

  /// The rest is reserved for sensors.
  std::size_t models_budget() const { return budget_ / 4 * 3; }

  /// False: no room for all.
  template <typename Choose>
  bool walk(Choose choose) {
    for (const world::ModelRow row : replica_.models.rows()) {
      if (replica_.models[row] == snapshot_.models[row] || !choose(row)) continue;
      if (full(models_budget())) return false;
      model(row);
    }
    return true;
  }

  /// False: no room for all.
  bool models_by_priority(Deferred& deferred) {
    deferred.gathered.resize(replica_.models.size());
    deferred.candidates.clear();
    for (const world::ModelRow row : replica_.models.rows()) {
      const ModelState &from = replica_.models[row], &to = snapshot_.models[row];
      if (from == to) continue;
      const geom::Vec2 at = place_of(snapshot_, row);
      double& gathered = deferred.gathered[row];
      gathered += is_out_of_view(wish_, at) ? kLeastImportance
                                            : importance(wish_, selected(row), at, change_of(from, to));
      deferred.candidates.push_back({gathered, row});
    }
    std::ranges::sort(deferred.candidates,
                      [](const Deferred::DeferredModel& a, const Deferred::DeferredModel& b) {
                        return std::tuple(-a.priority, a.row) < std::tuple(-b.priority, b.row);
                      });
    for (const auto& [priority, row] : deferred.candidates) {
      if (full(models_budget())) return false;
      model(row);
      deferred.gathered[row] = 0;
    }
    return true;
  }

  void model(world::ModelRow row) {
    ModelState& from = replica_.models[row];
    const ModelState& to = snapshot_.models[row];
    const std::uint8_t mask = changed_fields(from, to);
    if (mask == 0) return;
    item(mask, row);
    write_fields(mask, from, to, pack_);
    from = to;
  }

  /// Sends differences as long as `send` has room: those in view first, both round robin from `next`. True: all.
  template <typename Difference, typename Send>
  bool send_some(std::vector<Difference> news, world::ModelRow& next, Send send) {
    const auto from = std::ranges::lower_bound(news, next, {}, &Difference::model);
    std::rotate(news.begin(), from, news.end());
    std::stable_partition(news.begin(), news.end(),
                          [this](const Difference& each) { return in_view(each.model); });
    const auto stopped = std::ranges::find_if_not(news, send);
    next = stopped == news.end() ? world::ModelRow{0} : stopped->model;
    return stopped == news.end();
  }

  /// Differences between what the replica holds by row and what the snapshot has, sorted by row; with an empty
  /// value: removed. `difference_of` gives one of a row of the snapshot, `is_same` compares values.
  template <typename Held, typename Sent, typename DifferenceOf, typename IsSame>
  static auto differences(const Held& all_held, const Sent& all_sent, DifferenceOf difference_of,
                          IsSame is_same) {
    using Difference = decltype(difference_of(all_sent.front()));
    std::vector<Difference> news;
    auto held = all_held.begin();
    const auto end_held_before = [&](world::ModelRow row) {
      for (; held != all_held.end() && held->first < row; ++held) news.push_back({held->first, {}});
    };
    for (const auto& sent : all_sent) {
      end_held_before(sent.model);
      const bool holds = held != all_held.end() && held->first == sent.model;
      if (!holds || !is_same(held->second, sent)) news.push_back(difference_of(sent));
      if (holds) ++held;
    }
    end_held_before(world::ModelRow{});
    return news;
  }

  std::vector<Utterance> unheard() const {
    return differences(
        replica_.says, snapshot_.says,
        [](const Said& said) {
          return Utterance{said.model, said.text};
        },
        [](const auto& held, const Said& said) { return held == said.text; });
  }

  /// False: no room; some is reserved for sensors.
  bool say(const Utterance& utterance) {
    if (full(budget_ / 8 * 7)) return false;
    item(packet::kFresh, utterance.model);
    pack_.text(utterance.text);
    if (utterance.text.empty()) {
      replica_.says.erase(utterance.model);
    } else {
      replica_.says[utterance.model] = utterance.text;
    }
    return true;
  }

  std::vector<ModelDrawing> unseen() const {
    return differences(
        replica_.drawings, snapshot_.drawings, [](const ModelDrawing& drawn) { return drawn; },
        [](const SentDrawing& held, const ModelDrawing& drawn) {
          return held == drawn.drawing || *held == *drawn.drawing;
        });
  }

  void drawing(const ModelDrawing& drawn) {
    if (drawn.drawing == nullptr) {
      item(packet::kGone, drawn.model);
      replica_.drawings.erase(drawn.model);
      return;
    }
    item(packet::kFresh, drawn.model);
    write_drawing(*drawn.drawing, pack_);
    replica_.drawings[drawn.model] = drawn.drawing;
  }

  template <typename Iterator>
  Iterator walk_scans(Iterator from, Iterator end) {
    for (; from != end; ++from) {
      if (!wanted(layout_.sensors[from->sensor].model) || held(*from)) continue;
      if (full(budget_)) return from;
      scan(*from);
    }
    return end;
  }

  std::span<const std::uint16_t> beams_of(const SensorScan& scan) const {
    return std::span(snapshot_.beams).subspan(scan.first, layout_.sensors[scan.sensor].beam_count);
  }

  bool held(const SensorScan& scan) const {
    return std::ranges::equal(replica_.scans[scan.sensor], beams_of(scan));
  }

  void scan(const SensorScan& scan) {
    const auto beams = beams_of(scan);
    replica_.scans[scan.sensor].assign(beams.begin(), beams.end());
    scan_item(packet::kFresh, scan.sensor);
    for (const std::uint16_t beam : beams) pack_.u16(beam);
  }

  /// Removes held scans that are not in the snapshot or not wanted any more. Both are sorted by sensor.
  void drop_scans() {
    auto fresh = snapshot_.scans.begin();
    for (const world::SensorRow row : replica_.scans.rows()) {
      while (fresh != snapshot_.scans.end() && fresh->sensor < row) ++fresh;
      if (replica_.scans[row].empty()) continue;
      const bool measured = fresh != snapshot_.scans.end() && fresh->sensor == row;
      if (measured && wanted(layout_.sensors[row].model)) continue;
      if (full(budget_)) return;
      scan_item(packet::kGone, row);
      replica_.scans[row].clear();
    }
  }

  std::span<const std::int32_t> values_of(const Viewed& viewed) const {
    return std::span(snapshot_.values).subspan(viewed.first, viewed.count);
  }

  void view(const Viewed& viewed) {
    const auto values = values_of(viewed);
    const std::pair key(viewed.view, viewed.model);
    const auto held = replica_.views.find(key);
    if (held != replica_.views.end() && std::ranges::equal(held->second, values)) return;
    if (full(budget_)) return;
    replica_.views[key].assign(values.begin(), values.end());
    item(2 * viewed.view + packet::kFresh, viewed.model);
    const KindView& what = replicate::views()[viewed.view];
    if (what.list) pack_.varint(values.size() / what.codes.size());
    for (std::size_t k = 0; k < values.size(); ++k) value(what.codes[k % what.codes.size()], values[k]);
  }

  void value(Code code, std::int32_t value) {
    switch (code) {
      case Code::kVarint:
        pack_.varint(static_cast<std::uint32_t>(value));
        break;
      case Code::kZigzag:
        pack_.zigzag(value);
        break;
      case Code::kTurn:
        pack_.u16(static_cast<std::uint16_t>(value));
        break;
      case Code::kRgba:
        pack_.u32(static_cast<std::uint32_t>(value));
        break;
    }
  }

  /// Removes held views not in the snapshot or not wanted any more. Both are sorted by view and model.
  void drop_views() {
    const auto key_of = [](const Viewed& viewed) { return std::pair(viewed.view, viewed.model); };
    for (auto it = replica_.views.begin(); it != replica_.views.end();) {
      const auto key = it->first;
      const auto fresh = std::ranges::lower_bound(snapshot_.viewed, key, {}, key_of);
      if (fresh != snapshot_.viewed.end() && key_of(*fresh) == key && wanted(*fresh)) {
        ++it;
        continue;
      }
      if (full(budget_)) return;
      item(2 * key.first + packet::kGone, key.second);
      it = replica_.views.erase(it);
    }
  }

  const Layout& layout_;
  const Snapshot& snapshot_;
  const Wish& wish_;
  std::size_t budget_;
  Replica& replica_;
  std::vector<std::byte>& out_;
  Packer pack_;
  world::ModelRow selected_;  // its root; none: nobody
  std::uint32_t id_ = 0;      // of the previous item
  bool waiting_ = false;
  bool changed_ = false;
};

}  // namespace

Interest interest_of(const Wish& wish) {
  Interest interest;
  if (wish.sensors) interest.view = wish.view;
  if (wish.selected) interest.selected.push_back(*wish.selected);
  return interest;
}

Replica::Replica(std::shared_ptr<const Layout> of)
    : layout(std::move(of)), models(layout->start), scans(layout->sensors.size()) {}

void Replica::follow(std::shared_ptr<const Layout> to) {
  const Layout& from = *layout;
  Replica next(to);
  next.tick = tick;
  next.pace = pace;
  world::ByModel<world::ModelRow> row_now(from.id.size());  // none: it is gone
  compare(
      from, *to, [](world::ModelRow) {},
      [&](world::ModelRow before, world::ModelRow now) {
        row_now[before] = now;
        next.models[now] = models[before];
      },
      [](world::ModelRow) {});
  for (const world::SensorRow sensor : scans.rows()) {
    if (scans[sensor].empty() || !row_now[from.sensors[sensor].model]) continue;
    const auto now = to->sensor(from.id[from.sensors[sensor].model], from.sensors[sensor].nth);
    next.scans[now] = std::move(scans[sensor]);
  }
  for (auto& [row, text] : says)
    if (row_now[row]) next.says[row_now[row]] = std::move(text);
  for (auto& [row, drawing] : drawings)
    if (row_now[row]) next.drawings[row_now[row]] = std::move(drawing);
  for (auto& [key, values] : views)
    if (row_now[key.second]) next.views[{key.first, row_now[key.second]}] = std::move(values);
  *this = std::move(next);
}

Sent DeltaWriter::write(const Snapshot& snapshot, const Wish& wish, std::uint32_t frame, std::size_t budget,
                        Replica& replica, std::vector<std::byte>& out) {
  PLAYHOUSE_ASSERT(replica.layout == snapshot.layout);
  out.clear();
  PacketWriter packet(snapshot, wish, budget, replica, out);
  packet.head(frame);
  packet.models(deferred_);
  packet.says(next_text_);
  packet.scans(next_sensor_);
  packet.views();
  packet.drawings(next_drawing_, drawing_is_due_);
  return packet.finish();
}

}  // namespace playhouse::replicate
