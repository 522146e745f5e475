#include "playhouse/net/http_request.h"

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/http/verb.hpp>
#include <optional>
#include <string_view>

namespace playhouse::net {
namespace {

namespace http = boost::beast::http;
using Message = http::request<http::empty_body>;

constexpr std::string_view kScheme = "http://";

std::string text_of(boost::beast::string_view text) {
  return {text.data(), text.size()};
}

bool all_in(std::string_view text, std::string_view letters) {
  return text.find_first_not_of(letters) == std::string_view::npos;
}

/// "name", "name:port" or "[address]:port" (RFC 3986 3.2.2), without
/// percent-escapes and sub-delimiters, which valid hosts do not have.
bool is_authority(std::string_view text) {
  constexpr std::string_view kName = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~";
  const std::size_t bracket = text.starts_with('[') ? text.find(']') : 0;
  if (bracket == std::string_view::npos) return false;
  const std::size_t colon = std::min(text.find(':', bracket), text.size());
  const std::string_view host = text.substr(0, colon), port = text.substr(std::min(colon + 1, text.size()));
  const bool named = bracket == 0 ? !host.empty() && all_in(host, kName)
                                  : host.size() == bracket + 1 && bracket > 1 &&
                                        all_in(host.substr(1, bracket - 1), "0123456789abcdefABCDEF:.");
  return named && port.size() <= 5 && all_in(port, "0123456789");
}

/// "br, gzip;q=0.5"; weight zero means not acceptable (RFC 9110 12.4.2).
bool accepts_gzip(boost::beast::string_view encodings) {
  for (const auto& [name, parameters] : http::ext_list(encodings)) {
    if (!boost::beast::iequals(name, "gzip")) continue;
    for (const auto& [parameter, weight] : parameters)
      if (boost::beast::iequals(parameter, "q"))
        return text_of(weight).find_first_of("123456789") < weight.size();
    return true;
  }
  return false;
}

bool is_http(std::string_view target) {
  return boost::beast::iequals({target.data(), std::min(target.size(), kScheme.size())},
                               {kScheme.data(), kScheme.size()});
}

/// Validates message framing: lengths and Host.
std::optional<HttpRefusal> fault_of_frame(const Message& message) {
  if (message.count(http::field::transfer_encoding) > 0) {
    if (message.version() == 10) return HttpRefusal{400, "HTTP/1.0 has no Transfer-Encoding"};
    if (!message.chunked()) return HttpRefusal{400, "a Transfer-Encoding of a request ends with \"chunked\""};
    return HttpRefusal{413, "a request here has no body"};
  }
  const std::size_t hosts = message.count(http::field::host);
  if (hosts > 1) return HttpRefusal{400, "more than one Host"};
  if (hosts == 0 && message.version() == 11) return HttpRefusal{400, "HTTP/1.1 needs a Host"};
  if (hosts == 1 && !is_authority(text_of(message[http::field::host])))
    return HttpRefusal{400, "the Host is not a host"};
  return std::nullopt;
}

}  // namespace

std::variant<HttpRequest, HttpRefusal> read_request(const Message& message, const std::string& peer) {
  if (auto fault = fault_of_frame(message)) return *std::move(fault);
  if (message.method() == http::verb::unknown) return HttpRefusal{501, "no such method"};
  if (message.method() != http::verb::get && message.method() != http::verb::head)
    return HttpRefusal{405, "only GET and HEAD are served here"};

  HttpRequest request;
  request.host = text_of(message[http::field::host]);
  std::string target = text_of(message.target());
  if (is_http(target)) {  // absolute form, as to a proxy: its host overrides Host (RFC 9112 3.2.2)
    target.erase(0, kScheme.size());
    const std::size_t end = std::min(target.find_first_of("/?"), target.size());
    request.host = target.substr(0, end);
    if (!is_authority(request.host)) return HttpRefusal{400, "the target's host is not a host"};
    target.erase(0, end);
    if (!target.starts_with('/')) target.insert(0, "/");
  }
  if (!target.starts_with('/')) return HttpRefusal{400, "invalid target: a path is valid"};
  const std::size_t question = std::min(target.find('?'), target.size());
  request.path = target.substr(0, question);
  if (question < target.size()) request.query = target.substr(question + 1);
  request.origin = text_of(message[http::field::origin]);
  request.if_none_match = text_of(message[http::field::if_none_match]);
  request.accepts_gzip = accepts_gzip(message[http::field::accept_encoding]);
  request.peer = peer;
  const auto [first, last] = message.equal_range("X-Forwarded-For");
  for (auto field = first; field != last; ++field)
    request.forwarded_for += (field == first ? "" : ",") + text_of(field->value());
  return request;
}

std::optional<HttpRefusal> refusal_of(const boost::beast::error_code& error) {
  if (error == http::error::body_limit) return HttpRefusal{413, "a request here has no body"};
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return HttpRefusal{431, "the request's header is too long"};
  const bool of_http = error.category() == http::make_error_code(http::error::end_of_stream).category();
  if (!of_http || error == http::error::end_of_stream || error == http::error::partial_message)
    return std::nullopt;
  if (error == http::error::bad_version) return HttpRefusal{505, "HTTP/1.0 and HTTP/1.1 are served here"};
  return HttpRefusal{400, "not an HTTP request"};
}

}  // namespace playhouse::net
