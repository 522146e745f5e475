#include "playhouse/web_server/page_gate.h"

#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"

namespace playhouse::web_server {

PageGate::PageGate(std::string host_name, std::vector<std::string> further_names, net::TrustedProxies proxies)
    : names_(std::move(host_name), std::move(further_names)), proxies_(std::move(proxies)) {}

Result<void> PageGate::serves(const std::string& host) {
  if (host.empty() || names_.has(host)) return {};
  const std::string text = in_quotes(host) + " is not a name of this program; open it by its address or as " +
                           names_.machine() + " (--web-host gives it another name)";
  if (hosts_refused_++ == 0) log::warn("web: a request refused: {} (logged once)", text);
  return Error{"", text};
}

Result<std::string> PageGate::client_of(const net::HttpRequest& request) {
  if (!request.forwarded_for.empty() && proxies_.empty() && net::is_local(request.peer) &&
      forwarded_ignored_++ == 0)
    log::warn(
        "web: {} forwards requests of others (X-Forwarded-For), who all count as one: --trusted-proxy "
        "with its address tells them apart",
        request.peer);
  return proxies_.client_of(request.peer, request.forwarded_for);
}

Result<void> PageGate::may_control(const net::HttpRequest& request) {
  if (request.origin.empty() || names_.may_control(request.origin, request.host, request.encrypted))
    return {};
  const std::string text = "a page from " + in_quotes(request.origin) + " may not control this program";
  if (origins_refused_++ == 0)
    log::warn("web: {} refused: {}; its own page may, at {}://{}/ (logged once)", request.peer, text,
              request.encrypted ? "https" : "http", request.host);
  return Error{"", text};
}

std::string token_of(const net::HttpRequest& request) {
  constexpr std::string_view kToken = "token=";
  return request.query.starts_with(kToken) ? request.query.substr(kToken.size()) : std::string("*");
}

}  // namespace playhouse::web_server
