#pragma once

/// Unix sockets in place of ports: an address that begins with "/" is a folder, which has port N at the socket
/// FOLDER/N. Who may connect is what the modes of folder and socket say. Internal to net.

#include <cstdint>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"

namespace playhouse::net {

inline bool is_unix_folder(std::string_view address) {
  return address.starts_with('/');
}

/// A listening socket: its descriptor, and the file that remove() removes as long as it is this socket's.
struct UnixListening {
  int descriptor = -1;  // not blocking, close-on-exec
  std::string path;
  std::uint64_t file = 0;  // serial number of the file

  void remove() const;
};

/// Opens FOLDER/port, in place of a socket there that no program serves any more.
Result<UnixListening> listen_unix(const std::string& folder, std::uint16_t port);

/// Connects to FOLDER/port without waiting. Returns the descriptor, likewise.
Result<int> connect_unix(const std::string& folder, std::uint16_t port);

/// "unix:4242": the process that connected, for the log.
std::string unix_peer(int descriptor);

}  // namespace playhouse::net
