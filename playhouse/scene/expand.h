#pragma once

/// Macros applied to sections. A macro's body is not copied: an instance is the list of bodies it is made of,
/// the base first, and its fields are looked up from the last body to the first. Names are resolved when an
/// instance is made, so a macro may stand for any type from its definition on, also inside macros that were
/// defined before it.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/syntax.h"

namespace playhouse::scene {

/// A section with its macros resolved.
struct Instance {
  std::string_view type;              // the name that is no macro
  std::vector<const Section*> parts;  // macro bodies, base first; the instance's own body last
  SourceLine where;                   // of the instance
  /// The same in today's words: has the fields, and entities beside those of `parts`. Null: its words are
  /// today's.
  const Section* now = nullptr;
};

class Macros {
 public:
  explicit Macros(const Document& document) : document_(document) {}

  /// Adds `statement`; returns false, and changes nothing, when its name is taken: the first definition
  /// counts.
  bool define(const Statement& statement);
  const Statement* find(std::string_view name) const;
  std::vector<std::string_view> names() const;

  /// Fails when a macro is based on itself.
  Result<Instance> instance(const Section& section) const;

 private:
  const Document& document_;
  std::map<std::string_view, const Statement*> macros_;
};

/// The fields of an instance by key; of several with one key the last counts.
class FieldSet {
 public:
  explicit FieldSet(const Instance& instance);
  explicit FieldSet(std::span<const Section* const> parts);
  explicit FieldSet(std::span<const Field> fields);

  const Field* find(std::string_view key) const;
  /// In the order of their keys.
  std::span<const Field* const> all() const { return fields_; }

 private:
  void keep_last_of_each();
  std::vector<const Field*> fields_;
};

/// Reads unit_length ("m", "cm", "mm") and unit_angle ("degrees", "radians").
Result<Units> read_units(const Document& document, const FieldSet& fields);

/// "m", "cm" or "mm", and "degrees" or "radians", as read_units() reads them.
std::string_view length_word(const Units& units);
std::string_view angle_word(const Units& units);

/// The number that `text` spells completely, as in "-1.5", "+.5", "2."; none for anything else or beyond
/// 1e300.
std::optional<double> parse_number(std::string_view text);

/// The key of `point[12]` without its index, "point"; other keys as they are.
std::string_view without_index(std::string_view key);

}  // namespace playhouse::scene
