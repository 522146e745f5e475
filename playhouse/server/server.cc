#include "playhouse/server/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/server/outbox.h"
#include "playhouse/server/session.h"

namespace playhouse::server {
namespace {

constexpr std::size_t kWriteBytes = 256u
                                    << 10;  // of one gathered write; the rest stays where it can be replaced
constexpr double kLastAnswers = 5;          // s; a client that said goodbye waits so long for them

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

net::SharedBytes make_banner(const std::string& version) {
  std::string text = "Player v." + version;
  text.resize(std::min(text.size(), limits::kBannerBytes - 1));
  text.resize(limits::kBannerBytes);
  const auto bytes = std::as_bytes(std::span(text));
  return std::make_shared<std::vector<std::byte>>(bytes.begin(), bytes.end());
}

}  // namespace

class Server::Impl {
 public:
  Impl(net::Network& network, ServerOptions options, device::Outlet& outlet)
      : network_(network), options_(std::move(options)), banner_(make_banner(options_.version)) {
    board_.clock = wall_clock;
    board_.outlet = &outlet;
  }

  Result<std::uint16_t> listen(std::uint16_t port);
  void publish(std::vector<device::Publication> batch) {
    if (outbox_.put(std::move(batch))) wake();
  }
  void answer(Answer answer) {
    if (outbox_.put(std::move(answer))) wake();
  }
  ServerStatus status() const;
  std::vector<SessionStatus> sessions() const;
  Switchboard& board() { return board_; }

 private:
  /// A session and its connection.
  class Client final : public net::ConnectionEvents {
   public:
    Client(Impl& server, std::uint32_t serial, std::uint32_t robot,
           std::unique_ptr<net::Connection> connection)
        : server_(server),
          serial_(serial),
          connection_(std::move(connection)),
          session_(server.board_, serial, robot, connection_->peer()) {}

    void start() {
      connection_->start(*this);
      const net::SharedBytes banner = server_.banner_;
      connection_->send(std::span(&banner, 1));
    }
    void received(std::span<const std::byte> bytes) override;
    void drained() override;
    void closed(const std::string& why) override;

    /// Sends what may go and takes up input that had to wait. May remove this client.
    void advance();
    bool stalled() const { return connection_->in_flight_bytes() > 0 && session_.messages_waiting() > 0; }
    Session& session() { return session_; }
    const Session& session() const { return session_; }

   private:
    void pump();
    bool drop_if_broken();
    void say_goodbye();
    void remove();

    Impl& server_;
    const std::uint32_t serial_;
    std::unique_ptr<net::Connection> connection_;
    Session session_;
    std::vector<net::SharedBytes> parts_;
    bool paused_ = false;
    std::unique_ptr<net::Timer> goodbye_;  // set once the peer will send no more
  };

  void accept(std::uint32_t robot, std::unique_ptr<net::Connection> connection);
  void remove(std::uint32_t serial) { clients_.erase(serial); }
  void wake();
  void deliver_outbox();
  void deliver(const Answer& answer);
  void tell_of_lost_data();
  void advance_all();
  void make_room();
  Client* longest_unfinished();

  net::Network& network_;
  const ServerOptions options_;
  const net::SharedBytes banner_;
  Outbox outbox_;
  std::shared_ptr<int> alive_ =
      std::make_shared<int>(0);  // tasks posted by us look whether we are still there
  Switchboard board_;            // after the outbox: drivers that are stopped may still answer
  std::vector<std::unique_ptr<net::Listener>> listeners_;
  std::map<std::uint32_t, std::unique_ptr<Client>> clients_;
  std::uint32_t next_serial_ = 1;
  std::uint64_t accepted_ = 0, refused_ = 0, broken_ = 0;
  bool full_ = false, told_of_lost_data_ = false;
};

// --- one client
// ------------------------------------------------------------------------------------------------------

void Server::Impl::Client::received(std::span<const std::byte> bytes) {
  session_.receive(bytes);
  server_.deliver_outbox();  // drivers that answered at once
  server_.make_room();
  advance();
}

void Server::Impl::Client::drained() {
  advance();
}

void Server::Impl::Client::advance() {
  pump();
  while (session_.can_work_on()) {
    session_.work_on();
    server_.deliver_outbox();
    pump();
  }
  if (goodbye_) return say_goodbye();
  if (drop_if_broken()) return;
  const bool pause = !session_.wants_bytes();
  if (pause == std::exchange(paused_, pause)) return;
  pause ? connection_->pause() : connection_->resume();
}

// The peer may have shut down its half alone, to read the answers to what it asked.
void Server::Impl::Client::closed(const std::string& why) {
  log::debug("{}: {}", session_.peer(), why);
  goodbye_ = server_.network_.after(kLastAnswers, [this] { remove(); });
  advance();
}

// What it said in haste may still wait for the answers of drivers.
void Server::Impl::Client::say_goodbye() {
  if (session_.held_up()) return;
  session_.leave();
  if (!session_.waits_for_answers()) remove();
}

bool Server::Impl::Client::drop_if_broken() {
  if (session_.broken().empty()) return false;
  log::warn("{}: closed: {}", session_.peer(), session_.broken());
  ++server_.broken_;
  remove();
  return true;
}

void Server::Impl::Client::remove() {
  connection_->close_after_flush();
  server_.remove(serial_);
}

// With a write under way, `drained` comes back here; not to one who said goodbye, who gets all at once.
void Server::Impl::Client::pump() {
  if (!goodbye_ && connection_->in_flight_bytes() > 0) return;
  parts_.clear();
  session_.take(parts_, goodbye_ ? limits::kSessionQueueBytes : kWriteBytes);
  if (!parts_.empty()) connection_->send(parts_);
  parts_.clear();
}

// --- all of them
// -----------------------------------------------------------------------------------------------------

Result<std::uint16_t> Server::Impl::listen(std::uint16_t port) {
  // The acceptor learns its port from the listener, which knows it only once it listens.
  auto robot = std::make_shared<std::uint32_t>(port);
  auto listener = network_.listen(
      options_.bind, port,
      [this, robot](std::unique_ptr<net::Connection> connection) { accept(*robot, std::move(connection)); });
  if (!listener) return listener.error();
  *robot = (*listener)->port();
  listeners_.push_back(std::move(*listener));
  return listeners_.back()->port();
}

void Server::Impl::accept(std::uint32_t robot, std::unique_ptr<net::Connection> connection) {
  if (clients_.size() >= limits::kSessions) {
    ++refused_;
    if (!std::exchange(full_, true))
      log::warn("{}: refused: {} clients, the limit", connection->peer(), clients_.size());
    return;
  }
  full_ = false;
  ++accepted_;
  const std::uint32_t serial = next_serial_++;
  log::debug("{}: connected to port {}", connection->peer(), robot);
  auto client = std::make_unique<Client>(*this, serial, robot, std::move(connection));
  client->start();
  clients_.emplace(serial, std::move(client));
}

void Server::Impl::wake() {
  network_.post([this, alive = std::weak_ptr<int>(alive_)] {
    if (alive.expired()) return;
    deliver_outbox();
    advance_all();
  });
}

void Server::Impl::deliver_outbox() {
  for (Outbox::Item& item : outbox_.take_all()) {
    if (const auto* publication = std::get_if<device::Publication>(&item)) {
      const device::Address address = board_.devices[publication->device].address;
      board_.fanout.publish(*publication, address, board_.clock());
    } else {
      deliver(*std::get_if<Answer>(&item));
    }
  }
  tell_of_lost_data();
}

// Their number is in the status.
void Server::Impl::tell_of_lost_data() {
  const std::uint64_t lost = outbox_.data_dropped();
  if (lost > 0 && !std::exchange(told_of_lost_data_, true))
    log::warn("the server is too busy: {} messages of data gave way to newer ones, unsent", lost);
}

void Server::Impl::deliver(const Answer& answer) {
  const auto found = clients_.find(static_cast<std::uint32_t>(answer.ticket >> 32));
  if (found == clients_.end()) return;  // the client is gone
  found->second->session().answer(static_cast<std::uint32_t>(answer.ticket), answer.ack, answer.body);
}

void Server::Impl::advance_all() {
  for (auto next = clients_.begin(); next != clients_.end();) (next++)->second->advance();
}

// A message of an honest client takes moments, however long it is, so the one begun first has to go.
void Server::Impl::make_room() {
  while (board_.input_bytes > options_.input_bytes) {
    longest_unfinished()->session().give_up(fmt::format(
        "long messages of all clients take {} bytes, over the limit of {}, and its own began first",
        board_.input_bytes, options_.input_bytes));
    wake();
  }
}

Server::Impl::Client* Server::Impl::longest_unfinished() {
  Client* first = nullptr;
  for (const auto& [serial, client] : clients_) {
    if (client->session().input_bytes() == 0) continue;
    if (!first || client->session().input_turn() < first->session().input_turn()) first = client.get();
  }
  PLAYHOUSE_ASSERT(first);  // what is counted is some session's
  return first;
}

ServerStatus Server::Impl::status() const {
  ServerStatus status;
  status.sessions = clients_.size();
  status.stalled_sessions = static_cast<std::size_t>(std::count_if(
      clients_.begin(), clients_.end(), [](const auto& entry) { return entry.second->stalled(); }));
  status.sessions_accepted = accepted_;
  status.sessions_refused = refused_;
  status.sessions_broken = broken_;
  status.messages_received = board_.counters.messages_received;
  status.messages_sent = board_.counters.messages_sent;
  status.bytes_sent = board_.counters.bytes_sent;
  status.messages_encoded = board_.fanout.messages_encoded();
  status.data_dropped = board_.counters.data_dropped + outbox_.data_dropped();
  status.commands_dropped = board_.counters.commands_dropped;
  status.requests_refused = board_.counters.requests_refused;
  return status;
}

std::vector<SessionStatus> Server::Impl::sessions() const {
  std::vector<SessionStatus> result;
  for (const auto& [serial, client] : clients_) {
    const Session& session = client->session();
    result.push_back({session.peer(), session.robot(), session.devices_open(), session.messages_waiting(),
                      session.messages_sent(), session.data_dropped()});
  }
  return result;
}

Server::Server(net::Network& network, ServerOptions options)
    : impl_(std::make_unique<Impl>(network, std::move(options), *this)) {}
Server::~Server() = default;

Result<std::uint16_t> Server::listen(std::uint16_t port) {
  return impl_->listen(port);
}
Result<device::DeviceId> Server::add_device(device::Address address, device::Driver& driver) {
  return impl_->board().devices.add(address, driver);
}
Result<void> Server::hold(device::DeviceId device, device::Receipt receipt) {
  return impl_->board().devices.open(device, std::move(receipt));
}
void Server::release(device::DeviceId device, device::Receipt receipt) {
  impl_->board().devices.close(device, std::move(receipt));
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
std::vector<SessionStatus> Server::sessions() const {
  return impl_->sessions();
}
void Server::publish(std::vector<device::Publication> batch) {
  impl_->publish(std::move(batch));
}
void Server::answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) {
  impl_->answer({ticket, ack, std::move(body)});
}

}  // namespace playhouse::server
