#include "playhouse/net/forwarded.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <optional>

#include "playhouse/base/in_quotes.h"
#include "playhouse/net/asio.h"

namespace playhouse::net {
namespace {

namespace ip = asio::ip;

/// In its shortest form; IPv4 mapped to IPv6 is IPv4.
std::optional<std::string> numeric_address(std::string_view text) {
  error_code error;
  const ip::address address = ip::make_address(std::string(text), error);
  if (error || text.find('%') != std::string_view::npos) return std::nullopt;
  if (address.is_v6() && address.to_v6().is_v4_mapped())
    return ip::make_address_v4(ip::v4_mapped, address.to_v6()).to_string();
  return address.to_string();
}

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Of "10.0.0.2", "10.0.0.2:80", "::1", "[::1]" and "[::1]:80".
std::optional<std::string> address_with_port(std::string_view text) {
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view rest = text.substr(end + 1), inner = text.substr(1, end - 1);
    const bool is_whole = rest.empty() || (rest.starts_with(':') && is_port(rest.substr(1)));
    return is_whole && inner.find(':') != std::string_view::npos ? numeric_address(inner) : std::nullopt;
  }
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.find(':', colon + 1) != std::string_view::npos)
    return numeric_address(text);
  return is_port(text.substr(colon + 1)) ? numeric_address(text.substr(0, colon)) : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

}  // namespace

Result<TrustedProxies> TrustedProxies::parse(const std::string& list) {
  TrustedProxies proxies;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    const std::string_view text = trimmed(std::string_view(list).substr(begin, comma - begin));
    std::optional<std::string> address = numeric_address(text);
    if (!address) return Error{"", "invalid proxy " + in_quotes(text) + ": a numeric address is valid"};
    proxies.addresses_.insert(std::move(*address));
    begin = comma + 1;
  }
  if (proxies.addresses_.size() > kMost)
    return Error{"", fmt::format("too many proxies: up to {} are possible", kMost)};
  return proxies;
}

Result<std::string> TrustedProxies::client_of(const std::string& peer, std::string_view forwarded) const {
  if (addresses_.empty() || forwarded.empty()) return peer;
  const std::size_t colon = peer.rfind(':');
  const std::optional<std::string> of_peer = address_with_port(peer);
  if (!of_peer || !addresses_.contains(*of_peer)) return peer;
  for (;;) {
    const std::size_t comma = forwarded.rfind(',');
    const bool is_first = comma == std::string_view::npos;
    const std::string_view text = trimmed(is_first ? forwarded : forwarded.substr(comma + 1));
    const std::optional<std::string> address = address_with_port(text);
    if (!address) return Error{"", "invalid address " + in_quotes(text) + " in X-Forwarded-For"};
    if (is_first || !addresses_.contains(*address)) {
      const bool is_v6 = address->find(':') != std::string::npos;
      return (is_v6 ? "[" + *address + "]" : *address) + peer.substr(colon);
    }
    forwarded = forwarded.substr(0, comma);
  }
}

}  // namespace playhouse::net
