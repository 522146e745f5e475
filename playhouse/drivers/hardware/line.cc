#include "playhouse/drivers/hardware/line.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {
namespace {

constexpr std::string_view kTcp = "tcp:";

/// "HOST:PORT"; none if it is not.
std::optional<std::pair<std::string, std::uint16_t>> host_and_port(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon == 0) return std::nullopt;
  const std::string_view digits = text.substr(colon + 1);
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), port);
  if (error != std::errc() || end != digits.data() + digits.size() || port == 0) return std::nullopt;
  return std::pair(std::string(text.substr(0, colon)), port);
}

}  // namespace

std::string LinePlace::name() const {
  return path.empty() ? fmt::format("{}:{}", host, tcp_port) : path;
}

LinePlace read_line_place(SectionFields& fields, const OptionText& option, const std::string& otherwise,
                          const net::SerialSettings& serial) {
  OptionText told = option;
  told.otherwise = otherwise;
  std::string text = fields.text(told);
  if (text.empty()) text = otherwise;
  LinePlace place{.path = text, .serial = serial};
  if (!text.starts_with(kTcp)) {
    fields.expect(text.starts_with('/'), option.name,
                  "is a serial port, \"/dev/ttyUSB0\", or \"tcp:HOST:PORT\"");
    return place;
  }
  const auto there = host_and_port(std::string_view(text).substr(kTcp.size()));
  fields.expect(there.has_value(), option.name, "is \"tcp:HOST:PORT\" of a host and a port from 1 to 65535");
  place.path.clear();
  if (there) std::tie(place.host, place.tcp_port) = *there;
  return place;
}

HardwareLine::HardwareLine(net::Network& network, LinePlace place, LineEvents& events)
    : network_(network), place_(std::move(place)), name_(place_.name()), events_(events) {}

HardwareLine::~HardwareLine() = default;

Result<void> HardwareLine::open() {
  if (is_open() || attempt_ != nullptr) return {};
  if (place_.path.empty()) {
    attempt_ = network_.connect(
        place_.host, place_.tcp_port,
        [this](Result<std::unique_ptr<net::Connection>> made) { connected(std::move(made)); });
    return {};
  }
  Result<std::unique_ptr<net::SerialLine>> opened = network_.open_serial(place_.path, place_.serial);
  if (!opened) return opened.error();
  serial_ = std::move(*opened);
  serial_->start(*this);
  events_.line_opened();
  return {};
}

void HardwareLine::connected(Result<std::unique_ptr<net::Connection>> connection) {
  attempt_.reset();
  if (!connection) return events_.line_lost(connection.error().text);
  connection_ = std::move(*connection);
  connection_->expect_alive();
  connection_->start(*this);
  events_.line_opened();
}

void HardwareLine::close() {
  attempt_.reset();
  serial_.reset();
  if (connection_ != nullptr) connection_->close_after_flush();
  connection_.reset();
}

void HardwareLine::send(std::span<const std::byte> bytes) {
  if (serial_ != nullptr) return serial_->send(bytes);
  if (connection_ == nullptr || connection_->in_flight_bytes() + bytes.size() > limits::kSerialBytes) return;
  const auto shared = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
  connection_->send(std::span(&shared, 1));
}

Result<void> HardwareLine::set(const net::SerialSettings& settings) {
  return serial_ == nullptr ? Result<void>() : serial_->set(settings);
}

void HardwareLine::drop_input() {
  if (serial_ != nullptr) serial_->drop_input();
}

void HardwareLine::received(std::span<const std::byte> bytes) {
  events_.line_received(bytes);
}

void HardwareLine::ended(const std::string& why) {
  end(why);
}

void HardwareLine::closed(const std::string& why) {
  end(why);
}

void HardwareLine::end(const std::string& why) {
  serial_.reset();
  connection_.reset();
  events_.line_lost(why);
}

}  // namespace playhouse::drivers
