// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

#include <set>
#include <string_view>

#include "playhouse/scene/generated/kind_descs.h"

namespace playhouse::scene {

/// Adds the words with `engine = "arena"` in kinds/ whose values in `from` are not the defaults.
void add_arena_words(const PlainDesc& from, std::set<std::string_view>& words);
void add_arena_words(const WorldDesc& from, std::set<std::string_view>& words);
void add_arena_words(const KindDescs& from, std::set<std::string_view>& words);

}  // namespace playhouse::scene
