#include "playhouse/app/discovery/found_servers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netdb.h>

#include <algorithm>
#include <functional>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/commands/json_or_null.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"

namespace playhouse::app {
namespace {

using discovery::FoundServer;

constexpr double kBrowseSeconds = 3;

/// True if the name has an address, as it is one or by the system's name service.
bool is_host(const std::string& name) {
  addrinfo* found = nullptr;
  if (getaddrinfo(name.c_str(), nullptr, nullptr, &found) != 0) return false;
  freeaddrinfo(found);
  return true;
}

std::string place_of(const FoundServer& server) {
  const bool is_ipv6 = server.address.find(':') != std::string::npos;
  return fmt::format("{}{}{}:{}", is_ipv6 ? "[" : "", server.address, is_ipv6 ? "]" : "", server.port);
}

bool has_robot(const FoundServer& server, const std::string& name) {
  return std::ranges::find(server.texts.robots, name) != server.texts.robots.end();
}

/// The only one that fits; none if there is none. Fails with where they are if there are several.
Result<std::optional<client::Address>> only_one(const std::string& name,
                                                const std::vector<FoundServer>& servers,
                                                const std::function<bool(const FoundServer&)>& fits) {
  std::vector<std::string> places;
  std::optional<client::Address> address;
  for (const FoundServer& server : servers) {
    if (!fits(server)) continue;
    address = client::Address{server.address, server.port};
    places.push_back(place_of(server));
  }
  if (places.size() > 1)
    return Error{"",
                 fmt::format("{} is at {}: name one of them", in_quotes(name), fmt::join(places, " and "))};
  return address;
}

std::string json_line(const FoundServer& server) {
  return fmt::format(
      R"({{"server":{},"host":{},"port":{},"tls":{},"guests":{},"robots":{}}})", json_or_null(server.name),
      json_or_null(server.address), server.port, server.texts.encrypted, server.texts.has_guests,
      json_list(server.texts.robots, [](const std::string& robot) { return json_or_null(robot); }));
}

}  // namespace

Result<std::vector<FoundServer>> announced_servers() {
  return discovery::browse(kBrowseSeconds);
}

std::string and_of_network(std::string none, const Result<std::vector<FoundServer>>& servers) {
  return servers ? none : none + "; " + servers.error().text;
}

Error NamedServer::explain(const Error& why) const {
  return not_announced.empty() ? why : Error{why.where, why.text + "; " + not_announced};
}

Result<NamedServer> reach_server(const std::string& text) {
  const Result<client::Address> address = parse_server(text);
  if (address && is_host(address->host)) return NamedServer{*address, {}};
  const Result<std::vector<FoundServer>> servers = announced_servers();
  const std::vector<FoundServer> known = servers ? *servers : std::vector<FoundServer>();
  auto found = only_one(text, known, [&](const FoundServer& server) { return server.name == text; });
  if (found && !*found)
    found = only_one(text, known, [&](const FoundServer& server) { return has_robot(server, text); });
  if (!found) return found.error();
  if (*found) return NamedServer{**found, {}};
  if (!address) return address.error();
  return NamedServer{*address,
                     and_of_network("no server or robot " + in_quotes(text) + " is announced", servers)};
}

Result<NamedServer> server_of_robot(const std::string& robot) {
  const Result<client::Address> own = parse_server("");
  if (!own) return own.error();
  const Result<std::vector<FoundServer>> servers = announced_servers();
  const auto found = only_one(robot, servers ? *servers : std::vector<FoundServer>(),
                              [&](const FoundServer& server) { return has_robot(server, robot); });
  if (!found) return found.error();
  if (*found) return NamedServer{**found, {}};
  return NamedServer{*own, and_of_network("no server announces a robot " + in_quotes(robot), servers)};
}

void print_servers(const std::vector<FoundServer>& servers, bool json) {
  for (const FoundServer& server : servers) {
    if (json) {
      fmt::print("{}\n", json_line(server));
      continue;
    }
    std::vector<std::string> robots;
    for (const std::string& robot : server.texts.robots) robots.push_back(escaped(robot));
    fmt::print("{:<21} {:<20} {}{}{}\n", place_of(server), escaped(server.name),
               server.texts.encrypted ? "(TLS) " : "", server.texts.has_guests ? "(guests) " : "",
               fmt::join(robots, ", "));
  }
}

int list_servers(bool json) {
  const Result<std::vector<FoundServer>> servers = announced_servers();
  if (!servers) return fail(servers.error());
  print_servers(*servers, json);
  return kDone;
}

}  // namespace playhouse::app
