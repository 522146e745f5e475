#pragma once

/// The warnings of one load, in the order in which they came up. Of each kind the first
/// limits::kWarningsOfAKind are lines and the others a count, so that a file full of faults costs no more
/// than a good one and still shows its reader every kind.

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
#include "playhouse/scene/source_text.h"

namespace playhouse::scene {

enum class Warning : std::uint8_t { kUnknownWord, kNoEffect, kColor, kName, kMacro, kShape, kValue };
inline constexpr std::size_t kWarningKinds = 7;

class Warnings {
 public:
  explicit Warnings(const SourceTexts& sources) : sources_(&sources) {}

  /// What is said of a line already, as of a macro's by an instance before, is not said again.
  void add(Warning kind, SourceLine where, std::string text) {
    add(kind, where, std::move(text), [] { return std::string(); });
  }
  /// `hint()` is the tail of the text: looking for the nearest word costs more than all else, so it is called
  /// for lines that are kept only.
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

  /// The same of something that only older versions had, `what`: one line, of the first line that has it, and
  /// on how many others it is.
  void add_old(const void* what, SourceLine where, std::string text);

  /// The first unknown word that resembles a known one, for those who get the errors of a load: a slip there
  /// often is why something is missing later, and the warnings are not shown when an error ends the load.
  std::optional<Error> slip() const;

  /// How many warnings came up that the load had not given before, or that are of the line `watched`. Where
  /// there is none, the like of what was read gives none either, wherever it stands.
  std::size_t news() const { return news_; }
  void watch(SourceLine watched) { watched_ = watched; }

  /// All lines, and one for each kind that has more.
  std::vector<std::string> take();

 private:
  bool is_known(std::string_view line) const;
  /// Counts one more of a kind.
  bool has_room(Warning kind);

  const SourceTexts* sources_;
  std::vector<std::string> lines_;
  std::string slip_;
  std::size_t news_ = 0;
  SourceLine watched_;
  std::array<std::size_t, kWarningKinds> counts_{};
  /// What is old, with its row in lines_ and the lines of files that have it.
  struct Old {
    std::size_t row = 0;
    std::set<std::pair<std::uint32_t, std::uint32_t>> at;
  };
  std::map<const void*, Old> old_;
};

}  // namespace playhouse::scene
