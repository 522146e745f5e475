#pragma once

/// The event loop: one thread calls run(), everything of net and server happens in it. Built on Boost.Asio,
/// which stays in the .cc files (asio_loop.h gives the other transports of net their io_context).

#include <cstddef>
#include <initializer_list>
#include <memory>

#include "playhouse/net/network.h"

namespace playhouse::net {

class IoLoop final : public Network {
 public:
  IoLoop();
  ~IoLoop() override;
  IoLoop(const IoLoop&) = delete;
  IoLoop& operator=(const IoLoop&) = delete;

  /// Serves events until stop(). The calling thread is the io thread.
  void run();
  /// Makes run() return soon; tasks not begun stay for the next run(). Any thread.
  void stop();
  /// As stop(), once no connection waits for its peer any more (Connection::close_after_flush). Any thread.
  void finish();
  /// Connections that do now.
  std::size_t lingering() const;
  /// Runs what is ready now and returns without waiting.
  void poll();

  /// Calls `task` on the io thread for each of these signals, instead of their usual effect. Call once.
  void on_signal(std::initializer_list<int> signals, std::function<void(int)> task);

  void post(Task task) override;
  [[nodiscard]] std::unique_ptr<Timer> after(double seconds, Task task) override;
  Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                           Acceptor acceptor) override;
  Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                         DatagramSocket::Receiver receiver) override;
  double now() const override;
  [[nodiscard]] std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                 Connected connected) override;

  struct Impl;  // defined in asio_loop.h
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::net
