// TLS in front of a connection: decrypts into one end of a pair of local sockets, whose other end is what sessions and
// pages read and write. So neither knows of it.

#include <array>
#include <boost/asio/local/connect_pair.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/ssl/error.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "playhouse/net/asio.h"
#include "playhouse/net/asio_accept.h"
#include "playhouse/net/tls/asio_tls.h"
#include "playhouse/net/tls/decrypt.h"

namespace playhouse::net {
namespace {

namespace ssl = asio::ssl;
using asio::ip::tcp;

constexpr std::size_t kRecordBytes = 16384;     // as many as fit into a record of TLS
constexpr std::chrono::seconds kLingerTime{2};  // from our last byte to the peer's

/// Kept alive by its pending operations until both directions have ended.
class TlsTunnel : public std::enable_shared_from_this<TlsTunnel> {
 public:
  /// `owner` is that of the context.
  TlsTunnel(IoLoop::Impl& loop, std::shared_ptr<void> owner, ssl::context& context, tcp::socket socket)
      : loop_(loop),
        owner_(std::move(owner)),
        peer_(std::move(socket), context),
        inner_(loop.context),
        timer_(loop.context) {}

  /// Of a client: the server has to be this host.
  void expect(const std::string& host) {
    error_code error;
    peer_.set_verify_callback(ssl::host_name_verification(host), error);
    asio::ip::make_address(host, error);
    if (error)
      SSL_set_tlsext_host_name(peer_.native_handle(), host.c_str());  // names alone are told (RFC 6066)
  }

  void begin(ssl::stream_base::handshake_type side, std::function<void(Result<Decrypted>)> done) {
    if (loop_.handshakes.size() >= kHandshakes) std::function(loop_.handshakes.front())();
    handshake_ = loop_.handshakes.insert(loop_.handshakes.end(), [this] { close(); });
    close_after(std::chrono::seconds(kHandshakeSeconds));
    peer_.async_handshake(side, [self = shared_from_this(), done = std::move(done)](const error_code& error) {
      done(error ? self->give_up(error.message()) : self->open());
    });
  }

 private:
  void end_handshake() { loop_.handshakes.erase(*std::exchange(handshake_, {})); }

  Error give_up(const std::string& why) {
    const bool in_time = handshake_.has_value();
    close();
    return {"", in_time ? why : "not in time"};
  }

  Result<Decrypted> open() {
    if (!handshake_) return give_up("");
    end_handshake();
    timer_.cancel();
    asio::local::stream_protocol::socket outer(loop_.context);
    error_code error;
    if (asio::local::connect_pair(inner_, outer, error)) return give_up(error.message());
    tcp::socket shown(loop_.context);
    if (shown.assign(tcp::v4(), outer.release(error), error)) return give_up(error.message());
    inner_.non_blocking(true, error);
    shown.non_blocking(true, error);
    read_peer();
    wait_for_output();
    wait_for_hang_up();
    wait_for_fault();
    return Decrypted{std::move(shown), [weak = weak_from_this()] {
                       if (const auto self = weak.lock()) expect_alive(self->peer_.next_layer());
                     }};
  }

  void read_peer() {
    peer_.async_read_some(asio::buffer(input_),
                          [self = shared_from_this()](const error_code& error, std::size_t count) {
                            if (error) return self->end_of_input(error);
                            self->pass_on(count);
                          });
  }

  // Reads on after whoever reads here has ended: closing with unread input would reset the peer's connection.
  void pass_on(std::size_t count) {
    if (input_is_unwanted_) return read_peer();
    asio::async_write(inner_, asio::buffer(input_, count),
                      [self = shared_from_this()](const error_code& error, std::size_t) {
                        if (error) self->input_is_unwanted_ = true;
                        self->read_peer();
                      });
  }

  void end_of_input(const error_code& error) {
    const bool in_order = error == asio::error::eof || error == ssl::error::stream_truncated;
    if (!in_order || output_has_ended_) return close();
    error_code ignored;
    inner_.shutdown(asio::socket_base::shutdown_send, ignored);
  }

  // Without a buffer while nothing is there to send: most connections wait.
  void wait_for_output() {
    output_ = {};
    inner_.async_wait(asio::socket_base::wait_read, [self = shared_from_this()](const error_code& error) {
      if (!error) self->read_output();
    });
  }

  void read_output() {
    output_.resize(kRecordBytes);
    error_code error;
    const std::size_t count = inner_.read_some(asio::buffer(output_), error);
    if (error == asio::error::would_block || error == asio::error::interrupted) return wait_for_output();
    if (error) return end_of_output();
    asio::async_write(peer_, asio::buffer(output_, count),
                      [self = shared_from_this()](const error_code& failed, std::size_t) {
                        failed ? self->close() : self->read_output();
                      });
  }

  // Whoever reads and writes here is gone for good: what the peer has not taken in time is lost.
  void wait_for_hang_up() {
    inner_.async_wait(asio::socket_base::wait_error, [self = shared_from_this()](const error_code& error) {
      if (!error && !self->output_has_ended_) self->close_after(std::chrono::seconds(kFlushSeconds));
    });
  }

  // Detects a reset or timeout while whoever reads here does not.
  void wait_for_fault() {
    peer_.lowest_layer().async_wait(
        asio::socket_base::wait_error, [self = shared_from_this()](const error_code& error) {
          if (error) return;
          has_fault(self->peer_.next_layer()) ? self->close() : self->wait_for_fault();
        });
  }

  void end_of_output() {
    output_has_ended_ = true;
    close_after(kLingerTime);
    peer_.async_shutdown([self = shared_from_this()](const error_code&) { self->close(); });
  }

  void close_after(std::chrono::seconds time) {
    timer_.expires_after(time);
    timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->close();
    });
  }

  void close() {
    if (handshake_) end_handshake();
    error_code ignored;
    timer_.cancel(ignored);
    peer_.lowest_layer().close(ignored);
    inner_.close(ignored);
  }

  IoLoop::Impl& loop_;
  const std::shared_ptr<void> owner_;
  ssl::stream<tcp::socket> peer_;
  asio::local::stream_protocol::socket inner_;
  asio::steady_timer timer_;  // of the handshake, then of the end
  std::optional<IoLoop::Impl::Handshakes::iterator> handshake_;
  std::array<std::byte, 4096> input_;
  std::vector<std::byte> output_;
  bool input_is_unwanted_ = false, output_has_ended_ = false;
};

}  // namespace

void decrypt(IoLoop::Impl& loop, std::shared_ptr<TlsIdentity> identity, tcp::socket socket,
             std::function<void(Result<Decrypted>)> done) {
  ssl::context& context = identity->openssl().context;
  std::make_shared<TlsTunnel>(loop, std::move(identity), context, std::move(socket))
      ->begin(ssl::stream_base::server, std::move(done));
}

void decrypt_from(IoLoop::Impl& loop, std::shared_ptr<TlsTrust> trust, const std::string& host,
                  tcp::socket socket, std::function<void(Result<Decrypted>)> done) {
  ssl::context& context = trust->openssl().context;
  const auto tunnel = std::make_shared<TlsTunnel>(loop, std::move(trust), context, std::move(socket));
  tunnel->expect(host);
  tunnel->begin(ssl::stream_base::client, std::move(done));
}

}  // namespace playhouse::net
