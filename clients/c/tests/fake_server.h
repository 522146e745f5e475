#pragma once

/// A scripted server for one client, in a thread of its own.

#include <playhouse/c.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace playhouse_c {

using Bytes = std::vector<std::uint8_t>;

/// A received message.
struct Received {
  ph_header header{};
  Bytes body;
};

/// The body of a message.
Bytes encoded(const ph_struct_type &type, const void *value);

/// encoded() of a generated struct: body(ph_position2d_data_type, {...}).
template <typename T>
Bytes body(const ph_struct_type &type, const T &value) {
  return encoded(type, &value);
}

/// The server's end of the connection, for scripts.
class Peer {
 public:
  explicit Peer(int fd, std::uint16_t port) : fd_(fd), port_(port) {}

  /// The client's next message; none at its end.
  std::optional<Received> receive();
  void send(const Bytes &bytes);
  void say(ph_header header, const Bytes &body);
  void answer(const Received &request, const Bytes &body = {}, ph_kind kind = PH_KIND_ACK);
  /// DATA of a device.
  void data(const ph_message_type *message, const Bytes &body, std::uint16_t index = 0,
            double timestamp = 1.0);
  /// DATA of position2d:0 with `x` as its pose.
  void position(double x, double timestamp = 1.0);
  void synch();
  void overflow(std::uint32_t lost);

  /// Acknowledges requests of mode and access, and passes the rest to `rest`, until the client disconnects or
  /// `rest` returns false.
  void serve(const std::function<bool(const Received &)> &rest);

  /// From now on passes one byte per call of send(2).
  void dribble() { piece_ = 1; }
  /// When the script has ended, the connection is reset, as of a server that crashes, instead of being closed
  /// in order.
  void reset() { resets = true; }
  std::uint16_t port() const { return port_; }

  std::vector<Received> received;  // everything so far
  bool resets = false;

 private:
  bool read_exactly(std::uint8_t *out, std::size_t size);

  int fd_;
  std::uint16_t port_;
  std::size_t piece_ = SIZE_MAX;
};

class FakeServer {
 public:
  using Script = std::function<void(Peer &)>;

  explicit FakeServer(Script script, const std::string &banner = "Player v.3.1.1");
  FakeServer(const FakeServer &) = delete;
  /// Waits for the script to end.
  ~FakeServer() { finish(); }

  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  std::uint16_t port() const { return port_; }
  /// Waits for the script to end; then what the client sent, in order.
  const std::vector<Received> &finish();

 private:
  void run(const Script &script, const Bytes &banner);

  int listener_;
  std::uint16_t port_ = 0;
  std::vector<Received> received_;
  std::thread thread_;
};

/// A script that serves with `rest`.
FakeServer::Script script(std::function<bool(Peer &, const Received &)> rest);

struct Free {
  void operator()(ph_client *client) const { ph_client_free(client); }
};
using Client = std::unique_ptr<ph_client, Free>;

/// A connected client; a failure of the test if there is none.
Client connected(const std::string &address, ph_mode mode = PH_MODE_PULL, double timeout = 5.0);

}  // namespace playhouse_c

/// The call fails with this status, and its error has this text in it.
#define EXPECT_FAILS(CALL, STATUS, TEXT)                              \
  do {                                                                \
    ph_error error = {PH_OK, ""};                                     \
    EXPECT_EQ((CALL), STATUS) << error.text;                          \
    EXPECT_EQ(error.status, STATUS);                                  \
    EXPECT_THAT(std::string(error.text), ::testing::HasSubstr(TEXT)); \
  } while (0)

/// The same of a call that returns a pointer.
#define EXPECT_REFUSES(CALL, STATUS, TEXT)                            \
  do {                                                                \
    ph_error error = {PH_OK, ""};                                     \
    EXPECT_EQ((CALL), nullptr);                                       \
    EXPECT_EQ(error.status, STATUS);                                  \
    EXPECT_THAT(std::string(error.text), ::testing::HasSubstr(TEXT)); \
  } while (0)

/// The call succeeds.
#define EXPECT_WORKS(CALL)                  \
  do {                                      \
    ph_error error = {PH_OK, ""};           \
    EXPECT_EQ((CALL), PH_OK) << error.text; \
  } while (0)
