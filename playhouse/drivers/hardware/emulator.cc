#include "playhouse/drivers/hardware/emulator.h"

#include <fmt/format.h>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/drivers/back_off.h"

namespace playhouse::drivers {
namespace {

constexpr double kPause = 0.25;  // s between two bytes, in which no frame goes on

}  // namespace

EmulatorPlace read_emulator_place(SectionFields& fields, const net::SerialSettings& serial) {
  EmulatorPlace place{.serial = serial};
  place.link = fields.filename(
      {"port",
       "Name of the pseudo-terminal that it makes, which other programs open as a serial port.",
       {},
       "required without tcp_port"});
  place.tcp_port = static_cast<std::uint16_t>(fields.integer(
      {"tcp_port", "TCP port that it listens at on this machine, instead; 0: none."}, 0, 0, 65535));
  fields.expect(place.link.empty() != (place.tcp_port == 0), "port",
                "or tcp_port is needed, and one of them alone");
  return place;
}

Emulator::Emulator(std::string name, Site& site, EmulatorPlace place, UsedDevices used)
    : name_(std::move(name)),
      site_(site),
      place_(std::move(place)),
      serial_(place_.serial),
      addresses_([&used] {
        std::vector<device::Address> addresses;
        for (const std::optional<device::Address>& each : used)
          if (each) addresses.push_back(*each);
        return addresses;
      }()),
      numbers_(used.size()),
      client_(site.surroundings(), *this, addresses_.size()) {
  std::size_t number = 0;
  for (std::size_t device = 0; device < used.size(); ++device)
    if (used[device]) numbers_[device] = number++;
}

Emulator::~Emulator() = default;

Result<void> Emulator::begin(const config::CfgSection& section) {
  if (const Result<void> opened = open_line(); !opened)
    return Error{section.at(place_.link.empty() ? "tcp_port" : "port"), opened.error().line()};
  site_.add_user({this, &client_, {}, addresses_, section.at("requires"), [this] {
                    site_.surroundings().post([this, alive = std::weak_ptr<int>(alive_)] {
                      if (!alive.expired()) open_devices();
                    });
                    return Result<void>();
                  }});
  return {};
}

Result<void> Emulator::open_line() {
  net::Network& network = site_.surroundings().network();
  if (!place_.link.empty()) {
    Result<std::unique_ptr<net::SerialLine>> made = network.open_terminal(place_.link, place_.serial);
    if (!made) return made.error();
    terminal_ = std::move(*made);
    terminal_->start(*this);
    return {};
  }
  auto listener = network.listen("127.0.0.1", place_.tcp_port, [this](std::unique_ptr<net::Connection> host) {
    if (host_ != nullptr) return;  // a line has one end
    reset();
    host_ = std::move(host);
    host_->expect_alive();
    host_->start(*this);
  });
  if (!listener) return listener.error();
  listener_ = std::move(*listener);
  return {};
}

void Emulator::open_devices() {
  client_.prepare([this, alive = std::weak_ptr<int>(alive_)](const Result<void>& ready) {
    if (alive.expired()) return;
    if (!ready) return try_later(ready.error().text);
    if (const Result<void> opened = client_.open(); !opened) return try_later(opened.error().text);
    wait_ = 0;
    if (!std::exchange(told_, "").empty()) log::info("driver {}: its devices are open", in_quotes(name_));
  });
}

void Emulator::try_later(const std::string& why) {
  if (std::exchange(told_, why) != why) log::warn("driver {}: {}: trying again", in_quotes(name_), why);
  wait_ = next_wait(wait_);
  retry_ = after(wait_, [this] { open_devices(); });
}

void Emulator::finish() {
  if (client_.is_open()) reset();
  client_.close();
}

void Emulator::retired(device::DeviceId) {
  client_.close();
  log::warn("driver {}: its robot has gone", in_quotes(name_));
}

std::unique_ptr<net::Timer> Emulator::after(double seconds, std::function<void()> task) {
  return site_.surroundings().network().after(seconds, std::move(task));
}

double Emulator::now() const {
  return site_.surroundings().network().now();
}

bool Emulator::speaks_as_set() const {
  return terminal_ == nullptr || place_.at_any_speed || terminal_->settings() == serial_;
}

void Emulator::speak(const net::SerialSettings& serial) {
  serial_ = serial;
  if (terminal_ == nullptr) return;
  if (const Result<void> set = terminal_->set(serial); !set)
    log::warn("driver {}: {}", in_quotes(name_), set.error().line());
}

void Emulator::send(std::span<const std::byte> bytes) {
  if (terminal_ != nullptr) {
    if (speaks_as_set()) terminal_->send(bytes);
  } else if (host_ != nullptr && host_->in_flight_bytes() + bytes.size() <= limits::kSerialBytes) {
    const auto shared = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
    host_->send(std::span(&shared, 1));
  }
}

void Emulator::received(std::span<const std::byte> bytes) {
  if (const double before = std::exchange(heard_, now()); heard_ - before > kPause) line_paused();
  if (speaks_as_set()) line_received(bytes);
}

void Emulator::ended(const std::string& why) {
  log::error("driver {}: {}: {}", in_quotes(name_), place_.link, why);
}

void Emulator::closed(const std::string&) {
  host_.reset();
}

}  // namespace playhouse::drivers
