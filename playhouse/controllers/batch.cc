#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {
namespace {

using world::ModelRow;
using world::World;

/// Appends the rows in their own table of all models of one kind in the tree of `model`.
template <typename PartRow>
void collect(const World& world, ModelRow model, scene::ModelKind kind, std::vector<PartRow>& found) {
  if (world.models.kind[model.index] == kind) found.push_back(PartRow{world.models.part[model.index]});
  for (const std::uint32_t child : world.children(model)) collect(world, ModelRow{child}, kind, found);
}

/// Heading of a ranger's body frame in a robot above it. [rad]
double heading_in(const World& world, ModelRow robot, ModelRow ranger) {
  double heading = world.desc(ranger).X_MB.a;
  for (std::uint32_t at = ranger.index; at != robot.index; at = world.models.parent[at]) {
    heading += world.desc(ModelRow{at}).X_PM.a;
  }
  return heading;
}

}  // namespace

world::PositionRow position_of(const World& world, ModelRow model) {
  if (world.models.kind[model.index] != scene::ModelKind::kPosition) return {};
  return {world.models.part[model.index]};
}

std::vector<world::RangerRow> rangers_of(const World& world, ModelRow model) {
  std::vector<world::RangerRow> found;
  collect(world, model, scene::ModelKind::kRanger, found);
  return found;
}

std::vector<world::FiducialRow> finders_of(const World& world, ModelRow model) {
  std::vector<world::FiducialRow> found;
  collect(world, model, scene::ModelKind::kFiducial, found);
  return found;
}

std::vector<float> bearings_of(const World& world, ModelRow robot, world::RangerRow ranger) {
  const ModelRow model = world.rangers.model[ranger.index];
  const double heading = heading_in(world, robot, model);
  std::vector<float> bearings;
  for (const scene::RangerSensorDesc& sensor : world.desc(model).sensors) {
    for (std::uint32_t k = 0; k < sensor.samples; ++k) {
      const double beam = sensor.samples == 1 ? 0 : sensor.fov * (k / (sensor.samples - 1.0) - 0.5);
      bearings.push_back(static_cast<float>(geom::normalize(heading + sensor.X_BS.a + beam)));
    }
  }
  return bearings;
}

std::uint32_t first_beam(const World& world, world::RangerRow ranger) {
  const std::uint32_t sensor = world.rangers.first_sensor[ranger.index];
  return world.rangers.sensor_count[ranger.index] == 0 ? 0 : world.sensors.first_beam[sensor];
}

std::uint32_t beam_count(const World& world, world::RangerRow ranger) {
  const std::uint32_t first = world.rangers.first_sensor[ranger.index];
  std::uint32_t beams = 0;
  for (std::uint32_t k = first; k < first + world.rangers.sensor_count[ranger.index]; ++k) {
    PLAYHOUSE_ASSERT(world.sensors.first_beam[k] == world.sensors.first_beam[first] + beams);
    beams += world.sensors.beam_count[k];
  }
  return beams;
}

}  // namespace playhouse::controllers
