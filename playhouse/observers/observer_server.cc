#include "playhouse/observers/observer_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "playhouse/base/formats.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/observers/cookie.h"
#include "playhouse/replicate/datagrams/datagram_viewer.h"

namespace playhouse::observers {
namespace {

constexpr int kGoodbyes = 3;  // sent repeatedly against loss

}  // namespace

class ObserverServer::Impl final {
 public:
  Impl(net::Network& network, ObserverOptions options, replicate::SnapshotFeed& feed)
      : network_(network),
        options_(std::move(options)),
        feed_(feed),
        reader_(
            feed, [&network](std::function<void()> task) { network.post(std::move(task)); },
            [this] { reader_.take(); }) {}

  Result<std::uint16_t> listen() {
    auto socket = network_.open_datagrams(
        options_.bind, options_.port,
        [this](const net::Endpoint& from, std::span<const std::byte> bytes) { received(from, bytes); });
    if (!socket) return socket.error();
    socket_ = std::move(*socket);
    return socket_->port();
  }

  void end_sent_out() {
    for (auto observer = observers_.begin(); observer != observers_.end();) {
      const auto next = std::next(observer);
      if (options_.guests.is_sent_out(observer->second.token, net::to_text(observer->first))) {
        send_goodbye(observer->first, observer->second.viewer->session(), server::kSentOut);
        end(observer, "an admin has sent them out");
      }
      observer = next;
    }
  }

  void say_goodbye(const std::string& why) {
    for (const auto& [peer, observer] : observers_) send_goodbye(peer, observer.viewer->session(), why);
    observers_.clear();
    watch();
  }

  void close() {
    frame_timer_.reset();
    socket_.reset();
    observers_.clear();
  }

  ObserverStatus status() const {
    ObserverStatus status = status_;
    status.observers = observers_.size();
    return status;
  }

 private:
  struct Observer {
    std::uint64_t nonce = 0;  // of its join request
    std::string token;        // "*": none
    std::vector<std::byte> welcome;
    std::unique_ptr<replicate::DatagramViewer> viewer;
  };

  void received(const net::Endpoint& from, std::span<const std::byte> bytes) {
    const Result<replicate::Datagram> datagram = replicate::parse_datagram(bytes);
    if (!datagram) {
      ++status_.ignored;
    } else if (const auto* hello = std::get_if<replicate::Hello>(&*datagram)) {
      greet(from, *hello);
    } else if (const auto* join = std::get_if<replicate::JoinRequest>(&*datagram)) {
      let_in(from, *join);
    } else if (const auto* packet = std::get_if<replicate::PacketOf>(&*datagram)) {
      take(from, *packet);
    } else if (const auto* bye = std::get_if<replicate::Bye>(&*datagram)) {
      if (const auto observer = of_session(from, bye->session); observer != observers_.end())
        end(observer, "left");
    } else {
      ++status_.ignored;  // valid only from a server
    }
  }

  /// Stateless, and the answer is shorter than the hello.
  void greet(const net::Endpoint& from, const replicate::Hello& hello) {
    if (hello.format != formats::kObserver) return refuse(from, hello.nonce, format_text(hello.format));
    send(from, replicate::encode(
                   replicate::Challenge{hello.nonce, cookies_.make(from, hello.nonce, network_.now())}));
  }

  /// Short, as the answer must not be longer than the hello.
  static std::string format_text(std::uint8_t format) {
    return fmt::format("this observer speaks format {}, the run format {}", format, formats::kObserver);
  }

  void let_in(const net::Endpoint& from, const replicate::JoinRequest& join) {
    if (!cookies_.is_good(join.cookie, from, join.nonce, network_.now())) {
      ++status_.ignored;
      return;
    }
    // Same nonce: the welcome was lost, resend it. Another nonce from this address: replaces the old session.
    if (const auto known = observers_.find(from); known != observers_.end()) {
      if (known->second.nonce == join.nonce) return send(from, known->second.welcome);
      end(known, "came again");
    }
    if (join.format != formats::kObserver) return refuse(from, join.nonce, format_text(join.format));
    const std::string token = join.token.empty() ? "*" : join.token;
    const auto guest = options_.guests.admit(token, net::to_text(from));
    if (!guest)
      return refuse(from, join.nonce,
                    options_.guests.is_sent_out(token, net::to_text(from))
                        ? server::kSentOut
                        : "--token with the token that you were given is needed");
    if (observers_.size() >= options_.observers)
      return refuse(from, join.nonce, fmt::format("limit reached: {} observers", observers_.size()));
    if (!net::is_local(net::to_text(from)) && observers_from(from) >= most_of_one_network())
      return refuse(from, join.nonce,
                    fmt::format("limit reached: {} observers from one address", most_of_one_network()));
    welcome(from, join, *guest);
  }

  /// Half of the places: nobody shuts out all others alone.
  std::size_t most_of_one_network() const { return (options_.observers + 1) / 2; }

  std::size_t observers_from(const net::Endpoint& endpoint) const {
    const std::string network = net::network_of(net::to_text(endpoint));
    return static_cast<std::size_t>(std::ranges::count_if(observers_, [&](const auto& observer) {
      return net::network_of(net::to_text(observer.first)) == network;
    }));
  }

  void welcome(const net::Endpoint& from, const replicate::JoinRequest& join, const server::Guest& guest) {
    const std::uint32_t wanted = join.wanted.bytes_per_second;
    const replicate::Terms terms{
        std::clamp(wanted == 0 ? options_.bytes_per_second : wanted,
                   std::min(limits::kObserverBytesLeast, options_.bytes_per_second),
                   options_.bytes_per_second),
        std::clamp<std::uint32_t>(join.wanted.frames_per_second, 1, limits::kObserverFrames)};
    const std::uint64_t session = random_number();
    if (observers_.empty()) reader_.take();  // others may have watched meanwhile
    Observer observer{join.nonce, guest.token,
                      replicate::encode(replicate::Welcome{join.nonce, session, terms}),
                      std::make_unique<replicate::DatagramViewer>(session, terms, reader_.snapshot().layout,
                                                                  scene_text(), network_.now())};
    send(from, observer.welcome);
    observers_[from] = std::move(observer);
    log::info("observers: {} observes as {}{}{} ({} now)", net::to_text(from), name_of(guest.role),
              guest.name.empty() ? "" : " ", guest.name, observers_.size());
    watch();
    if (!frame_timer_) serve();
  }

  void take(const net::Endpoint& from, const replicate::PacketOf& packet) {
    const auto observer = of_session(from, packet.session);
    if (observer == observers_.end()) {
      ++status_.ignored;
      return;
    }
    const Result<void> taken = observer->second.viewer->receive(packet.rest, network_.now());
    if (taken) return;
    send_goodbye(from, packet.session, taken.error().text);
    end(observer, taken.error().text);
  }

  using Observers = std::map<net::Endpoint, Observer>;

  Observers::iterator of_session(const net::Endpoint& from, std::uint64_t session) {
    const auto observer = observers_.find(from);
    const bool is_it = observer != observers_.end() && observer->second.viewer->session() == session;
    return is_it ? observer : observers_.end();
  }

  void end(Observers::iterator observer, const std::string& why) {
    log::info("observers: {} left: {}", net::to_text(observer->first), why);
    observers_.erase(observer);
    watch();
  }

  /// One turn: offers the newest snapshot to all observers; repeated every frame while there are any.
  void serve() {
    const double now = network_.now();
    for (auto observer = observers_.begin(); observer != observers_.end();) {
      const auto next = std::next(observer);
      if (observer->second.viewer->is_gone(now)) {
        send_goodbye(observer->first, observer->second.viewer->session(), "nothing was heard of you");
        end(observer, "nothing was heard of it for long");
      } else {
        observer->second.viewer->offer(
            reader_.snapshot(), changes_, now,
            [&](std::span<const std::byte> datagram) { send(observer->first, datagram); });
      }
      observer = next;
    }
    frame_timer_.reset();
    if (observers_.empty()) return;
    frame_timer_ = network_.after(replicate::kFramePeriod, [this] { serve(); });
  }

  void refuse(const net::Endpoint& to, std::uint64_t nonce, const std::string& why) {
    if (status_.refused++ == 0) log::warn("observers: {} refused: {} (logged once)", net::to_text(to), why);
    send(to, replicate::encode(replicate::Refusal{nonce, why}));
  }

  void send_goodbye(const net::Endpoint& to, std::uint64_t session, const std::string& why) {
    for (int times = 0; times < kGoodbyes; ++times) send(to, replicate::encode(replicate::Bye{session, why}));
  }

  void send(const net::Endpoint& to, std::span<const std::byte> datagram) {
    ++status_.datagrams_sent;
    status_.bytes_sent += datagram.size();
    socket_->send(to, datagram);
  }

  void watch() { reader_.watch(!observers_.empty()); }

  /// The scene text for the newest snapshot's population, cached.
  std::shared_ptr<const replicate::PackedText> scene_text() {
    if (scene_layout_ != reader_.snapshot().layout) {
      scene_layout_ = reader_.snapshot().layout;
      scene_text_ = replicate::pack_text(feed_.scene_text(*scene_layout_, replicate::TellDevices::kNo));
    }
    return scene_text_;
  }

  net::Network& network_;
  ObserverOptions options_;
  const replicate::SnapshotFeed& feed_;
  replicate::SnapshotReader reader_;
  const Cookies cookies_;
  std::unique_ptr<net::DatagramSocket> socket_;
  Observers observers_;
  std::unique_ptr<net::Timer> frame_timer_;
  replicate::ChangesTexts changes_{replicate::TellDevices::kNo};
  std::shared_ptr<const replicate::Layout> scene_layout_;  // of scene_text_
  std::shared_ptr<const replicate::PackedText> scene_text_;
  ObserverStatus status_;
};

ObserverServer::ObserverServer(net::Network& network, ObserverOptions options, replicate::SnapshotFeed& feed)
    : impl_(std::make_unique<Impl>(network, std::move(options), feed)) {}
ObserverServer::~ObserverServer() {
  impl_->close();
}

Result<std::uint16_t> ObserverServer::listen() {
  return impl_->listen();
}
void ObserverServer::end_sent_out() {
  impl_->end_sent_out();
}
void ObserverServer::say_goodbye(const std::string& why) {
  impl_->say_goodbye(why);
}
ObserverStatus ObserverServer::status() const {
  return impl_->status();
}

}  // namespace playhouse::observers
