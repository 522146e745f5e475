/// Datagrams of the simulated network, delivered by alarms of the virtual clock.

#include <utility>
#include <vector>

#include "playhouse/net/simulated.h"

namespace playhouse::net {

class SimulatedDatagrams final : public DatagramSocket {
 public:
  SimulatedDatagrams(SimulatedNetwork& network, const Endpoint& here, std::shared_ptr<Receiver> receiver)
      : network_(network), here_(here), receiver_(std::move(receiver)) {}
  bool send(const Endpoint& to, std::span<const std::byte> bytes) override {
    network_.carry(here_, to, bytes);
    return true;
  }
  /// Machines here say nothing.
  void on_refused(std::function<void(const Endpoint&)>) override {}
  std::uint16_t port() const override { return here_.port; }

 private:
  SimulatedNetwork& network_;
  const Endpoint here_;
  const std::shared_ptr<Receiver> receiver_;  // registered in the network during our lifetime
};

Result<std::unique_ptr<DatagramSocket>> SimulatedNetwork::open_datagrams(const std::string& bind,
                                                                         std::uint16_t port,
                                                                         DatagramSocket::Receiver receiver) {
  const Result<Endpoint> here = parse_endpoint(bind, port == 0 ? next_port_++ : port);
  if (!here) return here.error();
  auto& receivers = datagram_ports_[*here];
  std::erase_if(receivers, [](const auto& each) { return each.expired(); });
  if (!receivers.empty() && !here->is_group())
    return Error{to_text(*here), "cannot listen for datagrams: port in use"};
  const auto shared = std::make_shared<DatagramSocket::Receiver>(std::move(receiver));
  receivers.push_back(shared);
  return std::unique_ptr<DatagramSocket>(std::make_unique<SimulatedDatagrams>(*this, *here, shared));
}

void SimulatedNetwork::carry(const Endpoint& from, const Endpoint& to, std::span<const std::byte> bytes) {
  if (is_cut()) return;
  const int copies =
      (rng_.uniform() < datagrams.loss ? 0 : 1) + (rng_.uniform() < datagrams.duplication ? 1 : 0);
  for (int copy = 0; copy < copies; ++copy) {
    const double arrives = now_ + datagrams.delay + datagrams.jitter * rng_.uniform();
    run_at(arrives, [this, from, to, bytes = std::vector(bytes.begin(), bytes.end())] {
      const auto port = datagram_ports_.find(to);
      if (port == datagram_ports_.end()) return;
      for (const auto& each : std::vector(port->second))
        if (const auto receiver = each.lock()) (*receiver)(from, bytes);
    });
  }
}

}  // namespace playhouse::net
