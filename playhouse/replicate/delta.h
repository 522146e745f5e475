#pragma once

/// Deltas: the difference between what a viewer holds (its replica, the baseline) and a snapshot, as one
/// packet. The transport is reliable and ordered, so what was sent is what the viewer holds, and each
/// viewer's replica is the only baseline there is: what does not fit the byte budget simply still differs
/// next time, and goes then.
///
// clang-format off
///   packet (little-endian; varint: 7 bits a byte, low first, top bit says "more"; zz: zigzag varint)
///   +------+-------+--------------+-------------+-----------+-----------+
///   | u8 3 | flags | varint frame | varint tick | f32 speed | f32 rtf   |
///   +------+-------+--------------+-------------+-----------+-----------+
///   | models : (u8 mask, zz id step, changed fields)*      u8 0         |
///   | says   : (u8 1, zz id step, varint n, n bytes of UTF-8)*  u8 0    |
///   | scans  : (u8 1, zz id step, varint nth, u16 beams...)             |
///   |          or (u8 2, zz id step, varint nth)           u8 0         |
///   | views  : (u8 2v + 1, zz id step, values)                          |
///   |          or (u8 2v + 2, zz id step)                  u8 0         |
///   +-------------------------------------------------------------------+
///   flags    1 paused, 2 rows are waiting, 4 too many beams in view
///   mask     which fields of the model follow:
///              1, 2, 4  x, y, z: zz difference [mm]
///              8        heading: zz difference mod 2^16
///              16       u8 state
///              32       u32 colour
///              64       varint flags that it carries
///              128      u16 tilt x, u16 tilt y
///   id step  the model's id - the id of the item before (first: from 0)
///   nth      which of the model's sensors
///   v        place in views()
///   values   of each code of the view in turn (varint, zz, u16 turn, u32 colour);
///            where it is a list, varint n and n times that
///   says     a text of no bytes: it says nothing any more
///   scans and views, second form: no data any more, nothing follows
///
/// Frames of one viewer count from 1. A scan has as many beams as the scene says its sensor has.
// clang-format on

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/replicate/snapshot.h"

namespace playhouse::replicate {

/// Numbers of the packet: what it begins with, its flags, and tags of items.
namespace packet {
inline constexpr std::uint8_t kFirst = 3;
inline constexpr std::uint8_t kPaused = 1, kWaiting = 2, kBeamsFull = 4;
inline constexpr std::uint8_t kEnd = 0, kFresh = 1, kGone = 2;
}  // namespace packet

/// What one viewer looks at.
struct Wish {
  geom::Box view;                          // what is on the screen  [m, W]
  bool sensors = false;                    // show the sensors of every robot in view
  std::optional<world::ModelId> selected;  // its robot's sensors and devices, wherever it is
};

/// What one viewer holds.
struct Replica {
  explicit Replica(std::shared_ptr<const Layout> layout);

  /// Goes over to another population, as a viewer does that was told changes_text().
  void follow(std::shared_ptr<const Layout> to);

  std::shared_ptr<const Layout> layout;
  std::uint64_t tick = 0;
  world::Pace pace;
  std::vector<ModelState> models;                 // by row
  std::vector<std::vector<std::uint16_t>> scans;  // by sensor row; empty: none held
  std::map<std::uint32_t, std::string> says;      // by model row; those that say something
  std::optional<std::uint64_t> said;              // Snapshot::said of which it has all texts, if it has
  /// By view and model row.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::int32_t>> views;
};

enum class Sent { kNothing, kPart, kAll };

/// Writes the differences between replicas and snapshots of one population, within a byte budget: the
/// selected robot first, then what is in view, then the rest, each from where the last frame stopped, so that
/// nothing waits for ever.
class DeltaWriter {
 public:
  /// Replaces `out` by a packet and brings `replica` up to what it says. kNothing: they were equal already
  /// (the packet is valid and empty). A scan larger than the budget still goes, alone.
  Sent write(const Snapshot& snapshot, const Wish& wish, std::uint32_t frame, std::size_t budget,
             Replica& replica, std::vector<std::byte>& out);

 private:
  std::uint32_t next_model_ = 0;   // where the walk over all models goes on
  std::uint32_t next_text_ = 0;    // the same for what they say
  std::uint32_t next_sensor_ = 0;  // and for scans
};

/// Applies a packet to the replica it was made for, as a page does. For tests, and for viewers in C++.
/// Fails when the bytes are no packet for its layout; the replica is then of no use any more.
Result<std::uint32_t> apply_packet(std::span<const std::byte> packet, Replica& replica);

}  // namespace playhouse::replicate
