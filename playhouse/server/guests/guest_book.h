#pragma once

/// GuestBook: who may do what on a server: roles, tokens and their rights, for Player clients, pages and observers.
/// docs/guests.md.

#include <array>
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
#include <utility>
#include <vector>

#include "playhouse/base/monotonic.h"

namespace playhouse::server {

class Server;

enum class GuestRole : std::uint8_t { kObserver, kDriver, kHuman, kAdmin };

/// The words for them in a file of guests, in that order.
inline constexpr std::array<std::string_view, 4> kGuestRoles = {"observer", "driver", "human", "admin"};

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
  /// wrong tokens a network has one try a second, right or wrong, but for right tokens that are too long to be
  /// guessed; each wrong one is logged.
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
/// Letters of a token that nobody guesses, so that others of its network, or who forges its address, cannot keep it out:
/// 20 of 32 are 100 bits.
inline constexpr std::size_t kUnguessableLetters = 20;
/// Networks whose wrong tokens are remembered.
inline constexpr std::size_t kGuessingNetworks = 4096;

/// True for 8 to 32 letters, digits, - and _.
bool is_token(std::string_view text);

/// The same for a key that everybody shares, of 32 letters at most, as AUTH of Player has room for.
bool is_key(std::string_view text);
inline constexpr std::string_view kInvalidKey = "invalid key: 8 to 32 letters, digits, - and _ are valid";

/// Who has the key is an admin, and nobody else is admitted; everybody if it is empty.
GuestBook book_of_key(std::string key);

/// Player clients have the rights of their guests. No effect for a book without guests. Before the server runs.
void admit_guests(Server& server, const GuestBook& guests);

}  // namespace playhouse::server
