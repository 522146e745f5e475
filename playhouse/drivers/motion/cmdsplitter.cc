#include "playhouse/drivers/motion/cmdsplitter.h"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace playhouse::drivers {

CmdSplitter::CmdSplitter(Shell& shell, const CmdSplitterOptions& options, std::size_t devices)
    : Forwarder(shell), devices_(devices) {
  std::vector<std::size_t> also;
  for (std::size_t i = 1; i < devices && !options.asks_first_only; ++i) also.push_back(i);
  shell.forward_others(
      kForwarded, [this](const device::Message& message) { return take(message); }, 0, std::move(also));
}

device::Taken CmdSplitter::take(const device::Message& message) {
  for (std::size_t i = 1; i < devices_; ++i) shell_.client().command(i, message.subtype, message.body);
  return forward(message);
}

Result<CmdSplitterOptions> cmd_splitter_options(SectionFields fields) {
  CmdSplitterOptions options;
  fields.no_effect({"devices", "Accepted: those that requires names count."});
  options.asks_first_only =
      fields.flag({"rq_first_device_only",
                   "1: requests go to the first device alone; 0: to all, and the first one answers."},
                  options.asks_first_only);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

/// One device, and those with keys 0, 1 and so on that have its interface.
Result<std::unique_ptr<device::Driver>> make_cmd_splitter(const config::CfgSection& section, Site& site) {
  const std::vector<config::DeviceAddress> provided = section.addresses("provides");
  const std::string interf = provided.empty() ? "position2d" : provided.front().interf;
  const std::size_t count = std::max<std::size_t>(section.addresses("requires").size(), 1);
  std::deque<std::string> keys;
  WantedDevices wanted{.provides = {{interf}}, .uses = {}};
  for (std::size_t i = 0; i < count; ++i)
    wanted.uses.push_back({interf, keys.emplace_back(std::to_string(i))});
  if (interf == "simulation")  // whoever may drive would manage the run
    return Error{section.at("provides"), "driver \"cmdsplitter\" is not for devices of simulation"};
  return make_algorithm<CmdSplitter>(section, site, wanted, cmd_splitter_options, count);
}

constexpr DeviceText kCmdSplitterProvides[] = {{"", {}, HowMany::kOne, "of any interface"}};
constexpr DeviceText kCmdSplitterUses[] = {
    {"", "0", HowMany::kOne, "of the same interface; answers, and has the data"},
    {"", "1", HowMany::kOneOrNone, "and so on: 2, 3 ..."}};

}  // namespace

constinit const DriverDefinition kCmdSplitterDriver{
    .name = "cmdsplitter",
    .doc = "Tells several devices what it is told.",
    .provides = kCmdSplitterProvides,
    .uses = kCmdSplitterUses,
    .read_options = reading<cmd_splitter_options>,
    .make = make_cmd_splitter,
};

}  // namespace playhouse::drivers
