#include "playhouse/discovery/announcer.h"

#include <avahi-client/client.h>
#include <avahi-client/publish.h>
#include <avahi-common/alternative.h>
#include <avahi-common/error.h>
#include <avahi-common/malloc.h>
#include <avahi-common/strlst.h>
#include <avahi-common/thread-watch.h>
#include <avahi-common/timeval.h>
#include <fmt/format.h>

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/discovery/texts.h"

namespace playhouse::discovery {
namespace {

constexpr unsigned kRetryMilliseconds = 5000;  // until the system bus is looked for again

constexpr const char* kNoDaemon = "there is no Avahi daemon";

struct FreeTexts {
  void operator()(AvahiStringList* list) const { avahi_string_list_free(list); }
};

std::unique_ptr<AvahiStringList, FreeTexts> avahi_list(const std::vector<std::string>& texts) {
  AvahiStringList* list = nullptr;
  for (const std::string& text : texts)
    list = avahi_string_list_add_arbitrary(list, reinterpret_cast<const std::uint8_t*>(text.data()),
                                           text.size());
  return std::unique_ptr<AvahiStringList, FreeTexts>(avahi_string_list_reverse(list));
}

}  // namespace

/// All but construction and destruction is done on the thread of `poll`, or before it runs.
struct Announcer::Impl {
  struct Published {
    Impl* announcer = nullptr;
    AnnouncedServer server;
    std::string name{};  // empty: not chosen yet
    AvahiEntryGroup* group = nullptr;
  };

  Impl(std::vector<AnnouncedServer> servers, AnnouncedFamily family)
      : protocol(family == AnnouncedFamily::kIpv4 ? AVAHI_PROTO_INET : AVAHI_PROTO_UNSPEC),
        poll(avahi_threaded_poll_new()) {
    for (AnnouncedServer& each : servers) published.push_back({this, std::move(each)});
    if (poll == nullptr) {
      tell_once("out of memory");
      return;
    }
    connect();
    avahi_threaded_poll_start(poll);
  }
  ~Impl() {
    if (poll == nullptr) return;
    avahi_threaded_poll_stop(poll);
    if (client != nullptr) avahi_client_free(client);
    avahi_threaded_poll_free(poll);  // with its timeouts
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void tell_once(const std::string& why) {
    if (!std::exchange(told, true)) log::info("not announced on the network: {}", why);
  }

  /// Waits for a daemon that is not there yet; without a system bus it looks for one again later.
  void connect() {
    for (Published& each : published) each.group = nullptr;  // freed with the client
    if (client != nullptr) avahi_client_free(std::exchange(client, nullptr));
    int error = 0;
    AvahiClient* const made =
        avahi_client_new(avahi_threaded_poll_get(poll), AVAHI_CLIENT_NO_FAIL, client_changed, this, &error);
    client = made;
    if (made != nullptr) return;
    tell_once(error == AVAHI_ERR_NO_DAEMON ? kNoDaemon : avahi_strerror(error));
    timeval due{};
    avahi_elapse_time(&due, kRetryMilliseconds, 0);
    const AvahiPoll* const api = avahi_threaded_poll_get(poll);
    if (retry == nullptr) {
      retry = api->timeout_new(
          api, &due, [](AvahiTimeout*, void* self) { static_cast<Impl*>(self)->connect(); }, this);
    } else {
      api->timeout_update(retry, &due);
    }
  }

  static void client_changed(AvahiClient* client, AvahiClientState state, void* self) {
    auto& announcer = *static_cast<Impl*>(self);
    announcer.client = client;  // it may be under construction
    switch (state) {
      case AVAHI_CLIENT_S_RUNNING:
        for (Published& each : announcer.published) announcer.publish(each);
        break;
      case AVAHI_CLIENT_S_COLLISION:
      case AVAHI_CLIENT_S_REGISTERING:  // the machine's name changes
        for (Published& each : announcer.published)
          if (each.group != nullptr) avahi_entry_group_reset(each.group);
        break;
      case AVAHI_CLIENT_CONNECTING:
        announcer.tell_once(kNoDaemon);
        break;
      case AVAHI_CLIENT_FAILURE:
        if (avahi_client_errno(client) == AVAHI_ERR_DISCONNECTED) {
          announcer.connect();
        } else {
          announcer.tell_once(avahi_strerror(avahi_client_errno(client)));
        }
        break;
    }
  }

  void publish(Published& each) {
    if (each.group == nullptr) each.group = avahi_entry_group_new(client, group_changed, &each);
    if (each.group == nullptr) return tell_once(avahi_strerror(avahi_client_errno(client)));
    if (avahi_entry_group_is_empty(each.group) == 0) return;
    if (each.name.empty()) {
      const char* const host = avahi_client_get_host_name(client);
      each.name = fmt::format("{} {}", host == nullptr ? "playhouse" : host, each.server.port);
    }
    const auto texts = avahi_list(each.server.texts);
    int added = AVAHI_ERR_COLLISION;
    for (int tries = 0; added == AVAHI_ERR_COLLISION && tries < kMostNames; ++tries) {
      if (tries > 0) take_other_name(each);
      added = avahi_entry_group_add_service_strlst(each.group, AVAHI_IF_UNSPEC, protocol, AvahiPublishFlags{},
                                                   each.name.c_str(), std::string(kServiceType).c_str(),
                                                   nullptr, nullptr, each.server.port, texts.get());
    }
    if (added == AVAHI_OK) added = avahi_entry_group_commit(each.group);
    if (added < 0) tell_once(avahi_strerror(added));
  }

  static void take_other_name(Published& each) {
    char* const other = avahi_alternative_service_name(each.name.c_str());
    each.name = other;
    avahi_free(other);
  }

  static void group_changed(AvahiEntryGroup* group, AvahiEntryGroupState state, void* published) {
    Published& each = *static_cast<Published*>(published);
    each.group = group;  // it may be under construction
    if (state == AVAHI_ENTRY_GROUP_ESTABLISHED) {
      log::info("announced on the network as {}", in_quotes(each.name));
    } else if (state == AVAHI_ENTRY_GROUP_COLLISION) {
      take_other_name(each);
      avahi_entry_group_reset(group);
      each.announcer->publish(each);
    } else if (state == AVAHI_ENTRY_GROUP_FAILURE) {
      each.announcer->tell_once(avahi_strerror(avahi_client_errno(avahi_entry_group_get_client(group))));
    }
  }

  static constexpr int kMostNames = 100;  // that others have
  const AvahiProtocol protocol;
  AvahiThreadedPoll* const poll;
  std::vector<Published> published;  // each stays where it is
  AvahiClient* client = nullptr;
  AvahiTimeout* retry = nullptr;
  bool told = false;
};

Announcer::Announcer(std::vector<AnnouncedServer> servers, AnnouncedFamily family)
    : impl_(std::make_unique<Impl>(std::move(servers), family)) {}

Announcer::~Announcer() = default;

}  // namespace playhouse::discovery
