#include "playhouse/config/warnings.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/finding.h"
#include "playhouse/base/limits.h"

namespace playhouse::config {
namespace {

/// Subjects of the counts, by kind.
constexpr std::array<std::string_view, kWarningKinds> kSubjects = {
    "unknown words",
    "words without effect",
    "unknown colors",
    "names that were given already",
    "macros that are defined already",
    "bodies that are not what they seem",
    "values out of range or without effect",
};

}  // namespace

bool Warnings::is_known(std::string_view line) const {
  return std::ranges::any_of(lines_, [line](const std::string& known) { return known.starts_with(line); });
}

void Warnings::add_old(const void* what, SourceLine where, std::string text) {
  const auto [old, is_new] = old_.try_emplace(what);
  if (is_new) {
    old->second.row = lines_.size();
    lines_.push_back(sources_->at(where) + ": " + std::move(text));
  }
  const bool here = where.file == watched_.file && where.line == watched_.line;
  news_ += old->second.at.emplace(where.file, where.line).second || here ? 1 : 0;
}

bool Warnings::has_room(Warning kind) {
  return counts_[static_cast<std::size_t>(kind)]++ < limits::kWarningsOfAKind;
}

std::optional<Error> Warnings::slip() const {
  if (slip_.empty()) return std::nullopt;
  return as_warning(placed(slip_));
}

std::vector<std::string> Warnings::take() {
  for (const auto& [what, old] : std::exchange(old_, {})) {
    const std::size_t more = old.at.size() - 1;
    if (more > 0)
      lines_[old.row] += " (and on " + std::to_string(more) + (more == 1 ? " line more)" : " lines more)");
  }
  for (std::size_t kind = 0; kind < kWarningKinds; ++kind) {
    if (counts_[kind] <= limits::kWarningsOfAKind) continue;
    lines_.push_back(escaped(sources_->file_names().front()) + ": and " +
                     std::to_string(counts_[kind] - limits::kWarningsOfAKind) + " more " +
                     std::string(kSubjects[kind]));
  }
  counts_ = {};
  return std::exchange(lines_, {});
}

}  // namespace playhouse::config
