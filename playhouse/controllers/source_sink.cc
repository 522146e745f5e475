#include "playhouse/controllers/source_sink.h"

#include <charconv>

#include "playhouse/base/in_quotes.h"

namespace playhouse::controllers {

Result<void> Source::join(world::World& world, const Post& post) {
  std::int32_t capacity = 1;
  if (!post.arguments.empty()) {
    const std::string& word = post.arguments[0];
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), capacity);
    if (error != std::errc() || end != word.data() + word.size() || capacity < 0) {
      return Error{{}, "wants its capacity as a whole number, not " + in_quotes(word)};
    }
  }
  model_.push_back(world.row(post.model));
  capacity_.push_back(capacity);
  return {};
}

void Source::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    std::int32_t& flags = world.models.flags[model_[i].index];
    if (flags < capacity_[i]) ++flags;
  }
}

Result<void> Sink::join(world::World& world, const Post& post) {
  model_.push_back(world.row(post.model));
  before_.push_back(world.models.flags[model_.back().index]);
  received_.push_back(0);
  return {};
}

void Sink::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t row = model_[i].index;
    const std::int32_t flags = world.models.flags[row];
    if (flags > before_[i]) {
      received_[i] += static_cast<std::uint64_t>(flags) - static_cast<std::uint64_t>(before_[i]);
      world.models.say.own(row).assign("received ").append(std::to_string(received_[i]));
    }
    before_[i] = flags;
  }
}

}  // namespace playhouse::controllers
