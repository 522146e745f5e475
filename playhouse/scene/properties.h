#pragma once

/// Properties of one entity of a world file, converted to SI units. Reading never throws: errors are
/// collected in a shared LoadState, defaults are returned, and the loader checks once at the end.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/expand.h"
#include "playhouse/config/warnings.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/text/values.h"

namespace playhouse::scene {

/// Of a world file, in its units: far beyond any scene, well inside all arithmetic.
inline constexpr double kLargestNumber = 1e9;

/// Shared state of one load.
struct LoadState {
  const config::Document& document;
  config::Units units;
  std::optional<Error> error;  // the first error
  std::vector<Error> others;   // further ones
  config::Warnings warnings;
  bool over = false;              // abort
  std::size_t faults = 0;         // including duplicates
  std::size_t random_colors = 0;  // read so far; each is unique to its model

  /// Records an error and continues, to find more, up to the limit on warnings of a kind.
  void fail(config::SourceLine where, std::string text) { add(document.error(where, std::move(text))); }
  /// Records an error and aborts: continuing would be too expensive or pointless.
  void end(Error fault);

 private:
  void add(Error fault);
};

/// Scale codes of tuple elements: N as it is, L by the unit of length, A by the unit of angle.
class Properties {
 public:
  Properties(LoadState& state, const config::ExpandedSection& instance)
      : state_(state), where_(instance.where), fields_(instance) {}
  Properties(LoadState& state, std::span<const config::Field> fields) : state_(state), fields_(fields) {}

  bool has(std::string_view key) const { return fields_.find(key) != nullptr; }
  /// Where `key` was given, otherwise where the entity starts.
  config::SourceLine where(std::string_view key) const;
  const config::FieldSet& fields() const { return fields_; }
  LoadState& state() const { return state_; }

  double number(std::string_view key, double otherwise) const;
  double length(std::string_view key, double otherwise) const;
  double angle(std::string_view key, double otherwise) const;
  /// Truncated, with a warning, if it is no whole number.
  int integer(std::string_view key, int otherwise) const;
  bool flag(std::string_view key, bool otherwise) const { return integer(key, otherwise ? 1 : 0) != 0; }
  std::string text(std::string_view key, std::string_view otherwise) const;
  std::vector<std::string> texts(std::string_view key) const;

  /// True if the word has `count` values, as before z was introduced (three for
  /// poses and velocities, two for sizes); warns, with `now` as the current form.
  bool is_flat(std::string_view key, std::size_t count, std::string_view now) const;

  /// The first `count` elements of a tuple; none if `key` is absent. Fewer are an
  /// error with `form`, as in "[x y z]", and none are returned; more are a warning.
  std::span<const config::Value> elements(std::string_view key, std::size_t count,
                                          std::string_view form) const;
  /// Fills `out` with one number per letter of `scales` (N,
  /// L, A), checked like elements(); false if there are none.
  bool tuple(std::string_view key, std::string_view scales, std::span<double> out,
             std::string_view form) const;

  /// A size without height, from Stage 2: the world is purely planar.
  bool has_flat_size() const;
  /// Three values are [x y heading], as in Stage 2.
  std::optional<geom::Pose> pose(std::string_view key) const;
  /// Two values are [x y], as in Stage 2, with the height of `otherwise`.
  geom::Size size(std::string_view key, geom::Size otherwise) const;
  /// `color`, else `color_rgba`, else `otherwise`. `row` seeds "random".
  Color color(Color otherwise, std::size_t row) const;

 private:
  /// None, with an error, if it is not a number.
  std::optional<double> scaled(const config::Field& field, std::size_t element, char scale) const;

  LoadState& state_;
  config::SourceLine where_;
  config::FieldSet fields_;
};

}  // namespace playhouse::scene
