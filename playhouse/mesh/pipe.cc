#include "playhouse/mesh/pipe.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace playhouse::mesh {
namespace {

struct Head {
  std::uint64_t bytes = 0;
  char kind = 0;
};

bool write(int descriptor, const void* from, std::size_t bytes) {
  const char* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ssize_t sent = ::send(descriptor, at, bytes, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
  return true;
}

}  // namespace

Pipe::~Pipe() {
  ::close(descriptor_);
}

bool Pipe::send(char kind, std::span<const std::byte> bytes) {
  Head head;
  head.bytes = bytes.size();
  head.kind = kind;
  return write(descriptor_, &head, sizeof head) && write(descriptor_, bytes.data(), bytes.size());
}

bool Pipe::read(void* to, std::size_t bytes) {
  char* at = static_cast<char*>(to);
  while (bytes > 0) {
    const ssize_t got = ::read(descriptor_, at, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

std::optional<Pipe::PipeMessage> Pipe::receive(std::size_t most) {
  Head head;
  if (!read(&head, sizeof head) || head.bytes > most) return std::nullopt;
  PipeMessage message{head.kind, std::vector<std::byte>(static_cast<std::size_t>(head.bytes))};
  if (!read(message.bytes.data(), message.bytes.size())) return std::nullopt;
  return message;
}

}  // namespace playhouse::mesh
