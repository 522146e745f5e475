#pragma once

/// Conversion of a request parsed by Beast to an HttpRequest, or rejection; internal to
/// net. Beast checks the grammar and contradictory lengths, this the other rules of RFC
/// 9112 for servers: exactly one Host (3.2), a valid target (3.2.2), no body (6.3).

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/message.hpp>
#include <optional>
#include <string>
#include <variant>

#include "playhouse/net/http.h"

namespace playhouse::net {

/// A reply after which the connection closes, since the start of the next request is uncertain.
struct HttpRefusal {
  unsigned status = 400;
  std::string text;
};

std::variant<HttpRequest, HttpRefusal> read_request(
    const boost::beast::http::request<boost::beast::http::empty_body>& message, const std::string& peer);

/// For a request that Beast rejects. None: the connection is lost.
std::optional<HttpRefusal> refusal_of(const boost::beast::error_code& error);

}  // namespace playhouse::net
