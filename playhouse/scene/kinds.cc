#include "playhouse/scene/kinds.h"

#include <algorithm>

#include "playhouse/base/assert.h"

namespace playhouse::scene {
namespace {

constexpr std::string_view kBase = "model";  // its words apply to all models

const Word* find_among(std::span<const Word> words, std::string_view name) {
  const auto found = std::ranges::find(words, name, &Word::name);
  return found == words.end() ? nullptr : &*found;
}

}  // namespace

const Kind* find_kind(std::string_view name) {
  const auto found = std::ranges::find(kinds(), name, &Kind::name);
  return found == kinds().end() ? nullptr : &*found;
}

const Kind* find_entity(std::string_view name) {
  const Kind* kind = find_kind(name);
  const bool has_brackets = kind && kind->entity != EntityForm::kWorld && kind->entity != EntityForm::kTrait;
  return has_brackets ? kind : nullptr;
}

const Kind* find_model_type(std::string_view name) {
  const Kind* kind = find_kind(name);
  return kind && kind->entity == EntityForm::kModel ? kind : nullptr;
}

const Kind& world_kind() {
  const auto found = std::ranges::find(kinds(), EntityForm::kWorld, &Kind::entity);
  PLAYHOUSE_ASSERT(found != kinds().end());
  return *found;
}

PlainDesc unsaid(const Kind& kind, bool at_top) {
  PlainDesc desc;
  desc.size = kind.size;
  desc.color = kind.color;
  desc.gui_move = at_top;
  return desc;
}

bool is_part_of(const Kind& part, const Kind& model) {
  return part.entity == EntityForm::kPart && (part.inside == kBase || part.inside == model.name);
}

std::span<const Word> common_words(const Kind& kind) {
  if (kind.entity != EntityForm::kModel || kind.name == kBase) return {};
  return find_kind(kBase)->words;
}

const Word* find_word(const Kind& kind, std::string_view name) {
  const Word* common = find_among(common_words(kind), name);
  return common ? common : find_among(kind.words, name);
}

}  // namespace playhouse::scene
