#pragma once

/// Lexer of Stage world files and Player configuration files, with includes spliced
/// in. The formats differ only in the characters of words and in boolean words.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/config/text/source_text.h"

namespace playhouse::config {

enum class Format : std::uint8_t { kWorld, kConfiguration };

enum class TokenKind : std::uint8_t {
  kWord,
  kNumber,
  kString,
  kBool,
  kOpen,
  kClose,
  kTupleOpen,
  kTupleClose,
  kLineEnd,
  kEnd
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string_view text;  // strings without quotes
  SourceLine where;
};

/// Name of a token in errors: `word "pose"`, `")"`, `the end of the line`.
std::string describe(const Token& token);

/// One pass over a top-level text and its includes. The texts
/// are owned by `sources`, which must outlive the tokens.
class TokenStream {
 public:
  /// `row` is the top-level text in `sources`; includes are resolved against its folder,
  /// then that of the including file, then along the reader's search path (file_search.h).
  TokenStream(Format format, SourceTexts& sources, FileReader& files, std::uint32_t row);

  /// The next token; kEnd at the end or after an error.
  Token next();
  /// The token that next() will return.
  const Token& peek();
  /// Continues with the text of `name`, then after the include statement. Fails on a missing file,
  /// a cycle, nesting beyond limits::kIncludeDepth and more than limits::kIncludes in total.
  Result<void> include(std::string_view name, SourceLine where);
  /// The error that stopped the stream, if any: "bad character", "unterminated string".
  const std::optional<Error>& error() const { return error_; }

 private:
  struct Cursor {
    std::uint32_t row = 0;
    std::size_t at = 0;
    std::uint32_t line = 1;
  };

  /// The row of an included file, read once however often it is included.
  Result<std::uint32_t> open(std::string_view name);
  void push(std::uint32_t row);
  Token scan();
  Token scan_line_end(std::string_view text, Cursor& cursor);
  Token scan_string(std::string_view text, Cursor& cursor);
  Token cut(TokenKind kind, std::size_t length);
  Token fail(SourceLine where, std::string what);
  SourceLine here() const;
  bool is_word_character(char c) const;

  Format format_;
  SourceTexts& sources_;
  FileReader& files_;
  std::vector<Cursor> stack_;
  std::size_t includes_ = 0;
  std::optional<Token> peeked_;
  std::optional<Error> error_;
};

}  // namespace playhouse::config
