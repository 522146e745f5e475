#include "playhouse/drivers/simulated/auto_map.h"

#include <map>

#include "playhouse/drivers/simulated/device_factory.h"
#include "playhouse/drivers/simulated/scan.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

using scene::ModelKind;

constexpr std::size_t kIndices = 65536;  // of one interface on one port

class Mapper {
 public:
  explicit Mapper(const world::World& world) : world_(world) {}

  AutoMap map() {
    add(wire::simulation::kCode, 0, {});
    // Rows keep the scene's order and children follow their parents, so the robots' numbers are known first.
    for (std::uint32_t row = 0; row < world_.models.size(); ++row) {
      if (is_robot(row)) robot_number_[row] = out_.robots++;
    }
    for (const auto& [robot, number] : robot_number_) map_tree(robot, number);
    for (std::uint32_t row = 0; row < world_.models.size(); ++row) {
      if (world_.models.root[row] == row && !is_robot(row)) map_tree(row, kNoRobot);
    }
    for (const auto& [interf, model] : further_) add(interf, further_index(interf), model);
    return std::move(out_);
  }

 private:
  bool is_robot(std::uint32_t row) const {
    return world_.models.root[row] == row && world_.models.kind[row] == ModelKind::kPosition;
  }

  /// Every device of a top-level model and of all it carries. `number` is the robot's.
  void map_tree(std::uint32_t top, std::size_t number) {
    laser_done_ = sonar_done_ = number == kNoRobot;
    visit(top, number);
  }

  void visit(std::uint32_t row, std::size_t number) {
    const world::ModelRow model{row};
    switch (world_.models.kind[row]) {
      case ModelKind::kPosition:
        add(wire::position2d::kCode, is_robot(row) ? number : further_index(wire::position2d::kCode), model);
        break;
      case ModelKind::kRanger:
        map_ranger(model, number);
        break;
      case ModelKind::kFiducial:
        add(wire::fiducial::kCode, fiducials_++, model);
        break;
      case ModelKind::kPlain:
        break;
    }
    for (const std::uint32_t child : world_.children(model)) visit(child, number);
  }

  void map_ranger(world::ModelRow model, std::size_t number) {
    add(wire::ranger::kCode, rangers_++, model);
    if (fits(world_, model, wire::laser::kCode)) map_first(wire::laser::kCode, model, number, laser_done_);
    if (ranger_rows(world_, model).sensor_count > 1)
      map_first(wire::sonar::kCode, model, number, sonar_done_);
  }

  /// The robot's first gets the robot's number, others wait for the indices behind all robots.
  void map_first(std::uint16_t interf, world::ModelRow model, std::size_t number, bool& done) {
    if (done) {
      further_.emplace_back(interf, model);
    } else {
      add(interf, number, model);
      done = true;
    }
  }

  std::size_t further_index(std::uint16_t interf) {
    const auto [entry, fresh] = next_further_.try_emplace(interf, out_.robots);
    static_cast<void>(fresh);
    return entry->second++;
  }

  void add(std::uint16_t interf, std::size_t index, world::ModelRow model) {
    if (index >= kIndices) {
      ++out_.left_out;
      return;
    }
    out_.devices.push_back({interf, static_cast<std::uint16_t>(index), model});
  }

  /// The number of a tree that is no robot.
  static constexpr std::size_t kNoRobot = static_cast<std::size_t>(-1);

  const world::World& world_;
  AutoMap out_;
  std::map<std::uint32_t, std::size_t> robot_number_;  // by model row
  std::map<std::uint16_t, std::size_t> next_further_;  // by interface
  std::vector<std::pair<std::uint16_t, world::ModelRow>> further_;
  std::size_t rangers_ = 0, fiducials_ = 0;
  bool laser_done_ = false, sonar_done_ = false;
};

}  // namespace

AutoMap auto_map(const world::World& world) {
  return Mapper(world).map();
}

}  // namespace playhouse::drivers
