#include "playhouse/app/guest_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "playhouse/app/whole_file.h"
#include "playhouse/web_server/guests.h"

namespace playhouse::app {

Result<server::GuestBook> read_guests(const Serving& serving) {
  if (serving.guests.empty()) return server::book_of_key(serving.key);
  const Result<std::string> text = read_file(serving.guests);
  if (!text) return text.error();
  Result<std::vector<server::Guest>> guests = web_server::parse_guests(*text, serving.guests);
  if (!guests) return guests.error();
  return server::GuestBook(std::move(*guests));
}

std::string client_place(const std::string& host, std::uint16_t port, const Serving& serving) {
  std::vector<std::string> ways;
  if (serving.is_encrypted()) ways.push_back("TLS");
  if (serving.udp) ways.push_back("also UDP");
  if (serving.multicast) ways.push_back("data also to " + net::to_text(*serving.multicast));
  if (!serving.unix_folder.empty()) ways.push_back(fmt::format("also {}/{}", serving.unix_folder, port));
  return fmt::format("Player clients: {}:{}{}", host, port,
                     ways.empty() ? "" : fmt::format(" ({})", fmt::join(ways, ", ")));
}

std::vector<std::string> guest_places(const server::GuestBook& guests, const std::string& host,
                                      std::optional<std::uint16_t> web_port, bool encrypted) {
  std::vector<std::string> lines;
  const std::string page =
      web_port ? fmt::format("{}://{}:{}/", encrypted ? "https" : "http", host, *web_port) : "";
  if (web_port) lines.push_back("web page: " + page);
  for (const server::Guest& guest : guests.guests()) {
    const bool has_token = guest.token != "*";
    const std::string who = has_token && !guest.name.empty()
                                ? fmt::format("{} ({})", guest.name, name_of(guest.role))
                                : std::string(name_of(guest.role));
    if (web_port) {
      lines.push_back(
          fmt::format("  {}: {}{}{}", who, page, has_token ? "#" : "", has_token ? guest.token : ""));
    } else {
      lines.push_back(fmt::format("  {}: {}", who, has_token ? "--token " + guest.token : "no token"));
    }
  }
  return lines;
}

}  // namespace playhouse::app
