/// An inertial measurement unit as interface imu (docs/drivers.md).

#include "playhouse/wire/generated/imu.h"

#include <atomic>
#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/drivers/shapes.h"

namespace playhouse::drivers {
namespace {

namespace imu = wire::imu;
using geom::Quaternion;
using geom::Vec3;
using wire::MessageType;

Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Estimated attitude, before the reference is applied.
Quaternion attitude(const world::Imus& imus, world::ImuRow row) {
  return geom::orientation(imus.X_WE[row].a, imus.tilt_WE[row]);
}
/// Attitude relative to the reference, as published.
Quaternion told_attitude(const world::Imus& imus, world::ImuRow row) {
  return inverse(geom::orientation(imus.reference_heading[row], imus.reference_tilt[row])) *
         attitude(imus, row);
}

geom::SpatialPose reference(const Quaternion& q) {
  return geom::spatial_pose({}, q);
}

/// Direction in W of the field of an axial dipole (Campbell, "Introduction
/// to Geomagnetic Fields", 2003: tan(inclination) = 2 tan(latitude)).
Vec3 field(double latitude) {
  const double s = std::sin(latitude), scale = 1 / std::sqrt(1 + 3 * s * s);
  return {0, scale * std::cos(latitude), -2 * scale * s};
}

float number(double value) {
  return static_cast<float>(value);
}

class Imu final : public SimulatedDevice {
 public:
  Imu(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        field_W_(field(simulation.world().scene().latitude)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, imu::kReqSetDatatype},
        {MessageType::kReq, imu::kReqResetOrientation},
        {MessageType::kReq, imu::kReqResetEuler},
    };
    return kServed;
  }
  void request(const device::Message& message, device::Replier replier) override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;
  void closed(world::Journal&) override { datatype_ = imu::kDataState; }

 private:
  /// Makes `reference(imus, row)` the reference of this unit; NACK if it has not measured yet.
  template <typename Reference>
  void set_reference(device::Replier replier, const Reference& reference) const {
    answer_by(std::move(replier), [id = model(), reference](world::Journal& journal) -> std::optional<Bytes> {
      const world::World& world = journal.world();
      const world::ModelRow row = world.row(id);
      if (!row) return std::nullopt;
      const geom::SpatialPose X = reference(world.imus, world::ImuRow(world.models.part[row]));
      if (!journal.apply(world::changes::SetAttitudeReference{id, X.X.a, X.tilt})) return std::nullopt;
      return Bytes();
    });
  }
  imu::DataCalib calibrated(const world::Imus& imus, world::ImuRow row) const;

  Vec3 field_W_;
  std::atomic<std::uint8_t> datatype_{imu::kDataState};  // type of message to send
};

void Imu::request(const device::Message& message, device::Replier replier) {
  if (message.subtype == imu::kReqSetDatatype) {
    const auto value = wire::decode<imu::DatatypeConfig>(message.body);
    if (!value || value->value < imu::kDataState || value->value > imu::kDataFullstate) return;  // NACK
    datatype_ = value->value;
    replier.ack();
  } else if (message.subtype == imu::kReqResetOrientation) {
    const auto value = wire::decode<imu::ResetOrientationConfig>(message.body);
    if (!value || value->value > 2) return;
    set_reference(std::move(replier), [all = value->value != 0](const world::Imus& imus, world::ImuRow row) {
      return all ? reference(attitude(imus, row)) : geom::SpatialPose{{0, 0, 0, imus.X_WE[row].a}, {}};
    });
  } else {
    const auto value = wire::decode<imu::ResetEulerConfig>(message.body);
    if (!value) return;
    const wire::Pose3d& turns = value->orientation;
    if (!std::isfinite(turns.proll) || !std::isfinite(turns.ppitch) || !std::isfinite(turns.pyaw)) return;
    const geom::SpatialPose X =
        geom::spatial_pose({}, geom::RollPitchYaw{turns.proll, turns.ppitch, turns.pyaw});
    set_reference(std::move(replier),
                  [q = geom::orientation(X.X.a, X.tilt)](const world::Imus& imus, world::ImuRow row) {
                    return reference(attitude(imus, row) * inverse(q));
                  });
  }
}

imu::DataCalib Imu::calibrated(const world::Imus& imus, world::ImuRow row) const {
  const auto& [f, w] = imus.reading[row];
  const Vec3 n = inverse(geom::orientation(imus.X_WB[row].a, imus.tilt_WB[row])) * field_W_;
  return {number(f.x), number(f.y), number(f.z), number(w.x), number(w.y),
          number(w.z), number(n.x), number(n.y), number(n.z)};
}

void Imu::emit(const world::World& world, std::vector<device::Publication>& out) {
  const world::ModelRow model_row = world.row(model());
  if (!model_row) return;
  const world::Imus& imus = world.imus;
  const world::ImuRow row = world.models.part[model_row];
  if (imus.measured_tick[row] != world.tick()) return;
  const Quaternion q = told_attitude(imus, row);
  const geom::Pose& at = imus.X_WE[row];
  const wire::Pose3d pose = pose3d(geom::spatial_pose({at.x, at.y, at.z}, q));
  const auto& [f, w] = imus.reading[row];
  switch (datatype_) {
    case imu::kDataCalib:
      return publish(world, imu::kDataCalib, calibrated(imus, row), out);
    case imu::kDataQuat:
      return publish(world, imu::kDataQuat,
                     imu::DataQuat{calibrated(imus, row), number(q.w), number(q.x), number(q.y), number(q.z)},
                     out);
    case imu::kDataEuler:
      return publish(world, imu::kDataEuler,
                     imu::DataEuler{calibrated(imus, row), {pose.proll, pose.ppitch, pose.pyaw}}, out);
    case imu::kDataFullstate: {
      const Vec3 v = inverse(attitude(imus, row)) * imus.v_WE[row];
      return publish(world, imu::kDataFullstate,
                     imu::DataFullstate{pose, {v.x, v.y, v.z, w.x, w.y, w.z}, {f.x, f.y, f.z, 0, 0, 0}}, out);
    }
    default:
      return publish(world, imu::kDataState, imu::DataState{pose}, out);
  }
}

}  // namespace

std::unique_ptr<SimulatedDevice> make_imu_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Imu>(simulation, model);
}

}  // namespace playhouse::drivers
