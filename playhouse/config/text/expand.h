#pragma once

/// Macro expansion. A macro's body is not copied: an instance is the list of
/// bodies it consists of, base first; fields are looked up from the last body
/// to the first. Names are resolved at instantiation, so a macro can redefine
/// any type from its definition on, even inside macros defined earlier.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/syntax.h"

namespace playhouse::config {

/// A section with its macros resolved.
struct ExpandedSection {
  std::string_view type;              // the base type, not a macro
  std::vector<const Section*> parts;  // macro bodies, base first; the instance's own body last
  SourceLine where;                   // of the instance
  /// The same rewritten to current words: contains the fields, and
  /// entities besides those of `parts`. Null: no rewriting was needed.
  const Section* now = nullptr;
};

class Macros {
 public:
  explicit Macros(const Document& document) : document_(document) {}

  /// Adds a definition; returns false without effect
  /// if the name is taken: the first definition wins.
  bool define(const Statement& statement);
  const Statement* find(std::string_view name) const;
  std::vector<std::string_view> names() const;

  /// Fails on recursive macros.
  Result<ExpandedSection> instance(const Section& section) const;

 private:
  const Document& document_;
  std::map<std::string_view, const Statement*> macros_;
};

/// The fields of an instance by key; of duplicates the last one counts.
class FieldSet {
 public:
  explicit FieldSet(const ExpandedSection& instance);
  explicit FieldSet(std::span<const Section* const> parts);
  explicit FieldSet(std::span<const Field> fields);

  const Field* find(std::string_view key) const;
  /// Sorted by key.
  std::span<const Field* const> all() const { return fields_; }

 private:
  void keep_last_of_each();
  std::vector<const Field*> fields_;
};

/// Reads unit_length ("m", "cm", "mm") and unit_angle ("degrees", "radians").
Result<Units> read_units(const Document& document, const FieldSet& fields);

/// The inverse of read_units(): "m", "cm" or "mm"; "degrees" or "radians".
std::string_view length_word(const Units& units);
std::string_view angle_word(const Units& units);

/// Parses a number that is the whole text, like "-1.5",
/// "+.5", "2."; none for anything else or beyond 1e300.
std::optional<double> parse_number(std::string_view text);

/// Strips the index of a key: `point[12]` -> "point"; other keys are unchanged.
std::string_view without_index(std::string_view key);

}  // namespace playhouse::config
