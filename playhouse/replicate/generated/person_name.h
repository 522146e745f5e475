// Generated from viewer/commands.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The name of a person who joins a world; valid as the name of a model and of a client.

#include <string_view>

namespace playhouse::replicate {

inline constexpr std::size_t kPersonNameBytes = 24;
inline constexpr std::string_view kPersonNameRule = "1 to 24 letters, digits, - and _, the first one a letter";

constexpr bool is_person_name(std::string_view name) {
  constexpr std::string_view kFirst = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  constexpr std::string_view kRest = "-0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz";
  return !name.empty() && name.size() <= kPersonNameBytes && kFirst.find(name[0]) != kFirst.npos &&
         name.find_first_not_of(kRest) == name.npos;
}

}  // namespace playhouse::replicate
