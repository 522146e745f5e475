#include "playhouse/discovery/browse.h"

#include <avahi-client/client.h>
#include <avahi-client/lookup.h>
#include <avahi-common/address.h>
#include <avahi-common/error.h>
#include <avahi-common/simple-watch.h>
#include <avahi-common/strlst.h>

#include <chrono>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace playhouse::discovery {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> strings_of(AvahiStringList* list) {
  std::vector<std::string> texts;
  for (; list != nullptr && texts.size() < kMostTexts; list = avahi_string_list_get_next(list))
    texts.emplace_back(reinterpret_cast<const char*>(avahi_string_list_get_text(list)),
                       avahi_string_list_get_size(list));
  return texts;
}

struct FreePoll {
  void operator()(AvahiSimplePoll* poll) const { avahi_simple_poll_free(poll); }
};
struct FreeClient {
  void operator()(AvahiClient* client) const { avahi_client_free(client); }
};

struct Search {
  AvahiClient* client = nullptr;
  std::map<std::pair<std::string, std::uint16_t>, FoundServer> found{};  // by name and port
  std::size_t asked = 0, pending = 0;                                    // resolvers
  bool asked_all = false, failed = false;

  bool done() const { return failed || (asked_all && pending == 0); }
};

void resolved(AvahiServiceResolver* resolver, AvahiIfIndex, AvahiProtocol, AvahiResolverEvent event,
              const char* name, const char*, const char*, const char*, const AvahiAddress* address,
              std::uint16_t port, AvahiStringList* texts, AvahiLookupResultFlags, void* self) {
  auto& search = *static_cast<Search*>(self);
  --search.pending;
  if (event == AVAHI_RESOLVER_FOUND && search.found.size() < kMostServers) {
    char text[AVAHI_ADDRESS_STR_MAX];
    avahi_address_snprint(text, sizeof text, address);
    FoundServer& server = search.found[{name, port}];
    if (server.address.empty() || address->proto == AVAHI_PROTO_INET)
      server = {name, text, port, from_texts(strings_of(texts))};
  }
  avahi_service_resolver_free(resolver);
}

void browsed(AvahiServiceBrowser*, AvahiIfIndex interf, AvahiProtocol protocol, AvahiBrowserEvent event,
             const char* name, const char* type, const char* domain, AvahiLookupResultFlags, void* self) {
  auto& search = *static_cast<Search*>(self);
  constexpr std::size_t kMostAsked = 4 * kMostServers;  // one server may be seen by several interfaces
  if (event == AVAHI_BROWSER_NEW && search.asked < kMostAsked) {
    ++search.asked;
    if (avahi_service_resolver_new(search.client, interf, protocol, name, type, domain, AVAHI_PROTO_UNSPEC,
                                   AvahiLookupFlags{}, resolved, self) != nullptr)
      ++search.pending;
  }
  if (event == AVAHI_BROWSER_ALL_FOR_NOW) search.asked_all = true;
  if (event == AVAHI_BROWSER_FAILURE) search.failed = true;
}

void client_changed_while_browsing(AvahiClient*, AvahiClientState state, void* self) {
  if (state == AVAHI_CLIENT_FAILURE) static_cast<Search*>(self)->failed = true;
}

}  // namespace

Result<std::vector<FoundServer>> browse(double seconds) {
  const std::unique_ptr<AvahiSimplePoll, FreePoll> poll(avahi_simple_poll_new());
  if (poll == nullptr) return Error{"", "out of memory"};
  Search search;
  int error = 0;
  const std::unique_ptr<AvahiClient, FreeClient> client(avahi_client_new(
      avahi_simple_poll_get(poll.get()), AvahiClientFlags{}, client_changed_while_browsing, &search, &error));
  if (client == nullptr)
    return Error{"", "cannot look for servers on the network, as there is no Avahi daemon"};
  search.client = client.get();
  if (avahi_service_browser_new(client.get(), AVAHI_IF_UNSPEC, AVAHI_PROTO_UNSPEC,
                                std::string(kServiceType).c_str(), nullptr, AvahiLookupFlags{}, browsed,
                                &search) == nullptr)
    return Error{"", "cannot look for servers on the network: " +
                         std::string(avahi_strerror(avahi_client_errno(client.get())))};
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!search.done() && Clock::now() < end) {
    constexpr int kPatience = 50;  // ms
    if (avahi_simple_poll_iterate(poll.get(), kPatience) != 0) break;
  }
  std::vector<FoundServer> servers;
  for (auto& [key, server] : search.found) servers.push_back(std::move(server));
  return servers;
}

}  // namespace playhouse::discovery
