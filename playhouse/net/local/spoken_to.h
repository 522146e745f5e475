#pragma once

/// Datagrams with the address of this machine that they came to, so that an answer comes from there: a socket of all
/// addresses answers from the one nearest to the peer, and a peer that has connected its socket drops that.

#include <sys/socket.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace playhouse::net {

/// An IPv6 address, or a mapped one of IPv4; zeros: unknown.
using OwnAddress = std::array<std::uint8_t, 16>;

/// Has the system tell it with each datagram from now on.
void tell_spoken_to(int socket, bool is_v4);

/// The size of a datagram put into `buffer`; `length` is that of `from`, before and after. None: see errno.
std::optional<std::size_t> receive_datagram(int socket, std::span<std::byte> buffer, sockaddr* from,
                                            socklen_t& length, OwnAddress& spoken_to);

/// Sends from that address, or from one that the system chooses if it has it no more. False: see errno.
bool send_datagram(int socket, std::span<const std::byte> bytes, const sockaddr* to, socklen_t length,
                   const OwnAddress& from);

/// What a message of the queue of errors tells (ip(7)): an errno, or 0.
int error_in(msghdr& message);

}  // namespace playhouse::net
