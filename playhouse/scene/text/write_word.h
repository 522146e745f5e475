#pragma once

/// Writers of single words, inverse to read_word.h
/// and Properties; called by the generated writers
/// of entities (generated/write_kinds.h).

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// An entity in file syntax: words with values, and nested entities.
struct Entity {
  std::string type;
  std::vector<std::string> words;
  std::vector<Entity> parts;
  friend bool operator==(const Entity&, const Entity&) = default;
};

/// The shortest decimal that reads back as this number, without an exponent, which Stage does not support.
std::string number_text(double value);
/// Quoted. Quotes and line ends, which a file's strings cannot contain, are replaced.
std::string quoted_text(std::string_view text);
std::string in_brackets(std::span<const std::string> values);

/// Appends words to an entity. Numbers are the shortest that read back as the same value
/// in the file's units; if there is none, as for most headings in degrees, the nearest.
class Words {
 public:
  Words(const config::Units& units, std::vector<std::string>& to) : units_(units), to_(to) {}

  void flag(std::string_view key, bool value) { integer(key, value ? 1 : 0); }
  void integer(std::string_view key, std::int64_t value);
  void number(std::string_view key, double value) { add(key, scaled(value, 'N')); }
  void length(std::string_view key, double value) { add(key, scaled(value, 'L')); }
  void angle(std::string_view key, double value) { add(key, scaled(value, 'A')); }
  /// From seconds.
  void milliseconds(std::string_view key, double value) { add(key, scaled(value, 'M')); }
  void text(std::string_view key, std::string_view value) { add(key, quoted_text(value)); }
  void texts(std::string_view key, std::span<const std::string> values);
  /// As `color` by name, or as `color_rgba`.
  void color(const Color& value);
  void colors(std::string_view key, std::span<const Color> values);
  /// `z` is the height of the file's reference frame.
  void pose(std::string_view key, const geom::Pose& value, double z = 0);
  void size(std::string_view key, const geom::Size& value);
  void point(std::string_view key, geom::Vec2 value);
  void twist(std::string_view key, std::string_view scales, const geom::Twist& value);
  void bounds(std::string_view key, std::string_view scales, std::span<const Interval> values);
  /// `scales` as in Properties::tuple(), and D for degrees regardless of the file's unit.
  void tuple(std::string_view key, std::string_view scales, std::span<const double> values);
  void kept(const KeptWord& word) { add(word.key, word.value); }

 private:
  void add(std::string_view key, const std::string& value);
  std::string scaled(double value, char scale) const;
  double heading(double value) const;

  const config::Units& units_;
  std::vector<std::string>& to_;
};

}  // namespace playhouse::scene
