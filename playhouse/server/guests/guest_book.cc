#include "playhouse/server/guests/guest_book.h"

#include <algorithm>
#include <array>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/server/server.h"
#include "playhouse/wire/auth_key.h"

namespace playhouse::server {
namespace {

bool is_letter(unsigned char c) {
  return (c | 0x20) >= 'a' && (c | 0x20) <= 'z';
}
/// Characters of tokens, which are parts of links.
bool is_word(std::string_view text) {
  return std::ranges::all_of(
      text, [](unsigned char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

}  // namespace

bool is_token(std::string_view text) {
  return text.size() >= limits::kTokenBytesLeast && text.size() <= limits::kTokenBytes && is_word(text);
}

static_assert(limits::kTokenBytesLeast == 8 && wire::kAuthKeyBytes == 32, "kInvalidKey says so");

bool is_key(std::string_view text) {
  return text.size() <= wire::kAuthKeyBytes && is_token(text);
}

std::string_view name_of(GuestRole role) {
  return kGuestRoles[static_cast<std::size_t>(role)];
}

GuestRights rights_of(GuestRole role) {
  if (role == GuestRole::kAdmin) return {.drives = true, .joins = true, .manages = true};
  return {.drives = role == GuestRole::kDriver, .joins = role == GuestRole::kHuman, .manages = false};
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
  if (is_known && token.size() >= kUnguessableLetters) return *guest;
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

GuestBook book_of_key(std::string key) {
  if (key.empty()) return {};
  return {{.role = GuestRole::kAdmin, .token = std::move(key), .name = {}}};
}

void admit_guests(Server& server, const GuestBook& guests) {
  if (guests.guests().empty()) return;
  server.admit_by(
      [guests](const std::string& token, const std::string& peer) -> std::optional<device::Rights> {
        const std::optional<Guest> guest = guests.admit(token, peer);
        if (!guest) return std::nullopt;
        const GuestRights rights = rights_of(guest->role);
        return device::Rights{.reads = true, .drives = rights.drives, .manages = rights.manages};
      });
}

}  // namespace playhouse::server
