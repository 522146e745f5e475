#include "playhouse/bridge/interfaces/motion/drive_settings.h"

namespace playhouse::drivers {

void DriveDevice::closed(world::Journal& journal) {
  journal.apply(world::changes::PowerWheels{model(), true});
  const world::Positions& positions = journal.world().positions;
  const world::PositionRow row = journal.world().position(model());
  if (positions.speed_limit[row] == geom::Twist{} && positions.acceleration_limit[row] == geom::Twist{})
    return;
  journal.apply(world::changes::LimitWay{model()});
}

void DriveDevice::limit_way(float speed, float acceleration, double geom::Twist::*part,
                            device::Replier replier) const {
  answer_by(std::move(replier), [=, id = model()](world::Journal& journal) -> std::optional<Bytes> {
    const world::World& world = journal.world();
    const world::PositionRow row = world.position(id);
    if (!row) return std::nullopt;
    geom::Twist most = world.positions.speed_limit[row], growth = world.positions.acceleration_limit[row];
    most.*part = static_cast<double>(speed);
    growth.*part = static_cast<double>(acceleration);
    return journal.apply(world::changes::LimitWay{id, most.x, most.a, growth.x, growth.a})
               ? std::optional(Bytes())
               : std::nullopt;
  });
}

}  // namespace playhouse::drivers
