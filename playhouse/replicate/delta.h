#pragma once

/// Deltas: the difference between what a viewer holds (its replica, the baseline) and a snapshot, as one
/// packet. The transport is reliable and ordered, so what was sent is what the viewer holds, and each
/// viewer's replica is the only baseline there is: what does not fit the byte budget simply still differs
/// next time, and goes then.
///
///   packet (little-endian; varint: 7 bits a byte, low first, top bit says "more"; zz: zigzag varint)
///   +------+-------+--------------+-------------+-----------+-----------+
///   | u8 1 | flags | varint frame | varint tick | f32 speed | f32 rtf   |
///   +------+-------+--------------+-------------+-----------+-----------+
///   | models    : (u8 mask, zz row step, changed fields)*  u8 0         |
///   | positions : (u8 mask, zz row step, changed fields)*  u8 0         |
///   | scans     : (u8 1, zz row step, u16 beams...)                     |
///   |             or (u8 2, zz row step)                   u8 0         |
///   | findings  : (u8 1, zz row step, varint n, hit * n)                |
///   |             or (u8 2, zz row step)                   u8 0         |
///   +-------------------------------------------------------------------+
///   flags: 1 paused, 2 rows are waiting, 4 too many beams in view
///   row step: row - row of the item before (first: from 0)
///   u8 2 in scans and findings: no data any more, nothing follows
///   model fields, by mask bit: 1 x, 2 y, 4 z (zz difference, mm), 8 heading (zz difference mod 2^16),
///                              16 u8 state, 32 u32 colour
///   position fields: 1 vx, 2 vy, 4 va, 8 ox, 16 oy (zz difference), 32 odometry heading (as above)
///   hit: varint target row, zz id, varint range mm, u16 bearing, u16 heading
///
/// Frames of one viewer count from 1. A scan has as many beams as the scene says its sensor has.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// What one viewer looks at.
struct Wish {
  geom::Box view;                         // what is on the screen  [m, W]
  bool sensors = false;                   // show the sensors of every robot in view
  std::optional<std::uint32_t> selected;  // top-level model row: its sensors and devices, wherever it is
};

/// What one viewer holds.
struct Replica {
  explicit Replica(const Layout& layout);

  std::uint64_t tick = 0;
  world::Pace pace;
  std::vector<ModelState> models;
  std::vector<PositionState> positions;
  std::vector<std::vector<std::uint16_t>> scans;            // by sensor row; empty: none held
  std::map<std::uint32_t, std::vector<HitState>> findings;  // by finder row
};

enum class Sent { kNothing, kPart, kAll };

/// Writes the differences between replicas and snapshots, within a byte budget: the selected robot first,
/// then what is in view, then the rest, each from where the last frame stopped, so that nothing waits for
/// ever.
class DeltaWriter {
 public:
  explicit DeltaWriter(const Layout& layout) : layout_(&layout) {}

  /// Replaces `out` by a packet and brings `replica` up to what it says. kNothing: they were equal already
  /// (the packet is valid and empty). A scan larger than the budget still goes, alone.
  Sent write(const Snapshot& snapshot, const Wish& wish, std::uint32_t frame, std::size_t budget,
             Replica& replica, std::vector<std::byte>& out);

 private:
  const Layout* layout_;
  std::uint32_t next_model_ = 0;   // where the walk over all models goes on
  std::uint32_t next_sensor_ = 0;  // the same for scans
};

/// Applies a packet to the replica it was made for, as a page does. For tests, and for viewers in C++.
/// Fails when the bytes are no packet for this layout; the replica is then of no use any more.
Result<std::uint32_t> apply_packet(std::span<const std::byte> packet, const Layout& layout, Replica& replica);

}  // namespace playhouse::replicate
