/// Clients that open, command and ask devices of every interface with any bodies. Each request is answered once,
/// and what comes out is what the catalogue of messages says.

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/dummy/dummy.h"
#include "playhouse/net/simulated.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

/// The server's place: the n-th device is of the n-th interface after that of the server itself.
class Program final : public Host, public device::Outlet, public device::Publisher {
 public:
  Program() {
    site_.data_flow().pass_to(*this);
    for (const wire::InterfaceDef& interf : wire::interfaces())
      if (interf.code != wire::player::kCode) PLAYHOUSE_ASSERT(dummy_.add({6665, interf.code, 0}).ok());
  }

  Result<device::DeviceId> add_device(device::Address address, device::Driver&) override {
    interfaces_.push_back(address.interf);
    return device::DeviceId{static_cast<std::uint32_t>(interfaces_.size() - 1)};
  }
  void retire_device(device::DeviceId) override {}
  void post(std::function<void()> task) override { network_.post(std::move(task)); }
  net::Network& network() override { return network_; }
  Result<void> hold(device::DeviceId, device::Driver*) override { return {}; }
  void release(device::DeviceId, device::Driver*) override {}

  void answer(std::uint64_t, bool ack, std::vector<std::byte> body) override {
    PLAYHOUSE_ASSERT(asked_ != nullptr);
    if (ack) PLAYHOUSE_ASSERT(asked_->check(body).empty());
    asked_ = nullptr;
  }
  void publish(std::vector<device::Publication> batch) override {
    for (const device::Publication& data : batch) {
      PLAYHOUSE_ASSERT(open_.contains(data.device.row));
      const auto* message =
          wire::find_message(interfaces_[data.device.row], MessageType::kData, data.subtype);
      PLAYHOUSE_ASSERT(message != nullptr && message->check(data.body).empty());
    }
  }

  void step(FuzzScript& script) {
    const std::uint8_t what = script.byte();
    const auto row = static_cast<std::uint32_t>(script.byte() % interfaces_.size());
    if (what % 8 == 0) return open_or_close(row);
    if (what % 8 == 1) return network_.run_for(0.1 * (what / 8));
    const std::uint8_t subtype = script.byte();
    const auto body = script.take(script.byte());
    say(row, what % 8 == 2 ? MessageType::kCmd : MessageType::kReq, subtype, body);
  }

 private:
  void open_or_close(std::uint32_t row) {
    if (open_.insert(row).second) {
      PLAYHOUSE_ASSERT(dummy_.start({row}).ok());
      return;
    }
    dummy_.stop({row});
    open_.erase(row);
  }
  void say(std::uint32_t row, MessageType type, std::uint8_t subtype, std::span<const std::byte> body) {
    const wire::MessageDef* const message = wire::find_message(interfaces_[row], type, subtype);
    if (message == nullptr || !message->check(body).empty()) return;  // a session lets none of these through
    const device::Message said{{row}, static_cast<std::uint8_t>(type), subtype, body};
    if (type == MessageType::kCmd) {
      PLAYHOUSE_ASSERT(dummy_.command(said) == device::Taken::kLatest);
      return;
    }
    asked_ = message;
    dummy_.request(said, {*this, 1});
    PLAYHOUSE_ASSERT(asked_ == nullptr);
  }

  net::SimulatedNetwork network_{1};
  std::vector<std::uint16_t> interfaces_;  // by the device's row
  std::set<std::uint32_t> open_;
  const wire::MessageDef* asked_ = nullptr;  // the request that is not answered
  Site site_{*this, 6665};
  Dummy dummy_{site_, 0.1, 1};
};

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::FuzzScript script(std::as_bytes(std::span(data, size)));
  playhouse::drivers::Program program;
  for (int step = 0; step < 64 && !script.done(); ++step) program.step(script);
  return 0;
}
