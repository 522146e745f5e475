#pragma once

/// The messages in a client's datagrams. Pure: no sockets, no clock.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace playhouse::server {

class DatagramStream {
 public:
  struct TakenMessages {
    std::vector<std::byte> messages;  // whole ones, in order
    bool dropped = false;             // this datagram or an unfinished message before it is lost
    std::uint32_t late = 0;           // commands left out: older than one that was taken before
    bool commands = false;            // there is a command among the messages
  };

  /// A datagram that is not empty. One of whole messages stands for itself; others continue an unfinished message
  /// of up to limits::kDatagramWaitingBytes, or begin one.
  TakenMessages take(std::span<const std::byte> datagram);
  /// Of an unfinished message.
  std::size_t unfinished_bytes() const { return unfinished_.size(); }

 private:
  void pass(std::span<const std::byte> messages, TakenMessages& taken);
  bool is_late(std::uint32_t number);

  std::vector<std::byte> unfinished_;
  std::uint32_t newest_ = 0;  // number of the last command; 0: none has one
};

}  // namespace playhouse::server
