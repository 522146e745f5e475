#include "playhouse/drivers/rangertolaser/ranger_to_laser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

namespace rng = wire::ranger;
namespace lsr = wire::laser;

namespace {

constexpr std::uint8_t kReq = static_cast<std::uint8_t>(wire::MessageType::kReq);

lsr::Config laser_config(const rng::Config& config) {
  lsr::Config laser;
  laser.min_angle = static_cast<float>(config.min_angle);
  laser.max_angle = static_cast<float>(config.max_angle);
  laser.resolution = static_cast<float>(config.angular_res);
  laser.max_range = static_cast<float>(config.max_range);
  laser.range_res = static_cast<float>(config.range_res);
  laser.intensity = 1;
  laser.scanning_frequency = static_cast<float>(config.frequency);
  return laser;
}

/// The scanner is the ranger's first element.
lsr::Geom laser_geom(const rng::Geom& geom) {
  lsr::Geom laser{geom.pose, geom.size};
  if (geom.element_poses.empty()) return laser;
  const wire::Pose3d& element = geom.element_poses.front();
  const geom::Pose X = geom::compose({geom.pose.px, geom.pose.py, geom.pose.pz, geom.pose.pyaw},
                                     {element.px, element.py, element.pz, element.pyaw});
  laser.pose = {X.x, X.y, X.z, geom.pose.proll, geom.pose.ppitch, X.a};
  return laser;
}

/// The answer to a laser's request from that to the ranger's: decoded, converted, encoded.
template <typename From, typename Convert>
void convert_answer(device::Replier& replier, const std::optional<std::vector<std::byte>>& body,
                    Convert convert) {
  if (!body) return replier.nack();
  const Result<From> value = wire::decode<From>(*body);
  if (!value) return replier.nack();
  replier.ack(wire::encode(convert(*value)));
}

/// What to say of addresses that lack the one interface that is wanted, when one of them nearly is it.
std::string interface_hint(const std::vector<scene::DeviceAddress>& addresses, std::string_view wanted) {
  const std::string_view words[] = {wanted};
  for (const scene::DeviceAddress& address : addresses) {
    if (address.interf == wanted) continue;
    if (const std::string hint = did_you_mean(address.interf, words); !hint.empty())
      return ", found " + in_quotes(address.text()) + hint;
  }
  return {};
}

}  // namespace

lsr::Data laser_scan(const rng::Config& config, const rng::DataRange& ranges,
                     const rng::DataIntns& intensities, std::uint32_t id) {
  lsr::Data scan;
  scan.min_angle = static_cast<float>(config.min_angle);
  scan.max_angle = static_cast<float>(config.max_angle);
  scan.resolution = static_cast<float>(config.angular_res);
  scan.max_range = static_cast<float>(config.max_range);
  scan.id = id;
  for (const double range : ranges.ranges) scan.ranges.push_back(static_cast<float>(range));
  for (const double value : intensities.intensities) {
    scan.intensity.push_back(static_cast<std::uint8_t>(value > 0 ? std::min(value, 255.0) : 0));
  }
  return scan;
}

Result<void> RangerToLaser::start(device::DeviceId) {
  if (const Result<void> held = surroundings_.hold(ranger_.id); !held) return held.error();
  ask_ranger(rng::kReqGetConfig, {}, [this](std::optional<std::vector<std::byte>> body) {
    const Result<rng::Config> config = wire::decode<rng::Config>(body.value_or(std::vector<std::byte>()));
    if (!config) return;
    const std::lock_guard lock(mutex_);
    config_ = *config;
  });
  return {};
}

void RangerToLaser::stop(device::DeviceId) {
  {
    const std::lock_guard lock(mutex_);
    config_.reset();
  }
  surroundings_.release(ranger_.id);
}

void RangerToLaser::request(const device::Message& message, device::Replier replier) {
  if (!capable(message.device, message.type, message.subtype)) return;
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function wants to be copied
  switch (message.subtype) {
    case lsr::kReqGetGeom:
      ask_ranger(rng::kReqGetGeom, {}, [shared](const std::optional<std::vector<std::byte>>& body) {
        convert_answer<rng::Geom>(*shared, body, laser_geom);
      });
      return;
    case lsr::kReqGetConfig:
      ask_ranger(rng::kReqGetConfig, {}, [shared](const std::optional<std::vector<std::byte>>& body) {
        convert_answer<rng::Config>(*shared, body, laser_config);
      });
      return;
    default:  // POWER, which both have with the same payload
      ask_ranger(rng::kReqPower, message.body, [shared](const std::optional<std::vector<std::byte>>& body) {
        if (body) shared->ack();
      });
  }
}

bool RangerToLaser::capable(device::DeviceId, std::uint8_t type, std::uint8_t subtype) const {
  return type == kReq &&
         (subtype == lsr::kReqGetGeom || subtype == lsr::kReqGetConfig || subtype == lsr::kReqPower);
}

void RangerToLaser::ask_ranger(std::uint8_t subtype, std::span<const std::byte> body, Heard heard) {
  std::uint64_t ticket = 0;
  {
    const std::lock_guard lock(mutex_);
    ticket = next_ticket_++;
    asked_[ticket] = std::move(heard);
  }
  ranger_.driver->request({ranger_.id, kReq, subtype, body}, device::Replier(*this, ticket));
}

void RangerToLaser::answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) {
  Heard heard;
  {
    const std::lock_guard lock(mutex_);
    const auto found = asked_.find(ticket);
    if (found == asked_.end()) return;
    heard = std::move(found->second);
    asked_.erase(found);
  }
  heard(ack ? std::optional(std::move(body)) : std::nullopt);
}

void RangerToLaser::read(std::span<const device::Publication> batch, std::vector<device::Publication>& more) {
  const std::lock_guard lock(mutex_);
  if (!config_) return;
  const device::Publication* ranges = nullptr;
  const device::Publication* intensities = nullptr;
  for (const device::Publication& publication : batch) {
    if (publication.device != ranger_.id) continue;
    if (publication.subtype == rng::kDataRange) ranges = &publication;
    if (publication.subtype == rng::kDataIntns) intensities = &publication;
  }
  if (ranges == nullptr) return;
  const Result<rng::DataRange> range_values = wire::decode<rng::DataRange>(ranges->body);
  if (!range_values) return;
  rng::DataIntns intensity_values;
  if (intensities != nullptr) {
    if (Result<rng::DataIntns> values = wire::decode<rng::DataIntns>(intensities->body))
      intensity_values = *values;
  }
  const lsr::Data scan = laser_scan(*config_, *range_values, intensity_values, ++scans_);
  more.push_back({laser_, lsr::kDataScan, ranges->timestamp, wire::encode(scan)});
}

Result<std::unique_ptr<device::Driver>> make_ranger_to_laser(const scene::CfgSection& section, Site& site) {
  const std::vector<scene::DeviceAddress> provides = section.addresses("provides");
  const std::vector<scene::DeviceAddress> needs = section.addresses("requires");
  if (provides.size() != 1 || provides.front().interf != "laser") {
    return Error{section.at("provides"), "driver \"rangertolaser\" provides one laser, e.g. [\"laser:0\"]" +
                                             interface_hint(provides, "laser")};
  }
  if (needs.size() != 1 || needs.front().interf != "ranger") {
    return Error{section.at("requires"), "driver \"rangertolaser\" requires one ranger, e.g. [\"ranger:0\"]" +
                                             interface_hint(needs, "ranger") + section.slip_for("requires")};
  }
  const Result<device::Address> laser = site.resolve(provides.front());
  if (!laser) return Error{section.at("provides"), laser.error().text};
  const Result<device::Address> ranger = site.resolve(needs.front());
  if (!ranger) return Error{section.at("requires"), ranger.error().text};

  auto driver = std::make_unique<RangerToLaser>(site.surroundings(), site.tap());
  const Result<device::DeviceId> id = site.add_device(*laser, *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_laser(*id);
  site.when_all_made([&site, where = section.at("requires"), text = needs.front().text(), address = *ranger,
                      shown = *laser, converter = driver.get()]() -> Result<void> {
    const auto neighbour = site.find(address);
    if (!neighbour) return Error{where, fmt::format("nothing provides {}", in_quotes(text))};
    converter->set_ranger(*neighbour);
    Simulation* const simulation = site.simulation();
    if (simulation == nullptr) return {};
    const world::ModelId model = simulation->directory().model_of(address);
    const std::size_t sensors =
        model ? simulation->world().desc(simulation->world().row(model)).sensors.size() : 1;
    if (sensors != 1)
      return Error{where, fmt::format("{} has {} sensors, and a laser shows the scan of one", in_quotes(text),
                                      sensors)};
    simulation->directory().add(model, shown);
    return {};
  });
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
