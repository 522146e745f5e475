#pragma once

/// The texts (TXT record) of a server that is announced by DNS-SD, "key=value" each: docs/discovery.md. What others
/// announce is untrusted, so whatever is longer or more than here is left out.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::discovery {

inline constexpr std::string_view kServiceType = "_player2._tcp";
inline constexpr std::size_t kOneTextBytes = 255;   // of one text, a limit of DNS
inline constexpr std::size_t kAllTextBytes = 1200;  // of all, so that an announcement fits into one packet
inline constexpr std::size_t kMostRobots = 64;      // named in them
inline constexpr std::size_t kMostTexts = 128;      // that are read

/// What clients learn of a server before they connect.
struct ServerTexts {
  bool encrypted = false;           // speaks TLS
  bool has_guests = false;          // may want a token
  std::vector<std::string> robots;  // names; the first ones of many

  friend bool operator==(const ServerTexts&, const ServerTexts&) = default;
};

/// Robots that do not fit are left out, as are those whose names do.
std::vector<std::string> texts_of(const ServerTexts& server, std::string_view version);
ServerTexts from_texts(std::span<const std::string> texts);

}  // namespace playhouse::discovery
