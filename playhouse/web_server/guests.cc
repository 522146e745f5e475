#include "playhouse/web_server/guests.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/replicate/generated/person_name.h"

namespace playhouse::web_server {
namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kSpace, end);
  }
  return words;
}

/// Error in a line; empty if it is valid.
std::string fault_of(const std::vector<std::string_view>& words) {
  if (std::ranges::find(server::kGuestRoles, words[0]) == server::kGuestRoles.end())
    return "invalid role " + in_quotes(words[0]) + ": observer, driver, human and admin are valid" +
           did_you_mean(words[0], server::kGuestRoles);
  if (words.size() < 2)
    return "a token is missing: role token [name]; ? makes one, * is for whoever has no token";
  if (words.size() > 3) return "more than role, token and name";
  const std::string_view token = words[1];
  if (token != "*" && token != "?" && !server::is_token(token))
    return fmt::format("invalid token: {} to {} letters, digits, - and _ are valid", limits::kTokenBytesLeast,
                       limits::kTokenBytes);
  if (words.size() < 3) return {};
  if (token == "*") return "* is for everybody without a token, who cannot all have one name";
  if (!replicate::is_person_name(words[2]))
    return fmt::format("invalid name {}: valid are {}", in_quotes(words[2]), replicate::kPersonNameRule);
  return {};
}

}  // namespace

Result<std::vector<server::Guest>> parse_guests(std::string_view text, const std::string& path) {
  if (text.size() > kGuestFileBytes) return Error{escaped(path), "more than 1 MiB of guests"};
  std::vector<server::Guest> guests;
  std::set<std::string, std::less<>> tokens;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty()) continue;
    const std::string where = escaped(path) + ":" + std::to_string(number);
    if (std::string fault = fault_of(words); !fault.empty()) return Error{where, std::move(fault)};
    server::Guest guest{static_cast<server::GuestRole>(std::ranges::find(server::kGuestRoles, words[0]) -
                                                       server::kGuestRoles.begin()),
                        words[1] == "?" ? random_token() : std::string(words[1]),
                        words.size() > 2 ? std::string(words[2]) : ""};
    if (!tokens.insert(guest.token).second) return Error{where, "another line has this token"};
    guests.push_back(std::move(guest));
  }
  if (guests.empty()) return Error{escaped(path), "no guest is listed: a line is role token [name]"};
  return guests;
}

std::string random_token() {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz234567";
  constexpr std::size_t kTokenLetters = 26;  // 5 bits each
  std::array<std::uint8_t, kTokenLetters> bytes;
  const ssize_t got = getrandom(bytes.data(), bytes.size(), 0);
  PLAYHOUSE_ASSERT(got == static_cast<ssize_t>(bytes.size()));
  std::string token;
  for (const std::uint8_t byte : bytes) token += kLetters[byte % kLetters.size()];
  return token;
}

}  // namespace playhouse::web_server
