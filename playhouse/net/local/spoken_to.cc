#include "playhouse/net/local/spoken_to.h"

#include <linux/errqueue.h>
#include <netinet/in.h>
#include <sys/uio.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace playhouse::net {
namespace {

constexpr OwnAddress kAnyAddress{};
constexpr std::array<std::uint8_t, 12> kMappedV4 = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};

bool is_mapped(const OwnAddress& address) {
  return std::equal(kMappedV4.begin(), kMappedV4.end(), address.begin());
}

/// Calls `look` with each part of a message's control data.
template <typename Look>
void for_each_part(msghdr& message, Look look) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part))
    look(*part);
}

template <typename Value>
Value value_of(const cmsghdr& part) {
  Value value{};
  std::memcpy(&value, CMSG_DATA(&part), sizeof value);
  return value;
}

OwnAddress address_in(msghdr& message) {
  OwnAddress address{};
  for_each_part(message, [&address](const cmsghdr& part) {
    if (part.cmsg_level == IPPROTO_IP && part.cmsg_type == IP_PKTINFO) {
      const in_addr four = value_of<in_pktinfo>(part).ipi_spec_dst;
      std::ranges::copy(kMappedV4, address.begin());
      std::memcpy(address.data() + kMappedV4.size(), &four, 4);
    } else if (part.cmsg_level == IPPROTO_IPV6 && part.cmsg_type == IPV6_PKTINFO) {
      const in6_addr six = value_of<in6_pktinfo>(part).ipi6_addr;
      std::memcpy(address.data(), &six, address.size());
    }
  });
  return address;
}

template <typename Value>
void put(msghdr& message, int level, int type, const Value& value) {
  message.msg_controllen = CMSG_SPACE(sizeof value);
  cmsghdr* const part = CMSG_FIRSTHDR(&message);
  part->cmsg_level = level;
  part->cmsg_type = type;
  part->cmsg_len = CMSG_LEN(sizeof value);
  std::memcpy(CMSG_DATA(part), &value, sizeof value);
}

/// A socket of IPv6 that speaks to IPv4 as well takes mapped addresses.
void put_address(msghdr& message, bool socket_is_v4, const OwnAddress& address) {
  if (socket_is_v4) {
    in_pktinfo info{};
    std::memcpy(&info.ipi_spec_dst, address.data() + kMappedV4.size(), 4);
    put(message, IPPROTO_IP, IP_PKTINFO, info);
  } else {
    in6_pktinfo info{};
    std::memcpy(&info.ipi6_addr, address.data(), address.size());
    put(message, IPPROTO_IPV6, IPV6_PKTINFO, info);
  }
}

}  // namespace

void tell_spoken_to(int socket, bool is_v4) {
  const int on = 1;
  is_v4 ? setsockopt(socket, IPPROTO_IP, IP_PKTINFO, &on, sizeof on)
        : setsockopt(socket, IPPROTO_IPV6, IPV6_RECVPKTINFO, &on, sizeof on);
}

std::optional<std::size_t> receive_datagram(int socket, std::span<std::byte> buffer, sockaddr* from,
                                            socklen_t& length, OwnAddress& spoken_to) {
  alignas(cmsghdr) std::array<std::byte, 256> control{};
  iovec part{buffer.data(), buffer.size()};
  msghdr message{};
  message.msg_name = from;
  message.msg_namelen = length;
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = ::recvmsg(socket, &message, 0);
  if (size < 0) return {};
  length = message.msg_namelen;
  spoken_to = address_in(message);
  return static_cast<std::size_t>(size);
}

bool send_datagram(int socket, std::span<const std::byte> bytes, const sockaddr* to, socklen_t length,
                   const OwnAddress& from) {
  const bool is_v4 = to->sa_family == AF_INET;
  if (from == kAnyAddress || (is_v4 && !is_mapped(from)))
    return ::sendto(socket, bytes.data(), bytes.size(), 0, to, length) >= 0;
  alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(in6_pktinfo))> control{};
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
  msghdr message{};
  message.msg_name = const_cast<sockaddr*>(to);
  message.msg_namelen = length;
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  put_address(message, is_v4, from);
  if (::sendmsg(socket, &message, 0) >= 0) return true;
  // It is no address of this machine any more, or that of a broadcast.
  if (errno != EINVAL && errno != EADDRNOTAVAIL && errno != ENETUNREACH) return false;
  return ::sendto(socket, bytes.data(), bytes.size(), 0, to, length) >= 0;
}

int error_in(msghdr& message) {
  int error = 0;
  for_each_part(message, [&error](const cmsghdr& part) {
    const bool is_error = (part.cmsg_level == IPPROTO_IP && part.cmsg_type == IP_RECVERR) ||
                          (part.cmsg_level == IPPROTO_IPV6 && part.cmsg_type == IPV6_RECVERR);
    if (is_error) error = static_cast<int>(value_of<sock_extended_err>(part).ee_errno);
  });
  return error;
}

}  // namespace playhouse::net
