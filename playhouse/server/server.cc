#include "playhouse/server/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/monotonic.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/server/client.h"
#include "playhouse/server/outbox.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::server {
namespace {

constexpr std::uint8_t kErrorLetter = 'e';  // access code that replies to opens never have
constexpr std::size_t kOutboxBatch = 16;    // items per lock of the outbox
constexpr double kLastRounds = 1;           // s; after the run, for clients to request remaining data
constexpr double kLastWrites = 1;           // s; then, to flush unrequested data

net::SharedBytes make_banner(const std::string& version) {
  std::string text = "Player v." + version;
  text.resize(std::min(text.size(), limits::kBannerBytes - 1));
  text.resize(limits::kBannerBytes);
  const auto bytes = std::as_bytes(std::span(text));
  return std::make_shared<std::vector<std::byte>>(bytes.begin(), bytes.end());
}

/// Notice for clients with a retired device open: an unsolicited reply to an open request.
Frame make_notice(device::Address address, const device::Driver& driver, double now) {
  wire::player::DeviceReq body;
  body.addr = {wire::kLocalhost, address.robot, address.interf, address.index};
  body.access = kErrorLetter;
  body.driver_name = wire::c_string(driver.name());
  wire::Header header;
  header.host = wire::kLocalhost;
  header.robot = address.robot;
  header.interf = wire::player::kCode;
  header.type = wire::MessageType::kAck;
  header.subtype = wire::player::kReqDev;
  header.timestamp = now;
  return make_frame(header, wire::encode(body));
}

}  // namespace

class Server::Impl final : public ClientOwner {
 public:
  Impl(net::Network& network, ServerOptions options, device::Outlet& outlet)
      : network_(network),
        options_(std::move(options)),
        banner_(make_banner(options_.version)),
        outbox_(options_.outbox_bytes) {
    datagram_room_->most_sessions = std::min(limits::kDatagramSessions, options_.sessions / 2 + 1);
    datagram_room_->most_bytes = options_.input_bytes / 8;
    board_.clock = unix_seconds;
    board_.outlet = &outlet;
  }

  Result<std::uint16_t> listen(std::uint16_t port);
  Result<void> listen_besides(std::uint16_t port, const net::Network::Acceptor& acceptor);
  Result<void> open_group();
  void accept(std::uint32_t robot, std::unique_ptr<net::Connection> connection);
  void publish(std::vector<device::Publication> batch) {
    if (outbox_.put(std::move(batch))) wake();
  }
  void answer(Answer answer) {
    if (outbox_.put(std::move(answer))) wake();
  }
  void forget() {
    if (outbox_.put(Forget{})) wake();
  }
  bool has_port(std::uint16_t port) const {
    return std::ranges::any_of(listeners_, [port](const auto& each) { return each->port() == port; });
  }
  ServerStatus status() const;
  Switchboard& board() { return board_; }
  void finish(std::function<void()> done);
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);
  void retire_device(device::DeviceId id);
  void stop_devices() { board_.devices.end(); }
  void close_clients(std::function<bool(const std::string& token, const std::string& peer)> which);
  void take_turns(device::Turns& turns);
  Result<void> hold(device::DeviceId device, device::Driver* holder);
  void release(device::DeviceId device, device::Driver* holder);

  std::vector<ClientStatus> clients() const;

 private:
  /// Connections from one address.
  struct Host {
    std::size_t clients = 0;
    bool full = false;
  };

  bool has_room_for(const net::Connection& connection);
  void remove(std::uint32_t serial) override;
  void wake();
  void schedule() override;
  void turn();
  /// Moves data and replies from the outbox to clients' queues until the turn has no deliveries
  /// left, so that neither fast data nor many readers starve sockets. The rest follows in another turn.
  void deliver_outbox() override;
  /// The same without a limit.
  void deliver_whole_outbox();
  /// Returns the number of deliveries, at least 1.
  std::size_t deliver(const Outbox::OutboxItem& item);
  void deliver(const Answer& answer);
  std::size_t device_rows() const;
  void tell_of_lost_data();
  void make_room() override;
  void advance_everybody();
  void end();
  void tell_datagrams() const;
  Client* longest_unfinished();
  void make_output_room();
  std::vector<Client*> largest_holders() const;
  void remove_silent(Client& client) override;
  void broke(const Client&) override { ++broken_; }
  bool is_over() const override { return static_cast<bool>(done_); }

  net::Network& network_;
  const ServerOptions options_;
  const net::SharedBytes banner_;
  Outbox outbox_;
  std::shared_ptr<int> alive_ =
      std::make_shared<int>(0);            // tasks posted by us look whether we are still there
  std::unique_ptr<MulticastGroup> group_;  // null: there is none
  Switchboard board_;                      // after the outbox: drivers that are stopped may still answer
  std::vector<std::unique_ptr<net::Listener>> listeners_;
  std::vector<std::unique_ptr<DatagramPort>> datagram_ports_;
  const std::shared_ptr<DatagramRoom> datagram_room_ = std::make_shared<DatagramRoom>();
  std::map<std::uint32_t, std::unique_ptr<Client>> clients_;
  std::function<void()> done_;                // set once the run is over
  std::unique_ptr<net::Timer> last_moments_;  // timeouts of shutdown: pending rounds, then pending writes
  std::map<std::string, Host> hosts_;         // except this machine
  std::uint32_t next_serial_ = 1;
  std::uint64_t accepted_ = 0, refused_ = 0, silent_ = 0, broken_ = 0, turns_ = 0, retired_ = 0;
  bool full_ = false, told_of_lost_data_ = false, scheduled_ = false;
  bool delivers_on_ = false;         // a wake() is pending for the rest of the outbox
  std::size_t deliveries_left_ = 0;  // of this turn
};

Result<std::uint16_t> Server::Impl::listen(std::uint16_t port) {
  // The acceptor needs the port, which is known only after listen().
  if (const Result<void> opened = open_group(); !opened) return opened.error();
  const auto robot = std::make_shared<std::uint32_t>(port);
  const auto accept_there = [this, robot](std::unique_ptr<net::Connection> connection) {
    accept(*robot, std::move(connection));
  };
  auto listener = network_.listen(options_.bind, port, accept_there);
  if (!listener) return listener.error();
  port = (*listener)->port();
  *robot = port;
  if (const Result<void> opened = listen_besides(port, accept_there); !opened) return opened.error();
  listeners_.push_back(std::move(*listener));
  return port;
}

/// For all ports, with the first.
Result<void> Server::Impl::open_group() {
  if (!options_.group || group_ != nullptr) return {};
  if (board_.admit)
    return Error{net::to_text(*options_.group),
                 "invalid group: everybody reads it, so admit_by() excludes it"};
  auto opened = MulticastGroup::open(network_, options_.bind, *options_.group);
  if (!opened) return opened.error();
  group_ = std::move(*opened);
  board_.group_place = group_->place();
  board_.fanout.share_by(*group_);
  return {};
}

/// Unix socket and UDP port of this number.
Result<void> Server::Impl::listen_besides(std::uint16_t port, const net::Network::Acceptor& acceptor) {
  std::unique_ptr<net::Listener> local;
  if (!options_.unix_folder.empty()) {
    auto listener = network_.listen(options_.unix_folder, port, acceptor);
    if (!listener) return listener.error();
    local = std::move(*listener);
  }
  if (options_.datagrams) {
    auto opened = DatagramPort::open(network_, options_.bind, port, acceptor, datagram_room_);
    if (!opened) return opened.error();
    datagram_ports_.push_back(std::move(*opened));
  }
  if (local) listeners_.push_back(std::move(local));
  return {};
}

void Server::Impl::accept(std::uint32_t robot, std::unique_ptr<net::Connection> connection) {
  if (done_ || !has_room_for(*connection)) {  // after the run only datagrams still come
    ++refused_;
    return;
  }
  ++accepted_;
  const std::uint32_t serial = next_serial_++;
  log::debug("{}: connected to port {}", connection->peer(), robot);
  auto client = std::make_unique<Client>(*this, network_, board_, serial, robot, std::move(connection));
  client->start(banner_);
  if (!client->host().empty()) ++hosts_[client->host()].clients;
  clients_.emplace(serial, std::move(client));
}

// Logged once per episode, to avoid flooding the log.
bool Server::Impl::has_room_for(const net::Connection& connection) {
  const std::string network = host_of(connection);
  if (const auto found = hosts_.find(network); found != hosts_.end()) {
    Host& host = found->second;
    const bool full = host.clients >= limits::kSessionsOfHost;
    if (!std::exchange(host.full, full) && full) {
      log::warn("{}: refused: {} clients from {}, the limit for one address", connection.peer(), host.clients,
                network);
    }
    if (full) return false;
  }
  if (clients_.size() < options_.sessions) {
    full_ = false;
    return true;
  }
  const auto silent = std::find_if(clients_.begin(), clients_.end(),
                                   [](const auto& entry) { return entry.second->silent(); });
  if (!std::exchange(full_, true)) {
    log::warn(
        "{}: {} clients, the limit: {}", connection.peer(), clients_.size(),
        silent == clients_.end() ? "refused" : "those that have said nothing, or have no token, give way");
  }
  if (silent == clients_.end()) return false;
  remove_silent(*silent->second);
  return true;
}

void Server::Impl::remove_silent(Client& client) {
  log::debug("{}: closed: it has said nothing, or has no token", client.session().peer());
  ++silent_;
  remove(client.serial());
}

void Server::Impl::remove(std::uint32_t serial) {
  const auto found = clients_.find(serial);
  if (const auto host = hosts_.find(found->second->host());
      host != hosts_.end() && --host->second.clients == 0)
    hosts_.erase(host);
  clients_.erase(found);
  if (!done_ || !clients_.empty()) return;
  network_.post([this, alive = std::weak_ptr<int>(alive_)] {
    if (!alive.expired()) end();
  });
}

void Server::Impl::close_clients(std::function<bool(const std::string&, const std::string&)> which) {
  network_.post([this, which = std::move(which), alive = std::weak_ptr<int>(alive_)] {
    if (alive.expired()) return;
    std::vector<std::uint32_t> closed;
    for (const auto& [serial, client] : clients_)
      if (which(client->session().token(), client->session().peer())) closed.push_back(serial);
    for (const std::uint32_t serial : closed) {
      log::info("{}: closed: sent out", clients_.at(serial)->session().peer());
      remove(serial);
    }
  });
}

void Server::Impl::wake() {
  network_.post([this, alive = std::weak_ptr<int>(alive_)] {
    if (alive.expired()) return;
    delivers_on_ = false;
    deliveries_left_ = limits::kTurnDeliveries;
    deliver_outbox();
    make_output_room();  // idle clients with queued data have no turns
    schedule();
  });
}

void Server::Impl::schedule() {
  if (board_.due.empty() || std::exchange(scheduled_, true)) return;
  network_.post([this, alive = std::weak_ptr<int>(alive_)] {
    if (!alive.expired()) turn();
  });
}

// Round robin: a busy session goes to the end of the queue. After
// limits::kTurnWork the loop polls the sockets before the next turn.
void Server::Impl::turn() {
  scheduled_ = false;
  deliveries_left_ = limits::kTurnDeliveries;
  deliver_outbox();
  std::size_t work = 0;
  for (std::size_t left = board_.due.size(); left > 0 && work < limits::kTurnWork; --left) {
    const auto found = clients_.find(board_.due.front());
    board_.due.pop_front();
    if (found == clients_.end()) continue;
    ++turns_;
    work += 1 + found->second->advance();
    make_output_room();
  }
  schedule();
}

void Server::Impl::deliver_outbox() {
  std::vector<Outbox::OutboxItem> items;
  for (bool more = true; more;) {
    if (deliveries_left_ == 0) {
      if (!std::exchange(delivers_on_, true)) wake();
      break;
    }
    items.clear();
    more = outbox_.take(items, std::min(deliveries_left_, kOutboxBatch));
    for (const Outbox::OutboxItem& item : items)
      deliveries_left_ -= std::min(deliveries_left_, deliver(item));
  }
  tell_of_lost_data();
}

void Server::Impl::deliver_whole_outbox() {
  std::vector<Outbox::OutboxItem> items;
  outbox_.take(items, SIZE_MAX);
  for (const Outbox::OutboxItem& item : items) deliver(item);
  tell_of_lost_data();
}

std::size_t Server::Impl::deliver(const Outbox::OutboxItem& item) {
  if (const auto* answer = std::get_if<Answer>(&item)) {
    deliver(*answer);
    return 1;
  }
  if (std::holds_alternative<Forget>(item)) {
    for (const auto& [serial, client] : clients_) client->session().forget_data();
    return std::max<std::size_t>(1, clients_.size());
  }
  const auto& publication = std::get<device::Publication>(item);
  if (!board_.devices.has(publication.device)) return 1;  // retired
  const device::Address address = board_.devices[publication.device].address;
  return std::max<std::size_t>(1, board_.fanout.publish(publication, address, board_.clock()));
}

// Warns once; the number is in the status.
void Server::Impl::tell_of_lost_data() {
  const std::uint64_t lost = outbox_.data_dropped();
  if (lost > 0)
    for (const auto& [device, messages] : outbox_.take_dropped()) board_.fanout.lose(device, messages);
  if (lost > 0 && !std::exchange(told_of_lost_data_, true))
    log::warn("the server is too busy: {} messages of data gave way to newer ones, unsent", lost);
}

void Server::Impl::deliver(const Answer& answer) {
  const auto found = clients_.find(static_cast<std::uint32_t>(answer.ticket >> 32));
  if (found == clients_.end()) return;  // disconnected
  found->second->session().answer(static_cast<std::uint32_t>(answer.ticket), answer.ack, answer.body);
}

Result<device::DeviceId> Server::Impl::add_device(device::Address address, device::Driver& driver) {
  board_.device_lists.erase(address.robot);
  return board_.devices.add(address, driver);
}

void Server::Impl::retire_device(device::DeviceId id) {
  if (!board_.devices.has(id)) return;
  deliver_whole_outbox();
  const auto [address, driver, users] = board_.devices[id];
  const Frame notice = counted(make_notice(address, *driver, board_.clock()), board_.frame_bytes);
  const DeviceUses::DeviceUse use = board_.uses.take(id);
  board_.device_lists.erase(address.robot);
  board_.fanout.retire(id);
  board_.devices.retire(id);
  ++retired_;
  for (const std::uint64_t ticket : use.tickets) deliver({ticket, false, {}});
  for (const std::uint32_t serial : use.sessions) clients_.at(serial)->session().retire(id, address, notice);
  for (device::Driver* holder : use.holders) holder->retired(id);
  if (users > 0) log::info("{} has retired, {} clients had it open", describe(address), use.sessions.size());
  schedule();
}

void Server::Impl::take_turns(device::Turns& turns) {
  board_.turns = &turns;
  turns.when_changed([this, alive = std::weak_ptr<int>(alive_)] {
    if (!board_.held_back.exchange(false)) return;
    network_.post([this, alive] {
      if (!alive.expired()) advance_everybody();
    });
  });
}

Result<void> Server::Impl::hold(device::DeviceId device, device::Driver* holder) {
  if (!board_.devices.has(device)) return Error{"", "the device has retired"};
  if (Result<void> opened = board_.devices.open(device); !opened) return opened;
  if (holder != nullptr) board_.uses.hold(device, *holder);
  return {};
}

void Server::Impl::release(device::DeviceId device, device::Driver* holder) {
  if (!board_.devices.has(device)) return;  // retirement has ended the hold
  if (holder != nullptr) board_.uses.release(device, *holder);
  board_.devices.close(device);
}

std::size_t Server::Impl::device_rows() const {
  std::size_t rows = board_.devices.size() + board_.fanout.size() + board_.uses.size();
  for (const auto& [serial, client] : clients_) rows += client->session().device_rows();
  return rows;
}

// Evicts the oldest incomplete message, with its client: a legitimate one takes moments to arrive.
void Server::Impl::make_room() {
  while (board_.input_bytes > options_.input_bytes) {
    longest_unfinished()->session().give_up(fmt::format(
        "long messages of all clients take {} bytes, over the limit of {}, and its own began first",
        board_.input_bytes, options_.input_bytes));
  }
}

Client* Server::Impl::longest_unfinished() {
  Client* first = nullptr;
  for (const auto& [serial, client] : clients_) {
    if (client->session().input_bytes() == 0) continue;
    if (!first || client->session().input_turn() < first->session().input_turn()) first = client.get();
  }
  PLAYHOUSE_ASSERT(first);  // counted bytes belong to a session
  return first;
}

void Server::Impl::finish(std::function<void()> done) {
  done_ = std::move(done);
  listeners_.clear();
  deliver_whole_outbox();
  board_.run_is_over = true;
  if (clients_.empty()) return end();
  last_moments_ = network_.after(kLastRounds, [this] {
    last_moments_ = network_.after(kLastWrites, [this] { end(); });
    for (const auto& [serial, client] : clients_) client->session().send_unasked();
    advance_everybody();
  });
  advance_everybody();
}

void Server::Impl::advance_everybody() {
  for (const auto& [serial, client] : clients_) client->session().mark_due();
  schedule();
}

void Server::Impl::tell_datagrams() const {
  if (group_ != nullptr)
    log::info("multicast: {} messages sent, {} not sent", group_->counts().sent, group_->counts().unsent);
  if (datagram_ports_.empty()) return;
  const DatagramCounts all = status().datagrams;
  log::info(
      "UDP: {} datagrams received, {} of them dropped, {} commands overtaken; {} messages sent, {} not sent, "
      "{} too long",
      all.received, all.dropped, all.late, all.sent, all.unsent, all.too_long);
}

void Server::Impl::end() {
  if (!done_) return;
  for (const auto& [serial, client] : clients_) client->tell_unread();
  tell_datagrams();
  clients_.clear();
  hosts_.clear();
  datagram_ports_.clear();
  last_moments_.reset();
  std::exchange(done_, {})();
}

// Drops data before it disconnects clients.
void Server::Impl::make_output_room() {
  const auto is_full = [this] { return *board_.frame_bytes > options_.output_bytes; };
  if (!is_full()) return;
  for (Client* client : largest_holders()) {
    if (!is_full()) return;
    client->session().drop_data();  // shared frames are not freed yet
  }
  for (Client* client : largest_holders()) {
    if (!is_full()) return;
    log::warn(
        "{}: closed: what all clients have not read takes {} bytes, over the limit of {}, and most of it is "
        "its own",
        client->session().peer(), *board_.frame_bytes, options_.output_bytes);
    ++broken_;
    remove(client->serial());
  }
}

// Clients with queued bytes, largest first.
std::vector<Client*> Server::Impl::largest_holders() const {
  std::vector<Client*> holders;
  for (const auto& [serial, client] : clients_)
    if (client->held_bytes() > 0) holders.push_back(client.get());
  std::ranges::stable_sort(holders, std::greater(), &Client::held_bytes);
  return holders;
}

ServerStatus Server::Impl::status() const {
  ServerStatus status;
  status.sessions = clients_.size();
  status.stalled_sessions = static_cast<std::size_t>(std::count_if(
      clients_.begin(), clients_.end(), [](const auto& entry) { return entry.second->stalled(); }));
  status.sessions_accepted = accepted_;
  status.sessions_refused = refused_;
  status.sessions_silent = silent_;
  status.sessions_broken = broken_;
  status.turns = turns_;
  status.messages_received = board_.counters.messages_received;
  status.messages_sent = board_.counters.messages_sent;
  status.bytes_sent = board_.counters.bytes_sent;
  status.messages_encoded = board_.fanout.messages_encoded();
  status.output_bytes = *board_.frame_bytes;
  status.data_dropped = board_.counters.data_dropped + outbox_.data_dropped();
  status.commands_dropped = board_.counters.commands_dropped;
  status.requests_refused = board_.counters.requests_refused;
  status.devices = board_.devices.size();
  status.devices_retired = retired_;
  status.device_rows = device_rows();
  for (const auto& port : datagram_ports_) status.datagrams += port->counts();
  if (group_ != nullptr) status.group = group_->counts();
  return status;
}

std::vector<ClientStatus> Server::Impl::clients() const {
  std::vector<ClientStatus> all;
  for (const auto& [serial, client] : clients_) {
    const Session& session = client->session();
    all.push_back({session.peer(), session.robot(), session.open_devices()});
  }
  return all;
}

Server::Server(net::Network& network, ServerOptions options)
    : impl_(std::make_unique<Impl>(network, std::move(options), *this)) {}
Server::~Server() = default;

Result<std::uint16_t> Server::listen(std::uint16_t port) {
  return impl_->listen(port);
}
Result<device::DeviceId> Server::add_device(device::Address address, device::Driver& driver) {
  return impl_->add_device(address, driver);
}
void Server::stop_devices() {
  impl_->stop_devices();
}

void Server::retire_device(device::DeviceId device) {
  impl_->retire_device(device);
}
Result<void> Server::hold(device::DeviceId device, device::Driver* holder) {
  return impl_->hold(device, holder);
}
void Server::release(device::DeviceId device, device::Driver* holder) {
  impl_->release(device, holder);
}
void Server::admit_by(Admit admit) {
  PLAYHOUSE_ASSERT(impl_->board().group_place.empty());  // everybody reads a group
  impl_->board().admit = std::move(admit);
}

void Server::close_clients(std::function<bool(const std::string& token, const std::string& peer)> which) {
  impl_->close_clients(std::move(which));
}

void Server::take_turns(device::Turns& turns) {
  impl_->take_turns(turns);
}
void Server::finish(std::function<void()> done) {
  impl_->finish(std::move(done));
}
void Server::set_clock(std::function<double()> clock) {
  impl_->board().clock = std::move(clock);
}
bool Server::has_readers(device::DeviceId device) const {
  return impl_->board().fanout.has_readers(device);
}
ServerStatus Server::status() const {
  return impl_->status();
}
void Server::prepare(device::DeviceId device, device::Driver::Prepared heard) {
  const device::DeviceTable& devices = impl_->board().devices;
  if (!devices.has(device)) return heard(Error{"", "the device has retired"});
  device::Driver& driver = *devices[device].driver;
  driver.ready(device) ? heard({}) : driver.prepare(device, std::move(heard));
}
std::map<device::Address, device::DeviceId> Server::devices() const {
  return impl_->board().devices.by_address();
}
std::vector<ClientStatus> Server::clients() const {
  return impl_->clients();
}
void Server::accept(std::uint16_t port, std::unique_ptr<net::Connection> connection) {
  impl_->accept(port, std::move(connection));
}
bool Server::has_port(std::uint16_t port) const {
  return impl_->has_port(port);
}
void Server::publish(std::vector<device::Publication> batch) {
  impl_->publish(std::move(batch));
}
void Server::forget() {
  impl_->forget();
}
void Server::answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) {
  impl_->answer({ticket, ack, std::move(body)});
}

}  // namespace playhouse::server
