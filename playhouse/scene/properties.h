#pragma once

/// The properties of one entity of a world file as numbers in SI units. Reading never throws: faults are kept
/// in a place the whole load shares, defaults are returned instead, and the load checks the place once.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/expand.h"
#include "playhouse/scene/warnings.h"

namespace playhouse::scene {

/// What all entities of one load share.
struct LoadState {
  const Document& document;
  Units units;
  std::optional<Error> error;  // the first fault
  std::vector<Error> others;   // the next ones
  Warnings warnings;
  bool over = false;              // nothing more can be said: the load ends
  std::size_t faults = 0;         // those that were known included
  std::size_t random_colors = 0;  // read so far; each is that of its model alone

  /// The load goes on, to find what else is wrong, until there are as many faults as warnings of a kind.
  void fail(SourceLine where, std::string text) { add(document.error(where, std::move(text))); }
  /// The load ends: what follows would cost too much, or make no sense.
  void end(Error fault);

 private:
  void add(Error fault);
};

/// How an element of a tuple is scaled: N as it is, L by the unit of length, A by the unit of angle.
class Properties {
 public:
  Properties(LoadState& state, const Instance& instance)
      : state_(state), where_(instance.where), fields_(instance) {}
  Properties(LoadState& state, std::span<const Field> fields) : state_(state), fields_(fields) {}

  bool has(std::string_view key) const { return fields_.find(key) != nullptr; }
  /// Where `key` was given, or where the entity starts.
  SourceLine where(std::string_view key) const;
  const FieldSet& fields() const { return fields_; }
  LoadState& state() const { return state_; }

  double number(std::string_view key, double otherwise) const;
  double length(std::string_view key, double otherwise) const;
  double angle(std::string_view key, double otherwise) const;
  int integer(std::string_view key, int otherwise) const;
  bool flag(std::string_view key, bool otherwise) const { return integer(key, otherwise ? 1 : 0) != 0; }
  std::string text(std::string_view key, std::string_view otherwise) const;
  std::vector<std::string> texts(std::string_view key) const;

  /// Whether the word has the `count` values that it had before there was a z, three of poses and velocities
  /// and two of sizes; that is a warning, and `now` is how it is written.
  bool is_flat(std::string_view key, std::size_t count, std::string_view now) const;

  /// The first `count` elements of a tuple; none when `key` is absent. Fewer fail with `form`, as in "[x y
  /// z]", and none are given; more are a warning.
  std::span<const Value> elements(std::string_view key, std::size_t count, std::string_view form) const;
  /// Fills `out` with as many numbers as `scales` has letters (N, L, A), as elements() does; false when there
  /// are none.
  bool tuple(std::string_view key, std::string_view scales, std::span<double> out,
             std::string_view form) const;

  /// A size without height, as Stage 2 had: the model is of a world in which all is at one height.
  bool has_flat_size() const;
  /// Three values are [x y heading], as Stage 2 had poses.
  std::optional<geom::Pose> pose(std::string_view key) const;
  /// Two values are [x y], as Stage 2 had sizes, with the height of `otherwise`.
  geom::Size size(std::string_view key, geom::Size otherwise) const;
  /// `color`, else `color_rgba`, else `otherwise`. `row` decides what "random" is.
  Color color(Color otherwise, std::size_t row) const;

 private:
  /// None, and a fault, for what is no number.
  std::optional<double> scaled(const Field& field, std::size_t element, char scale) const;

  LoadState& state_;
  SourceLine where_;
  FieldSet fields_;
};

}  // namespace playhouse::scene
