/// Speech of other models, as interface speech_recognition (docs/drivers.md).

#include "playhouse/wire/generated/speech_recognition.h"

#include "playhouse/base/limits.h"
#include "playhouse/bridge/generated/device_makers.h"

namespace playhouse::drivers {
namespace {

namespace heard = wire::speech_recognition;

class SpeechRecognition final : public SimulatedDevice {
 public:
  SpeechRecognition(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  /// Skips earlier utterances.
  void opened(world::Journal& journal) override {
    journal.listen();
    heard_ = journal.world().utterances.count;
  }
  void ended(world::Journal& journal) override { journal.stop_listening(); }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::Utterances& said = world.utterances;
    const world::ModelRow row = world.row(model());
    if (!row || heard_ == said.count) return;
    const world::ModelRow root = world.models.root[row];
    if (said.count - heard_ > limits::kUtterances) heard_ = said.count - limits::kUtterances;
    for (; heard_ < said.count; ++heard_) {
      const world::Utterances::One& one = said.newest[heard_ % limits::kUtterances];
      const world::ModelRow speaker = world.row(one.model);
      if (speaker && world.models.root[speaker] == root) continue;  // its own voice
      publish(world, heard::kDataString, heard::Data{wire::c_string(one.text)}, out);
    }
  }

 private:
  std::uint64_t heard_ = 0;  // next utterance
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_speech_recognition_device(run::Simulation& simulation,
                                                                world::ModelRow model) {
  return std::make_unique<SpeechRecognition>(simulation, model);
}

}  // namespace playhouse::drivers
