#include "playhouse_client/imu.h"

#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace imu = wire::imu;

namespace {

Inertia inertia_of(const imu::DataCalib& data) {
  return {{data.accel_x, data.accel_y, data.accel_z},
          {data.gyro_x, data.gyro_y, data.gyro_z},
          {data.magn_x, data.magn_y, data.magn_z}};
}

/// The subtype, of two, with the newer data.
std::uint8_t newer(const Device& device, std::uint8_t a, std::uint8_t b) {
  return device.timestamp(b) > device.timestamp(a) ? b : a;
}

}  // namespace

Result<Imu> Imu::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, imu::kCode, index, access);
  if (!device) return device.error();
  return Imu(std::move(*device));
}

Result<void> Imu::send(std::uint8_t datatype) {
  return done(device_.request(imu::kReqSetDatatype, imu::DatatypeConfig{datatype}));
}

std::optional<Pose3d> Imu::pose() const {
  if (newer(device_, imu::kDataState, imu::kDataFullstate) == imu::kDataFullstate) {
    const auto data = device_.latest<imu::DataFullstate>(imu::kDataFullstate);
    return data ? std::optional(client::pose(data->pose)) : std::nullopt;
  }
  const auto data = device_.latest<imu::DataState>(imu::kDataState);
  return data ? std::optional(client::pose(data->pose)) : std::nullopt;
}

std::optional<Pose3d> Imu::velocity() const {
  const auto data = device_.latest<imu::DataFullstate>(imu::kDataFullstate);
  return data ? std::optional(client::pose(data->vel)) : std::nullopt;
}

std::optional<Inertia> Imu::inertia() const {
  const std::uint8_t turned = newer(device_, imu::kDataQuat, imu::kDataEuler);
  const std::uint8_t newest = newer(device_, imu::kDataCalib, turned);
  if (newest == imu::kDataQuat) {
    const auto data = device_.latest<imu::DataQuat>(newest);
    return data ? std::optional(inertia_of(data->calib_data)) : std::nullopt;
  }
  if (newest == imu::kDataEuler) {
    const auto data = device_.latest<imu::DataEuler>(newest);
    return data ? std::optional(inertia_of(data->calib_data)) : std::nullopt;
  }
  const auto data = device_.latest<imu::DataCalib>(newest);
  return data ? std::optional(inertia_of(*data)) : std::nullopt;
}

std::optional<Attitude> Imu::attitude() const {
  const auto data = device_.latest<imu::DataEuler>(imu::kDataEuler);
  if (!data) return std::nullopt;
  return Attitude{data->orientation.proll, data->orientation.ppitch, data->orientation.pyaw};
}

std::optional<std::array<double, 4>> Imu::quaternion() const {
  const auto data = device_.latest<imu::DataQuat>(imu::kDataQuat);
  if (!data) return std::nullopt;
  return std::array<double, 4>{data->q0, data->q1, data->q2, data->q3};
}

Result<void> Imu::reset_orientation(bool all_axes) {
  return done(device_.request(imu::kReqResetOrientation, imu::ResetOrientationConfig{all_axes ? 1u : 0u}));
}

Result<void> Imu::reset_attitude(const Attitude& attitude) {
  const auto& [roll, pitch, yaw] = attitude;
  if (const auto sound = finite(device_, "reset_attitude", {roll, pitch, yaw}); !sound) return sound;
  return done(device_.request(imu::kReqResetEuler,
                              imu::ResetEulerConfig{on_wire(Pose3d{0, 0, 0, roll, pitch, yaw})}));
}

}  // namespace playhouse::client
