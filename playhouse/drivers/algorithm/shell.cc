#include "playhouse/drivers/algorithm/shell.h"

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/rng.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

/// A text's own seed.
std::uint64_t seed_of(std::string_view text) {
  std::uint64_t seed = 0;
  for (const char c : text) seed = mix64(seed ^ static_cast<unsigned char>(c));
  return seed;
}

}  // namespace

Shell::Shell(std::string name, device::Opener& opener, std::size_t uses, AlgorithmThread::Steps steps)
    : name_(std::move(name)), client_(opener, *this, uses), thread_(steps) {
  client_.when_news([this](std::vector<device::Publication>& more) { algorithm_->take_news(more); });
}

void Shell::on_command(std::uint8_t subtype, TakeCommand take, std::size_t device) {
  commands_[{device, subtype}] = std::move(take);
}

void Shell::on_request(std::uint8_t subtype, TakeRequest take, std::size_t device) {
  answers_[{device, subtype}] = {std::move(take), std::nullopt};
}

void Shell::forward_request(std::uint8_t subtype, std::size_t to, std::size_t device) {
  answers_[{device, subtype}] = {[this, to](const device::Message& message, device::Replier replier) {
                                   client_.forward(to, message.subtype, message.body, std::move(replier));
                                 },
                                 to};
}

void Shell::forward_others(std::size_t to, TakeCommand take, std::size_t device,
                           std::vector<std::size_t> also) {
  others_[device] = {to, std::move(take), std::move(also)};
}

Result<void> Shell::start(device::DeviceId) {
  if (open_ == 0) {
    if (const Result<void> opened = client_.open(); !opened) return opened;
    algorithm_->opened();
  }
  ++open_;
  return {};
}

void Shell::stop(device::DeviceId) {
  if (--open_ == 0) close();
}

void Shell::close() {
  if (!client_.is_open()) return;  // one that it uses has retired
  algorithm_->closing();
  client_.close();
  algorithm_->closed();
}

std::size_t Shell::number_of(device::DeviceId device) const {
  const auto found = std::ranges::find(provided_, device);
  return found == provided_.end() ? 0 : static_cast<std::size_t>(found - provided_.begin());
}

/// Null if it refuses what is not registered.
const Shell::Others* Shell::others_of(device::DeviceId device) const {
  const auto found = others_.find(number_of(device));
  return found == others_.end() ? nullptr : &found->second;
}

device::Taken Shell::command(const device::Message& message) {
  if (!client_.is_open()) return device::Taken::kNo;  // it must not wait for the next client
  const auto found = commands_.find({number_of(message.device), message.subtype});
  if (found != commands_.end()) return found->second(message);
  const Others* others = others_of(message.device);
  return others != nullptr ? others->take(message) : device::Taken::kNo;
}

void Shell::request(const device::Message& message, device::Replier replier) {
  if (refusal_ && asks_for_refusal(message)) return answer_refusal(refusal_(), std::move(replier));
  const auto found = answers_.find({number_of(message.device), message.subtype});
  if (found != answers_.end()) return found->second.take(message, std::move(replier));
  const Others* others = others_of(message.device);
  if (others == nullptr) return;
  for (const std::size_t device : others->also)
    client_.ask(device, message.subtype, message.body, [](const AnswerBody&) {});
  client_.forward(others->to, message.subtype, message.body, std::move(replier));
}

bool Shell::capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const {
  const DeviceSubtype key{number_of(device), subtype};
  if (type == static_cast<std::uint8_t>(wire::MessageType::kCmd) && commands_.contains(key)) return true;
  if (refusal_ && may_ask_for_refusal(type, subtype)) return true;
  if (type == static_cast<std::uint8_t>(wire::MessageType::kReq)) {
    const auto found = answers_.find(key);
    if (found != answers_.end())
      return !found->second.by || client_.capable(*found->second.by, type, subtype);
  }
  const Others* others = others_of(device);
  return others != nullptr && client_.capable(others->to, type, subtype);
}

Result<void> Shell::follow(SiteWorld& world, device::Address robot, std::span<const device::Address> own) {
  if (const Result<void> fits = algorithm_->fits(world, robot); !fits) return fits;
  const Moment now = world.join(robot, own, *this);
  seed_ = own_seed_ ^ mix64(now.seed);
  thread_.follow_ticks(now.tick, 1);
  return {};
}

void Shell::rewound(const Moment& moment) {
  seed_ = own_seed_ ^ mix64(moment.seed);
  thread_.clear();
  algorithm_->rewound({moment.tick, moment.time, seed_});
}

Result<Wired> wired(const config::CfgSection& section, const Site& site, const WantedDevices& wanted) {
  const auto provides = section_devices(section, site, "provides", wanted.provides);
  if (!provides) return provides.error();
  const auto uses = section_devices(section, site, "requires", wanted.uses);
  if (!uses) return uses.error();
  return Wired{*provides, *uses};
}

Result<std::unique_ptr<device::Driver>> registered(const config::CfgSection& section, Site& site,
                                                   const Wired& devices, std::unique_ptr<Shell> shell) {
  std::vector<device::DeviceId> ids;
  for (const device::Address& address : devices.provides) {
    const Result<device::DeviceId> id = site.add_device(address, *shell);
    if (!id) return Error{section.at("provides"), id.error().text};
    ids.push_back(*id);
  }
  shell->provide(std::move(ids));
  const auto connected = [&site, devices, where = section.at("requires"), &shell = *shell]() -> Result<void> {
    shell.set_seed(seed_of(site.shown(devices.provides.front())));
    if (site.world() == nullptr) return {};
    const device::Address robot = devices.uses.front();
    const Result<void> followed = shell.follow(*site.world(), robot, devices.provides);
    return followed ? followed : Error{where, in_quotes(site.shown(robot)) + " " + followed.error().text};
  };
  site.add_user(
      {shell.get(), &shell->client(), devices.provides, devices.uses, section.at("requires"), connected});
  return std::unique_ptr<device::Driver>(std::move(shell));
}

}  // namespace playhouse::drivers
