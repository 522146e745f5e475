/// Clients that open, command and ask every device of a small world with any values, while it runs. Each
/// request is answered exactly once, what goes out is what the catalogue of messages says, in order, and the
/// world stays finite.

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/graphics2d.h"
#include "playhouse/wire/generated/graphics3d.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/sonar.h"
#include "playhouse/wire/messages.h"
#include "playhouse/world/drawing.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

constexpr const char* kWorld = R"(
interval_sim 100
model( name "wall" pose [3 0 0 0] size [0.2 6 1] )
position( name "r0" size [0.44 0.38 0.22] origin [-0.04 0 0 0] fiducial_return 7 localization "odom"
  ranger( name "scanner" sensor( range [0.1 8] fov 180 samples 19 ) )
  ranger( name "sonars" sensor( pose [0.2 0.1 0 90] range [0 5] fov 15 ) sensor( range [0 5] fov 15 samples 2 ) )
  fiducial( name "finder" range_max 6 fov 90 ) )
position( name "r1" pose [1 1 0 90] size [0.4 0.4 0.2] drive "car" localization "gps" )
position( name "r2" pose [-1 1 0 0] size [0.4 0.4 0.2] drive "omni" fiducial_return 2 )
)";

struct Shown {
  std::uint16_t interf;
  const char* model;
};
constexpr Shown kDevices[] = {{wire::simulation::kCode, ""},        {wire::position2d::kCode, "r0"},
                              {wire::position2d::kCode, "r1"},      {wire::position2d::kCode, "r2"},
                              {wire::ranger::kCode, "r0.scanner"},  {wire::ranger::kCode, "r0.sonars"},
                              {wire::laser::kCode, "r0.scanner"},   {wire::sonar::kCode, "r0.sonars"},
                              {wire::fiducial::kCode, "r0.finder"}, {wire::graphics2d::kCode, "r0"},
                              {wire::graphics3d::kCode, "r0"}};
constexpr std::size_t kDeviceCount = std::size(kDevices);

void expect_body(std::uint16_t interf, MessageType type, std::uint8_t subtype,
                 std::span<const std::byte> body) {
  const wire::MessageDef* const row = wire::find_message(interf, type, subtype);
  PLAYHOUSE_ASSERT(row != nullptr);
  PLAYHOUSE_ASSERT(row->check(body).empty());
}

/// The server's place: knows which requests are open and what comes out.
class Clients final : public device::Outlet, public device::Publisher {
 public:
  device::Replier ask(std::uint16_t interf, std::uint8_t subtype) {
    open_[++last_ticket_] = {interf, subtype};
    return {*this, last_ticket_};
  }
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override {
    const auto asked = open_.find(ticket);
    PLAYHOUSE_ASSERT(asked != open_.end());
    const auto [interf, subtype] = asked->second;
    if (ack) expect_body(interf, MessageType::kAck, subtype, body);
    open_.erase(asked);
  }
  void publish(std::vector<device::Publication> batch) override {
    for (const device::Publication& data : batch) {
      PLAYHOUSE_ASSERT(data.device.row < kDeviceCount);
      expect_body(kDevices[data.device.row].interf, MessageType::kData, data.subtype, data.body);
      double& newest = newest_.try_emplace({data.device, data.subtype}, -1).first->second;
      PLAYHOUSE_ASSERT(data.timestamp > newest);
      newest = data.timestamp;
    }
  }
  bool all_answered() const { return open_.empty(); }

 private:
  std::uint64_t last_ticket_ = 0;
  std::map<std::uint64_t, std::pair<std::uint16_t, std::uint8_t>> open_;
  std::map<std::pair<device::DeviceId, std::uint8_t>, double> newest_;
};

void append(std::vector<std::byte>& body, std::uint64_t value, int bytes) {
  for (int i = bytes - 1; i >= 0; --i) body.push_back(static_cast<std::byte>(value >> 8 * i & 0xFF));
}

/// Fields, each of a kind, until an invalid kind.
std::vector<std::byte> any_body(FuzzScript& script) {
  std::vector<std::byte> body;
  while (!script.done()) {
    switch (script.byte()) {
      case 0: {
        const double number = script.number();
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        append(body, bits, 8);
        break;
      }
      case 1:
        append(body, script.byte(), 4);
        break;
      case 2: {  // a text: its length, twice, and its bytes, up to whole words
        const auto text = script.take(script.byte());
        append(body, text.size(), 4);
        append(body, text.size(), 4);
        body.insert(body.end(), text.begin(), text.end());
        body.resize((body.size() + 3) / 4 * 4);
        break;
      }
      case 3: {
        const auto raw = script.take(4);
        body.insert(body.end(), raw.begin(), raw.end());
        break;
      }
      default:
        return body;
    }
  }
  return body;
}

struct Bridge {
  scene::SceneDesc scene;
  Clients clients;
  run::Simulation simulation;
  ModelDevices devices;
  SimulatedDriver driver;
  std::set<std::uint32_t> open;

  explicit Bridge(scene::SceneDesc loaded)
      : scene(std::move(loaded)),
        simulation(*stage::make_engine(scene, {}), {.speed = 0, .paused = false, .duration = 0}),
        devices(simulation, clients),
        driver(devices, "stage") {
    for (std::uint32_t row = 0; row < kDeviceCount; ++row) {
      const auto [interf, name] = kDevices[row];
      const world::ModelRow model = *name == '\0' ? world::ModelRow{} : simulation.world().find(name);
      driver.add({row}, make_device(devices, interf, model));
      if (model)
        devices.directory().add(simulation.world().id(model),
                                {6665, interf, static_cast<std::uint16_t>(row)});
    }
  }

  void open_or_close(std::uint32_t row) {
    if (open.insert(row).second) {
      PLAYHOUSE_ASSERT(driver.start({row}).ok());
      return;
    }
    driver.stop({row});
    open.erase(row);
  }

  void say(std::uint32_t row, MessageType type, std::uint8_t subtype, const std::vector<std::byte>& body) {
    const std::uint16_t interf = kDevices[row].interf;
    const wire::MessageDef* const def = wire::find_message(interf, type, subtype);
    if (def == nullptr || !def->check(body).empty()) return;  // a session lets none of these through
    const device::Message message{{row}, static_cast<std::uint8_t>(type), subtype, body};
    if (type == MessageType::kCmd)
      driver.command(message);
    else
      driver.request(message, clients.ask(interf, subtype));
  }

  void run(unsigned ticks) {
    simulation.requests().resume();  // whoever paused it
    simulation.extend(ticks);
    simulation.run();
    PLAYHOUSE_ASSERT(clients.all_answered());
    for (const geom::Pose& X : simulation.world().models.X_WM)
      PLAYHOUSE_ASSERT(std::isfinite(X.x) && std::isfinite(X.y) && std::isfinite(X.z) && std::isfinite(X.a));
    simulation.world().models.drawing.each_kept(
        [](const std::vector<world::DrawnCorner>& drawing) { PLAYHOUSE_ASSERT(world::is_drawing(drawing)); });
  }
};

void play(FuzzScript script) {
  config::MemoryFiles none({});
  Bridge bridge(*scene::load_world_text(kWorld, "bridge.world", none));
  for (unsigned step = 0; step < 256 && !script.done(); ++step) {
    const std::uint8_t what = script.byte();
    const std::uint32_t row = what / 8 % kDeviceCount;
    switch (what % 8) {
      case 0:
        bridge.open_or_close(row);
        break;
      case 1:
        bridge.run(what / 8 % 4);
        break;
      case 2:
      case 3: {
        const std::uint8_t subtype = script.byte();
        bridge.say(row, MessageType::kCmd, subtype, any_body(script));
        break;
      }
      default: {
        const std::uint8_t subtype = script.byte();
        bridge.say(row, MessageType::kReq, subtype, any_body(script));
      }
    }
  }
  bridge.run(2);
  for (const std::uint32_t row : std::set(bridge.open)) bridge.open_or_close(row);
  bridge.run(1);
}

}  // namespace
}  // namespace playhouse::drivers

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  playhouse::log::silence();
  playhouse::drivers::play(playhouse::FuzzScript(std::as_bytes(std::span(data, size))));
  return 0;
}
