/// What others in the world say, as interface speech_recognition (docs/drivers.md).

#include "playhouse/wire/generated/speech_recognition.h"

#include <algorithm>

#include "playhouse/drivers/generated/device_makers.h"

namespace playhouse::drivers {
namespace {

namespace heard = wire::speech_recognition;

class SpeechRecognition final : public SimulatedDevice {
 public:
  SpeechRecognition(Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  /// What was said before is not heard.
  void opened(const world::World& world) override { heard_ = world.said(); }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row || heard_ == world.said()) return;
    const std::uint32_t root = world.models.root[row.index];
    const auto first = std::ranges::upper_bound(world.utterances, heard_, {}, &world::Utterance::number);
    for (auto each = first; each != world.utterances.end(); ++each) {
      const world::ModelRow speaker = world.row(each->model);
      if (speaker && world.models.root[speaker.index] == root) continue;  // its own voice
      publish(world, heard::kDataString, heard::Data{wire::c_string(each->text)}, out);
    }
    heard_ = world.said();
  }

 private:
  std::uint64_t heard_ = 0;  // World::said() after the last utterance that it heard
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_speech_recognition_device(Simulation& simulation,
                                                                world::ModelRow model) {
  return std::make_unique<SpeechRecognition>(simulation, model);
}

}  // namespace playhouse::drivers
