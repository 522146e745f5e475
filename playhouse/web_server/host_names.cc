#include "playhouse/web_server/host_names.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace playhouse::web_server {
namespace {

/// Strips the port of "host:port"; brackets of IPv6 are kept.
std::string_view without_port(std::string_view authority) {
  const std::size_t bracket = authority.find(']');
  return authority.substr(0, authority.find(':', bracket == std::string_view::npos ? 0 : bracket));
}

bool is_address(std::string_view host) {
  in6_addr address;
  if (host.starts_with('[') && host.ends_with(']'))
    return inet_pton(AF_INET6, std::string(host.substr(1, host.size() - 2)).c_str(), &address) == 1;
  return inet_pton(AF_INET, std::string(host).c_str(), &address) == 1;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// For a machine named "robo.lab.example": true for that, "robo" and "robo.local".
bool is_name_of(std::string_view machine, std::string_view host) {
  if (machine.empty()) return false;
  const std::string first(machine.substr(0, machine.find('.')));
  return same_letters(host, machine) || same_letters(host, first) || same_letters(host, first + ".local");
}

std::string machine_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

HostNames::HostNames(std::string machine, std::vector<std::string> further)
    : machine_(machine.empty() ? machine_name() : std::move(machine)), further_(std::move(further)) {}

bool HostNames::has(std::string_view authority) const {
  const std::string_view name = without_port(authority);
  return name == "localhost" || is_address(name) || is_name_of(machine_, name) || is_further(name);
}

bool HostNames::may_control(std::string_view origin, const std::string& host, bool encrypted) const {
  if (origin == "https://" + host) return encrypted || is_further(without_port(host));
  return origin == "http://" + host && !encrypted;
}

bool HostNames::is_further(std::string_view name) const {
  return std::ranges::any_of(further_,
                             [name](const std::string& other) { return same_letters(other, name); });
}

}  // namespace playhouse::web_server
