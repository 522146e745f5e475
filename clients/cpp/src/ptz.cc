#include "playhouse_client/ptz.h"

#include <utility>

#include "convert.h"
#include "done.h"
#include "finite.h"

namespace playhouse::client {

namespace ptz = wire::ptz;

Result<Ptz> Ptz::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, ptz::kCode, index, access);
  if (!device) return device.error();
  return Ptz(std::move(*device));
}

std::optional<View> Ptz::view() const {
  const auto data = device_.latest<ptz::Data>(ptz::kDataState);
  if (!data) return std::nullopt;
  return View{data->pan, data->tilt, data->zoom, data->panspeed, data->tiltspeed};
}

Result<void> Ptz::look(double pan, double tilt, double zoom) {
  if (const auto sound = finite_floats(device_, "look", {pan, tilt, zoom}); !sound) return sound;
  ptz::Cmd command;
  command.pan = static_cast<float>(pan);
  command.tilt = static_cast<float>(tilt);
  command.zoom = static_cast<float>(zoom);
  return device_.command(ptz::kCmdState, command);
}

Result<void> Ptz::turn(double pan_speed, double tilt_speed) {
  if (const auto sound = finite_floats(device_, "turn", {pan_speed, tilt_speed}); !sound) return sound;
  ptz::Cmd command;
  command.panspeed = static_cast<float>(pan_speed);
  command.tiltspeed = static_cast<float>(tilt_speed);
  return device_.command(ptz::kCmdState, command);
}

Result<void> Ptz::set_velocity_control(bool on) {
  const std::uint32_t mode = on ? ptz::kVelocityControl : ptz::kPositionControl;
  return done(device_.request(ptz::kReqControlMode, ptz::ReqControlMode{mode}));
}

Result<Geometry> Ptz::geometry() {
  const auto geom = device_.request<ptz::Geom>(ptz::kReqGeom);
  if (!geom) return geom.error();
  return Geometry{pose(geom->pos), size(geom->size)};
}

}  // namespace playhouse::client
