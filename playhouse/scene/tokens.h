#pragma once

/// Tokens of a Stage world file or a Player configuration file, with included files spliced in. The two
/// formats share their lexical rules but for the characters of a word and the words that mean yes and no.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/scene/source_text.h"

namespace playhouse::scene {

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
  std::string_view text;  // strings without their quotes
  SourceLine where;
};

/// How a token is named in an error: `word "pose"`, `")"`, `the end of the line`.
std::string describe(const Token& token);

/// One pass over a top-level text and all it includes. The texts belong to `sources`, which outlives the
/// tokens.
class TokenStream {
 public:
  /// `row` is the top-level text in `sources`; includes are resolved against its folder, then against the
  /// folder of the file that includes, then looked for in the reader's search path (file_search.h).
  TokenStream(Format format, SourceTexts& sources, FileReader& files, std::uint32_t row);

  /// The next token; after the end or an error always kEnd.
  Token next();
  /// The token next() will return.
  const Token& peek();
  /// Continues with the text of `name`, then after the include statement. Fails on a missing file, a cycle,
  /// more than limits::kIncludeDepth files inside each other and more than limits::kIncludes in all.
  Result<void> include(std::string_view name, SourceLine where);
  /// What stopped the stream, if anything; "bad character" and "unterminated string".
  const std::optional<Error>& error() const { return error_; }

 private:
  struct Cursor {
    std::uint32_t row = 0;
    std::size_t at = 0;
    std::uint32_t line = 1;
  };

  /// The row of an included file, which is read once however often it is included.
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

}  // namespace playhouse::scene
