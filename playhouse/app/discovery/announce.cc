#include "playhouse/app/discovery/announce.h"

#include <utility>

#include "playhouse/base/version.h"
#include "playhouse/discovery/texts.h"
#include "playhouse/net/fair_share.h"

namespace playhouse::app {

bool is_for_others(const std::string& bind) {
  const std::string peer = bind.find(':') == std::string::npos ? bind + ":0" : "[" + bind + "]:0";
  return !net::is_local(peer) && bind != "localhost";
}

std::unique_ptr<discovery::Announcer> announce(const Serving& serving, std::span<const std::uint16_t> ports,
                                               const std::vector<std::string>& robots) {
  constexpr std::size_t kMostPorts = 16;  // a world of many robots has one for each 65,536 of them
  if (ports.empty() || !is_for_others(serving.bind)) return nullptr;
  discovery::ServerTexts texts{serving.is_encrypted(), serving.is_controlled(), robots};
  std::vector<discovery::AnnouncedServer> servers;
  for (const std::uint16_t port : ports.first(std::min(ports.size(), kMostPorts))) {
    servers.push_back({port, discovery::texts_of(texts, version())});
    texts.robots.clear();
  }
  const bool is_ipv6 = serving.bind.find(':') != std::string::npos;
  return std::make_unique<discovery::Announcer>(
      std::move(servers), is_ipv6 ? discovery::AnnouncedFamily::kAny : discovery::AnnouncedFamily::kIpv4);
}

}  // namespace playhouse::app
