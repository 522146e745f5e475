#pragma once

/// Views: replicated data of kinds and traits beyond the pose, generated from
/// the `[[viewer]]` fields of kinds/*.toml (generated/views.cc). At most one
/// view per kind: a record, or a list of records, of integers. Quanta and units
/// are in docs/kinds/ and in the page's own table, web/src/protocol/generated/.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::replicate {

/// Encoding of a number: unsigned varint; zigzag varint; 16-bit fraction of a turn; 32-bit colour.
enum class Code : std::uint8_t { kVarint, kZigzag, kTurn, kRgba };

/// For which models a view is sent: all; those of the viewer's selected
/// robot; those, and all in view if the viewer asked for sensors.
enum class When : std::uint8_t { kChanged, kSelected, kShown };

struct KindView {
  When when;
  bool measures;                // has data only while subscribed
  bool list;                    // any number of records; else exactly one
  std::span<const Code> codes;  // of one record
  /// The model's row in the kind's table; none if it is of another kind.
  world::KindRow (*row_of)(const world::World& world, world::ModelRow model);
  /// Appends the numbers of a row of that table. False: no measurement yet.
  bool (*capture)(const world::World& world, world::KindRow row, std::vector<std::int32_t>& out);
};

/// In the order of kinds, then traits.
std::span<const KindView> views();

/// The state bits of a model: kSubscribed, and those of its kind.
std::uint8_t state_bits(const world::World& world, world::ModelRow model);
inline constexpr std::uint8_t kSubscribed = 1;  // a client reads or drives it

/// True if a subscription only makes models of the kind
/// measure, without side effects: safe for passive viewers.
bool may_be_watched(scene::ModelKind kind);

/// Appends the kind's fields of a prototype as members of a JSON object: `,"trail":20`.
void tell_kind(const scene::ModelDesc& model, std::string& text);

/// "position".
std::string_view kind_name(scene::ModelKind kind);

}  // namespace playhouse::replicate
