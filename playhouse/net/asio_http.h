#pragma once

/// How one connection is served; for listen_http() and for what makes its sockets itself.

#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <string>

#include "playhouse/net/http.h"
#include "playhouse/net/http_places.h"

namespace playhouse::net {

/// Answers requests until the connection ends. The service outlives it.
void serve_http(boost::asio::ip::tcp::socket socket, std::string peer, HttpService& service,
                const HttpDeadlines& deadlines, const std::shared_ptr<HttpPlaces>& places);

}  // namespace playhouse::net
