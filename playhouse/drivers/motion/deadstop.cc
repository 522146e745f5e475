#include "playhouse/drivers/motion/deadstop.h"

#include <algorithm>

namespace playhouse::drivers {

void DeadStop::opened() {
  const std::lock_guard lock(mutex_);
  told_ = false;
  told_at_.reset();
}

void DeadStop::take_news(std::vector<device::Publication>& more) {
  Forwarder::take_news(more);
  look_again();
}

bool DeadStop::forbids(const CommandedMotion&) const {
  return !told_ && told_at_ && now_ - *told_at_ >= options_.timeout;
}

/// Where the time went back, the command was given now.
std::optional<device::Publication> DeadStop::passed(device::Publication message) {
  const std::lock_guard lock(mutex_);
  now_ = message.timestamp;
  if (told_ || (told_at_ && *told_at_ > now_)) told_at_ = now_;
  told_ = false;
  return message;
}

Result<DeadStopOptions> dead_stop_options(SectionFields fields) {
  DeadStopOptions options;
  options.timeout = fields.number({"timeout", "The robot stops once it was told nothing for so long.", "s"},
                                  options.timeout);
  fields.no_effect({"cheat_time", "Accepted, as files of the original have it."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_dead_stop(const config::CfgSection& section, Site& site) {
  return make_algorithm<DeadStop>(section, site, {.provides = {{"position2d"}}, .uses = {{"position2d"}}},
                                  dead_stop_options);
}

constexpr DeviceText kDeadStopProvides[] = {{"position2d"}};
constexpr DeviceText kDeadStopUses[] = {{"position2d", {}, HowMany::kOne, "is the robot"}};

}  // namespace

constinit const DriverDefinition kDeadStopDriver{
    .name = "deadstop",
    .doc = "Stops a robot that was told nothing for a while.",
    .provides = kDeadStopProvides,
    .uses = kDeadStopUses,
    .read_options = reading<dead_stop_options>,
    .make = make_dead_stop,
};

}  // namespace playhouse::drivers
