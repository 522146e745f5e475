#pragma once

/// Guests: access control of the page: roles, tokens and their rights. A guest file has a
/// line for each: role, token and name; a guest's link contains the token. docs/guests.md.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/monotonic.h"
#include "playhouse/base/result.h"

namespace playhouse::web_server {

enum class GuestRole : std::uint8_t { kObserver, kDriver, kHuman, kAdmin };

std::string_view name_of(GuestRole role);

/// Permissions beyond watching.
struct GuestRights {
  bool drives = false;   // any robot
  bool joins = false;    // has an avatar, drives it and speaks
  bool manages = false;  // pauses, rewinds, adds, moves, removes, saves; mutes and kicks others
};

GuestRights rights_of(GuestRole role);

struct Guest {
  GuestRole role = GuestRole::kObserver;
  std::string token;  // "*": guests without a token
  std::string name;   // display name; empty: chosen by the guest
};

/// Access list of a run, with those kicked. A handle: copies share one list, so
/// that a kick, and who guesses, count on all transports. Any thread.
class GuestBook {
 public:
  using Clock = std::function<double()>;  // monotonic seconds; any thread

  /// Without guests everybody is admitted, as an admin.
  GuestBook(std::vector<Guest> guests = {}, Clock clock = monotonic_seconds);
  GuestBook(std::initializer_list<Guest> guests) : GuestBook(std::vector<Guest>(guests)) {}

  /// The guest with this token ("*": none) from this peer, "address:port"; none if not admitted.
  /// Kicked guests are rejected: by token, or by address if the token is shared by all. After kGuesses
  /// wrong tokens a network has one try a second, right or wrong; each wrong one is logged.
  std::optional<Guest> admit(const std::string& token, const std::string& peer) const;
  /// True if the guest was kicked: by its token, or by its network if it has none or there is no list.
  bool is_sent_out(const std::string& token, const std::string& peer) const;
  /// Kicks the guest with this token.
  void send_out(const std::string& token);
  /// Kicks whoever comes from this peer's network without a token.
  void send_out_network(const std::string& peer);

  const std::vector<Guest>& guests() const { return book_->guests; }

 private:
  /// Wrong tokens of a network that count yet, at this time; one is forgotten a second.
  struct Guesses {
    double count = 0;
    double at = 0;  // s
  };
  struct Book {
    std::vector<Guest> guests;
    Clock clock;
    std::mutex mutex;                             // guards the following
    std::set<std::string, std::less<>> sent_out;  // tokens, and networks of guests without one
    std::map<std::string, Guesses> guesses;       // by network
  };
  static bool may_guess(Book& book, const std::string& network);
  static void count_wrong(Book& book, const std::string& network);
  std::shared_ptr<Book> book_;
};

/// Message to a kicked guest, at the kick and on later attempts.
inline constexpr const char* kSentOut = "an admin has sent you out";

/// Wrong tokens at once from one network.
inline constexpr int kGuesses = 20;
/// Networks whose wrong tokens are remembered.
inline constexpr std::size_t kGuessingNetworks = 4096;

/// Limit on the size of a guest file.  [B]
inline constexpr std::size_t kGuestFileBytes = 1 << 20;

/// Parses `role token [name]` lines; # begins a comment, and token
/// ? is replaced by a random one. Fails with "path:line: what".
Result<std::vector<Guest>> parse_guests(std::string_view text, const std::string& path);

/// True for 8 to 128 letters, digits, - and _.
bool is_token(std::string_view text);

/// 26 letters and digits: 130 bits of entropy from the system.
std::string random_token();

}  // namespace playhouse::web_server
