#include "playhouse/drivers/scans/sonartoranger.h"

namespace playhouse::drivers {

wire::ranger::Geom ranger_geom_of(const wire::sonar::Geom& sonars) {
  return {{}, {}, sonars.poses, std::vector<wire::Bbox3d>(sonars.poses.size())};
}

std::optional<RangerReading> SonarSource::reading(const device::Publication& message) {
  if (message.subtype != wire::sonar::kDataRanges) return std::nullopt;
  const Result<wire::sonar::Data> data = wire::decode<wire::sonar::Data>(message.body);
  if (!data) return std::nullopt;
  return RangerReading{{data->ranges.begin(), data->ranges.end()}, {}};
}

/// A sonar has no configuration.
void SonarSource::answer(Shell& shell) {
  convert_answers<wire::sonar::Geom>(shell, 0, wire::ranger::kReqGetGeom, wire::sonar::kReqGetGeom,
                                     [](const wire::sonar::Geom& sonars) { return ranger_geom_of(sonars); });
  pass_request(shell, wire::ranger::kReqPower, wire::sonar::kReqPower);
}

namespace {

constexpr DeviceText kSonarToRangerUses[] = {{"sonar", {}, HowMany::kOne, "has the ranges"}};

}  // namespace

constinit const DriverDefinition kSonarToRangerDriver{
    .name = "sonartoranger",
    .doc = "Shows the ranges of sonars as a ranger.",
    .provides = kToRangerProvides,
    .uses = kSonarToRangerUses,
    .make = make_to_ranger<SonarSource>,
};

}  // namespace playhouse::drivers
