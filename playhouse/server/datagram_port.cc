#include "playhouse/server/datagram_port.h"

#include <list>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/server/datagram_stream.h"
#include "playhouse/server/frame.h"
#include "playhouse/wire/header.h"

namespace playhouse::server {
namespace {

constexpr double kLookSeconds = 2;  // period of looking for silent sessions
// Sessions that have said nothing since their empty datagram, whose sender may be forged: over it the oldest ends, so
// that they take no room of others.
constexpr std::size_t kUnheard = 256;

bool is_data(std::span<const std::byte> message) {
  return message.size() >= limits::kHeaderBytes &&
         wire::decode_header(message.first<limits::kHeaderBytes>()).type == wire::MessageType::kData;
}

}  // namespace

DatagramCounts& DatagramCounts::operator+=(const DatagramCounts& more) {
  received += more.received;
  dropped += more.dropped;
  late += more.late;
  sent += more.sent;
  unsent += more.unsent;
  too_long += more.too_long;
  silent += more.silent;
  return *this;
}

class DatagramConnection;

class DatagramPort::Impl : public std::enable_shared_from_this<Impl> {
 public:
  Impl(net::Network& network, net::Network::Acceptor acceptor, std::shared_ptr<DatagramRoom> room)
      : network_(network), acceptor_(std::move(acceptor)), room_(std::move(room)) {}

  Result<void> open(const std::string& bind, std::uint16_t port);
  void close() {
    socket_.reset();
    look_.reset();
  }

  net::Network& network() { return network_; }
  DatagramCounts& counts() { return counts_; }
  DatagramRoom& room() { return *room_; }
  /// Sends a message or drops it.
  void send(const net::Endpoint& to, std::span<const std::byte> message);
  void say_goodbye(const net::Endpoint& to) {
    if (socket_ != nullptr) socket_->send(to, {});
  }
  /// Of a session's first message.
  void heard_first(std::uint64_t number) { unheard_.erase(number); }
  /// Of any datagram.
  void heard(DatagramConnection& connection);
  void forget(const net::Endpoint& peer, const DatagramConnection* connection);

 private:
  void received(const net::Endpoint& from, std::span<const std::byte> datagram);
  void begin(const net::Endpoint& from);
  enum class Goodbye : std::uint8_t { kNo, kYes };
  void end(const net::Endpoint& peer, const std::string& why, Goodbye goodbye);
  void remove(std::map<net::Endpoint, DatagramConnection*>::iterator session);
  bool make_room();
  void end_blind_ones(double before);
  void look_for_silence();

  net::Network& network_;
  const net::Network::Acceptor acceptor_;
  const std::shared_ptr<DatagramRoom> room_;
  std::unique_ptr<net::DatagramSocket> socket_;  // null: closed
  std::map<net::Endpoint, DatagramConnection*> sessions_;
  std::list<DatagramConnection*> by_hearing_;       // of sessions_: the one heard longest ago first
  std::map<std::uint64_t, net::Endpoint> unheard_;  // by number of the session: the oldest first
  std::uint64_t begun_ = 0;
  std::unique_ptr<net::Timer> look_;
  DatagramCounts counts_;
};

class DatagramConnection final : public net::Connection {
 public:
  /// `number` of the session at its port.
  DatagramConnection(std::shared_ptr<DatagramPort::Impl> port, const net::Endpoint& peer,
                     std::uint64_t number)
      : port_(std::move(port)),
        peer_(peer),
        serial_(number),
        peer_text_(net::to_text(peer)),
        heard_(port_->network().now()) {}
  ~DatagramConnection() override {
    if (!over_) port_->say_goodbye(peer_);
    port_->room().bytes -= counted_;
    port_->forget(peer_, this);
  }

  void start(net::ConnectionEvents& events) override { events_ = &events; }

  void send(std::span<const net::SharedBytes> parts) override {
    if (over_) return;
    for (const net::SharedBytes& part : parts) send_message(*part);
    tell_drained();
  }

  std::size_t in_flight_bytes() const override { return in_flight_; }
  void pause() override { paused_ = true; }
  void resume() override {
    if (std::exchange(paused_, false) && !waiting_.empty()) later([this] { pass_on(); });
  }
  void close_after_flush() override {
    if (!std::exchange(over_, true)) port_->say_goodbye(peer_);
  }
  const std::string& peer() const override { return peer_text_; }

  /// For the port.
  void received(std::span<const std::byte> datagram);
  double heard() const { return heard_; }
  /// It commands and is sent no data, which its machine would refuse if it were gone, and has not been heard since `time`.
  bool commands_blindly(double time) const { return commands_ && number_ == 0 && heard_ <= time; }
  std::uint64_t serial() const { return serial_; }
  const net::Endpoint& endpoint() const { return peer_; }
  std::list<DatagramConnection*>::iterator place;  // for the port
  /// The peer is gone, or begins anew. Destroys the connection, perhaps.
  void end(const std::string& why) {
    if (std::exchange(over_, true) || events_ == nullptr) return;
    in_flight_ = 0;
    const std::weak_ptr<int> alive = alive_;
    events_->lost();
    if (!alive.expired()) events_->closed(why);
  }

 private:
  void send_message(std::span<const std::byte> message) {
    in_flight_ += message.size();
    const bool data = is_data(message);
    if (data) ++number_;
    if (message.size() > limits::kDatagramMostBytes) return refuse_long(message, data);
    data ? port_->send(peer_, numbered(message, number_)) : port_->send(peer_, message);
  }

  /// An answer that cannot arrive is refused, so that nobody waits for it.
  void refuse_long(std::span<const std::byte> message, bool data) {
    ++port_->counts().too_long;
    if (!std::exchange(warned_, true))
      log::warn("{}: a message of {} bytes is longer than a datagram; TCP carries it (logged once)",
                peer_text_, message.size());
    if (data) return;
    wire::Header header = wire::decode_header(message.first<limits::kHeaderBytes>());
    header.type = wire::MessageType::kNack;
    port_->send(peer_, *make_frame(header, {}).bytes);
  }

  // Later, as of a socket: what is sent in a turn of the loop is limited.
  void tell_drained() {
    later([this] {
      in_flight_ = 0;
      if (!over_) events_->drained();
    });
  }

  void pass_on() {
    if (paused_ || over_ || waiting_.empty()) return;
    const std::vector<std::byte> messages = std::exchange(waiting_, {});
    count_held();
    events_->received(messages);
  }

  void count_held() {
    const std::size_t held = stream_.unfinished_bytes() + waiting_.size();
    port_->room().bytes += held - std::exchange(counted_, held);
  }

  template <typename Task>
  void later(Task task) {
    port_->network().post([task = std::move(task), alive = std::weak_ptr<int>(alive_)] {
      if (!alive.expired()) task();
    });
  }

  const std::shared_ptr<DatagramPort::Impl> port_;
  const net::Endpoint peer_;
  const std::uint64_t serial_;
  const std::string peer_text_;
  const std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  net::ConnectionEvents* events_ = nullptr;
  DatagramStream stream_;
  std::vector<std::byte> waiting_;  // whole messages, while paused
  std::size_t counted_ = 0;         // bytes held, as the room has them
  double heard_ = 0;                // s
  bool commands_ = false;           // it has
  std::size_t in_flight_ = 0;       // bytes, until the next turn of the loop
  std::uint32_t number_ = 0;        // of the last data message
  bool paused_ = false, over_ = false, warned_ = false;
};

void DatagramConnection::received(std::span<const std::byte> datagram) {
  heard_ = port_->network().now();
  port_->heard(*this);
  DatagramCounts& counts = port_->counts();
  if (port_->room().bytes + datagram.size() > port_->room().most_bytes)
    return static_cast<void>(++counts.dropped);
  DatagramStream::TakenMessages taken = stream_.take(datagram);
  counts.late += taken.late;
  commands_ |= taken.commands;
  if (!taken.messages.empty()) port_->heard_first(serial_);
  const bool has_room = waiting_.size() + taken.messages.size() <= limits::kDatagramWaitingBytes;
  if (taken.dropped || !has_room) ++counts.dropped;
  if (has_room) waiting_.insert(waiting_.end(), taken.messages.begin(), taken.messages.end());
  count_held();
  if (events_ != nullptr) pass_on();
}

Result<void> DatagramPort::Impl::open(const std::string& bind, std::uint16_t port) {
  Result<std::unique_ptr<net::DatagramSocket>> socket = network_.open_datagrams(
      bind, port, [this](const net::Endpoint& from, std::span<const std::byte> datagram) {
        const auto self = shared_from_this();  // the server may close the port meanwhile
        received(from, datagram);
      });
  if (!socket) return socket.error();
  socket_ = std::move(*socket);
  socket_->on_refused([this](const net::Endpoint& peer) { end(peer, "its port is closed", Goodbye::kNo); });
  look_for_silence();
  return {};
}

void DatagramPort::Impl::send(const net::Endpoint& to, std::span<const std::byte> message) {
  const bool sent = socket_ != nullptr && socket_->send(to, message);
  ++(sent ? counts_.sent : counts_.unsent);
}

void DatagramPort::Impl::forget(const net::Endpoint& peer, const DatagramConnection* connection) {
  const auto found = sessions_.find(peer);
  if (found != sessions_.end() && found->second == connection) remove(found);
}

void DatagramPort::Impl::remove(std::map<net::Endpoint, DatagramConnection*>::iterator session) {
  unheard_.erase(session->second->serial());
  by_hearing_.erase(session->second->place);
  sessions_.erase(session);
  --room_->sessions;
}

void DatagramPort::Impl::heard(DatagramConnection& connection) {
  by_hearing_.splice(by_hearing_.end(), by_hearing_, connection.place);
}

/// False: all sessions are of other ports.
bool DatagramPort::Impl::make_room() {
  if (unheard_.size() >= kUnheard)
    end(net::Endpoint(unheard_.begin()->second), "it has said nothing", Goodbye::kYes);
  if (room_->sessions < room_->most_sessions) return true;
  if (by_hearing_.empty()) return false;
  end(net::Endpoint(by_hearing_.front()->endpoint()), "it gives way to another session by UDP",
      Goodbye::kYes);
  return true;
}

void DatagramPort::Impl::received(const net::Endpoint& from, std::span<const std::byte> datagram) {
  ++counts_.received;
  if (datagram.empty()) {
    end(from, "a new session of the same peer", Goodbye::kNo);
    return begin(from);
  }
  const auto found = sessions_.find(from);
  if (found != sessions_.end()) return found->second->received(datagram);
  // A message before any session: its content is dropped, as by the original.
  ++counts_.dropped;
  begin(from);
}

void DatagramPort::Impl::begin(const net::Endpoint& from) {
  if (!make_room()) return static_cast<void>(++counts_.dropped);
  auto connection = std::make_unique<DatagramConnection>(shared_from_this(), from, ++begun_);
  sessions_[from] = connection.get();
  connection->place = by_hearing_.insert(by_hearing_.end(), connection.get());
  unheard_[begun_] = from;
  ++room_->sessions;
  acceptor_(std::move(connection));
}

void DatagramPort::Impl::end(const net::Endpoint& peer, const std::string& why, Goodbye goodbye) {
  const auto found = sessions_.find(peer);
  if (found == sessions_.end()) return;
  DatagramConnection* const connection = found->second;
  remove(found);
  if (goodbye == Goodbye::kYes) say_goodbye(peer);
  connection->end(why);
}

void DatagramPort::Impl::end_blind_ones(double before) {
  std::vector<net::Endpoint> blind;
  for (const DatagramConnection* const connection : by_hearing_) {
    if (connection->heard() > before) break;
    if (connection->commands_blindly(before)) blind.push_back(connection->endpoint());
  }
  for (const net::Endpoint& peer : blind) {
    ++counts_.silent;
    end(peer, "it has commanded, and nothing shows that it is still there", Goodbye::kYes);
  }
}

void DatagramPort::Impl::look_for_silence() {
  const double before = network_.now() - limits::kDatagramSilentSeconds;
  while (!by_hearing_.empty() && by_hearing_.front()->heard() <= before) {
    ++counts_.silent;
    end(net::Endpoint(by_hearing_.front()->endpoint()), "it has been silent for too long", Goodbye::kYes);
  }
  end_blind_ones(network_.now() - limits::kDatagramBlindSeconds);
  look_ = network_.after(kLookSeconds, [this] { look_for_silence(); });
}

Result<std::unique_ptr<DatagramPort>> DatagramPort::open(net::Network& network, const std::string& bind,
                                                         std::uint16_t port, net::Network::Acceptor acceptor,
                                                         std::shared_ptr<DatagramRoom> room) {
  auto impl = std::make_shared<Impl>(network, std::move(acceptor), std::move(room));
  if (const Result<void> opened = impl->open(bind, port); !opened) return opened.error();
  return std::unique_ptr<DatagramPort>(new DatagramPort(std::move(impl)));
}

DatagramPort::~DatagramPort() {
  impl_->close();
}

const DatagramCounts& DatagramPort::counts() const {
  return impl_->counts();
}

}  // namespace playhouse::server
