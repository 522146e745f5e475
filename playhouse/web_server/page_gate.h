#pragma once

/// PageGate: who may use a page of this program: by which names it is reached, from which pages it is controlled, and who
/// is behind reverse proxies. Every refusal is logged once. Io thread only.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/net/forwarded.h"
#include "playhouse/net/http.h"
#include "playhouse/web_server/host_names.h"

namespace playhouse::web_server {

class PageGate {
 public:
  /// `host_name` of this machine; empty: ask the system. `further_names` are configured host names.
  PageGate(std::string host_name, std::vector<std::string> further_names, net::TrustedProxies proxies);

  /// As net::HttpService::serves().
  Result<void> serves(const std::string& host);
  /// As net::HttpService::client_of().
  Result<std::string> client_of(const net::HttpRequest& request);
  /// Fails for a request from a page of somebody else.
  Result<void> may_control(const net::HttpRequest& request);

 private:
  HostNames names_;
  net::TrustedProxies proxies_;
  std::uint64_t hosts_refused_ = 0, origins_refused_ = 0, forwarded_ignored_ = 0;
};

/// Token of a request, "?token=..."; "*": none.
std::string token_of(const net::HttpRequest& request);

}  // namespace playhouse::web_server
