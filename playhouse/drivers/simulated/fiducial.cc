#include "playhouse/drivers/simulated/fiducial.h"

#include "playhouse/drivers/simulated/shapes.h"
#include "playhouse/wire/generated/fiducial.h"

namespace playhouse::drivers {

namespace fid = wire::fiducial;
using wire::MessageType;

Fiducial::Fiducial(Simulation& simulation, world::ModelRow model)
    : SimulatedDevice(simulation, simulation.world().id(model)) {
  const world::World& world = simulation.world();
  const scene::ModelDesc& desc = world.desc(model);
  geometry_ = wire::encode(fid::Geom{pose3d(pose_on_robot(world, model)), bbox3d(desc.size), {}});
  const scene::FiducialDesc finder = desc.fiducial.value_or(scene::FiducialDesc{});
  field_of_view_ =
      wire::encode(fid::Fov{static_cast<float>(finder.range_min), static_cast<float>(finder.range_max),
                            static_cast<float>(finder.fov)});
}

std::span<const Served> Fiducial::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, fid::kReqGetGeom},
      {MessageType::kReq, fid::kReqGetFov},
      {MessageType::kReq, fid::kReqGetId},
      {MessageType::kReq, fid::kReqSetId},
  };
  return kServed;
}

void Fiducial::request(const device::Message& message, device::Replier replier) {
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

/// Sets the id if the message is SET_ID; answers with the id either way.
void Fiducial::exchange_id(const device::Message& message, device::Replier replier) {
  std::optional<std::int32_t> wanted;
  if (message.subtype == fid::kReqSetId) {
    const auto value = wire::decode<fid::Id>(message.body);
    if (!value) return;
    wanted = static_cast<std::int32_t>(value->id);
  }
  ask_world(std::move(replier), [id = model(), wanted](world::World& world) -> std::optional<Bytes> {
    const world::ModelRow finder = world.row(id);
    if (!finder) return std::nullopt;
    const std::uint32_t robot = world.models.root[finder.index];
    if (wanted) world::set_fiducial_return(world, {robot}, *wanted);
    return wire::encode(fid::Id{static_cast<std::uint32_t>(world.models.fiducial_return[robot])});
  });
}

void Fiducial::emit(const world::World& world, std::vector<device::Publication>& out) {
  const world::ModelRow row = world.row(model());
  if (!row) return;
  const std::uint32_t finder = world.models.part[row.index];
  if (world.fiducials.measured_tick[finder] != world.tick()) return;
  fid::Data data;
  for (const world::FiducialHit& hit : world.fiducials.hits[finder]) {
    const geom::SinCos bearing = geom::sincos(hit.bearing);
    fid::Item item;
    item.id = hit.id;
    item.pose.px = hit.range * bearing.cos;
    item.pose.py = hit.range * bearing.sin;
    item.pose.pyaw = hit.heading;
    data.fiducials.push_back(item);
  }
  publish(world, fid::kDataScan, data, out);
}

std::unique_ptr<SimulatedDevice> make_fiducial_device(Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Fiducial>(simulation, model);
}

}  // namespace playhouse::drivers
