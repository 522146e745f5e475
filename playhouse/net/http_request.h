#pragma once

/// One request as Beast parsed it, made into a HttpRequest or refused; for the .cc files of net only. Beast
/// sees to the grammar and to lengths that contradict each other, this to what RFC 9112 asks of a server
/// besides: one Host (3.2), a target that names something here (3.2.2), no body that nobody would read (6.3).

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/message.hpp>
#include <optional>
#include <string>
#include <variant>

#include "playhouse/net/http.h"

namespace playhouse::net {

/// An answer after which the connection ends: where the next request begins is not certain any more.
struct HttpRefusal {
  unsigned status = 400;
  std::string text;
};

std::variant<HttpRequest, HttpRefusal> read_request(
    const boost::beast::http::request<boost::beast::http::empty_body>& message, const std::string& peer);

/// For a head that Beast refuses. None: the connection is lost, there is nobody to answer.
std::optional<HttpRefusal> refusal_of(const boost::beast::error_code& error);

}  // namespace playhouse::net
