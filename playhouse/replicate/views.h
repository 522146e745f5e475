#pragma once

/// Views: what travels of each kind of model, and of each trait, beyond its pose, made from the `[[viewer]]`
/// fields of kinds/*.toml (generated/views.cc). A kind has one view at most: a record, or a list of records,
/// of whole numbers. Quanta and units are in docs/kinds/ and in the page's own table,
/// web/src/protocol/generated/.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::replicate {

/// How a number travels: an unsigned varint; a signed one, zigzag; 16 bits of a turn; 32 bits of a colour.
enum class Code : std::uint8_t { kVarint, kZigzag, kTurn, kRgba };

/// Whose views a viewer gets: those of all models; of all in its selected robot; of these, and of all in
/// sight if it asked for sensors.
enum class When : std::uint8_t { kChanged, kSelected, kShown };

struct View {
  When when;
  bool measures;                // it does while somebody subscribes
  bool list;                    // any number of records; else one
  std::span<const Code> codes;  // of one record
  /// The model's row in the table of the kind, or Row::kNone if it is of another.
  std::uint32_t (*row_of)(const world::World& world, std::uint32_t model);
  /// Appends the numbers of a row of that table. False: it has not measured yet.
  bool (*capture)(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out);
};

/// In the order of their kinds; traits come behind them.
std::span<const View> views();

/// The bits of a model's state: kSubscribed, and those of its kind.
std::uint8_t state_bits(const world::World& world, std::uint32_t model);
inline constexpr std::uint8_t kSubscribed = 1;  // somebody reads or drives it

/// Whether models of the kind measure while somebody subscribes, and do nothing else for those who only look:
/// they change nothing.
bool may_be_watched(scene::ModelKind kind);

/// Appends what a kind tells of its prototypes, as fields of a JSON object: `,"trail":20`.
void tell_kind(const scene::ModelDesc& model, std::string& text);

/// "position".
std::string_view kind_name(scene::ModelKind kind);

}  // namespace playhouse::replicate
