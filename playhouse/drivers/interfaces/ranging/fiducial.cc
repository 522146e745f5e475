#include "playhouse/drivers/interfaces/ranging/fiducial.h"

#include "playhouse/drivers/interfaces/shapes.h"

namespace playhouse::drivers {

namespace fid = wire::fiducial;
using wire::MessageType;

namespace {

fid::Fov field_of_view(const world::World& world, world::ModelRow model) {
  const scene::FiducialDesc& finder = *world.desc(model).fiducial;
  return {static_cast<float>(finder.range_min), static_cast<float>(finder.range_max),
          static_cast<float>(finder.fov)};
}

class Fiducial final : public FiducialDevice {
 public:
  Fiducial(run::Simulation& simulation, world::ModelRow model)
      : FiducialDevice(simulation, model, field_of_view(simulation.world(), model)) {}

 private:
  std::optional<fid::Data> read(const world::World& world) const override {
    const world::ModelRow row = world.row(model());
    if (!row) return std::nullopt;
    const world::FiducialRow finder = world.models.part[row];
    if (world.fiducials.measured_tick[finder] != world.tick()) return std::nullopt;
    fid::Data data;
    for (const world::FiducialHit& hit : world.fiducials.hits[finder])
      data.fiducials.push_back(fiducial_item(hit.id, hit.range, hit.bearing, hit.heading));
    return data;
  }
};

}  // namespace

fid::Item fiducial_item(std::int32_t id, double range, double bearing, double heading) {
  const geom::SinCos ahead = geom::sincos(bearing);
  fid::Item item;
  item.id = id;
  item.pose.px = range * ahead.cos;
  item.pose.py = range * ahead.sin;
  item.pose.pyaw = heading;
  return item;
}

FiducialDevice::FiducialDevice(run::Simulation& simulation, world::ModelRow model,
                               const fid::Fov& field_of_view)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      geometry_(wire::encode(fid::Geom{pose3d(pose_on_robot(simulation.world(), model)),
                                       bbox3d(simulation.world().desc(model).size),
                                       {}})),
      field_of_view_(wire::encode(field_of_view)) {}

std::span<const Served> FiducialDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, fid::kReqGetGeom},
      {MessageType::kReq, fid::kReqGetFov},
      {MessageType::kReq, fid::kReqGetId},
      {MessageType::kReq, fid::kReqSetId},
  };
  return kServed;
}

void FiducialDevice::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case fid::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case fid::kReqGetFov:
      replier.ack(field_of_view_);
      return;
    case fid::kReqGetId:
    case fid::kReqSetId:
      exchange_id(message, std::move(replier));
      return;
    default:
      return;
  }
}

/// Sets the id if the message is SET_ID; replies with the id in any case.
void FiducialDevice::exchange_id(const device::Message& message, device::Replier replier) {
  std::optional<std::int32_t> wanted;
  if (message.subtype == fid::kReqSetId) {
    const auto value = wire::decode<fid::Id>(message.body);
    if (!value) return;
    wanted = static_cast<std::int32_t>(value->id);
  }
  answer_by(std::move(replier), [id = model(), wanted](world::Journal& journal) -> std::optional<Bytes> {
    const world::World& world = journal.world();
    const world::ModelRow finder = world.row(id);
    if (!finder) return std::nullopt;
    const world::ModelRow robot = world.models.root[finder];
    if (wanted) journal.apply(world::changes::SetFiducial{world.id(robot), *wanted});
    return wire::encode(fid::Id{static_cast<std::uint32_t>(world.models.fiducial_return[robot])});
  });
}

void FiducialDevice::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (const std::optional<fid::Data> data = read(world)) publish(world, fid::kDataScan, *data, out);
}

std::unique_ptr<SimulatedDevice> make_fiducial_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Fiducial>(simulation, model);
}

}  // namespace playhouse::drivers
