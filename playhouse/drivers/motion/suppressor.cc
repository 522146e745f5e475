#include "playhouse/drivers/motion/suppressor.h"

#include <string>
#include <utility>

#include "playhouse/drivers/decoded.h"

namespace playhouse::drivers {

Suppressor::Suppressor(Shell& shell, const SuppressorOptions& options)
    : shell_(shell), options_(options), data_(shell.client().queue(0, kStatesKept)) {
  for (const std::size_t from : {kMaster, kSlave})
    shell.forward_others(
        0, [this, from](const device::Message& message) { return take(message, from); }, from);
}

void Suppressor::closed() {
  const std::lock_guard lock(mutex_);
  told_at_.reset();
}

device::Taken Suppressor::take(const device::Message& message, std::size_t from) {
  {
    const std::lock_guard lock(mutex_);
    if (from == kMaster)
      told_at_ = now_;
    else if (told_at_ && now_ - *told_at_ < options_.fadeout)
      return device::Taken::kLatest;  // silenced, as is expected
  }
  return shell_.client().command(0, message.subtype, message.body);
}

void Suppressor::take_news(std::vector<device::Publication>& more) {
  for (device::Publication& message : data_.take()) {
    {
      const std::lock_guard lock(mutex_);
      now_ = message.timestamp;
      if (told_at_ && *told_at_ > now_) told_at_ = now_;  // time went back
    }
    message.clients.clear();
    message.device = shell_.device(kSlave);
    more.push_back(message);
    message.device = shell_.device(kMaster);
    more.push_back(std::move(message));
  }
}

Result<SuppressorOptions> suppressor_options(SectionFields fields) {
  SuppressorOptions options;
  options.fadeout = fields.number(
      {"fadeout_time", "After a command of the master those of the slave are dropped for so long.", "s"},
      options.fadeout);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_suppressor(const config::CfgSection& section, Site& site) {
  const std::vector<config::DeviceAddress> used = section.addresses("requires");
  const std::string interf = used.empty() ? "position2d" : used.front().interf;
  if (interf == "simulation")  // whoever may drive would manage the run
    return Error{section.at("requires"), "driver \"suppressor\" is not for devices of simulation"};
  return make_algorithm<Suppressor>(section, site,
                                    {.provides = {{interf, "master"}, {interf, "slave"}}, .uses = {{interf}}},
                                    suppressor_options);
}

constexpr DeviceText kSuppressorProvides[] = {{"", "master", HowMany::kOne, "of any interface"},
                                              {"", "slave", HowMany::kOne, "of the same"}};
constexpr DeviceText kSuppressorUses[] = {{"", {}, HowMany::kOne, "of the same; gets the commands"}};

}  // namespace

constinit const DriverDefinition kSuppressorDriver{
    .name = "suppressor",
    .doc = "Two sources of commands to one device, of which one silences the other for a while.",
    .provides = kSuppressorProvides,
    .uses = kSuppressorUses,
    .read_options = reading<suppressor_options>,
    .make = make_suppressor,
};

}  // namespace playhouse::drivers
