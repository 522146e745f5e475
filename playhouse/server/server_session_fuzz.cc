// Clients that send anything, stall, vanish and come back, while devices publish: the server must neither
// crash nor grow nor wait. The first byte of the input seeds the network's pieces; each later step is one
// byte of what to do and, for bytes to send, two bytes of length.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/net/simulated.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"

namespace playhouse::server {
namespace {

constexpr std::uint16_t kPort = 6665;
constexpr int kSteps = 512;  // more of the same finds little, and long runs are few

void play(FuzzScript script) {
  net::SimulatedNetwork network(script.byte());
  network.window_bytes = 512;
  FakeDriver wheels, laser;
  wheels.answers[1] = std::vector<std::byte>(72);
  wheels.answers[wire::kReqGetDblprop] = wire::encode(wire::DblpropReq{wire::c_string("rate"), 0.5});
  laser.holds_requests = laser.holds_barriers = true;
  Server server(network);
  if (!server.listen(kPort)) return;
  const device::DeviceId ids[] = {*server.add_device({kPort, 4, 0}, wheels),
                                  *server.add_device({kPort, 6, 0}, laser)};
  std::vector<net::SimulatedPeer> peers{network.connect(kPort)};
  double time = 0;
  for (int steps = 0; steps < kSteps && !script.done(); ++steps) {
    const std::uint8_t step = script.byte();
    net::SimulatedPeer& peer = peers[step / 16 % peers.size()];
    switch (step % 16) {
      case 0: {
        std::vector<device::Publication> batch;
        batch.push_back({ids[step / 16 % 2], 1, time += 0.1, std::vector<std::byte>(step)});
        server.publish(std::move(batch));
        break;
      }
      case 1:
        if (peers.size() < 4) peers.push_back(network.connect(kPort));
        break;
      case 2:
        peer.finish();
        break;
      case 3:
        peer.vanish();
        break;
      case 4:
        peer.stall();
        break;
      case 5:
        peer.read_on();
        break;
      case 6:
        laser.held.clear();
        laser.barriers.clear();
        break;
      case 7:
        network.run();
        break;
      default:
        peer.send(script.take(script.byte() * 256u + script.byte()));
    }
    if (step % 2 == 0) network.run();
  }
  network.run();
  laser.held.clear();
  laser.barriers.clear();
}

}  // namespace
}  // namespace playhouse::server

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  spdlog::set_level(spdlog::level::off);
  playhouse::server::play(playhouse::FuzzScript(std::as_bytes(std::span(data, size))));
  return 0;
}
