#include "playhouse/controllers/source_sink.h"

#include <charconv>

#include "playhouse/base/in_quotes.h"
#include "playhouse/world/periods.h"

namespace playhouse::controllers {

Result<void> Source::join(world::World& world, const Post& post) {
  std::int32_t capacity = 1;
  if (!post.arguments.empty()) {
    const std::string& word = post.arguments[0];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), capacity);
    if (error != std::errc() || end != word.data() + word.size() || capacity < 0) {
      return Error{{}, "needs its capacity as a whole number, not " + in_quotes(word)};
    }
  }
  model_.push_back(world.row(post.model));
  capacity_.push_back(capacity);
  update_ticks_.push_back(world::update_ticks(world, model_.back()));
  makes_.push_back(0);
  return {};
}

void Source::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i)
    makes_[i] = world.tick() % update_ticks_[i] == 0 && world.models.flags[model_[i]] < capacity_[i];
}

void Source::deliver(world::World& world) {
  for (const std::uint32_t i : by_id())
    if (makes_[i]) world::add_flags(world, model_[i], 1);
}

Result<void> Sink::join(world::World& world, const Post& post) {
  model_.push_back(world.row(post.model));
  before_.push_back(world.models.flags[model_.back()]);
  received_.push_back(0);
  says_.push_back(0);
  return {};
}

void Sink::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::int32_t flags = world.models.flags[model_[i]];
    says_[i] = flags > before_[i];
    if (says_[i]) received_[i] += static_cast<std::uint64_t>(flags) - static_cast<std::uint64_t>(before_[i]);
    before_[i] = flags;
  }
}

void Sink::deliver(world::World& world) {
  for (const std::uint32_t i : by_id()) {
    if (!says_[i]) continue;
    text_.assign("received ").append(std::to_string(received_[i]));
    world::set_say(world, model_[i], text_);
  }
}

}  // namespace playhouse::controllers
