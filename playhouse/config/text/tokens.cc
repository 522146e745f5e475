#include "playhouse/config/text/tokens.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/config/text/file_search.h"

namespace playhouse::config {
namespace {

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_sign(char c) {
  return c == '+' || c == '-';
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

/// Length of a number at `at`: a run of "+-.0-9", plus an exponent, unlike in the originals.
std::size_t number_length(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && (is_digit(text[end]) || is_sign(text[end]) || text[end] == '.')) ++end;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text.size() && is_sign(text[exponent])) ++exponent;
    if (exponent < text.size() && is_digit(text[exponent])) {
      while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
      end = exponent;
    }
  }
  return end - at;
}

std::string bad_character(char c) {
  std::string what = "unexpected character ";
  if (c > ' ' && c < 127) {
    what += std::string("'") + c + "'";
  } else {
    char hex[8];
    std::snprintf(hex, sizeof hex, "0x%02X", static_cast<unsigned char>(c));
    what += hex;
  }
  if (c == ',' || c == ';') what += " (values are separated by spaces)";
  if (c == '\'') what += " (strings take double quotes)";
  if (c == '=') what += " (a value follows its name after a space)";
  if (c == '{' || c == '}') what += " (sections take parentheses)";
  return what;
}

}  // namespace

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::kLineEnd:
      return "the end of the line";
    case TokenKind::kEnd:
      return "the end of the file";
    case TokenKind::kWord:
      return "the word " + in_quotes(token.text);
    case TokenKind::kString:
      return "the string " + in_quotes(token.text);
    default:
      return in_quotes(token.text);
  }
}

TokenStream::TokenStream(Format format, SourceTexts& sources, FileReader& files, std::uint32_t row)
    : format_(format), sources_(sources), files_(files) {
  push(row);
}

void TokenStream::push(std::uint32_t row) {
  Cursor cursor{row, 0, 1};
  if (sources_.text(row).starts_with("\xEF\xBB\xBF")) cursor.at = 3;  // skips a byte order mark
  stack_.push_back(cursor);
}

SourceLine TokenStream::here() const {
  return {stack_.back().row, stack_.back().line};
}

bool TokenStream::is_word_character(char c) const {
  return is_letter(c) || is_digit(c) || c == '.' || c == '-' || c == '_' || c == '[' || c == ']' ||
         (c == ':' && format_ == Format::kConfiguration);
}

Token TokenStream::next() {
  if (peeked_) {
    const Token token = *peeked_;
    peeked_.reset();
    return token;
  }
  return error_ ? Token{TokenKind::kEnd, {}, here()} : scan();
}

const Token& TokenStream::peek() {
  if (!peeked_) peeked_ = error_ ? Token{TokenKind::kEnd, {}, here()} : scan();
  return *peeked_;
}

Result<std::uint32_t> TokenStream::open(std::string_view name) {
  const std::vector<std::string>& paths = sources_.file_names();
  const std::vector<std::string> folders =
      folders_for(paths[stack_.front().row], paths[stack_.back().row], files_);
  std::string why;
  for (const std::string& folder : folders) {
    const std::string path = resolve(folder, name);
    if (const auto row = sources_.find(path)) {
      if (const Result<void> used = sources_.use_again(*row); !used) return used.error();
      return *row;
    }
    Result<std::string> text = files_.read(path);
    if (text) return sources_.add(path, std::move(*text));
    if (why.empty()) why = text.error().text;
  }
  const auto is_include = [](std::string_view file) { return file.ends_with(".inc"); };
  return Error{{},
               "included file " + in_quotes(resolve(folders.front(), name)) + " " + why +
                   also_not_in(folders, name, files_, is_include)};
}

Result<void> TokenStream::include(std::string_view name, SourceLine where) {
  PLAYHOUSE_ASSERT(!peeked_);
  const std::string at = sources_.at(where);
  if (stack_.size() > static_cast<std::size_t>(limits::kIncludeDepth)) {
    return Error{at, "more than " + std::to_string(limits::kIncludeDepth) + " files include each other"};
  }
  if (++includes_ > limits::kIncludes) {
    return Error{at, "more than " + std::to_string(limits::kIncludes) + " files are included"};
  }
  const Result<std::uint32_t> row = open(name);
  if (!row) return Error{at, row.error().text};
  for (const Cursor& cursor : stack_) {
    if (cursor.row != *row) continue;
    return Error{at, "file " + in_quotes(sources_.file_names()[*row]) + " includes itself"};
  }
  push(*row);
  return {};
}

Token TokenStream::cut(TokenKind kind, std::size_t length) {
  Cursor& cursor = stack_.back();
  const Token token{kind, sources_.text(cursor.row).substr(cursor.at, length), here()};
  cursor.at += length;
  return token;
}

Token TokenStream::fail(SourceLine where, std::string what) {
  error_ = Error{sources_.at(where), std::move(what)};
  return {TokenKind::kEnd, {}, where};
}

Token TokenStream::scan_line_end(std::string_view text, Cursor& cursor) {
  // CR LF and LF CR are one line end, like CR or LF alone.
  const char c = text[cursor.at];
  const bool pair =
      cursor.at + 1 < text.size() && is_line_end(text[cursor.at + 1]) && text[cursor.at + 1] != c;
  const Token token = cut(TokenKind::kLineEnd, pair ? 2 : 1);
  ++cursor.line;
  return token;
}

Token TokenStream::scan_string(std::string_view text, Cursor& cursor) {
  const std::size_t end = text.find_first_of("\"\r\n", cursor.at + 1);
  if (end == std::string_view::npos || text[end] != '"') {
    return fail(here(), "string without its closing quote on this line");
  }
  const Token token{TokenKind::kString, text.substr(cursor.at + 1, end - cursor.at - 1), here()};
  cursor.at = end + 1;
  return token;
}

Token TokenStream::scan() {
  Cursor& cursor = stack_.back();
  const std::string_view text = sources_.text(cursor.row);
  while (cursor.at < text.size() && (text[cursor.at] == ' ' || text[cursor.at] == '\t')) ++cursor.at;
  if (cursor.at < text.size() && text[cursor.at] == '#') {
    cursor.at = std::min(text.find_first_of("\r\n", cursor.at), text.size());
  }
  if (cursor.at >= text.size()) {
    if (stack_.size() == 1) return {TokenKind::kEnd, {}, here()};
    // The end of an included file also ends its last line.
    const Token end{TokenKind::kLineEnd, {}, here()};
    stack_.pop_back();
    return end;
  }
  const char c = text[cursor.at];
  if (is_line_end(c)) return scan_line_end(text, cursor);
  if (c == '"') return scan_string(text, cursor);
  if (c == '(') return cut(TokenKind::kOpen, 1);
  if (c == ')') return cut(TokenKind::kClose, 1);
  if (c == '[') return cut(TokenKind::kTupleOpen, 1);
  if (c == ']') return cut(TokenKind::kTupleClose, 1);
  if (is_digit(c) || is_sign(c) || c == '.') return cut(TokenKind::kNumber, number_length(text, cursor.at));
  if (!is_letter(c)) return fail(here(), bad_character(c));
  std::size_t end = cursor.at;
  while (end < text.size() && is_word_character(text[end])) ++end;
  const std::string_view word = text.substr(cursor.at, end - cursor.at);
  const bool yes_or_no = format_ == Format::kConfiguration &&
                         (word == "true" || word == "false" || word == "yes" || word == "no");
  return cut(yes_or_no ? TokenKind::kBool : TokenKind::kWord, word.size());
}

}  // namespace playhouse::config
