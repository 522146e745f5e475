#include "playhouse/web_server/web_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/small_world.h"

namespace playhouse::web_server {
namespace {

using replicate::SmallWorld;

constexpr PageFile kPage[] = {
    {"/index.html", "text/html; charset=utf-8", "\"abc\"", "<p>the page</p>", {}},
    {"/assets/main-1.js", "text/javascript; charset=utf-8", "\"def\"", "let x = 1", "squeezed"},
};

/// Notes what is asked for; changes wait until the test, as the tick thread, carries them out.
class Notes final : public world::Control {
 public:
  void pause() override { note("pause"); }
  void resume() override { note("resume"); }
  void step_once() override { note("step"); }
  void set_speed(double speed) override { note("speed " + std::to_string(speed).substr(0, 3)); }
  bool post(std::function<void(world::World&)> change) override {
    const std::lock_guard lock(mutex_);
    changes_.push_back(std::move(change));
    return true;
  }
  void carry_out(world::World& world) {
    std::vector<std::function<void(world::World&)>> changes;
    {
      const std::lock_guard lock(mutex_);
      changes.swap(changes_);
    }
    for (const auto& change : changes) change(world);
  }
  std::string all() {
    const std::lock_guard lock(mutex_);
    return all_;
  }

 private:
  void note(const std::string& what) {
    const std::lock_guard lock(mutex_);
    all_ += what + ";";
  }
  std::mutex mutex_;
  std::string all_;
  std::vector<std::function<void(world::World&)>> changes_;
};

/// A client's end of a connection, byte by byte.
class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// The server has closed.
  bool ended() const { return ended_; }
  void send(const std::string& bytes) {
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), ssize_t(bytes.size()));
  }

  /// Reads until the predicate holds for what has come; false at the end of the stream or after five seconds.
  bool read_until(
      const std::function<bool(const std::string&)>& enough, const std::function<void()>& meanwhile = [] {}) {
    for (int rounds = 0; rounds < 500 && !enough(in); ++rounds) {
      meanwhile();
      pollfd waiting{socket_, POLLIN, 0};
      if (::poll(&waiting, 1, 10) <= 0) continue;
      char buffer[4096];
      const ssize_t count = ::recv(socket_, buffer, sizeof buffer, 0);
      ended_ = count <= 0;
      if (ended_) return enough(in);
      in.append(buffer, static_cast<std::size_t>(count));
    }
    return enough(in);
  }

  /// The whole answer to one request; the server closes after it.
  std::string ask(const std::string& request) {
    send(request);
    read_until([](const std::string&) { return false; });
    return in;
  }

  bool upgrade(const std::string& more = "") {
    ask_to_upgrade(more);
    return upgraded();
  }
  /// As the browser of a page from `origin` that calls the program `host`.
  bool upgrade_at(const std::string& host, const std::string& origin) {
    ask_to_upgrade("Origin: " + origin + "\r\n", host);
    return upgraded();
  }
  void ask_to_upgrade(const std::string& more = "", const std::string& host = "127.0.0.1") {
    send("GET /live HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
         more + "\r\n");
  }
  bool upgraded() {
    if (!read_until([](const std::string& text) { return text.find("\r\n\r\n") != std::string::npos; }))
      return false;
    const bool switched = in.starts_with("HTTP/1.1 101");
    in.erase(0, in.find("\r\n\r\n") + 4);
    return switched;
  }

  void send_text(const std::string& text) {
    std::string frame = "\x81";
    if (text.size() < 126) {
      frame += static_cast<char>(0x80 | text.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(text.size() >> 8);
      frame += static_cast<char>(text.size() & 0xFF);
    }
    send(frame + std::string(4, '\0') + text);  // masked with zeros
  }

  /// The next whole message; its first byte is the WebSocket opcode. Empty: none came.
  std::string message(const std::function<void()>& meanwhile = [] {}) {
    if (!read_until([this](const std::string&) { return message_bytes() != 0; }, meanwhile)) return {};
    const std::size_t bytes = message_bytes();
    std::string whole =
        std::string(1, static_cast<char>(in[0] & 0x0F)) + in.substr(head_bytes(), bytes - head_bytes());
    in.erase(0, bytes);
    return whole;
  }

  std::string in;

 private:
  std::size_t head_bytes() const {
    const int length = in[1] & 0x7F;
    return length < 126 ? 2 : length == 126 ? 4 : 10;
  }
  std::size_t message_bytes() const {
    if (in.size() < 2 || in.size() < head_bytes()) return 0;
    std::size_t length = in[1] & 0x7F;
    if (length > 125) {
      const std::size_t count = length == 126 ? 2 : 8;
      length = 0;
      for (std::size_t k = 0; k < count; ++k) length = length << 8 | static_cast<unsigned char>(in[2 + k]);
    }
    return in.size() < head_bytes() + length ? 0 : head_bytes() + length;
  }

  int socket_;
  bool ended_ = false;
};

class WebServerTest : public testing::Test {
 protected:
  explicit WebServerTest(std::span<const PageFile> page = kPage, const std::string& bind = "127.0.0.1")
      : server_(loop_, {.bind = bind, .port = 0, .page = page, .host_name = "robo.lab.example"}, notes_,
                small_.world) {
    const Result<std::uint16_t> port = server_.listen();
    EXPECT_TRUE(port.ok());
    port_ = *port;
    io_ = std::thread([this] { loop_.run(); });
  }
  ~WebServerTest() override {
    loop_.stop();
    io_.join();
  }

  std::string get(const std::string& path, const std::string& more = "") {
    return Client(port_).ask("GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + more +
                             "\r\n");
  }

  /// One turn of the program: what viewers asked for, a tick, and a picture of it.
  void turn() {
    notes_.carry_out(small_.world);
    small_.tick();
    server_.show(small_.world, {});
  }
  std::function<void()> turning() {
    return [this] { turn(); };
  }
  bool turn_until(const std::function<bool()>& done) {
    for (int k = 0; k < 1000; ++k) {
      if (done()) return true;
      turn();
      std::this_thread::yield();
      ::poll(nullptr, 0, 2);
    }
    return done();
  }

  SmallWorld small_{3};
  Notes notes_;
  net::IoLoop loop_;
  WebServer server_;
  std::uint16_t port_ = 0;
  std::thread io_;
};

class NoPageTest : public WebServerTest {
 protected:
  NoPageTest() : WebServerTest(std::span<const PageFile>()) {}
};

TEST_F(WebServerTest, serves_the_page_with_its_type_and_tag) {
  const std::string answer = get("/");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK")) << answer;
  EXPECT_NE(answer.find("Content-Type: text/html; charset=utf-8"), std::string::npos);
  EXPECT_NE(answer.find("ETag: \"abc\""), std::string::npos);
  EXPECT_TRUE(answer.ends_with("<p>the page</p>"));
  EXPECT_TRUE(get("/", "If-None-Match: \"abc\"\r\n").starts_with("HTTP/1.1 304"));
  EXPECT_TRUE(get("/?x=1").ends_with("<p>the page</p>"));
}

TEST_F(WebServerTest, serves_the_compressed_form_to_who_takes_it) {
  EXPECT_TRUE(get("/assets/main-1.js").ends_with("let x = 1"));
  const std::string answer = get("/assets/main-1.js", "Accept-Encoding: br, gzip\r\n");
  EXPECT_TRUE(answer.ends_with("squeezed"));
  EXPECT_NE(answer.find("Content-Encoding: gzip"), std::string::npos);
  EXPECT_NE(answer.find("immutable"), std::string::npos);
}

TEST_F(WebServerTest, what_is_not_in_the_page_is_not_there) {
  for (const char* path :
       {"/nothing", "/../../etc/passwd", "/assets/../../etc/passwd", "//etc/passwd", "/%2e%2e/x"}) {
    EXPECT_TRUE(get(path).starts_with("HTTP/1.1 404")) << path;
  }
}

TEST_F(WebServerTest, other_requests_are_refused_by_name) {
  EXPECT_TRUE(Client(port_)
                  .ask("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n")
                  .starts_with("HTTP/1.1 405"));
  EXPECT_TRUE(Client(port_)
                  .ask("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 99\r\n\r\n")
                  .starts_with("HTTP/1.1 413"));
  EXPECT_TRUE(Client(port_).ask("rubbish\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(
      Client(port_).ask("GET / HTTP/1.1\r\nX: " + std::string(20000, 'x')).starts_with("HTTP/1.1 431"));
}

TEST_F(NoPageTest, says_how_to_build_the_page_when_there_is_none) {
  const std::string answer = get("/");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 503"));
  EXPECT_NE(answer.find("npm run build"), std::string::npos);
}

TEST_F(WebServerTest, a_viewer_gets_the_scene_and_then_packets_that_make_the_world) {
  Client viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  const std::string scene = viewer.message();
  ASSERT_FALSE(scene.empty());
  EXPECT_EQ(scene[0], 1);
  EXPECT_NE(scene.find("\"name\":\"small\""), std::string::npos);
  const SmallWorld start(3);
  const replicate::Layout layout(start.world);
  replicate::Replica replica(layout);
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    const std::string packet = viewer.message(turning());
    ASSERT_FALSE(packet.empty());
    EXPECT_EQ(packet[0], 2);
    const Result<std::uint32_t> applied =
        apply_packet(std::as_bytes(std::span(packet).subspan(1)), layout, replica);
    ASSERT_TRUE(applied.ok()) << applied.error().text;
    EXPECT_EQ(*applied, frame);
    viewer.send_text("{\"do\":\"ack\",\"frame\":" + std::to_string(frame) + "}");
  }
  EXPECT_GT(replica.tick, 0u);
}

TEST_F(WebServerTest, commands_reach_the_simulation) {
  Client viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.send_text(R"({"do":"pause"})");
  viewer.send_text(R"({"do":"step"})");
  viewer.send_text(R"({"do":"speed","times_real_time":2.5})");
  viewer.send_text(R"({"do":"resume"})");
  EXPECT_TRUE(turn_until([this] { return notes_.all() == "pause;step;speed 2.5;resume;"; })) << notes_.all();
}

TEST_F(WebServerTest, a_robot_is_dragged_and_a_wall_is_not) {
  Client viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(R"({"do":"drag","model":1,"x":40,"y":50,"a":1})");
  EXPECT_TRUE(turn_until([this] { return std::abs(small_.world.models.X_PM[1].x - 40) < 5; }));
  viewer.send_text(R"({"do":"drag","model":0,"x":40,"y":50,"a":1})");
  std::string text;
  while (!(text = viewer.message(turning())).empty() && text[0] != 1) {
  }
  EXPECT_NE(text.find("may not be moved"), std::string::npos);
  EXPECT_EQ(small_.world.models.X_PM[0].x, 0);
}

TEST_F(WebServerTest, the_sensors_of_a_selected_robot_measure_until_its_viewer_leaves) {
  const auto subscribers = [this] { return small_.world.models.subscribers[SmallWorld::robot(1) + 1]; };
  {
    Client viewer(port_);
    ASSERT_TRUE(viewer.upgrade());
    viewer.send_text("{\"do\":\"select\",\"model\":" + std::to_string(SmallWorld::robot(1)) + "}");
    EXPECT_TRUE(turn_until([&] { return subscribers() == 1; }));
    EXPECT_EQ(small_.world.models.subscribers[SmallWorld::robot(1)], 0u) << "its wheels are not touched";
    EXPECT_EQ(small_.world.models.subscribers[SmallWorld::robot(0) + 1], 0u);
  }
  EXPECT_TRUE(turn_until([&] { return subscribers() == 0; }));
}

TEST_F(WebServerTest, pages_of_other_sites_are_refused) {
  EXPECT_TRUE(Client(port_).upgrade("Origin: http://localhost:5173\r\n"));
  EXPECT_TRUE(Client(port_).upgrade("Origin: http://127.0.0.1\r\n"));
  EXPECT_FALSE(Client(port_).upgrade("Origin: http://elsewhere.example\r\n"));
  EXPECT_FALSE(Client(port_).upgrade("Origin: null\r\n"));
  EXPECT_FALSE(Client(port_).upgrade("Origin: http://localhost.elsewhere.example\r\n"));
  EXPECT_FALSE(Client(port_).upgrade_at("192.168.7.5:8080", "http://192.168.7.6:8080"));
}

TEST_F(WebServerTest, a_page_is_known_by_its_address_or_the_name_of_the_machine) {
  EXPECT_TRUE(Client(port_).upgrade_at("192.168.7.5:8080", "http://192.168.7.5:8080"));
  EXPECT_TRUE(Client(port_).upgrade_at("[fd00::5]:8080", "http://[fd00::5]:8080"));
  for (const std::string host : {"robo", "robo:8080", "robo.local:8080", "robo.lab.example:8080"})
    EXPECT_TRUE(Client(port_).upgrade_at(host, "http://" + host)) << host;
}

TEST_F(WebServerTest, a_name_that_was_made_to_point_here_is_refused) {
  for (const std::string host :
       {"elsewhere.example", "elsewhere.example:8080", "192.168.7.5.elsewhere.example",
        "[fd00::5].elsewhere.example", "robo.elsewhere.example", "robots", ""})
    EXPECT_FALSE(Client(port_).upgrade_at(host, "http://" + host)) << host;
}

class WideOpenTest : public WebServerTest {
 protected:
  WideOpenTest() : WebServerTest(kPage, "0.0.0.0") {}
};

TEST_F(WideOpenTest, a_name_that_was_made_to_point_here_is_refused) {
  EXPECT_FALSE(Client(port_).upgrade_at("elsewhere.example:8080", "http://elsewhere.example:8080"));
  EXPECT_TRUE(Client(port_).upgrade_at("192.168.7.5:8080", "http://192.168.7.5:8080"));
  EXPECT_TRUE(Client(port_).upgrade_at("Robo:8080", "http://Robo:8080"));
  EXPECT_TRUE(Client(port_).upgrade()) << "no browser, no origin";
}

TEST_F(WebServerTest, a_viewer_over_the_limit_is_refused_until_another_leaves) {
  std::vector<std::unique_ptr<Client>> viewers;
  for (std::size_t k = 0; k < limits::kViewers; ++k) {
    viewers.push_back(std::make_unique<Client>(port_));
    ASSERT_TRUE(viewers.back()->upgrade());
  }
  Client late(port_);
  EXPECT_FALSE(late.upgrade());
  EXPECT_TRUE(late.ended() || late.in.find("as many viewers") != std::string::npos);
  viewers.pop_back();
  EXPECT_TRUE(turn_until([this] { return Client(port_).upgrade(); }));
}

TEST_F(WebServerTest, viewers_who_come_all_at_once_are_no_more_than_the_limit) {
  constexpr std::size_t kCrowd = limits::kViewers + 20;
  std::promise<void> all_have_asked;
  loop_.post([asked = all_have_asked.get_future().share()] { asked.wait(); });
  std::vector<std::unique_ptr<Client>> crowd;
  for (std::size_t k = 0; k < kCrowd; ++k) {
    crowd.push_back(std::make_unique<Client>(port_));
    crowd.back()->ask_to_upgrade();
  }
  all_have_asked.set_value();
  std::size_t watching = 0;
  for (const auto& viewer : crowd) watching += viewer->upgraded() && viewer->message()[0] == 1;
  EXPECT_EQ(watching, limits::kViewers);
}

TEST_F(WebServerTest, a_viewer_that_does_not_acknowledge_gets_four_packets_and_others_go_on) {
  Client silent(port_), keen(port_);
  ASSERT_TRUE(silent.upgrade());
  ASSERT_TRUE(keen.upgrade());
  keen.message();
  for (int frame = 1; frame <= 8; ++frame) {
    ASSERT_FALSE(keen.message(turning()).empty());
    keen.send_text("{\"do\":\"ack\",\"frame\":" + std::to_string(frame) + "}");
  }
  EXPECT_EQ(silent.message()[0], 1);
  for (std::uint32_t frame = 1; frame <= limits::kViewerFramesInFlight; ++frame) {
    EXPECT_EQ(silent.message()[0], 2);
  }
  EXPECT_TRUE(silent.in.empty());
}

TEST_F(WebServerTest, commands_that_cannot_be_are_told_and_then_end_the_connection) {
  Client viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  for (std::size_t k = 0; k < limits::kViewerFaults; ++k) viewer.send_text(R"({"do":"pasue"})");
  const std::string notice = viewer.message();
  EXPECT_NE(notice.find("did you mean"), std::string::npos);
  std::string last = notice;
  while (!last.empty() && last[0] != 8) last = viewer.message();
  EXPECT_NE(last.find("too many commands"), std::string::npos);
}

TEST_F(WebServerTest, a_message_over_the_limit_ends_the_connection) {
  Client viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(std::string(limits::kViewerCommandBytes + 1, ' '));
  while (!viewer.message(turning()).empty()) {
  }
  EXPECT_TRUE(viewer.ended());
}

}  // namespace
}  // namespace playhouse::web_server
