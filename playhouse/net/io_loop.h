#pragma once

/// The event loop of net and server: one thread calls run(). Built on Boost.Asio,
/// which stays in the .cc files (asio_loop.h shares its io_context within net).

#include <cstddef>
#include <initializer_list>
#include <memory>

#include "playhouse/net/network.h"

namespace playhouse::net {

class TlsIdentity;

class IoLoop final : public Network {
 public:
  IoLoop();
  ~IoLoop() override;
  IoLoop(const IoLoop&) = delete;
  IoLoop& operator=(const IoLoop&) = delete;

  /// Processes events until stop(). The calling thread is the io thread.
  void run();
  /// Makes run() return soon; queued tasks stay for the next run(). Any thread.
  void stop();
  /// Like stop(), after all lingering connections have closed (Connection::close_after_flush). Any thread.
  void finish();
  /// Number of lingering connections.
  std::size_t lingering() const;
  /// Processes ready events without blocking.
  void poll();

  /// Ports that are opened from now on for connections and pages speak TLS.
  void use_tls(std::shared_ptr<TlsIdentity> identity);

  /// Calls `task` on the io thread for each of these signals, replacing their default action. Call once.
  void on_signal(std::initializer_list<int> signals, std::function<void(int)> task);

  void post(Task task) override;
  [[nodiscard]] std::unique_ptr<Timer> after(double seconds, Task task) override;
  Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                           Acceptor acceptor) override;
  Result<std::unique_ptr<Listener>> listen_http(const std::string& bind, std::uint16_t port,
                                                HttpService& service) override;
  Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                         DatagramSocket::Receiver receiver) override;
  double now() const override;
  [[nodiscard]] std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                 Connected connected) override;

  [[nodiscard]] std::unique_ptr<Attempt> connect_tls(const std::string& host, std::uint16_t port,
                                                     std::shared_ptr<TlsTrust> trust,
                                                     Connected connected) override;
  Result<std::unique_ptr<SerialLine>> open_serial(const std::string& path,
                                                  const SerialSettings& settings) override;
  Result<std::unique_ptr<SerialLine>> open_terminal(const std::string& link,
                                                    const SerialSettings& settings) override;

  struct Impl;  // defined in asio_loop.h
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::net
