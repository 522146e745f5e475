#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/json_or_null.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/scene/text/vocabulary.h"

namespace playhouse::app {
namespace {

using scene::Kind;
using scene::KindInterface;
using scene::Word;

constexpr std::array<std::string_view, 4> kUses = {"read", "silent", "later", "old"};

std::string_view name_of(scene::Support use) {
  return kUses.at(static_cast<std::size_t>(use));
}

std::string json_of(const Word& word) {
  return fmt::format(
      R"({{"name":{},"use":{},"type":{},"form":{},"unit":{},"default":{},"default_told":{},"limits":{},"doc":{},"instead":{}}})",
      json_or_null(word.name), json_or_null(name_of(word.use)), json_or_null(word.type),
      json_or_null(word.form), json_or_null(word.unit), json_or_null(word.otherwise), json_or_null(word.told),
      json_or_null(word.limits), json_or_null(word.doc), json_or_null(word.instead));
}

std::string json_of(const KindInterface& interf) {
  return fmt::format(R"({{"name":{},"index":{},"when":{},"listed_when":{}}})", json_or_null(interf.name),
                     json_or_null(name_of(interf.index)), json_or_null(name_of(interf.when)),
                     json_or_null(name_of(interf.listed)));
}

/// Default size, colour and solidity of a model.
std::string body_of(const Kind& kind) {
  if (kind.entity != scene::EntityForm::kModel) return "null";
  return fmt::format(R"({{"size":[{},{},{}],"color":[{},{},{},{}],"solid":{}}})", kind.size.x, kind.size.y,
                     kind.size.z, kind.color.r, kind.color.g, kind.color.b, kind.color.a, kind.solid);
}

void print_json(const Kind& kind) {
  fmt::print(
      R"({{"name":{},"entity":{},"inside":{},"simulated":{},"doc":{},"body":{},"interfaces":{},"words":{}}})"
      "\n",
      json_or_null(kind.name), json_or_null(name_of(kind.entity)), json_or_null(kind.inside), kind.simulated,
      json_or_null(kind.doc), body_of(kind),
      json_list(kind.interfaces, [](const auto& i) { return json_of(i); }),
      json_list(kind.words, [](const auto& w) { return json_of(w); }));
}

void print_line(const Kind& kind) {
  fmt::print("{:<15} {}{}\n", kind.name, kind.doc, kind.simulated ? "" : " Not simulated yet.");
}

/// Syntax of a word's value.
std::string value_of(const Word& word) {
  const std::string form(word.form.empty() ? word.type : word.form);
  return word.unit.empty() ? form : fmt::format("{} ({})", form, word.unit);
}

std::string meaning_of(const Word& word) {
  std::string text(word.doc);
  if (!word.limits.empty()) text += fmt::format(" Limits: {}.", word.limits);
  const std::string_view otherwise = word.otherwise.empty() ? word.told : word.otherwise;
  return otherwise.empty() ? text : fmt::format("{} Default: {}.", text, otherwise);
}

void print_words(const Kind& kind, scene::Support use, std::string_view title) {
  std::size_t width = 0;
  for (const Word& word : kind.words) width = std::max(width, word.use == use ? word.name.size() : 0);
  if (width == 0) return;
  fmt::print("\n{}:\n", title);
  for (const Word& word : kind.words) {
    if (word.use != use) continue;
    if (word.type.empty()) {
      fmt::print("  {}\n", word.instead.empty() ? std::string(word.name)
                                                : fmt::format("{:<{}} {}", word.name, width, word.instead));
    } else {
      fmt::print("  {:<{}} {}\n  {:<{}} {}\n", word.name, width, value_of(word), "", width, meaning_of(word));
    }
  }
}

void print_page(const Kind& kind) {
  print_line(kind);
  for (const KindInterface& interf : kind.interfaces) fmt::print("{:<15} interface {}\n", "", interf.name);
  print_words(kind, scene::Support::kRead, "Words");
  print_words(kind, scene::Support::kLater, "Words that are not simulated yet");
  print_words(kind, scene::Support::kSilent, "Words without effect");
  print_words(kind, scene::Support::kOld, "Words of older versions, and what to write");
  if (!scene::common_words(kind).empty())
    fmt::print("\nBesides, it has the words of every model: playhouse kinds model\n");
  for (const Kind& part : scene::kinds()) {
    if (part.inside == kind.name) fmt::print("\nInside it: playhouse kinds {}\n", part.name);
  }
}

}  // namespace

int kinds(const KindsOptions& options) {
  if (options.name.empty()) {
    for (const Kind& kind : scene::kinds()) options.json ? print_json(kind) : print_line(kind);
    return kDone;
  }
  const Kind* kind = scene::find_kind(options.name);
  if (kind == nullptr) {
    const std::string_view others[] = {scene::world_kind().name};
    return fail({"", fmt::format("unknown kind {}{}; playhouse kinds lists all", in_quotes(options.name),
                                 scene::what_instead(options.name, others))},
                kUsage);
  }
  options.json ? print_json(*kind) : print_page(*kind);
  return kDone;
}

}  // namespace playhouse::app
