#pragma once

/// Guests: who may open the page, and what each may do. A file has a line for each: role, token and name; the
/// link by which somebody comes carries the token. docs/guests.md.

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::web_server {

enum class Role : std::uint8_t { kObserver, kDriver, kHuman, kAdmin };

std::string_view name_of(Role role);

/// What a role may do besides looking.
struct Rights {
  bool drives = false;   // any robot
  bool joins = false;    // has a body, drives it and speaks
  bool manages = false;  // pauses, rewinds, adds, moves, removes and saves; mutes others and sends them out
};

Rights rights_of(Role role);

struct Guest {
  Role role = Role::kObserver;
  std::string token;  // "*": whoever has none
  std::string name;   // what they are called; empty: as they wish
};

/// Who may come to a run, and who was sent out of it. A handle: copies speak of the same book, so that who
/// was sent out of the page does not come back through another transport. Thread: one.
class GuestBook {
 public:
  /// No guests: everybody may come, as an admin.
  GuestBook(std::vector<Guest> guests = {});
  GuestBook(std::initializer_list<Guest> guests) : GuestBook(std::vector<Guest>(guests)) {}

  /// Who comes with this token ("*": with none) from this peer, "address:port"; nobody where they may not.
  /// One who was sent out is not let in again: by the token, or by the address where everybody has the same.
  std::optional<Guest> admit(const std::string& token, const std::string& peer) const;
  /// Whether that is why nobody is let in.
  bool is_sent_out(const std::string& token, const std::string& peer) const;
  /// Sends out whoever has this token, or comes from the peer's network where they have none.
  void send_out(const std::string& token, const std::string& peer);

  const std::vector<Guest>& guests() const { return book_->guests; }

 private:
  struct Book {
    std::vector<Guest> guests;
    std::set<std::string, std::less<>> sent_out;  // tokens, and networks of those without one
  };
  std::shared_ptr<Book> book_;
};

/// What somebody reads who was sent out, then and when they come again.
inline constexpr const char* kSentOut = "an admin has sent you out";

/// Longest file of guests.  [B]
inline constexpr std::size_t kGuestFileBytes = 1 << 20;

/// Reads `role token [name]` lines; # begins a comment, and the token ? is made at random. Fails with
/// "path:line: what".
Result<std::vector<Guest>> parse_guests(std::string_view text, const std::string& path);

/// 26 letters and digits, 130 bits at random from the system.
std::string random_token();

}  // namespace playhouse::web_server
