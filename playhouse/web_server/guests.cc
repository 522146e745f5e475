#include "playhouse/web_server/guests.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <functional>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/replicate/generated/person_name.h"

namespace playhouse::web_server {
namespace {

constexpr std::array<std::string_view, 4> kRoles = {"observer", "driver", "human", "admin"};

bool is_letter(unsigned char c) {
  return (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
}
/// Characters of tokens, which are parts of links.
bool is_word(std::string_view text) {
  return std::ranges::all_of(
      text, [](unsigned char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

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
  if (std::ranges::find(kRoles, words[0]) == kRoles.end())
    return "invalid role " + in_quotes(words[0]) + ": observer, driver, human and admin are valid" +
           did_you_mean(words[0], kRoles);
  if (words.size() < 2)
    return "a token is missing: role token [name]; ? makes one, * is for whoever has no token";
  if (words.size() > 3) return "more than role, token and name";
  const std::string_view token = words[1];
  if (token != "*" && token != "?" && !is_token(token))
    return fmt::format("invalid token: {} to {} letters, digits, - and _ are valid", limits::kTokenBytesLeast,
                       limits::kTokenBytes);
  if (words.size() < 3) return {};
  if (token == "*") return "* is for everybody without a token, who cannot all have one name";
  if (!replicate::is_person_name(words[2]))
    return fmt::format("invalid name {}: valid are {}", in_quotes(words[2]), replicate::kPersonNameRule);
  return {};
}

}  // namespace

bool is_token(std::string_view text) {
  return text.size() >= limits::kTokenBytesLeast && text.size() <= limits::kTokenBytes && is_word(text);
}

std::string_view name_of(GuestRole role) {
  return kRoles[static_cast<std::size_t>(role)];
}

GuestRights rights_of(GuestRole role) {
  if (role == GuestRole::kAdmin) return {.drives = true, .joins = true, .manages = true};
  return {.drives = role == GuestRole::kDriver, .joins = role == GuestRole::kHuman, .manages = false};
}

Result<std::vector<Guest>> parse_guests(std::string_view text, const std::string& path) {
  if (text.size() > kGuestFileBytes) return Error{escaped(path), "more than 1 MiB of guests"};
  std::vector<Guest> guests;
  std::set<std::string, std::less<>> tokens;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty()) continue;
    const std::string where = escaped(path) + ":" + std::to_string(number);
    if (std::string fault = fault_of(words); !fault.empty()) return Error{where, std::move(fault)};
    Guest guest{static_cast<GuestRole>(std::ranges::find(kRoles, words[0]) - kRoles.begin()),
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

GuestBook::GuestBook(std::vector<Guest> guests, Clock clock) : book_(std::make_shared<Book>()) {
  book_->guests = std::move(guests);
  book_->clock = std::move(clock);
}

std::optional<Guest> GuestBook::admit(const std::string& token, const std::string& peer) const {
  if (is_sent_out(token, peer)) return std::nullopt;
  if (guests().empty()) return Guest{GuestRole::kAdmin, "*", {}};
  const auto guest = std::ranges::find(guests(), token, &Guest::token);
  const bool is_known = guest != guests().end();
  if (token == "*") return is_known ? std::optional<Guest>(*guest) : std::nullopt;
  const std::string network = net::network_of(peer);
  {
    const std::lock_guard lock(book_->mutex);
    if (!may_guess(*book_, network)) return std::nullopt;
    if (is_known) return *guest;
    count_wrong(*book_, network);
  }
  log::warn("guests: {} gave a wrong token", peer);
  return std::nullopt;
}

/// With the book's mutex.
void GuestBook::count_wrong(Book& book, const std::string& network) {
  if (book.guesses.size() >= kGuessingNetworks && !book.guesses.contains(network))
    book.guesses.erase(
        std::ranges::min_element(book.guesses, {}, [](const auto& each) { return each.second.at; }));
  Guesses& guesses = book.guesses[network];
  guesses = {guesses.count + 1, book.clock()};
}

/// Brings the count of the network up to date. With the book's mutex.
bool GuestBook::may_guess(Book& book, const std::string& network) {
  const auto found = book.guesses.find(network);
  if (found == book.guesses.end()) return true;
  Guesses& guesses = found->second;
  const auto now = book.clock();
  guesses.count = std::max(0.0, guesses.count - (now - guesses.at));
  guesses.at = now;
  return guesses.count <= kGuesses - 1;
}

bool GuestBook::is_sent_out(const std::string& token, const std::string& peer) const {
  // Without a list every token is invented.
  const bool by_network = token == "*" || guests().empty();
  const std::lock_guard lock(book_->mutex);
  return book_->sent_out.contains(by_network ? net::network_of(peer) : token);
}

void GuestBook::send_out(const std::string& token) {
  const std::lock_guard lock(book_->mutex);
  book_->sent_out.insert(token);
}

void GuestBook::send_out_network(const std::string& peer) {
  const std::lock_guard lock(book_->mutex);
  book_->sent_out.insert(net::network_of(peer));
}

}  // namespace playhouse::web_server
