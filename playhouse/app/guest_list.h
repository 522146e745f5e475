#pragma once

/// The access list of a program (--guests, docs/guests.md): read once, and given to every server it holds for.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/app/commands/options.h"
#include "playhouse/base/result.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::app {

/// Reads the guest file, or admits who has the key, as an admin; with neither everybody is. Fails if the file is
/// invalid or admits nobody.
Result<server::GuestBook> read_guests(const Serving& serving);

/// "Player clients: HOST:PORT", and " (TLS)", " (also UDP)" and the like if so.
std::string client_place(const std::string& host, std::uint16_t port, const Serving& serving);

/// "web page: http://HOST:PORT/" (https with TLS), if there is one, and a line for each guest: a link, or a token.
std::vector<std::string> guest_places(const server::GuestBook& guests, const std::string& host,
                                      std::optional<std::uint16_t> web_port, bool encrypted);

}  // namespace playhouse::app
