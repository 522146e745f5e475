#include "playhouse/app/guest_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "playhouse/app/whole_file.h"

namespace playhouse::app {

Result<web_server::GuestBook> read_guests(const Serving& serving) {
  if (!serving.key.empty())
    return web_server::GuestBook({{.role = web_server::GuestRole::kAdmin, .token = serving.key, .name = {}}});
  if (serving.guests.empty()) return web_server::GuestBook();
  const Result<std::string> text = read_file(serving.guests);
  if (!text) return text.error();
  Result<std::vector<web_server::Guest>> guests = web_server::parse_guests(*text, serving.guests);
  if (!guests) return guests.error();
  return web_server::GuestBook(std::move(*guests));
}

void admit_guests(server::Server& server, const web_server::GuestBook& guests) {
  if (guests.guests().empty()) return;
  server.admit_by(
      [guests](const std::string& token, const std::string& peer) -> std::optional<device::Rights> {
        const std::optional<web_server::Guest> guest = guests.admit(token, peer);
        if (!guest) return std::nullopt;
        const web_server::GuestRights rights = web_server::rights_of(guest->role);
        return device::Rights{.reads = true, .drives = rights.drives, .manages = rights.manages};
      });
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

std::vector<std::string> guest_places(const web_server::GuestBook& guests, const std::string& host,
                                      std::optional<std::uint16_t> web_port, bool encrypted) {
  std::vector<std::string> lines;
  const std::string page =
      web_port ? fmt::format("{}://{}:{}/", encrypted ? "https" : "http", host, *web_port) : "";
  if (web_port) lines.push_back("web page: " + page);
  for (const web_server::Guest& guest : guests.guests()) {
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
