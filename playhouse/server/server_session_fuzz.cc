// Clients that send anything, stall, vanish and come back, while devices publish, come and go: the server
// must neither crash nor grow nor wait. The first byte of the input seeds the network's pieces; each later
// step is one byte of what to do and, for bytes to send, two bytes of length.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "playhouse/base/assert.h"
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

/// A place where a device comes and goes: of the wheels, which answer at once, or of a laser, which does not.
struct Place {
  device::Address address;
  std::unique_ptr<FakeDriver> driver = {};  // none while there is no device
  device::DeviceId id = {};                 // of the last one

  void come(Server& server) {
    driver = std::make_unique<FakeDriver>();
    driver->answers[1] = std::vector<std::byte>(72);
    driver->answers[wire::kReqGetDblprop] = wire::encode(wire::DblpropReq{wire::c_string("rate"), 0.5});
    driver->holds_requests = driver->holds_barriers = address.interf == 6;
    id = *server.add_device(address, *driver);
  }
  void go(Server& server) {
    server.retire_device(id);
    driver.reset();
  }
  void answer() {
    if (!driver) return;
    driver->held.clear();
    driver->barriers.clear();
  }
};

void play(FuzzScript script) {
  net::SimulatedNetwork network(script.byte());
  network.window_bytes = 512;
  Place places[] = {{{kPort, 4, 0}}, {{kPort, 6, 0}}, {{kPort, 4, 1}}, {{kPort, 6, 1}}};
  Server server(network);
  if (!server.listen(kPort)) return;
  for (Place& place : places) place.come(server);
  std::vector<net::SimulatedPeer> peers{network.connect(kPort)};
  double time = 0;
  for (int steps = 0; steps < kSteps && !script.done(); ++steps) {
    const std::uint8_t step = script.byte();
    net::SimulatedPeer& peer = peers[step / 16 % peers.size()];
    Place& place = places[step / 16 % std::size(places)];
    switch (step % 16) {
      case 0: {
        std::vector<device::Publication> batch;
        batch.push_back({place.id, 1, time += 0.1, std::vector<std::byte>(step)});
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
        for (Place& each : places) each.answer();
        break;
      case 7:
        network.run();
        break;
      case 15:
        place.driver ? place.go(server) : place.come(server);
        break;
      default:
        peer.send(script.take(script.byte() * 256u + script.byte()));
    }
    if (step % 2 == 0) network.run();
  }
  network.run();
  for (Place& place : places)
    if (place.driver) place.go(server);
  for (net::SimulatedPeer& peer : peers) peer.vanish();
  network.run();
  PLAYHOUSE_ASSERT(server.status().device_rows == 0);
}

}  // namespace
}  // namespace playhouse::server

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::server::play(playhouse::FuzzScript(std::as_bytes(std::span(data, size))));
  return 0;
}
