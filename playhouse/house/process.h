#pragma once

/// Process: a simulated network as one process has it: what the process has posted and not run ends with it.
/// Thread: one for the whole house.

#include <memory>
#include <string>
#include <utility>

#include "playhouse/net/network.h"

namespace playhouse::house {

class Process final : public net::Network {
 public:
  explicit Process(net::Network& network) : network_(network) {}

  void post(Task task) override {
    network_.post([alive = std::weak_ptr<int>(alive_), task = std::move(task)] {
      if (!alive.expired()) task();
    });
  }
  [[nodiscard]] std::unique_ptr<net::Timer> after(double seconds, Task task) override {
    return network_.after(seconds, std::move(task));
  }
  Result<std::unique_ptr<net::Listener>> listen(const std::string& bind, std::uint16_t port,
                                                Acceptor acceptor) override {
    return network_.listen(bind, port, std::move(acceptor));
  }
  Result<std::unique_ptr<net::Listener>> listen_http(const std::string& bind, std::uint16_t port,
                                                     net::HttpService& service) override {
    return network_.listen_http(bind, port, service);
  }
  Result<std::unique_ptr<net::DatagramSocket>> open_datagrams(
      const std::string& bind, std::uint16_t port, net::DatagramSocket::Receiver receiver) override {
    return network_.open_datagrams(bind, port, std::move(receiver));
  }
  double now() const override { return network_.now(); }
  [[nodiscard]] std::unique_ptr<net::Attempt> connect(const std::string& host, std::uint16_t port,
                                                      Connected connected) override {
    return network_.connect(host, port, std::move(connected));
  }
  Result<std::unique_ptr<net::SerialLine>> open_serial(const std::string& path,
                                                       const net::SerialSettings& settings) override {
    return network_.open_serial(path, settings);
  }
  Result<std::unique_ptr<net::SerialLine>> open_terminal(const std::string& link,
                                                         const net::SerialSettings& settings) override {
    return network_.open_terminal(link, settings);
  }

 private:
  net::Network& network_;
  const std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace playhouse::house
