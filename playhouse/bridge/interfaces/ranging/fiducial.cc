#include "playhouse/bridge/interfaces/ranging/fiducial.h"

#include <cmath>
#include <utility>

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/scan_settings.h"
#include "playhouse/drivers/shapes.h"

namespace playhouse::drivers {

namespace fid = wire::fiducial;
using wire::MessageType;

namespace {

FovSettings field_of_view(const world::World& world, world::ModelRow model) {
  const scene::FiducialDesc& finder = *world.desc(model).fiducial;
  return {finder.range_min, finder.range_max, finder.fov};
}

fid::Fov fov(const FovSettings& settings) {
  return {static_cast<float>(settings.min_range), static_cast<float>(settings.max_range),
          static_cast<float>(settings.view_angle)};
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
                               const FovSettings& field_of_view)
    : DeviceWithSettings(simulation, simulation.world().id(model), field_of_view),
      geometry_(wire::encode(fid::Geom{pose3d(pose_on_robot(simulation.world(), model)),
                                       bbox3d(simulation.world().desc(model).size),
                                       {}})) {}

std::span<const Served> FiducialDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, fid::kReqGetGeom}, {MessageType::kReq, fid::kReqGetFov},
      {MessageType::kReq, fid::kReqSetFov},  {MessageType::kReq, fid::kReqGetId},
      {MessageType::kReq, fid::kReqSetId},
  };
  return kServed;
}

std::span<const FiducialDevice::NamedSetting> FiducialDevice::named() const {
  static constexpr NamedSetting kNamed[] = {
      {"min_range", &FovSettings::min_range},
      {"max_range", &FovSettings::max_range},
      {"view_angle", &FovSettings::view_angle},
  };
  return kNamed;
}

/// Not more than the model measures.
bool FiducialDevice::settle(FovSettings& wanted) const {
  if (is_same(wanted.min_range, usual().min_range)) wanted.min_range = usual().min_range;
  if (is_same(wanted.max_range, usual().max_range)) wanted.max_range = usual().max_range;
  if (is_same(wanted.view_angle, usual().view_angle)) wanted.view_angle = usual().view_angle;
  return wanted.min_range >= usual().min_range && wanted.min_range <= wanted.max_range &&
         wanted.max_range <= usual().max_range && wanted.view_angle >= 0 &&
         wanted.view_angle <= usual().view_angle;
}

bool FiducialDevice::is_seen(const fid::Item& item) const {
  const FovSettings& set = settings();
  const double range = std::hypot(item.pose.px, item.pose.py);
  const double bearing = std::atan2(item.pose.py, item.pose.px);
  return (set.min_range == usual().min_range || range >= set.min_range) &&
         (set.max_range == usual().max_range || range <= set.max_range) &&
         (set.view_angle == usual().view_angle || std::fabs(bearing) <= set.view_angle / 2);
}

void FiducialDevice::request(const device::Message& message, device::Replier replier) {
  const auto answer = [](const FovSettings& settings) { return wire::encode(fov(settings)); };
  switch (message.subtype) {
    case fid::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case fid::kReqGetFov:
      return tell_settings(std::move(replier), answer);
    case fid::kReqSetFov: {
      const auto value = wire::decode<fid::Fov>(message.body);
      if (!value) return;
      const auto edit = [value = *value](FovSettings& wanted) {
        wanted = {static_cast<double>(value.min_range), static_cast<double>(value.max_range),
                  static_cast<double>(value.view_angle)};
        return true;
      };
      return change_settings(std::move(replier), edit, answer);
    }
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
  std::optional<fid::Data> data = read(world);
  if (!data) return;
  std::erase_if(data->fiducials, [&](const fid::Item& item) { return !is_seen(item); });
  publish(world, fid::kDataScan, *data, out);
}

std::unique_ptr<SimulatedDevice> make_fiducial_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Fiducial>(simulation, model);
}

}  // namespace playhouse::drivers
