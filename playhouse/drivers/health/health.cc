#include "playhouse/drivers/health/health.h"

#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/drivers/section_devices.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

constexpr DeviceText kHealthProvides[] = {{"health"}};

double health_interval(SectionFields& fields) {
  return fields.number({"interval", "Time between two STATEs while the device is open.", "s"}, 1, 0.1);
}

void read_health(SectionFields fields) {
  health_interval(fields);
}

}  // namespace

Health::Health(Site& site, std::string name, double interval, ReadFile read_file)
    : site_(site), name_(std::move(name)), interval_(interval), read_file_(std::move(read_file)) {}

Result<void> Health::start(device::DeviceId) {
  before_ = cpu_times();
  wait();
  return {};
}

void Health::wait() {
  timer_ = site_.surroundings().network().after(interval_, [this] {
    publish();
    wait();
  });
}

std::optional<CpuTimes> Health::cpu_times() {
  const Result<std::string> stat = read_file_("/proc/stat");
  const Result<CpuTimes> times = stat ? read_cpu_times(*stat) : stat.error();
  if (times) return *times;
  log_once(times.error());
  return std::nullopt;
}

void Health::publish() {
  const std::optional<CpuTimes> now = cpu_times();
  if (!now) return;
  const auto shares = before_ ? cpu_shares(*before_, *now) : std::nullopt;
  if (before_ && !shares) return;  // the next time
  before_ = now;
  if (!shares) return;
  const Result<std::string> meminfo = read_file_("/proc/meminfo");
  const Result<MemoryLoad> load = meminfo ? read_memory_load(*meminfo) : meminfo.error();
  if (!load) return log_once(load.error());
  site_.data_flow().publish({{device_, wire::health::kDataState, site_.time(),
                              wire::encode(wire::health::Data{*shares, load->memory, load->swap})}});
}

void Health::log_once(const Error& error) {
  if (!std::exchange(logged_, true)) log::warn("driver {}: no data: {}", name_, error.text);
}

constinit const DriverDefinition kHealthDriver{
    .name = "health",
    .doc = "Tells how busy the machine is on which the program runs.",
    .other_name = "statgrabdriver",
    .provides = kHealthProvides,
    .read_options = read_health,
    .make = make_health,
};

Result<std::unique_ptr<device::Driver>> make_health(const config::CfgSection& section, Site& site) {
  const auto provided = section_devices(section, site, "provides", {"health"});
  if (!provided) return provided.error();
  SectionFields fields(section);
  const double interval = health_interval(fields);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  auto driver = std::make_unique<Health>(
      site, section.name(), interval, [](const std::string& path) { return config::DiskFiles().read(path); });
  const Result<device::DeviceId> id = site.add_device(provided->front(), *driver);
  if (!id) return Error{section.at("provides"), id.error().text};
  driver->set_device(*id);
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
