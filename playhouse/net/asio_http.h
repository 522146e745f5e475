#pragma once

/// HTTP on one connection; for listen_http() and for tests with sockets of their own.

#include <memory>

#include "playhouse/net/asio_accept.h"
#include "playhouse/net/http.h"
#include "playhouse/net/http_places.h"

namespace playhouse::net {

/// Serves requests until the connection ends. The service must outlive it.
void serve_http(AcceptedSocket accepted, HttpService& service, const HttpDeadlines& deadlines,
                const std::shared_ptr<HttpPlaces>& places);

}  // namespace playhouse::net
