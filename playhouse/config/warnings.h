#pragma once

/// The warnings of one load, in order. Of each kind the first
/// limits::kWarningsOfAKind are listed and the rest counted, so that a file
/// full of errors costs no more than a good one and every kind is still shown.

#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/text/source_text.h"

namespace playhouse::config {

enum class Warning : std::uint8_t { kUnknownWord, kNoEffect, kColor, kName, kMacro, kShape, kValue };
inline constexpr std::size_t kWarningKinds = 7;

class Warnings {
 public:
  explicit Warnings(const SourceTexts& sources) : sources_(&sources) {}

  /// Duplicates, such as those of a macro line instantiated several times, are dropped.
  void add(Warning kind, SourceLine where, std::string text) {
    add(kind, where, std::move(text), [] { return std::string(); });
  }
  /// `hint()` computes the suggestion: the search is
  /// expensive, so it is called only for lines that are kept.
  template <std::invocable Hint>
  void add(Warning kind, SourceLine where, std::string text, Hint hint) {
    std::string line = sources_->at(where) + ": " + text;
    const bool known = is_known(line);
    const bool here = where.file == watched_.file && where.line == watched_.line;
    news_ += !known || here ? 1 : 0;
    if (known || !has_room(kind)) return;
    const std::string tail = hint();
    lines_.push_back(std::move(line) + tail);
    if (kind == Warning::kUnknownWord && !tail.empty() && slip_.empty()) slip_ = lines_.back();
  }

  /// The same for a feature `what` of older versions: one
  /// line at its first use, with the number of further lines.
  void add_old(const void* what, SourceLine where, std::string text);

  /// The first unknown word similar to a known one, to be listed with the errors of a load:
  /// such a typo often causes a later error, and warnings are not shown when the load fails.
  std::optional<Error> slip() const;

  /// Number of warnings that are new, or of line `watched`. If there are none,
  /// repeating what was read would give none either, wherever it stands.
  std::size_t news() const { return news_; }
  void watch(SourceLine watched) { watched_ = watched; }

  /// All lines, plus one for each kind with more.
  std::vector<std::string> take();

 private:
  bool is_known(std::string_view line) const;
  /// Counts a warning of a kind; false at its limit.
  bool has_room(Warning kind);

  const SourceTexts* sources_;
  std::vector<std::string> lines_;
  std::string slip_;
  std::size_t news_ = 0;
  SourceLine watched_;
  std::array<std::size_t, kWarningKinds> counts_{};
  /// An old feature: its row in lines_ and the source lines that use it.
  struct Old {
    std::size_t row = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> at;
  };
  std::map<const void*, Old> old_;
};

}  // namespace playhouse::config
