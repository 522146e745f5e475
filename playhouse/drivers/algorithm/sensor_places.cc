#include "playhouse/drivers/algorithm/sensor_places.h"

#include <optional>
#include <span>
#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {
namespace {

std::vector<geom::Pose> places(std::span<const wire::Pose3d> poses) {
  std::vector<geom::Pose> X_RS;
  for (const wire::Pose3d& pose : poses) {
    const std::optional<geom::Pose> place = planar(pose);
    if (!place) return {};
    X_RS.push_back(*place);
  }
  return X_RS;
}

}  // namespace

void ask_places(device::DeviceClient& client, std::size_t device, ScanSensor sensor,
                std::function<void(std::vector<geom::Pose> X_RS)> heard) {
  if (sensor == ScanSensor::kSonar) {
    return client.ask(device, wire::sonar::kReqGetGeom, {},
                      [heard = std::move(heard)](const AnswerBody& body) {
                        heard(places(decoded<wire::sonar::Geom>(body).value_or(wire::sonar::Geom{}).poses));
                      });
  }
  client.ask(device, wire::laser::kReqGetGeom, {}, [heard = std::move(heard)](const AnswerBody& body) {
    const std::optional<wire::laser::Geom> geom = decoded<wire::laser::Geom>(body);
    heard(geom ? places({&geom->pose, 1}) : std::vector<geom::Pose>());
  });
}

}  // namespace playhouse::drivers
