#include "playhouse/bridge/analog_sensor.h"

#include "playhouse/wire/generated/aio.h"

namespace playhouse::drivers {
namespace {

class AnalogSensor final : public SimulatedDevice {
 public:
  AnalogSensor(run::Simulation& simulation, world::ModelRow model, Voltages voltages)
      : SimulatedDevice(simulation, simulation.world().id(model)), voltages_(voltages) {}

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    wire::aio::Data data;
    if (row && voltages_(world, world.models.part[row], data.voltages))
      publish(world, wire::aio::kDataState, data, out);
  }

 private:
  Voltages voltages_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_analog_sensor(run::Simulation& simulation, world::ModelRow model,
                                                    Voltages voltages) {
  return std::make_unique<AnalogSensor>(simulation, model, voltages);
}

}  // namespace playhouse::drivers
