#include "playhouse/config/text/syntax.h"

#include <fmt/format.h>

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::config {
namespace {

class Parser {
 public:
  Parser(Format format, Document& document, TokenStream tokens)
      : format_(format), document_(document), tokens_(std::move(tokens)) {}

  Result<void> parse_file();

 private:
  Result<void> parse_include(const Token& word);
  Result<void> parse_define(const Token& word);
  Result<void> parse_body(Section& section, int depth);
  Result<void> parse_value(Field& field);
  Result<void> parse_tuple(Field& field, SourceLine opened);
  /// After a name: parses a field or a section.
  Result<void> parse_item(const Token& name, std::vector<Field>& fields, std::vector<Section>& sections,
                          int depth);

  void skip_line_ends();
  /// The lexer's error if there is one, otherwise `text` at `where`.
  Error error(SourceLine where, std::string text) const;

  Format format_;
  Document& document_;
  TokenStream tokens_;
};

bool is_value(TokenKind kind) {
  return kind == TokenKind::kNumber || kind == TokenKind::kString || kind == TokenKind::kBool;
}

Value value_of(const Token& token) {
  const ValueKind kind = token.kind == TokenKind::kNumber   ? ValueKind::kNumber
                         : token.kind == TokenKind::kString ? ValueKind::kString
                                                            : ValueKind::kBool;
  return {kind, token.text};
}

Error Parser::error(SourceLine where, std::string text) const {
  return tokens_.error() ? *tokens_.error() : document_.error(where, std::move(text));
}

void Parser::skip_line_ends() {
  while (tokens_.peek().kind == TokenKind::kLineEnd) tokens_.next();
}

Result<void> Parser::parse_file() {
  for (;;) {
    const Token token = tokens_.next();
    switch (token.kind) {
      case TokenKind::kLineEnd:
        continue;
      case TokenKind::kEnd:
        return tokens_.error() ? Result<void>(*tokens_.error()) : Result<void>();
      case TokenKind::kClose:
        return error(token.where, "\")\" without its \"(\"");
      case TokenKind::kWord:
        break;
      default:
        return error(token.where, "expected a name, found " + describe(token));
    }
    Result<void> parsed;
    if (token.text == "include") {
      parsed = parse_include(token);
    } else if (token.text == "define") {
      parsed = parse_define(token);
    } else {
      std::vector<Section> sections;
      parsed = parse_item(token, document_.fields, sections, 1);
      if (!sections.empty()) document_.statements.push_back({std::move(sections.front()), {}});
    }
    if (!parsed) return parsed;
  }
}

Result<void> Parser::parse_include(const Token& word) {
  const Token name = tokens_.next();
  if (name.kind != TokenKind::kString) {
    return error(word.where, "include needs a file name in quotes, found " + describe(name));
  }
  return tokens_.include(name.text, word.where);
}

Result<void> Parser::parse_define(const Token& word) {
  const Token name = tokens_.next();
  if (name.kind != TokenKind::kWord) {
    return error(word.where, "define needs the name of the macro, found " + describe(name));
  }
  const Token base = tokens_.next();
  if (base.kind != TokenKind::kWord) {
    return error(word.where, "define " + in_quotes(name.text) +
                                 " needs the type it is based on, as in: define name " +
                                 (format_ == Format::kWorld ? "model ( ... )" : "driver ( ... )"));
  }
  skip_line_ends();
  const Token open = tokens_.next();
  if (open.kind != TokenKind::kOpen) {
    return error(open.where, "define " + in_quotes(name.text) + " needs \"(\", found " + describe(open));
  }
  Statement statement{{name.text, word.where, {}, {}}, base.text};
  if (const Result<void> parsed = parse_body(statement.section, 1); !parsed) return parsed;
  document_.statements.push_back(std::move(statement));
  return {};
}

Result<void> Parser::parse_item(const Token& name, std::vector<Field>& fields, std::vector<Section>& sections,
                                int depth) {
  const std::string subject = in_quotes(name.text);
  if (std::count(name.text.begin(), name.text.end(), '[') >
      std::count(name.text.begin(), name.text.end(), ']')) {
    return error(name.where, subject + " needs a space before its \"[\"");
  }
  if (is_value(tokens_.peek().kind) || tokens_.peek().kind == TokenKind::kTupleOpen) {
    Field field{name.text, {}, name.where};
    if (const Result<void> parsed = parse_value(field); !parsed) return parsed;
    fields.push_back(std::move(field));
    return {};
  }
  const bool ends_line = tokens_.peek().kind == TokenKind::kLineEnd;
  skip_line_ends();
  const Token open = tokens_.next();
  if (open.kind == TokenKind::kOpen) {
    if (depth > limits::kEntityDepth) {
      return error(name.where, "sections nested more than " + std::to_string(limits::kEntityDepth) + " deep");
    }
    sections.push_back({name.text, name.where, {}, {}});
    return parse_body(sections.back(), depth + 1);
  }
  if (is_value(open.kind) || open.kind == TokenKind::kTupleOpen) {
    return error(name.where, "the value of " + subject + " must be on the same line");
  }
  if (open.kind == TokenKind::kWord && !ends_line) {
    static constexpr std::string_view kKeywords[] = {"include", "define"};
    const std::string hint = did_you_mean(name.text, kKeywords);
    return error(name.where, subject + " needs a value, found " + describe(open) +
                                 (hint.empty() ? " (text takes double quotes)" : hint));
  }
  return error(name.where, subject + " needs a value or \"(\"");
}

Result<void> Parser::parse_body(Section& section, int depth) {
  for (;;) {
    const Token token = tokens_.next();
    switch (token.kind) {
      case TokenKind::kLineEnd:
        continue;
      case TokenKind::kClose:
        return {};
      case TokenKind::kEnd:
        return error(section.where, in_quotes(section.name) + " lacks its closing \")\"");
      case TokenKind::kWord:
        break;
      default:
        return error(token.where, "expected a name or \")\", found " + describe(token));
    }
    Result<void> parsed;
    if (token.text == "include") {
      parsed = parse_include(token);
    } else if (token.text == "define" && tokens_.peek().kind == TokenKind::kWord) {
      parsed = error(token.where, "define is possible outside all sections only");
    } else {
      parsed = parse_item(token, section.fields, section.sections, depth);
    }
    if (!parsed) return parsed;
  }
}

Result<void> Parser::parse_value(Field& field) {
  const Token token = tokens_.next();
  if (token.kind == TokenKind::kTupleOpen) return parse_tuple(field, token.where);
  field.values.push_back(value_of(token));
  return {};
}

Result<void> Parser::parse_tuple(Field& field, SourceLine opened) {
  const std::string subject = "the tuple of " + in_quotes(field.key);
  for (;;) {
    const Token token = tokens_.next();
    switch (token.kind) {
      case TokenKind::kTupleClose:
        return {};
      case TokenKind::kNumber:
      case TokenKind::kString:
        field.values.push_back(value_of(token));
        break;
      case TokenKind::kLineEnd:
        if (format_ == Format::kConfiguration) break;
        return error(opened, subject + " must end with \"]\" on the same line");
      case TokenKind::kEnd:
        return error(opened, subject + " lacks its \"]\"");
      default:
        return error(token.where, subject + " holds numbers and quoted strings, found " + describe(token));
    }
  }
}

/// The format of a file of another program, recognised by its beginning; empty: none.
std::string_view foreign_format(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("#VRML_SIM")) return "a world of Webots";
  if (text.starts_with("version https://git-lfs.github.com/"))
    return "a pointer of Git LFS, in place of the file; `git lfs pull` fetches it";
  if (!text.starts_with('<')) return {};
  const std::string_view head = text.substr(0, 4096);
  if (head.find("<sdf") != head.npos || head.find("<gazebo") != head.npos) return "a world of Gazebo (SDF)";
  return "XML";
}

}  // namespace

Result<Document> parse_document(Format format, const std::string& path, std::string text, FileReader& files) {
  if (const std::string_view other = foreign_format(text); !other.empty())
    return Error{escaped(path) + ":1",
                 fmt::format("this is {}, not a {} of Player/Stage", other,
                             format == Format::kWorld ? "world file" : "configuration file")};
  Document document;
  const Result<std::uint32_t> row = document.sources.add(path, std::move(text));
  if (!row) return Error{escaped(path), row.error().text};
  Parser parser(format, document, TokenStream(format, document.sources, files, *row));
  if (const Result<void> parsed = parser.parse_file(); !parsed) return parsed.error();
  return document;
}

}  // namespace playhouse::config
