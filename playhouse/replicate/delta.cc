#include "playhouse/replicate/delta.h"

#include <algorithm>

#include "playhouse/base/packing.h"

namespace playhouse::replicate {
namespace {

constexpr std::uint8_t kPacket = 1;
constexpr std::uint8_t kPaused = 1, kWaiting = 2, kBeamsFull = 4;
constexpr std::uint8_t kEnd = 0, kFresh = 1, kGone = 2;

std::int64_t turn_difference(std::uint16_t from, std::uint16_t to) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(to - from));
}

/// Writes one packet; every function of a section returns false when the budget is spent.
class PacketWriter {
 public:
  PacketWriter(const Layout& layout, const Snapshot& snapshot, const Wish& wish, std::size_t budget,
               Replica& replica, std::vector<std::byte>& out)
      : layout_(layout),
        snapshot_(snapshot),
        wish_(wish),
        budget_(budget),
        replica_(replica),
        out_(out),
        pack_(out) {}

  void head(std::uint32_t frame) {
    const world::Pace& pace = snapshot_.pace;
    pack_.u8(kPacket);
    pack_.u8(
        static_cast<std::uint8_t>((pace.paused ? kPaused : 0) | (snapshot_.beams_full ? kBeamsFull : 0)));
    pack_.varint(frame);
    pack_.varint(snapshot_.tick);
    pack_.f32(static_cast<float>(pace.speed));
    pack_.f32(static_cast<float>(pace.real_time_factor));
    changed_ = replica_.tick != snapshot_.tick || replica_.pace.paused != pace.paused ||
               replica_.pace.speed != pace.speed;
    replica_.tick = snapshot_.tick;
    replica_.pace = pace;
  }

  /// Selected first, then what is in view, then all, both from `next` on.
  void models(std::uint32_t& next) {
    row_ = 0;
    if (wish_.selected) {
      for (const std::uint32_t row : layout_.tree(*wish_.selected)) model(row);
    }
    const auto count = static_cast<std::uint32_t>(replica_.models.size());
    if (next >= count) next = 0;
    const std::uint32_t first = next;
    std::uint32_t stopped = first;
    bool room = walk(first, stopped, [&](std::uint32_t row) { return in_view(row); });
    if (room) room = walk(first, stopped, [](std::uint32_t) { return true; });
    next = room ? 0 : stopped;
    pack_.u8(kEnd);
  }

  void positions() {
    row_ = 0;
    for (const Placed& placed : snapshot_.positions) {
      if (selected(layout_.position_model[placed.position])) position(placed.position, placed.state);
    }
    pack_.u8(kEnd);
  }

  void scans(std::uint32_t& next) {
    row_ = 0;
    for (const Scan& scan : snapshot_.scans) {
      if (selected(layout_.sensors[scan.sensor].model) && !held(scan)) this->scan(scan);
    }
    drop_scans();
    // From the sensor where the last frame stopped, around.
    const auto begin = snapshot_.scans.begin(), end = snapshot_.scans.end();
    const auto from =
        std::lower_bound(begin, end, next, [](const Scan& s, std::uint32_t row) { return s.sensor < row; });
    auto stopped = walk_scans(from, end);
    if (stopped == end) {
      stopped = walk_scans(begin, from);
      next = stopped == from ? 0 : stopped->sensor;
    } else {
      next = stopped->sensor;
    }
    pack_.u8(kEnd);
  }

  void findings() {
    row_ = 0;
    for (const Finding& finding : snapshot_.findings) {
      if (wanted(layout_.finder_model[finding.finder])) this->finding(finding);
    }
    for (auto it = replica_.findings.begin(); it != replica_.findings.end();) {
      const auto row = it->first;
      if (wanted(layout_.finder_model[row]) && in_snapshot_finding(row)) {
        ++it;
        continue;
      }
      if (full(budget_)) break;
      item(kGone, row);
      it = replica_.findings.erase(it);
    }
    pack_.u8(kEnd);
  }

  Sent finish() {
    if (waiting_) out_[1] |= std::byte{kWaiting};
    return waiting_ ? Sent::kPart : changed_ ? Sent::kAll : Sent::kNothing;
  }

 private:
  /// True, and remembered as rows waiting, when the packet is as long as `budget` or longer.
  bool full(std::size_t budget) {
    const bool full = out_.size() >= budget;
    waiting_ = waiting_ || full;
    return full;
  }

  void item(std::uint8_t tag, std::uint32_t row) {
    pack_.u8(tag);
    pack_.zigzag(static_cast<std::int64_t>(row) - static_cast<std::int64_t>(row_));
    row_ = row;
    changed_ = true;
  }

  bool selected(std::uint32_t model) const {
    return wish_.selected && layout_.root[model] == *wish_.selected;
  }

  bool in_view(std::uint32_t model) const {
    const geom::Vec2 at = place_of(layout_, snapshot_, model);
    return at.x >= wish_.view.x_min && at.x <= wish_.view.x_max && at.y >= wish_.view.y_min &&
           at.y <= wish_.view.y_max;
  }

  bool wanted(std::uint32_t model) const { return selected(model) || (wish_.sensors && in_view(model)); }

  /// Models from `first` around, as long as there is room. False: stopped before row `stopped`.
  template <typename Choose>
  bool walk(std::uint32_t first, std::uint32_t& stopped, Choose choose) {
    const auto count = static_cast<std::uint32_t>(replica_.models.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t row = first + k < count ? first + k : first + k - count;
      if (replica_.models[row] == snapshot_.models[row] || !choose(row)) continue;
      if (full(budget_ / 4 * 3)) {  // the rest is the sensors' share
        stopped = row;
        return false;
      }
      model(row);
    }
    return true;
  }

  void model(std::uint32_t row) {
    ModelState& from = replica_.models[row];
    const ModelState& to = snapshot_.models[row];
    const int mask = (from.x != to.x ? 1 : 0) | (from.y != to.y ? 2 : 0) | (from.z != to.z ? 4 : 0) |
                     (from.a != to.a ? 8 : 0) | (from.state != to.state ? 16 : 0) |
                     (from.color != to.color ? 32 : 0);
    if (mask == 0) return;
    item(static_cast<std::uint8_t>(mask), row);
    if (mask & 1) difference(from.x, to.x);
    if (mask & 2) difference(from.y, to.y);
    if (mask & 4) difference(from.z, to.z);
    if (mask & 8) pack_.zigzag(turn_difference(from.a, to.a));
    if (mask & 16) pack_.u8(to.state);
    if (mask & 32) pack_.u32(to.color);
    from = to;
  }

  void position(std::uint32_t row, const PositionState& to) {
    PositionState& from = replica_.positions[row];
    const int mask = (from.vx != to.vx ? 1 : 0) | (from.vy != to.vy ? 2 : 0) | (from.va != to.va ? 4 : 0) |
                     (from.ox != to.ox ? 8 : 0) | (from.oy != to.oy ? 16 : 0) | (from.oa != to.oa ? 32 : 0);
    if (mask == 0) return;
    item(static_cast<std::uint8_t>(mask), row);
    if (mask & 1) difference(from.vx, to.vx);
    if (mask & 2) difference(from.vy, to.vy);
    if (mask & 4) difference(from.va, to.va);
    if (mask & 8) difference(from.ox, to.ox);
    if (mask & 16) difference(from.oy, to.oy);
    if (mask & 32) pack_.zigzag(turn_difference(from.oa, to.oa));
    from = to;
  }

  void difference(std::int32_t from, std::int32_t to) {
    pack_.zigzag(static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from));
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

  std::span<const std::uint16_t> beams_of(const Scan& scan) const {
    return std::span(snapshot_.beams).subspan(scan.first, layout_.sensors[scan.sensor].beam_count);
  }

  bool held(const Scan& scan) const {
    return std::ranges::equal(replica_.scans[scan.sensor], beams_of(scan));
  }

  void scan(const Scan& scan) {
    const auto beams = beams_of(scan);
    replica_.scans[scan.sensor].assign(beams.begin(), beams.end());
    item(kFresh, scan.sensor);
    for (const std::uint16_t beam : beams) pack_.u16(beam);
  }

  /// Takes back what is held and not in the snapshot, or no longer wanted. Both are in the order of sensors.
  void drop_scans() {
    auto fresh = snapshot_.scans.begin();
    for (std::uint32_t row = 0; row < replica_.scans.size(); ++row) {
      while (fresh != snapshot_.scans.end() && fresh->sensor < row) ++fresh;
      if (replica_.scans[row].empty()) continue;
      const bool measured = fresh != snapshot_.scans.end() && fresh->sensor == row;
      if (measured && wanted(layout_.sensors[row].model)) continue;
      if (full(budget_)) return;
      item(kGone, row);
      replica_.scans[row].clear();
    }
  }

  bool in_snapshot_finding(std::uint32_t row) const {
    return std::ranges::binary_search(snapshot_.findings, row, {}, &Finding::finder);
  }

  void finding(const Finding& finding) {
    const auto hits = std::span(snapshot_.hits).subspan(finding.first, finding.count);
    const auto held = replica_.findings.find(finding.finder);
    if (held != replica_.findings.end() && std::ranges::equal(held->second, hits)) return;
    if (full(budget_)) return;
    replica_.findings[finding.finder].assign(hits.begin(), hits.end());
    item(kFresh, finding.finder);
    pack_.varint(hits.size());
    for (const HitState& hit : hits) {
      pack_.varint(hit.target);
      pack_.zigzag(hit.id);
      pack_.varint(static_cast<std::uint32_t>(std::max(hit.range, 0)));
      pack_.u16(hit.bearing);
      pack_.u16(hit.heading);
    }
  }

  const Layout& layout_;
  const Snapshot& snapshot_;
  const Wish& wish_;
  std::size_t budget_;
  Replica& replica_;
  std::vector<std::byte>& out_;
  Packer pack_;
  std::uint32_t row_ = 0;
  bool waiting_ = false;
  bool changed_ = false;
};

}  // namespace

Replica::Replica(const Layout& layout)
    : models(layout.start), positions(layout.position_model.size()), scans(layout.sensors.size()) {}

Sent DeltaWriter::write(const Snapshot& snapshot, const Wish& wish, std::uint32_t frame, std::size_t budget,
                        Replica& replica, std::vector<std::byte>& out) {
  out.clear();
  PacketWriter packet(*layout_, snapshot, wish, budget, replica, out);
  packet.head(frame);
  packet.models(next_model_);
  packet.positions();
  packet.scans(next_sensor_);
  packet.findings();
  return packet.finish();
}

}  // namespace playhouse::replicate
