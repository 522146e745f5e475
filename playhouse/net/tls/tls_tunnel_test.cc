// Connections through TLS, for a peer that is OpenSSL's own client with a blocking socket, in a thread. Out of scope here:
// certificates of files, and browsers (tests/e2e/test_tls.py).

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509.h>
#include <sys/socket.h>
#include <unistd.h>

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "playhouse/net/io_loop.h"
#include "playhouse/net/testing_bytes.h"
#include "playhouse/net/tls/tls_identity.h"

namespace playhouse::net {
namespace {

constexpr std::size_t kMuch = 3'000'000;  // more than all buffers on the way together
constexpr std::size_t kWaiting =
    500'000;  // more than is read although nobody wants it, less than a system takes

template <typename T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

template <typename T>
std::string pem_of(int (*write)(BIO*, const T*), const T* what) {
  const Owned<BIO> bio(BIO_new(BIO_s_mem()), [](BIO* each) { BIO_free(each); });
  EXPECT_EQ(write(bio.get(), what), 1);
  char* text = nullptr;
  const auto size = static_cast<std::size_t>(BIO_get_mem_data(bio.get(), &text));
  return {text, size};
}

/// Of a certificate that signs itself, valid for an hour.
std::shared_ptr<TlsIdentity> made_identity() {
  const Owned<EVP_PKEY> key(EVP_EC_gen("P-256"), EVP_PKEY_free);
  const Owned<X509> certificate(X509_new(), X509_free);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), 0);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), 3600);
  X509_set_pubkey(certificate.get(), key.get());
  X509_sign(certificate.get(), key.get(), EVP_sha256());
  const auto write_key = +[](BIO* bio, const EVP_PKEY* each) {
    return PEM_write_bio_PrivateKey(bio, each, nullptr, nullptr, 0, nullptr, nullptr);
  };
  const auto write_certificate = +[](BIO* bio, const X509* each) { return PEM_write_bio_X509(bio, each); };
  auto identity = TlsIdentity::of({"test.crt", pem_of<X509>(write_certificate, certificate.get())},
                                  {"test.key", pem_of<EVP_PKEY>(write_key, key.get())});
  EXPECT_TRUE(identity) << identity.error().line();
  return *identity;
}

/// The peer, after its handshake.
class Peer {
 public:
  explicit Peer(std::uint16_t port) : descriptor_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(descriptor_, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
    SSL_set_fd(ssl_.get(), descriptor_);
    EXPECT_EQ(SSL_connect(ssl_.get()), 1);
  }
  ~Peer() {
    if (descriptor_ >= 0) close(descriptor_);
  }

  void send(const std::string& text) {
    EXPECT_EQ(SSL_write(ssl_.get(), text.data(), static_cast<int>(text.size())),
              static_cast<int>(text.size()));
  }
  std::string read(std::size_t count) {
    std::string all(count, 0);
    std::size_t have = 0, more = 0;
    while (have < count && SSL_read_ex(ssl_.get(), all.data() + have, count - have, &more) == 1) have += more;
    all.resize(have);
    return all;
  }
  /// Whether the server has ended in order, by TLS.
  bool at_end() {
    char more = 0;
    const int result = SSL_read(ssl_.get(), &more, 1);
    return SSL_get_error(ssl_.get(), result) == SSL_ERROR_ZERO_RETURN;
  }
  void finish() { SSL_shutdown(ssl_.get()); }
  void reset() {
    const linger hard{1, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    close(std::exchange(descriptor_, -1));
  }

 private:
  const Owned<SSL_CTX> context_{SSL_CTX_new(TLS_client_method()), SSL_CTX_free};
  const Owned<SSL> ssl_{SSL_new(context_.get()), SSL_free};
  int descriptor_;
};

class TlsTunnelTest : public ::testing::Test, public ConnectionEvents {
 protected:
  TlsTunnelTest() {
    loop_.use_tls(made_identity());
    auto listener = loop_.listen("127.0.0.1", 0, [this](std::unique_ptr<Connection> connection) {
      connection_ = std::move(connection);
      connection_->start(*this);
      on_accepted_();
    });
    EXPECT_TRUE(listener);
    listener_ = std::move(*listener);
  }

  /// Serves until stop(), while a peer does its work in a thread; ends when both have ended.
  void run_beside(const std::function<void(Peer&)>& work) {
    std::thread peer([&] {
      Peer there(listener_->port());
      work(there);
    });
    const auto patience = loop_.after(60, [this] { loop_.stop(); });  // a fault is a failure, not a hang
    loop_.run();
    connection_.reset();
    loop_.poll();
    peer.join();
  }

  void received(std::span<const std::byte> bytes) override {
    received_ += text(bytes);
    on_received_();
  }
  void drained() override {}
  void lost() override {
    ++losses_;
    on_lost_();
  }
  void closed(const std::string& why) override {
    end_ = why;
    on_closed_();
  }

  IoLoop loop_;
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<Connection> connection_;
  std::string received_, end_;
  int losses_ = 0;
  std::function<void()> on_accepted_ = [] {}, on_received_ = [] {}, on_lost_ = [] {}, on_closed_ = [] {};
};

TEST_F(TlsTunnelTest, passes_everything_both_ways_although_neither_side_reads_at_first) {
  const std::string there(kMuch, 'a'), back(kMuch, 'b');
  std::unique_ptr<Timer> timer;
  on_accepted_ = [&] {
    connection_->pause();
    const SharedBytes parts[] = {shared(back)};
    connection_->send(parts);
    timer = loop_.after(0.05, [&] { connection_->resume(); });
  };
  on_received_ = [&] {
    if (received_.size() == kMuch) connection_->close_after_flush();
  };
  std::string heard;
  run_beside([&](Peer& peer) {
    std::thread writer([&] { peer.send(there); });
    writer.join();
    heard = peer.read(kMuch);
    EXPECT_TRUE(peer.at_end());
    loop_.stop();
  });
  EXPECT_TRUE(received_ == there);
  EXPECT_TRUE(heard == back);
}

TEST_F(TlsTunnelTest, tells_of_the_end_of_a_peer_that_still_reads) {
  on_closed_ = [&] {
    const SharedBytes parts[] = {shared("the answer")};
    connection_->send(parts);
    connection_->close_after_flush();
  };
  std::string heard;
  run_beside([&](Peer& peer) {
    peer.send("a question");
    peer.finish();
    heard = peer.read(10);
    loop_.stop();
  });
  EXPECT_EQ(received_, "a question");
  EXPECT_EQ(end_, "closed");
  EXPECT_EQ(heard, "the answer");
}

TEST_F(TlsTunnelTest, tells_of_a_reset_while_nothing_is_read) {
  on_accepted_ = [&] {
    connection_->pause();
    const SharedBytes parts[] = {shared("!")};
    connection_->send(parts);
  };
  on_lost_ = [&] { loop_.stop(); };
  run_beside([&](Peer& peer) {
    EXPECT_EQ(peer.read(1), "!");
    peer.send(std::string(kWaiting, 'a'));
    peer.reset();
  });
  EXPECT_EQ(losses_, 1);
}

}  // namespace
}  // namespace playhouse::net
