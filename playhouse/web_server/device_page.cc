#include "playhouse/web_server/device_page.h"

#include <optional>
#include <string_view>
#include <utility>

#include "playhouse/net/http.h"
#include "playhouse/web_server/page_reply.h"

namespace playhouse::web_server {
namespace {

constexpr std::string_view kStatus = "/status.json";

}  // namespace

DevicePage::DevicePage(net::Network& network, DevicePageOptions options, ClientCame came, StatusText status)
    : network_(network),
      options_(std::move(options)),
      gate_(options_.host_name, options_.further_names, options_.proxies),
      came_(std::move(came)),
      status_(std::move(status)) {}

Result<std::uint16_t> DevicePage::listen() {
  auto listener = network_.listen_http(options_.bind, options_.port, *this);
  if (!listener) return listener.error();
  listener_ = std::move(*listener);
  return listener_->port();
}

net::HttpReply DevicePage::get(const net::HttpRequest& request) {
  if (request.path != kStatus)
    return page_reply(options_.page, request.path == "/" ? "/devices.html" : request.path,
                      request.accepts_gzip);
  const std::optional<server::Guest> guest = options_.guests.admit(token_of(request), request.peer);
  if (!guest) return failed_reply(403, "Open the page by the link that you were given.\n");
  net::HttpReply reply;
  reply.content_type = "application/json";
  reply.cache_control = "no-store";
  reply.text = std::make_shared<const std::string>(status_(*guest));
  return reply;
}

Result<void> DevicePage::may_upgrade(const net::HttpRequest& request) {
  if (!player_port_of(request.path, options_.player_port)) return Error{"", kPlayerPaths};
  return gate_.may_control(request);
}

void DevicePage::upgraded(std::unique_ptr<net::WebSocket> socket, const net::HttpRequest& request) {
  came_(*player_port_of(request.path, options_.player_port), std::move(socket));
}

}  // namespace playhouse::web_server
