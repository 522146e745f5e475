#include "playhouse/drivers/algorithm/scan_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace rng = wire::ranger;
namespace snr = wire::sonar;

namespace {

constexpr std::size_t kMostEyes = 1000;  // of a ring: what a step costs is linear in them

std::uint8_t subtype_of(ScanInterface interf) {
  switch (interf) {
    case ScanInterface::kLaser:
      return lsr::kDataScan;
    case ScanInterface::kRanger:
      return rng::kDataRange;
    case ScanInterface::kSonar:
      break;
  }
  return snr::kDataRanges;
}

std::string_view no_places(ScanInterface interf) {
  switch (interf) {
    case ScanInterface::kLaser:
      return "its laser does not tell its place";
    case ScanInterface::kRanger:
      return "its ranger does not tell its places";
    case ScanInterface::kSonar:
      break;
  }
  return "its sonars do not tell their places";
}

/// Without tilts; none if one cannot be used, lest ranges are taken for those of other sensors.
std::vector<geom::Pose> usable_places(std::span<const wire::Pose3d> poses) {
  std::vector<geom::Pose> X_RS;
  for (const wire::Pose3d& pose : poses) {
    const std::optional<geom::Pose> place = planar(pose);
    if (!place) return {};
    X_RS.push_back(*place);
  }
  return X_RS;
}

/// Of each element on the robot; of the device, if it has none.
std::vector<geom::Pose> places_of(const rng::Geom& geom) {
  const std::optional<geom::Pose> X_RD = planar(geom.pose);
  if (!X_RD) return {};
  if (geom.element_poses.empty()) return {*X_RD};
  std::vector<geom::Pose> X_RS = usable_places(geom.element_poses);
  for (geom::Pose& place : X_RS) place = geom::compose(*X_RD, place);
  return X_RS;
}

std::optional<RangeScan> laser_scan(const lsr::Data& data, std::vector<ScanEye> eyes) {
  RangeScan scan{std::move(eyes), data.ranges, data.min_angle, data.resolution};
  scan.max_range = data.max_range;
  return scan;
}

/// What one of them lacks, the others do without.
std::optional<RangeScan> sonar_scan(snr::Data data, std::vector<ScanEye> eyes) {
  const std::size_t count = std::min(data.ranges.size(), eyes.size());
  eyes.resize(count);
  data.ranges.resize(count);
  return RangeScan{std::move(eyes), std::move(data.ranges)};
}

}  // namespace

std::string_view name_of(ScanInterface interf) {
  switch (interf) {
    case ScanInterface::kLaser:
      return "laser";
    case ScanInterface::kRanger:
      return "ranger";
    case ScanInterface::kSonar:
      break;
  }
  return "sonar";
}

std::vector<ScanInterface> named_scans(const config::CfgSection& section) {
  std::vector<ScanInterface> named;
  for (const ScanInterface each : kScanInterfaces)
    if (names_device(section, "requires", name_of(each))) named.push_back(each);
  if (named.empty()) named.push_back(ScanInterface::kLaser);
  return named;
}

WantedDevice wanted_scan(ScanInterface interf) {
  return {.interf = name_of(interf), .key = {}, .called = "laser, ranger or sonar"};
}

ScanReader::ScanReader(device::DeviceClient& client, std::size_t device, ScanInterface interf)
    : client_(client), device_(device), interf_(interf), scans_(client.latest(device, subtype_of(interf))) {
  if (interf == ScanInterface::kRanger) stamped_ = &client.latest(device, rng::kDataRangestamped);
}

// --- places and angles

void ScanReader::ask(Failed failed) {
  {
    const std::lock_guard lock(mutex_);
    eyes_.clear();
    config_.reset();
  }
  if (interf_ == ScanInterface::kLaser) {
    client_.ask(device_, lsr::kReqGetGeom, {}, [this, failed = std::move(failed)](const AnswerBody& body) {
      const std::optional<lsr::Geom> geom = decoded<lsr::Geom>(body);
      take_places(geom ? std::vector{geom->pose} : std::vector<wire::Pose3d>(), failed);
    });
  } else if (interf_ == ScanInterface::kSonar) {
    client_.ask(device_, snr::kReqGetGeom, {}, [this, failed = std::move(failed)](const AnswerBody& body) {
      take_places(decoded<snr::Geom>(body).value_or(snr::Geom{}).poses, failed);
    });
  } else {
    client_.ask(device_, rng::kReqGetGeom, {}, [this, failed = std::move(failed)](const AnswerBody& body) {
      const std::optional<rng::Geom> geom = decoded<rng::Geom>(body);
      if (!geom) return failed(std::string(no_places(interf_)));
      take_geometry(*geom, failed);
    });
  }
}

void ScanReader::take_places(const std::vector<wire::Pose3d>& poses, const Failed& failed) {
  const std::vector<geom::Pose> X_RS = usable_places(poses);
  if (X_RS.empty()) return failed(std::string(no_places(interf_)));
  if (X_RS.size() > kMostEyes)
    return failed(fmt::format("its sonars are {}, and {} at most can be used", X_RS.size(), kMostEyes));
  const std::lock_guard lock(mutex_);
  if (interf_ == ScanInterface::kLaser) {
    eyes_ = {{X_RS.front()}};
  } else {
    eyes_ = ring_of(X_RS);
  }
}

/// Of a ranger. Angles and limits are asked for before its scans are used.
void ScanReader::take_geometry(const rng::Geom& geom, const Failed& failed) {
  const std::vector<geom::Pose> X_RS = places_of(geom);
  if (X_RS.empty()) return failed(std::string(no_places(interf_)));
  if (X_RS.size() > kMostEyes)
    return failed(
        fmt::format("its ranger has {} elements, and {} at most can be used", X_RS.size(), kMostEyes));
  client_.ask(device_, rng::kReqGetConfig, {},
              [this, eyes = ring_of(X_RS), failed](const AnswerBody& body) mutable {
                const std::optional<rng::Config> config = decoded<rng::Config>(body);
                if (!config && eyes.size() == 1) return failed("its ranger does not tell its angles");
                const std::lock_guard lock(mutex_);
                eyes_ = std::move(eyes);
                config_ = config;
              });
}

bool ScanReader::is_ready() const {
  const std::lock_guard lock(mutex_);
  return !eyes_.empty();
}

// --- scans

bool ScanReader::take() {
  std::optional<device::Publication> ranges = scans_.take_latest();
  std::optional<device::Publication> stamped;
  if (stamped_ != nullptr) stamped = stamped_->take_latest();
  if (stamped) take_changes(*stamped);
  if (!ranges) return false;
  newest_ = std::move(*ranges);
  return true;
}

void ScanReader::take_changes(const device::Publication& stamped) {
  const Result<rng::DataRangestamped> scan = wire::decode<rng::DataRangestamped>(stamped.body);
  if (!scan) return;
  const std::vector<geom::Pose> X_RS =
      scan->have_geom != 0 ? places_of(scan->geom) : std::vector<geom::Pose>();
  const std::lock_guard lock(mutex_);
  if (scan->have_config != 0) config_ = scan->config;
  if (!X_RS.empty() && X_RS.size() <= kMostEyes) eyes_ = ring_of(X_RS);
}

std::optional<RangeScan> ScanReader::scan() const {
  const std::lock_guard lock(mutex_);
  if (eyes_.empty()) return std::nullopt;
  if (interf_ == ScanInterface::kLaser) {
    const Result<lsr::Data> data = wire::decode<lsr::Data>(newest_.body);
    return data ? laser_scan(*data, eyes_) : std::nullopt;
  }
  if (interf_ == ScanInterface::kSonar) {
    Result<snr::Data> data = wire::decode<snr::Data>(newest_.body);
    return data ? sonar_scan(std::move(*data), eyes_) : std::nullopt;
  }
  const Result<rng::DataRange> data = wire::decode<rng::DataRange>(newest_.body);
  if (!data) return std::nullopt;
  std::vector<float> ranges;
  ranges.reserve(data->ranges.size());
  for (const double range : data->ranges) ranges.push_back(static_cast<float>(range));
  return ranger_scan(std::move(ranges));
}

/// One range per element is that along its pose; more are spread as its configuration says. Locked.
std::optional<RangeScan> ScanReader::ranger_scan(std::vector<float> ranges) const {
  RangeScan scan{eyes_, std::move(ranges)};
  if (config_ && config_->max_range > 0)
    scan.max_range = static_cast<float>(config_->max_range);  // as ranges
  const std::size_t beams = scan.beams();
  if (beams <= 1) return scan;
  if (!config_) return std::nullopt;
  for (ScanEye& eye : scan.eyes) eye.half_width = 0;
  scan.first_angle = config_->min_angle;
  scan.angle_step = config_->angular_res > 0
                        ? config_->angular_res
                        : (config_->max_angle - config_->min_angle) / static_cast<double>(beams - 1);
  return scan;
}

}  // namespace playhouse::drivers
