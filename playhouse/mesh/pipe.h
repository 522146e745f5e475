#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace playhouse::mesh {

/// One end of a message pipe between two processes. Owns the descriptor.
class Pipe {
 public:
  explicit Pipe(int descriptor) : descriptor_(descriptor) {}
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  struct PipeMessage {
    char kind = 0;
    std::vector<std::byte> bytes;
  };
  /// False if the peer has closed.
  bool send(char kind, std::span<const std::byte> bytes);
  /// None if the peer has closed, or sends more than `most` bytes.
  std::optional<PipeMessage> receive(std::size_t most);

 private:
  bool read(void* to, std::size_t bytes);

  int descriptor_;
};

}  // namespace playhouse::mesh
