#include "playhouse/app/free_ports.h"

#include <unistd.h>

#include <cstdint>
#include <utility>

namespace playhouse::app {
namespace {

using Listeners = std::vector<std::unique_ptr<net::Listener>>;

constexpr int kTriesOfSystem = 8;

// Below the ports that Linux takes for outgoing connections (ip_local_port_range), which may occupy every second of those.
constexpr std::uint32_t kFirstQuiet = 20000, kEndQuiet = 32768;
constexpr std::uint32_t kTriesBelow = 64;

/// Whether the port was free; 0 is any one.
bool hold(net::Network& network, const std::string& bind, std::uint32_t port, Listeners& held) {
  if (port > kLastPort) return false;
  auto opened = network.listen(bind, static_cast<std::uint16_t>(port), [](auto) {});
  if (opened) held.push_back(std::move(*opened));
  return opened.ok();
}

/// From `first` on (0: any one); empty if one of them is in use.
Listeners hold_row(net::Network& network, const std::string& bind, std::uint32_t first, std::size_t count) {
  Listeners held;
  while (held.size() < count)
    if (!hold(network, bind, held.empty() ? first : held.back()->port() + 1u, held)) return {};
  return held;
}

}  // namespace

Listeners hold_free_ports(net::Network& network, const std::string& bind, std::size_t count) {
  for (int k = 0; k < kTriesOfSystem; ++k)
    if (Listeners held = hold_row(network, bind, 0, count); !held.empty()) return held;
  if (count > kEndQuiet - kFirstQuiet) return {};
  // Programs that start at once begin at different places.
  const std::uint32_t starts = kEndQuiet - kFirstQuiet - static_cast<std::uint32_t>(count) + 1;
  for (std::uint32_t k = 0; k < kTriesBelow; ++k) {
    const std::uint32_t first =
        kFirstQuiet + (static_cast<std::uint32_t>(::getpid()) * 97 + k * 211) % starts;
    if (Listeners held = hold_row(network, bind, first, count); !held.empty()) return held;
  }
  return {};
}

}  // namespace playhouse::app
