#pragma once

/// Budget: a resource limit shared by all models of a world, since macros, bitmaps and meshes amplify input.

#include <cstddef>
#include <string>
#include <string_view>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

class Budget {
 public:
  /// "the world holds more than `limit` `what`".
  Budget(std::size_t limit, std::string_view what) : left_(limit), limit_(limit), what_(what) {}

  std::size_t left() const { return left_; }
  /// As much must be left.
  void spend(std::size_t amount) { left_ -= amount; }
  /// Aborts the load, with an error at `where`, if less is left.
  void spend(std::size_t amount, config::SourceLine where, LoadState& state) {
    if (amount > left_) {
      state.end(state.document.error(
          where, "the world holds more than " + std::to_string(limit_) + " " + std::string(what_)));
      return;
    }
    spend(amount);
  }

 private:
  std::size_t left_, limit_;
  std::string_view what_;
};

}  // namespace playhouse::scene
