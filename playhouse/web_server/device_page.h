#pragma once

/// DevicePage: the page of a server without a world, at http://bind:port/: its devices with their
/// values, driving, and who is connected. The page is a Player client over a WebSocket: it has the
/// rights of its token, as every other client. docs/device-page.md. Io thread, or before that runs.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/net/network.h"
#include "playhouse/server/guests/guest_book.h"
#include "playhouse/web_server/page_files.h"
#include "playhouse/web_server/page_gate.h"
#include "playhouse/web_server/player_path.h"

namespace playhouse::web_server {

class DevicePage final : private net::HttpService {
 public:
  struct DevicePageOptions {
    std::string bind = "127.0.0.1";          // numeric address
    std::uint16_t port = 8080;               // 0: any free one
    std::span<const PageFile> page;          // usually page_files()
    std::string host_name;                   // of this machine; empty: ask the system
    std::vector<std::string> further_names;  // further allowed host names
    server::GuestBook guests;                // access list
    net::TrustedProxies proxies;             // in front of the page, which name its clients
    std::uint16_t player_port = 6665;        // of clients that name none
  };
  /// What the page shows of the server beside its devices, to whom it may show it, as JSON.
  using StatusText = std::function<std::string(const server::Guest& guest)>;

  /// `network` must outlive it; destroy it when the network has stopped.
  DevicePage(net::Network& network, DevicePageOptions options, ClientCame came, StatusText status);

  /// Starts listening; returns the port.
  Result<std::uint16_t> listen();

 private:
  Result<void> serves(const std::string& host) override { return gate_.serves(host); }
  Result<std::string> client_of(const net::HttpRequest& request) override { return gate_.client_of(request); }
  net::HttpReply get(const net::HttpRequest& request) override;
  bool takes_slot(const net::HttpRequest&) override { return false; }  // the server limits its sessions
  Result<void> may_upgrade(const net::HttpRequest& request) override;
  void upgraded(std::unique_ptr<net::WebSocket> socket, const net::HttpRequest& request) override;

  net::Network& network_;
  DevicePageOptions options_;
  PageGate gate_;
  ClientCame came_;
  StatusText status_;
  std::unique_ptr<net::Listener> listener_;
};

}  // namespace playhouse::web_server
