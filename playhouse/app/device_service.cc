#include "playhouse/app/device_service.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <iterator>
#include <optional>
#include <utility>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/discovery/announce.h"
#include "playhouse/app/guest_list.h"
#include "playhouse/app/kept_files.h"
#include "playhouse/app/tls_files.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/log_output.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/bridge/all_drivers.h"
#include "playhouse/device/device_table.h"
#include "playhouse/device_server/descriptor_limit.h"
#include "playhouse/record/mcap/mcap_writer.h"
#include "playhouse/server/websocket_connection.h"
#include "playhouse/web_server/page_files.h"

namespace playhouse::app {
namespace {

constexpr double kLookSeconds = 1;  // period of looking for devices to record

/// The first non-loopback IPv4 address of this machine; none without a network.
std::optional<std::string> address_for_others() {
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return std::nullopt;
  std::optional<std::string> found;
  for (const ifaddrs* each = all; each != nullptr && !found; each = each->ifa_next) {
    constexpr unsigned kUp = IFF_UP | IFF_RUNNING;
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET) continue;
    if ((each->ifa_flags & kUp) != kUp || (each->ifa_flags & IFF_LOOPBACK)) continue;
    char text[INET_ADDRSTRLEN];
    const auto& address = reinterpret_cast<const sockaddr_in*>(each->ifa_addr)->sin_addr;
    if (inet_ntop(AF_INET, &address, text, sizeof text) != nullptr) found = text;
  }
  freeifaddrs(all);
  return found;
}

}  // namespace

DeviceService::DeviceService(Serving serving, std::span<const std::string> allowed)
    : serving_(std::move(serving)),
      devices_(server_options(serving_), {.folders = {}, .allowed = {allowed.begin(), allowed.end()}}) {}

DeviceService::~DeviceService() {
  alive_.reset();
  devices_.close();
  end_recording();
}

Result<void> DeviceService::read_tls() {
  const Result<std::shared_ptr<net::TlsIdentity>> identity = read_tls_files(serving_);
  if (!identity) return identity.error();
  loop().use_tls(*identity);
  return {};
}

Result<void> DeviceService::make_drivers(const config::CfgFile& file) {
  return devices_.make_drivers(drivers::all_drivers(), file, warn);
}

Result<void> DeviceService::read_guests() {
  Result<server::GuestBook> guests = app::read_guests(serving_);
  if (!guests) return guests.error();
  guests_ = std::move(*guests);
  server::admit_guests(devices_.server(), guests_);
  return {};
}

Result<void> DeviceService::open_page(std::uint16_t player_port) {
  if (!serving_.web) return {};
  web_server::DevicePage::DevicePageOptions options{.bind = serving_.bind,
                                                    .port = *serving_.web,
                                                    .page = web_server::page_files(),
                                                    .host_name = {},
                                                    .further_names = serving_.web_hosts,
                                                    .guests = guests_,
                                                    .proxies = serving_.proxies,
                                                    .player_port = player_port};
  page_ = std::make_unique<web_server::DevicePage>(
      loop(), std::move(options),
      [this](std::uint16_t port, std::unique_ptr<net::WebSocket> socket) {
        server::accept_websocket(devices_.server(), port, std::move(socket));
      },
      [this](const server::Guest& guest) { return status_text(guest); });
  const Result<std::uint16_t> port = page_->listen();
  if (!port) {
    const std::string text = port.error().text + "; --web takes another port";
    page_.reset();
    if (serving_.web_was_asked_for) return Error{port.error().where, text};
    log::warn("no web page: {}: {}", port.error().where, text);
    return {};
  }
  web_port_ = *port;
  return {};
}

Result<void> DeviceService::record(const std::string& file) {
  Result<std::unique_ptr<record::McapWriter>> writer = record::McapWriter::create(file, "");
  if (!writer) return writer.error();
  recording_ = file;
  record_file_ = std::make_unique<record::RecordThread>(std::move(*writer));
  recorder_ = std::make_unique<record::DeviceRecorder>(*record_file_, devices_.server(), unix_seconds);
  tap_.record(*recorder_);
  open_recorded();
  return {};
}

void DeviceService::open_recorded() {
  for (const auto& [address, device] : devices_.server().devices()) {
    if (!recorded_.insert(device).second) continue;
    recorder_->add(device, address);
    devices_.server().prepare(
        device, [this, device = device, alive = std::weak_ptr<int>(alive_)](const Result<void>& outcome) {
          if (!alive.expired() && (!outcome || !devices_.server().hold(device))) recorded_.erase(device);
        });
  }
  look_ = loop().after(kLookSeconds, [this] { open_recorded(); });
}

void DeviceService::end_recording() {
  if (!recorder_) return;
  look_.reset();
  recorder_->finish();
  record_file_->finish();  // what fails is in the log
}

std::vector<std::string> DeviceService::places() const {
  const std::string host = shown_host(serving_.bind);
  std::vector<std::string> lines;
  for (const std::uint16_t port : ports()) lines.push_back(client_place(host, port, serving_));
  std::ranges::move(
      guest_places(guests_, host, page_ ? std::optional(web_port_) : std::nullopt, serving_.is_encrypted()),
      std::back_inserter(lines));
  return lines;
}

/// {"ports":[6665],"clients":[{"peer":"127.0.0.1:4242","port":6665,"devices":["laser:0"]}],"drives":true}, with --udp "udp" with
/// server::DatagramCounts, with --multicast "multicast" with server::GroupCounts, and with a recording "recording":{"file":"lab.mcap","messages":7,"bytes":900,"dropped":0}.
std::string DeviceService::status_text(const server::Guest& guest) const {
  boost::json::array clients;
  for (const server::ClientStatus& client : devices_.server().clients()) {
    boost::json::array devices;
    for (const device::Address& address : client.open)
      devices.push_back(boost::json::string(device::describe_on_port(address)));
    clients.push_back(
        boost::json::object{{"peer", client.peer}, {"port", client.port}, {"devices", std::move(devices)}});
  }
  boost::json::array ports;
  for (const std::uint16_t port : devices_.ports()) ports.push_back(port);
  boost::json::object status{{"ports", std::move(ports)},
                             {"clients", std::move(clients)},
                             {"drives", server::rights_of(guest.role).drives}};
  if (serving_.udp) {
    const server::DatagramCounts udp = devices_.server().status().datagrams;
    status["udp"] =
        boost::json::object{{"received", udp.received}, {"dropped", udp.dropped}, {"late", udp.late},
                            {"sent", udp.sent},         {"unsent", udp.unsent},   {"too_long", udp.too_long}};
  }
  if (serving_.multicast) {
    const server::GroupCounts group = devices_.server().status().group;
    status["multicast"] = boost::json::object{{"sent", group.sent}, {"unsent", group.unsent}};
  }
  if (recorder_) {
    const record::DeviceRecorder::RecordingStatus recording = recorder_->status();
    status["recording"] = boost::json::object{{"file", escaped(recording_)},
                                              {"messages", recording.messages},
                                              {"bytes", recording.bytes},
                                              {"dropped", recording.dropped}};
  }
  return boost::json::serialize(status);
}

int DeviceService::run() {
  const int code = devices_.run();
  end_recording();
  return code;
}

bool has_world(const config::CfgFile& file) {
  return std::ranges::any_of(file.drivers,
                             [](const config::CfgSection& section) { return section.name() == "stage"; });
}

int serve_devices(const config::CfgFile& file, const Serving& serving, const Running& running,
                  const std::function<void(const std::vector<std::uint16_t>&)>& opened) {
  if (!running.for_a_world.empty())
    return fail_at({escaped(file.path),
                    fmt::format("invalid option {}: the file has no world", running.for_a_world.front())},
                   kUsage);
  DeviceService service(serving, running.allowed_libraries);
  if (const Result<void> read = service.read_tls(); !read) return fail_in_file(read.error());
  const Result<std::uint16_t> default_port = service.listen(file);
  if (!default_port) return fail(default_port.error());
  service.open_site(*default_port);
  if (const Result<void> made = service.make_drivers(file); !made) return fail_in_file(made.error(), {});
  if (!running.record.empty()) {
    if (const Result<void> kept = keep_files(running.record, file.files); !kept)
      return fail_in_file(kept.error());
    if (const Result<void> step = service.record(running.record); !step) return fail_at(step.error());
  }
  if (const Result<void> read = service.read_guests(); !read) return fail_in_file(read.error());
  if (const Result<void> page = service.open_page(*default_port); !page) return fail(page.error());
  for (const std::string& place : service.places()) log::say(place);
  if (opened) opened(service.ports());
  const auto announced = announce(serving, service.ports(), {});
  return service.run();
}

server::ServerOptions server_options(const Serving& serving) {
  server::ServerOptions options;
  options.bind = serving.bind;
  options.sessions = device_server::sessions_that_fit(serving.is_encrypted());
  options.unix_folder = serving.unix_folder;
  options.datagrams = serving.udp;
  options.group = serving.multicast;
  options.share_memory(serving.client_mib);
  return options;
}

std::string shown_host(const std::string& bind) {
  if (bind == "localhost") return "127.0.0.1";
  if (bind == "0.0.0.0" || bind == "::") return address_for_others().value_or("127.0.0.1");
  return bind.find(':') == std::string::npos ? bind : "[" + bind + "]";
}

}  // namespace playhouse::app
