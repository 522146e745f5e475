#include "playhouse/drivers/hardware/hardware_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/back_off.h"
#include "playhouse/drivers/hardware/offered.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

constexpr double kLongestWait = 3600;  // s

}  // namespace

HardwareOptions read_hardware_options(SectionFields& fields, LinePlace place, bool moves) {
  HardwareOptions options{.place = std::move(place)};
  options.reconnects = fields.flag(
      {"reconnect",
       "1: devices wait for a line that cannot be opened or is lost, instead of failing and retiring."},
      false);
  if (moves)
    options.watchdog = fields.number(
        {"watchdog",
         "The wheels stop when no command has come for so long, an hour at most; 0: the last one holds.",
         "s"},
        0);
  fields.expect(options.watchdog <= kLongestWait, "watchdog", "is 3600 s at most");
  return options;
}

HardwareDriver::HardwareDriver(std::string name, Site& site, HardwareOptions options)
    : name_(std::move(name)),
      site_(site),
      options_(std::move(options)),
      line_(site.surroundings().network(), options_.place, *this) {}

HardwareDriver::~HardwareDriver() = default;

Result<void> HardwareDriver::register_devices(const config::CfgSection& section,
                                              std::span<const DeviceText> offered) {
  const auto places = offered_devices(section, site_, "provides", offered);
  if (!places) return places.error();
  for (const std::optional<device::Address>& place : *places) {
    devices_.push_back({place, {}, 0});
    if (!place) continue;
    const Result<device::DeviceId> id = site_.add_device(*place, *this);
    if (!id) return Error{section.at("provides"), id.error().text};
    devices_.back().id = *id;
  }
  return {};
}

std::size_t HardwareDriver::number_of(device::DeviceId device) const {
  const auto is_it = [device](const OfferedDevice& each) { return each.address && each.id == device; };
  return static_cast<std::size_t>(std::ranges::find_if(devices_, is_it) - devices_.begin());
}

std::unique_ptr<net::Timer> HardwareDriver::after(double seconds, std::function<void()> task) {
  return site_.surroundings().network().after(seconds, std::move(task));
}

void HardwareDriver::inform(const std::string& text) const {
  log::info("driver {}: {}", in_quotes(name_), text);
}

void HardwareDriver::warn(const std::string& text) const {
  log::warn("driver {}: {}", in_quotes(name_), text);
}

bool HardwareDriver::set_baud(int baud) {
  net::SerialSettings serial = options_.place.serial;
  serial.baud = baud_ = baud;
  const Result<void> set = line_.set(serial);
  if (!set) give_up(set.error().text);
  return set.ok();
}

// --- devices

Result<void> HardwareDriver::start(device::DeviceId device) {
  const std::size_t number = number_of(device);
  if (open_ == 0) {
    const Result<void> opened = line_.open();
    if (!opened && !options_.reconnects) return Error{"", opened.error().line()};
    ++open_;
    if (!opened) line_lost(opened.error().text);
  } else {
    ++open_;
  }
  ++devices_[number].open;
  this->opened(number);
  return {};
}

/// After the commands that came before.
void HardwareDriver::stop(device::DeviceId device) {
  site_.surroundings().post([alive = std::weak_ptr<int>(alive_), this, number = number_of(device)] {
    if (alive.expired()) return;
    --devices_[number].open;
    closed(number);
    if (--open_ == 0) close_line();
  });
}

void HardwareDriver::finish() {
  close_line();
  std::set<std::shared_ptr<device::Replier>> asked;
  const std::lock_guard lock(mutex_);
  asked.swap(asked_);
}

void HardwareDriver::close_line() {
  retry_.reset();
  watchdog_.reset();
  wait_ = 0;
  told_.clear();
  if (line_.is_open()) ending();
  line_.close();
  forget_start();
  forgot();
}

void HardwareDriver::started() {
  is_ready_ = true;
  for (const auto& ask : std::exchange(waiting_requests_, {})) ask();
  for (const auto& [key, body] : std::exchange(waiting_commands_, {})) commands_.at(key)(body);
}

/// Those who wait get NACK.
void HardwareDriver::forget_start() {
  is_ready_ = false;
  waiting_requests_.clear();
  waiting_commands_.clear();
}

device::Taken HardwareDriver::command(const device::Message& message) {
  const auto found = commands_.find({number_of(message.device), message.subtype});
  if (found == commands_.end()) return device::Taken::kNo;
  site_.surroundings().post([alive = std::weak_ptr<int>(alive_), this, &command = *found,
                             body = CommandBody(message.body.begin(), message.body.end())] {
    if (alive.expired()) return;
    if (is_ready_) return command.second(body);
    if (open_ > 0) waiting_commands_[command.first] = body;
  });
  return device::Taken::kQueued;
}

void HardwareDriver::request(const device::Message& message, device::Replier replier) {
  const auto found = requests_.find({number_of(message.device), message.subtype});
  if (found == requests_.end()) return;
  site_.surroundings().post([this, alive = std::weak_ptr<int>(alive_), kept = keep(std::move(replier)),
                             answer = &found->second,
                             body = CommandBody(message.body.begin(), message.body.end())] {
    if (alive.expired()) return;
    const auto ask = [replier = take(kept), answer, body] {
      if (replier == nullptr) return;
      if (AnswerBody answered = (*answer)(body)) replier->ack(std::move(*answered));
    };
    if (is_ready_ || open_ == 0) return ask();
    if (waiting_requests_.size() < limits::kSessionAnswers) waiting_requests_.push_back(ask);
  });
}

/// Until it is posted: what is posted may never run, and is destroyed after the server then.
std::weak_ptr<device::Replier> HardwareDriver::keep(device::Replier replier) {
  const auto shared = std::make_shared<device::Replier>(std::move(replier));
  const std::lock_guard lock(mutex_);
  asked_.insert(shared);
  return shared;
}

/// Null after finish().
std::shared_ptr<device::Replier> HardwareDriver::take(const std::weak_ptr<device::Replier>& kept) {
  const std::shared_ptr<device::Replier> shared = kept.lock();
  const std::lock_guard lock(mutex_);
  asked_.erase(shared);
  return shared;
}

bool HardwareDriver::capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const {
  const DeviceKey key{number_of(device), subtype};
  if (type == static_cast<std::uint8_t>(wire::MessageType::kCmd)) return commands_.contains(key);
  return type == static_cast<std::uint8_t>(wire::MessageType::kReq) && requests_.contains(key);
}

void HardwareDriver::barrier(device::Replier replier) {
  site_.surroundings().post([this, alive = std::weak_ptr<int>(alive_), kept = keep(std::move(replier))] {
    if (alive.expired()) return;
    if (const auto taken = take(kept)) taken->ack();
  });
}

void HardwareDriver::publish_body(std::size_t device, std::uint8_t subtype, CommandBody body) {
  site_.data_flow().publish({{devices_[device].id, subtype, site_.time(), std::move(body)}});
}

void HardwareDriver::feed_watchdog() {
  if (options_.watchdog == 0) return;
  watchdog_ = after(options_.watchdog, [this] { stop_wheels(); });
}

// --- the line

void HardwareDriver::line_opened() {
  is_ready_ = !starts_up();
  baud_ = options_.place.serial.baud;
  began();
}

void HardwareDriver::line_received(std::span<const std::byte> bytes) {
  wait_ = 0;
  if (!std::exchange(told_, "").empty()) inform(line_.name() + " answers again");
  received(bytes);
}

void HardwareDriver::line_lost(const std::string& why) {
  watchdog_.reset();
  forget_start();
  forgot();
  if (!options_.reconnects) {
    log::error("driver {}: {}: {}: its devices retire", in_quotes(name_), line_.name(), why);
    return retire_all();
  }
  if (std::exchange(told_, why) != why) warn(fmt::format("{}: {}: trying again", line_.name(), why));
  retry();
}

void HardwareDriver::retry() {
  wait_ = next_wait(wait_);
  retry_ = after(wait_, [this] {
    if (const Result<void> opened = line_.open(); !opened) line_lost(opened.error().text);
  });
}

void HardwareDriver::give_up(const std::string& why) {
  line_.close();
  line_lost(why);
}

void HardwareDriver::retire_all() {
  std::vector<device::Address> addresses;
  for (const OfferedDevice& device : devices_)
    if (device.address) addresses.push_back(*device.address);
  site_.retire_later(std::move(addresses));
}

}  // namespace playhouse::drivers
