#include "playhouse/app/benches/bench_clients.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/app/benches/bench_page.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/header.h"
#include "playhouse_client/client.h"

namespace playhouse::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kSettle = 0.5;  // s, for all devices to open

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// CPU time of a process's threads so far. [s]
double cpu_seconds(pid_t process) {
  std::uint64_t total_ns = 0;
  std::error_code ignored;
  for (const auto& thread :
       std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process), ignored)) {
    std::ifstream file(thread.path() / "schedstat");
    std::uint64_t running_ns = 0;
    file >> running_ns;
    total_ns += running_ns;
  }
  return static_cast<double>(total_ns) * 1e-9;
}

/// Resident memory of a process. [B]
double resident_bytes(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/statm", process));
  double size = 0, resident = 0;
  file >> size >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// A connection that counts its messages; non-blocking once open.
class Listener {
 public:
  Listener() = default;
  ~Listener() {
    if (socket_ >= 0) close(socket_);
  }
  Listener(Listener&& other) noexcept { *this = std::move(other); }
  Listener& operator=(Listener&& other) noexcept {
    std::swap(socket_, other.socket_);
    std::swap(buffer_, other.buffer_);
    std::swap(banner_, other.banner_);
    std::swap(last_, other.last_);
    return *this;
  }

  int socket() const { return socket_; }

  bool connect(std::uint16_t port) {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return socket_ >= 0 &&
           ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }

  bool open_device(std::uint16_t interf, std::uint16_t index) {
    wire::player::DeviceReq request;
    request.addr.interf = interf;
    request.addr.index = index;
    request.access = wire::player::kOpenMode;
    const std::vector<std::byte> body = wire::encode(request);
    wire::Header header;
    header.interf = wire::player::kCode;
    header.type = wire::MessageType::kReq;
    header.subtype = wire::player::kReqDev;
    header.size = static_cast<std::uint32_t>(body.size());
    std::vector<std::byte> bytes(limits::kHeaderBytes);
    wire::encode_header(header, std::span<std::byte, limits::kHeaderBytes>(bytes));
    bytes.insert(bytes.end(), body.begin(), body.end());
    return send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
  }

  /// Reads what is available; false if the server has closed.
  bool read() {
    std::array<std::byte, 65536> chunk;
    const ssize_t size = recv(socket_, chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (size <= 0) return false;
    buffer_.insert(buffer_.end(), chunk.begin(), chunk.begin() + size);
    return true;
  }

  /// Counts the complete messages read so far. `interval`: period of a device's data [s].
  void count(double interval, std::uint64_t& messages, std::uint64_t& lost) {
    std::size_t at = banner_ ? 0 : limits::kBannerBytes;
    while (buffer_.size() >= at + limits::kHeaderBytes) {
      const wire::Header header = wire::decode_header(
          std::span<const std::byte, limits::kHeaderBytes>(buffer_.data() + at, limits::kHeaderBytes));
      if (buffer_.size() < at + limits::kHeaderBytes + header.size) break;
      at += limits::kHeaderBytes + header.size;
      banner_ = true;
      if (header.type != wire::MessageType::kData) continue;
      ++messages;
      double& last = last_[header.interf << 16 | header.index];
      if (last > 0)
        lost +=
            static_cast<std::uint64_t>(std::max(0l, std::lround((header.timestamp - last) / interval) - 1));
      last = header.timestamp;
    }
    if (banner_) buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at));
  }

 private:
  int socket_ = -1;
  std::vector<std::byte> buffer_;
  bool banner_ = false;                   // was skipped
  std::map<std::uint32_t, double> last_;  // latest timestamps, by device
};

Result<std::vector<Listener>> open_all(const FanOutPlan& plan) {
  std::vector<Listener> listeners(plan.clients);
  for (std::size_t i = 0; i < listeners.size(); ++i) {
    const auto robot = static_cast<std::uint16_t>(i % plan.robots);
    if (!listeners[i].connect(plan.port) || !listeners[i].open_device(wire::position2d::kCode, robot) ||
        !listeners[i].open_device(wire::laser::kCode, robot)) {
      return Error{"", fmt::format("client {} cannot connect: {}", i, std::strerror(errno))};
    }
  }
  return listeners;
}

struct Count {
  std::uint64_t messages = 0, lost = 0;
};

/// Reads for so long; counts only messages of that period.
Result<Count> listen_for(std::vector<Listener>& listeners, double seconds, double interval) {
  std::vector<pollfd> waiting;
  for (const Listener& listener : listeners) waiting.push_back({listener.socket(), POLLIN, 0});
  Count count;
  const Clock::time_point start = Clock::now();
  while (seconds_since(start) < seconds) {
    if (poll(waiting.data(), waiting.size(), 50) <= 0) continue;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      if (waiting[i].revents == 0) continue;
      if (!listeners[i].read()) return Error{"", "the server closed a connection"};
      listeners[i].count(interval, count.messages, count.lost);
    }
  }
  return count;
}

/// Frame number of a packet (replicate/delta.h).
std::uint64_t frame_of(std::span<const std::byte> packet) {
  Unpacker in(packet);
  in.u8();  // version
  in.u8();  // flags
  return in.varint();
}

/// Acts as a page that views the whole world with measurements;
/// acknowledges packets for so long, and returns their number.
Result<std::uint64_t> be_page(PageSocket& page, double seconds) {
  std::uint64_t packets = 0;
  for (const Clock::time_point start = Clock::now(); seconds_since(start) < seconds;) {
    const Result<PageSocket::PageMessage> message = page.next();  // at least a packet per second arrives
    if (!message) return message.error();
    if (!message->binary) continue;
    const std::uint64_t frame = frame_of(std::as_bytes(std::span(message->bytes)));
    const Result<void> sent = page.send_text(fmt::format(R"({{"do":"ack","frame":{}}})", frame));
    if (!sent) return sent.error();
    ++packets;
  }
  return packets;
}

}  // namespace

Result<RoundTrip> measure_round_trip(std::uint16_t port, int requests) {
  Result<client::Client> client = client::Client::connect(fmt::format("127.0.0.1:{}", port));
  if (!client) return client.error();
  Result<client::Device> robot = client::Device::open(*client, wire::position2d::kCode, 0);
  if (!robot) return robot.error();
  std::vector<double> times;
  for (int i = 0; i < requests; ++i) {
    const Clock::time_point start = Clock::now();
    const auto geom = robot->request<wire::position2d::Geom>(wire::position2d::kReqGetGeom);
    if (!geom) return geom.error();
    times.push_back(seconds_since(start) * 1e3);
  }
  std::sort(times.begin(), times.end());
  return RoundTrip{times[times.size() / 2], times[times.size() * 99 / 100]};
}

Result<AmongIdle> measure_round_trip_among_idle(std::uint16_t port, int requests, std::size_t idle,
                                                pid_t server) {
  const double before = resident_bytes(server);
  std::vector<Listener> others(idle);
  for (Listener& other : others) {
    if (!other.connect(port))
      return Error{"", fmt::format("{} idle clients cannot connect: {}", idle, std::strerror(errno))};
  }
  const Result<RoundTrip> round_trip = measure_round_trip(port, requests);
  if (!round_trip) return round_trip.error();
  return AmongIdle{*round_trip, (resident_bytes(server) - before) / static_cast<double>(idle)};
}

Result<RoundTrip> measure_round_trip_among_readers(const FanOutPlan& plan, int requests) {
  Result<std::vector<Listener>> listeners = open_all(plan);
  if (!listeners) return listeners.error();
  if (const Result<Count> settled = listen_for(*listeners, kSettle, plan.interval); !settled)
    return settled.error();
  std::atomic<bool> over = false;
  Result<Count> read = Count{};
  std::thread reader([&] {
    while (!over && read) read = listen_for(*listeners, kSettle, plan.interval);
  });
  const Result<RoundTrip> round_trip = measure_round_trip(plan.port, requests);
  over = true;
  reader.join();
  if (!read) return read.error();
  return round_trip;
}

Result<FanOut> measure_fan_out(const FanOutPlan& plan) {
  Result<std::vector<Listener>> listeners = open_all(plan);
  if (!listeners) return listeners.error();
  if (const Result<Count> settled = listen_for(*listeners, kSettle, plan.interval); !settled)
    return settled.error();
  const double cpu_before = cpu_seconds(plan.server);
  const Clock::time_point start = Clock::now();
  const Result<Count> count = listen_for(*listeners, plan.seconds, plan.interval);
  if (!count) return count.error();
  const double elapsed = seconds_since(start);
  return FanOut{plan.clients, static_cast<double>(count->messages) / elapsed, count->lost,
                (cpu_seconds(plan.server) - cpu_before) / elapsed};
}

Result<double> watch_as_page(std::uint16_t port, double seconds, const std::function<void(bool)>& watches) {
  Result<PageSocket> page = PageSocket::connect(port);
  if (!page) return page.error();
  const Result<void> looks =
      page->send_text(R"({"do":"look","x_min":-1e6,"y_min":-1e6,"x_max":1e6,"y_max":1e6,"sensors":true})");
  if (!looks) return looks.error();
  if (const Result<std::uint64_t> settled = be_page(*page, kSettle); !settled) return settled.error();
  watches(true);
  const Result<std::uint64_t> packets = be_page(*page, seconds);
  watches(false);
  if (!packets) return packets.error();
  return static_cast<double>(*packets) / seconds;
}

Result<FanOut> read_lasers(const FanOutPlan& plan, const std::function<void(bool)>& reads) {
  std::vector<Listener> listeners(plan.clients);
  for (Listener& listener : listeners)
    if (!listener.connect(plan.port)) return Error{"", std::string("a client: ") + std::strerror(errno)};
  for (std::size_t robot = 0; robot < plan.robots; ++robot)
    if (!listeners[robot % plan.clients].open_device(wire::laser::kCode, static_cast<std::uint16_t>(robot)))
      return Error{"", fmt::format("laser:{} cannot be opened: {}", robot, std::strerror(errno))};
  if (const Result<Count> settled = listen_for(listeners, kSettle, plan.interval); !settled)
    return settled.error();
  reads(true);
  const Result<Count> count = listen_for(listeners, plan.seconds, plan.interval);
  reads(false);
  if (!count) return count.error();
  return FanOut{plan.clients, static_cast<double>(count->messages) / plan.seconds, count->lost, 0};
}

}  // namespace playhouse::app
