#pragma once

/// Parser: tokens -> sections and fields, the syntax common to
/// Stage world files and Player configuration files. Macros are
/// kept unexpanded; see expand.h. Independent of vocabulary.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/tokens.h"

namespace playhouse::config {

enum class ValueKind : std::uint8_t { kNumber, kString, kBool };

struct Value {
  ValueKind kind = ValueKind::kNumber;
  std::string_view text;
};

/// `key value` or `key [ value ... ]`.
struct Field {
  std::string_view key;
  std::vector<Value> values;
  SourceLine where;
};

/// `name ( fields and sections )`, in file order within each kind.
struct Section {
  std::string_view name;
  SourceLine where;
  std::vector<Field> fields;
  std::vector<Section> sections;
};

/// A top-level section, or, if `base` is not empty, the macro `define section.name base ( ... )`.
struct Statement {
  Section section;
  std::string_view base;
};

/// A parsed file with its includes. Move-only; views refer to `sources`.
struct Document {
  SourceTexts sources;
  std::vector<Field> fields;  // outside all sections
  std::vector<Statement> statements;

  Error error(SourceLine where, std::string text) const { return {sources.at(where), std::move(text)}; }
};

/// Parses `text`, read from `path`. Fails with one error, "file:line: what".
Result<Document> parse_document(Format format, const std::string& path, std::string text, FileReader& files);

}  // namespace playhouse::config
