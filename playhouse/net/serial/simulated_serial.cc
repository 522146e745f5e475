#include "playhouse/net/serial/simulated_serial.h"

#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

namespace playhouse::net {

constexpr int kBitsOfByte = 10;  // with those that begin and end it
constexpr std::size_t kLongestPiece = 16;

struct SimulatedCable {
  struct Piece {
    std::unique_ptr<Timer> timer;
    std::vector<std::byte> bytes;
  };
  struct CableEnd {
    bool is_open = false;
    SerialEvents* events = nullptr;
    SerialSettings settings;
    std::deque<Piece> pieces;  // on their way to it
    double arrival = 0;        // s, of the last of them
  };
  CableEnd terminal, port;
  bool is_unplugged = false;
};

namespace {

void deliver(SimulatedCable& cable, bool to_port) {
  SimulatedCable::CableEnd& end = to_port ? cable.port : cable.terminal;
  const SimulatedCable::Piece piece = std::move(end.pieces.front());
  end.pieces.pop_front();
  if (end.events != nullptr) end.events->received(piece.bytes);
}

}  // namespace

class SimulatedSerialLine final : public SerialLine {
 public:
  SimulatedSerialLine(SimulatedSerial& serial, std::shared_ptr<SimulatedCable> cable, std::string name,
                      bool is_port)
      : serial_(serial), cable_(std::move(cable)), name_(std::move(name)), is_port_(is_port) {}
  ~SimulatedSerialLine() override {
    own().events = nullptr;
    own().is_open = false;
    own().pieces.clear();
  }

  void start(SerialEvents& events) override { own().events = &events; }
  void send(std::span<const std::byte> bytes) override { serial_.carry(cable_, !is_port_, bytes); }
  Result<void> set(const SerialSettings& settings) override {
    own().settings = settings;
    return {};
  }
  SerialSettings settings() const override {
    return is_port_ ? cable_->port.settings : cable_->terminal.settings;
  }
  void drop_input() override { own().pieces.clear(); }
  const std::string& name() const override { return name_; }

 private:
  SimulatedCable::CableEnd& own() { return is_port_ ? cable_->port : cable_->terminal; }

  SimulatedSerial& serial_;
  const std::shared_ptr<SimulatedCable> cable_;
  const std::string name_;
  const bool is_port_;
};

Result<std::unique_ptr<SerialLine>> SimulatedSerial::open_port(const std::string& path,
                                                               const SerialSettings& settings) {
  const auto found = cables_.find(path);
  if (found == cables_.end() || !found->second->terminal.is_open || found->second->is_unplugged)
    return Error{path, "cannot be opened: No such file or directory"};
  SimulatedCable& cable = *found->second;
  if (cable.port.is_open) return Error{path, "is in use by another program"};
  cable.port.is_open = true;
  cable.port.settings = settings;
  return std::unique_ptr<SerialLine>(std::make_unique<SimulatedSerialLine>(*this, found->second, path, true));
}

Result<std::unique_ptr<SerialLine>> SimulatedSerial::open_terminal(const std::string& link,
                                                                   const SerialSettings& settings) {
  std::shared_ptr<SimulatedCable>& cable = cables_[link];
  if (cable == nullptr) cable = std::make_shared<SimulatedCable>();
  if (cable->terminal.is_open) return Error{link, "cannot be made: File exists"};
  cable->terminal.is_open = true;
  cable->terminal.settings = settings;
  return std::unique_ptr<SerialLine>(std::make_unique<SimulatedSerialLine>(*this, cable, link, false));
}

void SimulatedSerial::unplug(const std::string& path) {
  const auto found = cables_.find(path);
  if (found == cables_.end() || std::exchange(found->second->is_unplugged, true)) return;
  network_.post([cable = found->second] {
    if (SerialEvents* const events = std::exchange(cable->port.events, nullptr)) events->ended("is gone");
  });
}

void SimulatedSerial::plug(const std::string& path) {
  if (const auto found = cables_.find(path); found != cables_.end()) found->second->is_unplugged = false;
}

void SimulatedSerial::carry(const std::shared_ptr<SimulatedCable>& cable, bool to_port,
                            std::span<const std::byte> bytes) {
  SimulatedCable::CableEnd& end = to_port ? cable->port : cable->terminal;
  if (!end.is_open || cable->is_unplugged) return;
  const SerialSettings& sent = to_port ? cable->terminal.settings : cable->port.settings;
  while (!bytes.empty()) {
    const std::size_t count = 1 + rng_.bits() % std::min(bytes.size(), kLongestPiece);
    SimulatedCable::Piece piece;
    for (std::byte byte : bytes.first(count)) {
      if (rng_.uniform() < faults.loss) continue;
      if (sent != end.settings) byte = static_cast<std::byte>(rng_.bits());
      if (rng_.uniform() < faults.change) byte ^= static_cast<std::byte>(1u << rng_.bits() % 8);
      piece.bytes.push_back(byte);
    }
    bytes = bytes.subspan(count);
    end.arrival =
        std::max(end.arrival, network_.now()) + static_cast<double>(count) * kBitsOfByte / sent.baud;
    piece.timer = network_.after(end.arrival - network_.now(),
                                 [cable = cable.get(), to_port] { deliver(*cable, to_port); });
    end.pieces.push_back(std::move(piece));
  }
}

}  // namespace playhouse::net
