#include "playhouse/net/fair_share.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <map>
#include <tuple>

#include "playhouse/base/assert.h"
#include "playhouse/net/asio.h"

namespace playhouse::net {
namespace ip = asio::ip;

namespace {

std::string_view address_of(std::string_view peer) {
  const std::string_view text = peer.substr(0, peer.rfind(':'));
  return text.starts_with('[') && text.ends_with(']') ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

bool is_local(std::string_view peer) {
  if (peer.starts_with("unix:") || peer.starts_with('/')) return true;
  error_code error;
  const ip::address address = ip::make_address(std::string(address_of(peer)), error);
  if (error) return false;
  if (address.is_v6() && address.to_v6().is_v4_mapped())
    return ip::make_address_v4(ip::v4_mapped, address.to_v6()).is_loopback();
  return address.is_loopback();
}

std::string network_of(std::string_view peer) {
  const std::string_view text = address_of(peer);
  error_code error;
  const ip::address address = ip::make_address(std::string(text), error);
  if (error || address.is_v4()) return std::string(text);
  ip::address_v6 v6 = address.to_v6();
  if (v6.is_v4_mapped()) return ip::make_address_v4(ip::v4_mapped, v6).to_string();
  ip::address_v6::bytes_type bytes = v6.to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), 0);
  return ip::address_v6(bytes).to_string();
}

std::string holder_of(std::string_view token, std::string_view peer) {
  if (token != "*") return std::string(token);
  return is_local(peer) ? std::string(peer) : network_of(peer);
}

std::size_t places_of(std::span<const Holder> holders, std::string_view network) {
  return static_cast<std::size_t>(std::ranges::count(holders, network, &Holder::network));
}

std::size_t gives_way(std::span<const Holder> holders) {
  PLAYHOUSE_ASSERT(!holders.empty());
  std::map<std::string_view, std::size_t> places;
  for (const Holder& holder : holders) ++places[holder.network];
  const auto first = std::ranges::max_element(holders, {}, [&](const Holder& holder) {
    return std::tuple(places[holder.network], -holder.quiet_since);
  });
  return static_cast<std::size_t>(first - holders.begin());
}

}  // namespace playhouse::net
