#include "playhouse/record/selection.h"

#include <algorithm>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/base/split.h"
#include "playhouse/record/messages.h"

namespace playhouse::record {
namespace {

constexpr std::string_view kPoses = "poses";

std::vector<std::string_view> words() {
  std::vector<std::string_view> words{"ranger", kSpeechWord, kPoses};
  for (const TableMessages& table : table_messages()) words.push_back(table.topic);
  return words;
}

}  // namespace

Result<Selection> Selection::parse(std::string_view text) {
  Selection selection;
  selection.everything_ = false;
  const std::vector<std::string_view> known = words();
  for (const std::string_view entry : split(text, ',')) {
    const std::size_t at = entry.find('@');
    const std::string_view kind = entry.substr(0, at);
    const std::string_view name = at == std::string_view::npos ? "" : entry.substr(at + 1);
    if (kind.empty() && name.empty())
      return Error{{}, "invalid entry " + in_quotes(entry) + ": a kind or @NAME is valid"};
    if (!kind.empty() && std::ranges::find(known, kind) == known.end())
      return Error{{},
                   "no kind that can be recorded is called " + in_quotes(kind) + did_you_mean(kind, known)};
    if (at != std::string_view::npos && name.empty())
      return Error{{}, "a name is missing behind @ in " + in_quotes(entry)};
    if (kind != kPoses) selection.entries_.push_back({std::string(kind), std::string(name)});
  }
  return selection;
}

bool Selection::has(const world::World& world, world::ModelRow model, std::string_view kind) const {
  if (everything_) return true;
  const auto is_in = [&](const std::string& name) {
    for (world::ModelRow row = model; row; row = world.models.parent[row])
      if (world.name(row) == name || world.alias(row) == name) return true;
    return false;
  };
  return std::ranges::any_of(entries_, [&](const Selector& entry) {
    return (entry.kind.empty() || entry.kind == kind) && (entry.name.empty() || is_in(entry.name));
  });
}

std::vector<std::string> Selection::unknown_names(const world::World& world) const {
  std::vector<std::string> unknown;
  for (const Selector& entry : entries_)
    if (!entry.name.empty() && !world.find(entry.name)) unknown.push_back(entry.name);
  return unknown;
}

}  // namespace playhouse::record
