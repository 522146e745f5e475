/// Pages of the simulated network. A message counts with its bytes and arrives whole.

#include "playhouse/net/simulated_page.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/net/http.h"
#include "playhouse/net/simulated.h"

namespace playhouse::net {

/// Both directions of a WebSocket.
struct SimulatedSocket {
  struct UnderWay {
    SimulatedPage::SocketMessage message;
    double arrival = 0;  // s
  };

  explicit SimulatedSocket(SimulatedNetwork& its_network) : network(its_network) {}

  SimulatedNetwork& network;
  std::string name;  // peer
  WebSocketEvents* events = nullptr;
  std::deque<UnderWay> to_server;
  std::deque<SimulatedPage::SocketMessage> in_flight;  // sent by the server, not accepted by the "system"
  std::deque<UnderWay> window;                         // accepted, not read by the page
  std::vector<SimulatedPage::SocketMessage> read;      // by the page, for take()
  std::optional<std::string> closing;                  // the server has closed it: why, told behind the rest
  std::optional<std::string> closed;                   // the page knows
  bool finished = false, vanished = false, stalled = false, paused = false;
  bool told_closed = false;
  bool draining = false;  // `drained` is pending
};

namespace {

double last_arrival(const std::deque<SimulatedSocket::UnderWay>& messages) {
  return messages.empty() ? 0 : messages.back().arrival;
}

bool has_arrived(const std::deque<SimulatedSocket::UnderWay>& messages, double now) {
  return !messages.empty() && messages.front().arrival <= now;
}

class SimulatedHttpListener final : public Listener {
 public:
  SimulatedHttpListener(std::uint16_t port, std::shared_ptr<HttpService*> service)
      : port_(port), service_(std::move(service)) {}
  ~SimulatedHttpListener() override { *service_ = nullptr; }
  std::uint16_t port() const override { return port_; }

 private:
  std::uint16_t port_;
  std::shared_ptr<HttpService*> service_;  // shared with the network
};

}  // namespace

class SimulatedWebSocket final : public WebSocket {
 public:
  explicit SimulatedWebSocket(std::shared_ptr<SimulatedSocket> socket) : socket_(std::move(socket)) {}
  ~SimulatedWebSocket() override {
    if (!socket_->closing) socket_->in_flight.clear();
    close("closed");
  }
  void start(WebSocketEvents& events) override { socket_->events = &events; }
  void send_text(std::shared_ptr<const std::string> text) override {
    const auto bytes = std::as_bytes(std::span(*text));
    send({true, {bytes.begin(), bytes.end()}});
  }
  void send_binary(SharedBytes bytes) override { send({false, *bytes}); }
  void pause() override { socket_->paused = true; }
  void resume() override { socket_->paused = false; }
  std::size_t messages_in_flight() const override { return socket_->in_flight.size(); }
  void close_after_flush(std::string reason) override { close(std::move(reason)); }
  void close(std::string reason) override {
    socket_->events = nullptr;
    if (!socket_->closing) socket_->closing = std::move(reason);
  }
  const std::string& peer() const override { return socket_->name; }

 private:
  void send(SimulatedPage::SocketMessage message) {
    if (socket_->vanished) return;
    socket_->in_flight.push_back(std::move(message));
    socket_->draining = true;
  }

  std::shared_ptr<SimulatedSocket> socket_;
};

void SimulatedPage::send(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  send({true, {bytes.begin(), bytes.end()}});
}
void SimulatedPage::send(SocketMessage message) {
  if (socket_->finished || socket_->vanished) return;
  socket_->to_server.push_back(
      {std::move(message), socket_->network.arrival(last_arrival(socket_->to_server))});
}
void SimulatedPage::finish() {
  socket_->finished = true;
}
void SimulatedPage::vanish() {
  socket_->vanished = true;
  socket_->to_server.clear();
  socket_->in_flight.clear();
  socket_->window.clear();
}
void SimulatedPage::stall() {
  socket_->stalled = true;
}
void SimulatedPage::read_on() {
  socket_->stalled = false;
}
std::vector<SimulatedPage::SocketMessage> SimulatedPage::take() {
  return std::exchange(socket_->read, {});
}
const std::optional<std::string>& SimulatedPage::closed() const {
  return socket_->closed;
}

Result<std::unique_ptr<Listener>> SimulatedNetwork::listen_http(const std::string& bind, std::uint16_t port,
                                                                HttpService& service) {
  if (port == 0) port = next_port_++;
  auto& entry = services_[port];
  if (entry && *entry) return Error{bind + ":" + std::to_string(port), "cannot listen: port in use"};
  entry = std::make_shared<HttpService*>(&service);
  return std::unique_ptr<Listener>(std::make_unique<SimulatedHttpListener>(port, entry));
}

SimulatedPage SimulatedNetwork::open_page(std::uint16_t port, HttpRequest request) {
  const auto found = services_.find(port);
  PLAYHOUSE_ASSERT(found != services_.end() && *found->second);
  auto socket = std::make_shared<SimulatedSocket>(*this);
  after_cut([this, service = found->second, socket, request = std::move(request)]() mutable {
    if (!*service) return void(socket->closed = "cannot connect: Connection refused");
    Result<void> served = (*service)->serves(request.host);
    const Result<std::string> client = (*service)->client_of(request);
    if (served && !client) served = client.error();
    if (served) served = (*service)->may_upgrade(request);
    if (!served) return void(socket->closed = served.error().text);
    socket->name = *client;
    sockets_.push_back(socket);
    (*service)->upgraded(std::make_unique<SimulatedWebSocket>(socket), request);
  });
  return SimulatedPage(socket);
}

bool SimulatedNetwork::is_over(const SimulatedSocket& socket) {
  return socket.closing && (socket.closed || socket.vanished);
}

bool SimulatedNetwork::step_socket(SimulatedSocket& socket) {
  bool busy = !is_cut() && carry_commands(socket);
  busy |= accept_messages(socket);
  if (!is_cut() && !socket.stalled)
    for (; has_arrived(socket.window, now_); socket.window.pop_front()) {
      socket.read.push_back(std::move(socket.window.front().message));
      busy = true;
    }
  if (socket.in_flight.empty() && std::exchange(socket.draining, false)) {
    busy = true;
    if (socket.events && !socket.vanished) socket.events->drained();
  }
  if (!is_cut() && socket.closing && !socket.closed && socket.in_flight.empty() && socket.window.empty()) {
    socket.closed = socket.closing;
    busy = true;
  }
  return busy;
}

/// Page to server.
bool SimulatedNetwork::carry_commands(SimulatedSocket& socket) {
  if (!socket.events || socket.paused) return false;
  if (has_arrived(socket.to_server, now_)) {
    const SimulatedPage::SocketMessage message = std::move(socket.to_server.front().message);
    socket.to_server.pop_front();
    const std::vector<std::byte>& bytes = message.bytes;
    if (message.is_text) {
      socket.events->received({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } else if (!socket.events->received_bytes(bytes)) {
      std::exchange(socket.events, nullptr)->closed("sent a binary message");
    }
    return true;
  }
  if (!socket.to_server.empty() || !(socket.finished || socket.vanished) ||
      std::exchange(socket.told_closed, true))
    return false;
  socket.events->closed(socket.vanished ? "lost" : "closed");
  return true;
}

/// What the server has sent goes on its way as long as the window is not full.
bool SimulatedNetwork::accept_messages(SimulatedSocket& socket) {
  std::size_t bytes = 0;
  for (const auto& each : socket.window) bytes += each.message.bytes.size();
  bool busy = false;
  for (; !socket.in_flight.empty() && bytes < window_bytes; socket.in_flight.pop_front()) {
    bytes += socket.in_flight.front().bytes.size();
    const double arrives = arrival(last_arrival(socket.window));
    socket.window.push_back({std::move(socket.in_flight.front()), arrives});
    busy = true;
  }
  return busy;
}

}  // namespace playhouse::net
