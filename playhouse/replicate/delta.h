#pragma once

/// Deltas: the difference between a viewer's replica (the baseline) and a
/// snapshot, as one packet. The transport is reliable and ordered, so what was
/// sent is what the viewer holds: no acknowledged baselines are needed. What
/// exceeds the byte budget remains different and is sent with a later frame.
///
// clang-format off
///   packet (little-endian; varint: 7 bits a byte, low first, top bit says "more"; zz: zigzag varint)
///   +------+-------+--------------+-------------+-----------+-----------+
///   | u8 4 | flags | varint frame | varint tick | f32 speed | f32 rtf   |
///   +------+-------+--------------+-------------+-----------+-----------+
///   | models : (u8 mask, zz id step, changed fields)*      u8 0         |
///   | says   : (u8 1, zz id step, varint n, n bytes of UTF-8)*  u8 0    |
///   | scans  : (u8 1, zz id step, varint nth, u16 beams...)             |
///   |          or (u8 2, zz id step, varint nth)           u8 0         |
///   | views  : (u8 2v + 1, zz id step, values)                          |
///   |          or (u8 2v + 2, zz id step)                  u8 0         |
///   | drawings: (u8 1, zz id step, varint runs, (u8 form, u32           |
///   |            colour, varint shapes, corner*)*)                      |
///   |          or (u8 2, zz id step)                       u8 0         |
///   +-------------------------------------------------------------------+
/// flags    1 paused, 2 rows were deferred, 4 too many beams in view
///   mask     which fields of the model follow:
///              1, 2, 4  x, y, z: zz difference [mm]
///              8        heading: zz difference mod 2^16
///              16       u8 state
///              32       u32 colour
/// 64       varint flags carried
///              128      u16 tilt x, u16 tilt y
/// id step  the model's id - the id of the previous item (first: from 0)
/// nth      index among the model's sensors
/// v        index in views()
/// form     of each shape of the run: 1 point, 2 line, 3 triangle; 4 more: on the floor (SentCorner::flat)
/// corner   zz x, y, z: difference to the corner before, in the drawing [mm]
/// values   for each code of the view (varint, zz, u16 turn, u32 colour);
///          for a list, varint n and n times that
/// says     an empty text: it says nothing any more
///   scans, views and drawings, second form: no data any more, nothing follows
///
/// Frames of a viewer are numbered from 1. The number of beams of a scan is that of its sensor in the scene.
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

/// Constants of the packet: first byte, flags, item tags.
namespace packet {
inline constexpr std::uint8_t kFirst = 4;
inline constexpr std::uint8_t kPaused = 1, kWaiting = 2, kBeamsFull = 4;
inline constexpr std::uint8_t kEnd = 0, kFresh = 1, kGone = 2;
}  // namespace packet

/// The interest of one viewer.
struct Wish {
  geom::Box view;                          // the visible area  [m, W]
  bool sensors = false;                    // include sensors of every robot in view
  std::optional<world::ModelId> selected;  // include sensors and devices of this robot, wherever it is
};

/// What has to be captured for it.
Interest interest_of(const Wish& wish);

/// The state that one viewer holds.
struct Replica {
  explicit Replica(std::shared_ptr<const Layout> layout);

  /// Switches to another population, as a viewer does on changes_text().
  void follow(std::shared_ptr<const Layout> to);

  std::shared_ptr<const Layout> layout;
  std::uint64_t tick = 0;
  world::Pace pace;
  world::ByModel<ModelState> models;
  ByRow<world::SensorTable, std::vector<std::uint16_t>> scans;  // empty: none held
  std::map<world::ModelRow, std::string> says;                  // non-empty texts
  std::optional<std::uint64_t> said;                // Snapshot::said up to which all texts are held
  std::map<world::ModelRow, SentDrawing> drawings;  // non-empty
  std::optional<std::uint64_t> drawn;               // Snapshot::drawn up to which all drawings are held
  /// Values by view and model.
  std::map<std::pair<std::uint32_t, world::ModelRow>, std::vector<std::int32_t>> views;
};

enum class Sent { kNothing, kPart, kAll };

/// Priorities of models that frames had no room for.
struct Deferred {
  struct DeferredModel {
    double priority = 0;
    world::ModelRow row;
  };
  world::ByModel<double> gathered;        // since its last update; empty: the last frame had room for all
  std::vector<DeferredModel> candidates;  // scratch
};

/// Writes the deltas between replicas and snapshots of one population, within a
/// byte budget: the selected robot first, then models in view, then the rest. Models that a frame had no room
/// for are sent by priority (importance.h), texts, scans and drawings round robin from where the last frame stopped, so
/// that nothing starves: after a frame without room for any drawing, the next one has one.
class DeltaWriter {
 public:
  /// Replaces `out` by a packet and updates `replica` to match. kNothing: no difference
  /// (the packet is valid and empty). A scan or a drawing larger than the budget is sent alone.
  Sent write(const Snapshot& snapshot, const Wish& wish, std::uint32_t frame, std::size_t budget,
             Replica& replica, std::vector<std::byte>& out);

 private:
  Deferred deferred_;
  world::ModelRow next_text_{0};     // cursor over their texts
  world::SensorRow next_sensor_{0};  // cursor over scans
  world::ModelRow next_drawing_{0};  // cursor over drawings
  bool drawing_is_due_ = false;      // the last frame had no room for any
};

/// Applies a packet to the replica that it was made for, as the page does. For tests and C++
/// viewers. Fails on bytes that are no packet for its layout; the replica is unusable then.
Result<std::uint32_t> apply_packet(std::span<const std::byte> packet, Replica& replica);

}  // namespace playhouse::replicate
