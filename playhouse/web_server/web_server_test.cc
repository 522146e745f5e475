#include "playhouse/web_server/web_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <future>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/testing/wait.h"
#include "playhouse/net/http.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/simulated.h"
#include "playhouse/net/testing/web_client.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/world/population/population.h"

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
  std::string why_fixed() const override { return fixed; }
  void pause() override { note("pause"); }
  void resume() override { note("resume"); }
  void step_once() override { note("step"); }
  void set_speed(double speed) override { note("speed " + std::to_string(speed).substr(0, 3)); }
  void drive(world::ModelId robot, const geom::Twist& velocity) override {
    post([=](world::Journal& journal) { journal.apply(world::changes::Drive{robot, velocity}); });
  }
  void record(bool on) override { recording = on; }
  void rewind(std::uint64_t tick) override { note("rewind " + std::to_string(tick)); }
  std::shared_ptr<const world::Timeline> timeline() const override {
    const std::lock_guard lock(mutex_);
    return timeline_;
  }
  void set_past(world::Timeline timeline) {
    const std::lock_guard lock(mutex_);
    timeline_ = std::make_shared<const world::Timeline>(std::move(timeline));
  }
  std::uint64_t generation(world::ModelId) const override { return 0; }
  void reserve(world::ModelId model, bool on) override {
    const std::lock_guard lock(mutex_);
    on ? static_cast<void>(reserved_.insert(model)) : static_cast<void>(reserved_.erase(model));
  }
  bool is_reserved(world::ModelId model) {
    const std::lock_guard lock(mutex_);
    return reserved_.contains(model);
  }
  bool post(std::function<void(world::Journal&)> change, world::ModelId = {}) override {
    const std::lock_guard lock(mutex_);
    if (full_) {
      ++refused_;
      return false;
    }
    changes_.push_back(std::move(change));
    return true;
  }
  /// Refuses what is posted from now on, or takes it again.
  void set_full(bool full) {
    const std::lock_guard lock(mutex_);
    full_ = full;
  }
  int refused() {
    const std::lock_guard lock(mutex_);
    return refused_;
  }
  void carry_out(world::World& world) {
    std::vector<std::function<void(world::Journal&)>> changes;
    {
      const std::lock_guard lock(mutex_);
      changes.swap(changes_);
    }
    world::Journal journal(world);
    for (const auto& change : changes) change(journal);
  }
  std::size_t posted() {
    const std::lock_guard lock(mutex_);
    return changes_.size();
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

 public:
  std::atomic<bool> recording = false;
  std::string fixed;  // why nobody may change the world; before anybody comes

 private:
  mutable std::mutex mutex_;
  std::string all_;
  std::shared_ptr<const world::Timeline> timeline_ = std::make_shared<const world::Timeline>();
  std::vector<std::function<void(world::Journal&)>> changes_;
  std::set<world::ModelId> reserved_;
  bool full_ = false;
  int refused_ = 0;
};

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A page: what it is told of who watches is kept apart.
class WebClient : public net::WebClient {
 public:
  using net::WebClient::WebClient;
  std::string message(const std::function<void()>& meanwhile = [] {}) {
    for (;;) {
      std::string message = net::WebClient::message(meanwhile);
      if (message.find("{\"people\":") == std::string::npos) return message;
      people_ = std::move(message);
    }
  }
  const std::string& people() const { return people_; }

 private:
  std::string people_;
};

class WebServerTest : public testing::Test {
 protected:
  explicit WebServerTest(
      const std::function<void(WebOptions&)>& change = [](WebOptions&) {}, int people = 0)
      : small_(3, 0, people),
        feed_(
            small_.world,
            [](world::ModelId model) {
              return model == SmallWorld::id(0) ? std::vector<std::string>{"position2d:0"}
                                                : std::vector<std::string>();
            },
            [this] { return loop_.now(); }),
        server_(loop_, options(change), notes_, small_.world, feed_) {
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
    return get_of("127.0.0.1", path, more);
  }
  std::string get_of(const std::string& host, const std::string& path, const std::string& more = "") {
    return WebClient(port_).ask("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n" +
                                more + "\r\n");
  }

  /// One turn of the program: what viewers asked for, a tick, and a picture of it.
  void turn() {
    notes_.carry_out(small_.world);
    small_.tick();
    if (feed_.wants_show()) feed_.show(small_.world, {});
  }
  std::function<void()> turning() {
    return [this] { turn(); };
  }
  /// As the io thread has it.
  WebStatus status() {
    std::promise<WebStatus> status;
    loop_.post([&] { status.set_value(server_.status()); });
    return status.get_future().get();
  }
  bool turn_until(const std::function<bool()>& done) {
    return wait_until([&] {
      if (done()) return true;
      turn();
      return done();
    });
  }

  SmallWorld small_;
  Notes notes_;
  net::IoLoop loop_;
  replicate::SnapshotFeed feed_;
  WebServer server_;  // what a slow machine could cross waits an hour: who is to see its end changes it
  std::uint16_t port_ = 0;
  std::thread io_;

 private:
  WebOptions options(const std::function<void(WebOptions&)>& change) {
    WebOptions options{.port = 0,
                       .page = kPage,
                       .host_name = "robo.lab.example",
                       .viewer_quiet = 3600,
                       .join_period = 3600,
                       .physics_shapes = [this] {
                         world::PhysicsShapes shapes;
                         shapes.bodies = {{small_.world.id({SmallWorld::robot(1)}), {}}};
                         return shapes;
                       }};
    change(options);
    return options;
  }
};

class NoPageTest : public WebServerTest {
 protected:
  NoPageTest() : WebServerTest([](WebOptions& options) { options.page = {}; }) {}
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

TEST_F(WebServerTest, the_page_is_shown_in_no_frame_and_loads_its_own_files_alone) {
  for (const char* path : {"/", "/assets/main-1.js", "/nothing"}) {
    const std::string answer = get(path);
    EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'; ")) << path;
    EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'\r\n")) << path;
    EXPECT_THAT(answer, HasSubstr("X-Frame-Options: DENY\r\n")) << path;
    EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff\r\n")) << path;
    EXPECT_THAT(answer, HasSubstr("Cross-Origin-Resource-Policy: same-origin\r\n")) << path;
  }
  EXPECT_THAT(get("/"), HasSubstr("script-src 'self'; "));
  EXPECT_THAT(get("/"), Not(HasSubstr("unsafe")));
}

TEST_F(WebServerTest, serves_the_compressed_form_to_who_takes_it) {
  EXPECT_TRUE(get("/assets/main-1.js").ends_with("let x = 1"));
  const std::string answer = get("/assets/main-1.js", "Accept-Encoding: br, gzip\r\n");
  EXPECT_TRUE(answer.ends_with("squeezed"));
  EXPECT_NE(answer.find("Content-Encoding: gzip"), std::string::npos);
  EXPECT_NE(answer.find("immutable"), std::string::npos);
  EXPECT_THAT(answer, HasSubstr("Vary: Accept-Encoding\r\n"));
  EXPECT_TRUE(get("/assets/main-1.js", "Accept-Encoding: gzip;q=0.5\r\n").ends_with("squeezed"));
  EXPECT_TRUE(get("/assets/main-1.js", "Accept-Encoding: gzip;q=0, br\r\n").ends_with("let x = 1"));
}

TEST_F(WebServerTest, what_is_not_in_the_page_is_not_there) {
  for (const char* path :
       {"/nothing", "/../../etc/passwd", "/assets/../../etc/passwd", "//etc/passwd", "/%2e%2e/x"}) {
    EXPECT_TRUE(get(path).starts_with("HTTP/1.1 404")) << path;
  }
}

TEST_F(WebServerTest, other_requests_are_refused_by_name) {
  EXPECT_TRUE(WebClient(port_)
                  .ask("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n")
                  .starts_with("HTTP/1.1 405"));
  EXPECT_TRUE(WebClient(port_)
                  .ask("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 99\r\n\r\n")
                  .starts_with("HTTP/1.1 413"));
  EXPECT_TRUE(WebClient(port_).ask("rubbish\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(
      WebClient(port_).ask("GET / HTTP/1.1\r\nX: " + std::string(20000, 'x')).starts_with("HTTP/1.1 431"));
}

TEST_F(NoPageTest, says_how_to_build_the_page_when_there_is_none) {
  const std::string answer = get("/");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 503"));
  EXPECT_NE(answer.find("npm run build"), std::string::npos);
}

TEST_F(WebServerTest, a_viewer_gets_the_scene_and_then_packets_that_make_the_world) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  const std::string scene = viewer.message();
  ASSERT_FALSE(scene.empty());
  EXPECT_EQ(scene[0], 1);
  EXPECT_NE(scene.find("\"name\":\"small\""), std::string::npos);
  EXPECT_NE(scene.find("\"devices\":[\"position2d:0\"]"), std::string::npos);
  const SmallWorld start(3);
  replicate::Replica replica(start.layout());
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    const std::string packet = viewer.message(turning());
    ASSERT_FALSE(packet.empty());
    EXPECT_EQ(packet[0], 2);
    const Result<std::uint32_t> applied = apply_packet(std::as_bytes(std::span(packet).subspan(1)), replica);
    ASSERT_TRUE(applied.ok()) << applied.error().text;
    EXPECT_EQ(*applied, frame);
    viewer.send_text("{\"do\":\"ack\",\"frame\":" + std::to_string(frame) + "}");
  }
  EXPECT_GT(replica.tick, 0u);
}

/// The next text message, as a page reads it; "" at the end. Packets before it are acknowledged.
std::string next_text(WebClient& viewer, const std::function<void()>& turning) {
  for (;;) {
    std::string message = viewer.message(turning);
    if (message.empty() || message[0] == 1) return message;
    const int frame = message[3];  // after the opcode, the version and the flags; below 128 here
    viewer.send_text("{\"do\":\"ack\",\"frame\":" + std::to_string(frame) + "}");
  }
}

TEST_F(WebServerTest, commands_reach_the_simulation) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.send_text(R"({"do":"pause"})");
  viewer.send_text(R"({"do":"step"})");
  viewer.send_text(R"({"do":"speed","times_real_time":2.5})");
  viewer.send_text(R"({"do":"resume"})");
  EXPECT_TRUE(turn_until([this] { return notes_.all() == "pause;step;speed 2.5;resume;"; })) << notes_.all();
}

TEST_F(WebServerTest, viewers_hear_which_instants_there_are_and_go_back_to_them) {
  EXPECT_FALSE(notes_.recording);
  {
    WebClient viewer(port_);
    ASSERT_TRUE(viewer.upgrade());
    EXPECT_THAT(viewer.message(), HasSubstr(R"("name":"small")"));
    EXPECT_TRUE(notes_.recording);
    viewer.send_text(R"({"do":"rewind","tick":20})");
    EXPECT_THAT(next_text(viewer, turning()), HasSubstr("no moment of this run is kept yet"));
    notes_.set_past({{5, 10, 20, 30, 37}, ""});
    EXPECT_THAT(next_text(viewer, turning()),
                EndsWith("{\"history\":{\"first\":5,\"steps\":[[5,1],[10,2],[7,1]]}}\n"));
    viewer.send_text(R"({"do":"rewind","tick":20})");
    EXPECT_TRUE(turn_until([this] { return notes_.all() == "rewind 20;"; })) << notes_.all();
    WebClient other(port_);
    ASSERT_TRUE(other.upgrade());
    other.message();
    EXPECT_THAT(next_text(other, turning()), HasSubstr(R"("first":5,)"));
  }
  EXPECT_TRUE(turn_until([this] { return !notes_.recording; })) << "nobody watches any more";
}

TEST_F(WebServerTest, viewers_hear_why_a_run_cannot_go_back) {
  notes_.set_past({{}, "controller shy cannot be saved"});
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  EXPECT_THAT(next_text(viewer, turning()),
              EndsWith("{\"history\":{\"none\":\"controller shy cannot be saved\"}}\n"));
  viewer.send_text(R"({"do":"rewind","tick":20})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("cannot go back: controller shy cannot be saved"));
  EXPECT_EQ(notes_.all(), "");
}

TEST_F(WebServerTest, a_flood_of_commands_waits_for_its_turns_and_nobody_else_does) {
  WebClient flooder(port_), other(port_);
  ASSERT_TRUE(flooder.upgrade());
  ASSERT_TRUE(other.upgrade());
  for (int k = 1; k <= 1000; ++k)
    flooder.send_text(R"({"do":"drag","model":1,"y":50,"a":1,"x":)" + std::to_string(k) + "}");
  ASSERT_TRUE(wait_until([this] { return notes_.posted() == limits::kViewerCommandsPerTurn; }))
      << notes_.posted();
  other.send_text(R"({"do":"pause"})");
  ASSERT_TRUE(wait_until([this] { return notes_.all() == "pause;"; }));
  EXPECT_EQ(notes_.posted(), limits::kViewerCommandsPerTurn)
      << "the rest is with the system until the next turn";
  std::size_t most = 0;
  EXPECT_TRUE(turn_until([&] {
    most = std::max(most, notes_.posted());
    return std::abs(small_.world.models.X_PM[{1}].x - 1000) < 5;
  })) << "nothing is lost";
  EXPECT_LE(most, limits::kViewerCommandsPerTurn);
}

TEST_F(WebServerTest, a_robot_is_dragged_and_a_wall_is_not) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(R"({"do":"drag","model":1,"x":40,"y":50,"a":1})");
  EXPECT_TRUE(turn_until([this] { return std::abs(small_.world.models.X_PM[{1}].x - 40) < 5; }));
  viewer.send_text(R"({"do":"drag","model":0,"x":40,"y":50,"a":1})");
  std::string text;
  while (!(text = viewer.message(turning())).empty() && text[0] != 1) {
  }
  EXPECT_NE(text.find("may not be moved"), std::string::npos);
  EXPECT_EQ(small_.world.models.X_PM[{0}].x, 0);
}

TEST_F(WebServerTest, robots_are_added_copied_and_removed_and_viewers_follow) {
  WebClient viewer(port_), other(port_);
  ASSERT_TRUE(viewer.upgrade());
  ASSERT_TRUE(other.upgrade());
  EXPECT_THAT(viewer.message(), HasSubstr(R"("addable":["r0","puck"])"));
  EXPECT_THAT(other.message(), HasSubstr(R"("name":"small")"));
  viewer.send_text(R"({"do":"add","robot":0,"x":3,"y":-4,"a":0})");
  for (WebClient* each : {&viewer, &other})
    EXPECT_THAT(next_text(*each, turning()),
                AllOf(HasSubstr(R"({"gone":[],)"), HasSubstr(R"({"id":14,)"), HasSubstr(R"("name":"r0~2")"),
                      HasSubstr(R"({"id":15,)"), HasSubstr(R"("parent":14,)")));
  world::set_fiducial_return(small_.world, {14}, 77);
  viewer.send_text(R"({"do":"copy","model":15,"x":5,"y":5,"a":1})");
  EXPECT_THAT(next_text(viewer, turning()), AllOf(HasSubstr(R"({"id":18,)"), HasSubstr(R"("name":"r0~3")")));
  EXPECT_EQ(small_.world.models.fiducial_return[{18}], 77);
  viewer.send_text(R"({"do":"remove","model":2})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr(R"({"gone":[1,2,3,4],)"));
  EXPECT_EQ(small_.world.models.size(), 18u);
  viewer.send_text(R"({"do":"drag","model":1,"x":5,"y":5,"a":1})");
  viewer.send_text(R"({"do":"remove","model":1})");
  viewer.send_text(R"({"do":"remove","model":18})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr(R"({"gone":[18,19,20,21],)"));
  viewer.send_text(R"({"do":"copy","model":18,"x":5,"y":5,"a":1})");
  viewer.send_text(R"({"do":"remove","model":0})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("may not be removed"))
      << "who has gone is nobody's fault";
  viewer.send_text(R"({"do":"copy","model":999,"x":5,"y":5,"a":1})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("no such model"));
  viewer.send_text(R"({"do":"add","robot":7,"x":3,"y":-4,"a":0})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("no such robot to add"));
}

TEST_F(WebServerTest, nobody_joins_a_world_without_people_or_speaks_without_a_body) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(R"({"do":"join","name":"Ada","x":0,"y":0,"a":0})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("nobody can join this world"));
  viewer.send_text(R"({"do":"say","text":"hello"})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("only who has joined"));
}

TEST_F(WebServerTest, a_copy_has_the_color_that_the_original_has_now) {
  constexpr scene::Color kGreen{0, 1, 0, 1};
  const world::ModelRow puck = small_.world.find("puck");  // ticks of this world paint robots
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  world::set_color(small_.world, puck, kGreen);
  viewer.send_text(R"({"do":"copy","model":)" + std::to_string(small_.world.id(puck).value) +
                   R"(,"x":5,"y":5,"a":1})");
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr(R"("name":"puck~2")"));
  const world::ModelRow copy = small_.world.find("puck~2");
  ASSERT_TRUE(copy);
  EXPECT_EQ(small_.world.models.color[copy], kGreen);
}

TEST_F(WebServerTest, a_viewer_gets_the_world_as_it_stands_as_a_file) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  ASSERT_TRUE(world::spawn(small_.world, SmallWorld::robot(1), {7, 8, 0, 0}, "newcomer").ok());
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr("newcomer"));
  viewer.send_text(R"({"do":"save"})");
  viewer.send_text(R"({"do":"save"})");
  EXPECT_THAT(next_text(viewer, [] {}), HasSubstr("the world is on its way already")) << "no tick came yet";
  EXPECT_THAT(next_text(viewer, turning()),
              AllOf(HasSubstr(R"({"world":{"file":")"), HasSubstr(R"(.world","text":"# As it stood at )"),
                    HasSubstr(R"(name \"newcomer\" pose [)")));
  EXPECT_TRUE(turn_until([&] {
    viewer.send_text(R"({"do":"save"})");
    return next_text(viewer, turning()).find(R"({"world":)") != std::string::npos;
  })) << "once it is there, it can be had again";
}

TEST_F(WebServerTest, who_comes_next_gets_no_answer_to_one_who_left) {
  {
    WebClient early(port_);
    ASSERT_TRUE(early.upgrade());
    early.message();
    early.send_text(R"({"do":"save"})");
    ASSERT_TRUE(wait_until([this] { return notes_.posted() > 0; }));
  }
  ASSERT_TRUE(wait_until([this] { return status().viewers == 0; }));
  WebClient late(port_);  // often where the other was in memory
  ASSERT_TRUE(late.upgrade());
  late.message();
  turn();
  ASSERT_TRUE(world::spawn(small_.world, SmallWorld::robot(1), {7, 8, 0, 0}, "newcomer").ok());
  EXPECT_THAT(next_text(late, turning()), HasSubstr("newcomer"));
}

TEST_F(WebServerTest, a_viewer_that_comes_later_gets_the_population_of_then) {
  WebClient early(port_);
  ASSERT_TRUE(early.upgrade());
  early.message();
  ASSERT_TRUE(world::despawn(small_.world, SmallWorld::id(1)).ok());
  EXPECT_THAT(next_text(early, turning()), HasSubstr(R"({"gone":[5,6,7,8],)"));
  WebClient late(port_);
  ASSERT_TRUE(late.upgrade());
  const std::string scene = late.message();
  EXPECT_THAT(scene, Not(HasSubstr(R"("name":"r1")")));
  EXPECT_THAT(scene, HasSubstr(R"("name":"r2")"));
  EXPECT_EQ(late.message(turning())[0], 2);
}

TEST_F(WebServerTest, a_viewer_that_comes_later_reads_what_was_said_before) {
  WebClient early(port_);
  ASSERT_TRUE(early.upgrade());
  early.message();
  world::set_say(small_.world, {SmallWorld::robot(0)}, "good morning");
  turn();
  EXPECT_EQ(early.message(turning())[0], 2);  // a picture, so that the server knows
  WebClient late(port_);
  ASSERT_TRUE(late.upgrade());
  late.message();
  EXPECT_THAT(late.message(), AllOf(HasSubstr(R"({"said":[{"tick":)"),
                                    HasSubstr(R"("model":1,"name":"r0","text":"good morning"}])")));
}

TEST_F(WebServerTest, a_selected_robot_that_goes_is_forgotten_and_its_successor_is_not_taken_for_it) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(R"({"do":"select","model":1})");
  ASSERT_TRUE(turn_until([&] { return small_.world.models.subscribers[{2}] == 1; }));
  ASSERT_TRUE(world::despawn(small_.world, SmallWorld::id(0)).ok());
  EXPECT_THAT(next_text(viewer, turning()), HasSubstr(R"({"gone":[1,2,3,4],)"));
  viewer.send_text(R"({"do":"select","model":5})");
  ASSERT_TRUE(turn_until([&] { return small_.world.models.subscribers[{2}] == 1; }));
  viewer.send_text(R"({"do":"select","model":null})");
  EXPECT_TRUE(turn_until([&] { return small_.world.models.subscribers[{2}] == 0; }));
}

TEST_F(WebServerTest, a_robot_is_driven_until_its_viewer_leaves) {
  const auto wheels = [this] { return small_.world.models.subscribers[{SmallWorld::robot(1)}]; };
  {
    WebClient viewer(port_);
    ASSERT_TRUE(viewer.upgrade());
    viewer.send_text("{\"do\":\"drive\",\"model\":" + std::to_string(SmallWorld::robot(1)) +
                     ",\"forward\":0.4,\"sideways\":0,\"turn\":-0.5}");
    EXPECT_TRUE(turn_until([&] { return small_.world.positions.command[{1}].a == -0.5; }));
    EXPECT_EQ(small_.world.positions.command[{1}].x, 0.4);
    EXPECT_EQ(wheels(), 1u);
  }
  EXPECT_TRUE(turn_until([&] { return wheels() == 0; }));
  EXPECT_EQ(small_.world.positions.command[{1}], geom::Twist{});
}

TEST_F(WebServerTest, who_numbers_a_command_is_told_from_which_tick_on_it_counts) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.send_text("{\"do\":\"drive\",\"model\":" + std::to_string(SmallWorld::robot(1)) +
                   ",\"forward\":0.4,\"sideways\":0,\"turn\":0,\"input\":77}");
  // To open the wheels, to turn them and to tell: all of them before the next tick.
  ASSERT_TRUE(wait_until([&] { return notes_.posted() == 3; })) << notes_.posted();
  small_.world.tick_ = 4711;
  std::string text;
  do {
    text = next_text(viewer, turning());
  } while (!text.empty() && text.find("driven") == std::string::npos);
  EXPECT_THAT(text, HasSubstr("{\"driven\":{\"input\":77,\"tick\":4711}}"));
  EXPECT_EQ(small_.world.positions.command[{1}].x, 0.4) << "and it has been carried out by then";
}

TEST_F(WebServerTest, what_physics_takes_bodies_for_is_told_on_demand_as_often_as_it_is_asked_for) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  for (int k = 0; k < 3; ++k) {
    viewer.send_text(R"({"do":"physics"})");
    std::string text;
    do {
      text = next_text(viewer, turning());
    } while (!text.empty() && text.find("physics") == std::string::npos);
    EXPECT_THAT(text, HasSubstr("{\"physics\":{\"fixed\":[],\n\"bodies\":[{\"model\":5,\"solids\":[]}]}}"));
  }
}

TEST_F(WebServerTest, a_full_queue_refuses_to_tell_of_physics_and_does_the_next_time) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  const auto answer = [&] {
    viewer.send_text(R"({"do":"physics"})");
    std::string text;
    do {
      text = next_text(viewer, turning());
    } while (text.find("physics") == std::string::npos && text.find("notice") == std::string::npos);
    return text;
  };
  notes_.set_full(true);
  EXPECT_THAT(answer(), HasSubstr("too busy"));
  notes_.set_full(false);
  EXPECT_THAT(answer(), HasSubstr("\"physics\":{"));
}

TEST_F(WebServerTest, a_wall_is_not_driven) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(R"({"do":"drive","model":0,"forward":1,"sideways":0,"turn":0})");
  std::string text;
  while (!(text = viewer.message(turning())).empty() && text[0] != 1) {
  }
  EXPECT_NE(text.find("no such robot to drive"), std::string::npos);
}

TEST_F(WebServerTest, the_sensors_of_a_selected_robot_measure_until_its_viewer_leaves) {
  const auto subscribers = [this] { return small_.world.models.subscribers[{SmallWorld::robot(1) + 1}]; };
  {
    WebClient viewer(port_);
    ASSERT_TRUE(viewer.upgrade());
    viewer.send_text("{\"do\":\"select\",\"model\":" + std::to_string(SmallWorld::robot(1)) + "}");
    EXPECT_TRUE(turn_until([&] { return subscribers() == 1; }));
    EXPECT_FALSE(world::is_used(small_.world, {SmallWorld::robot(1) + 1})) << "looking is no use";
    EXPECT_EQ(small_.world.models.subscribers[{SmallWorld::robot(1)}], 0u) << "its wheels are not touched";
    EXPECT_EQ(small_.world.models.subscribers[{SmallWorld::robot(0) + 1}], 0u);
  }
  EXPECT_TRUE(turn_until([&] { return subscribers() == 0; }));
}

TEST_F(WebServerTest, a_full_queue_does_not_leave_sensors_on_although_nobody_watches_any_more) {
  const auto subscribers = [this] { return small_.world.models.subscribers[{SmallWorld::robot(1) + 1}]; };
  {
    WebClient viewer(port_);
    ASSERT_TRUE(viewer.upgrade());
    viewer.send_text("{\"do\":\"select\",\"model\":" + std::to_string(SmallWorld::robot(1)) + "}");
    ASSERT_TRUE(turn_until([&] { return subscribers() == 1; }));
    notes_.set_full(true);
  }
  EXPECT_TRUE(wait_until([this] { return notes_.refused() > 0; }));
  notes_.set_full(false);
  EXPECT_TRUE(turn_until([&] { return subscribers() == 0; }));
}

TEST_F(WebServerTest, pages_of_other_sites_are_refused) {
  const auto upgrades = [this](const std::string& origin, const std::string& host = "127.0.0.1:8080") {
    return WebClient(port_).upgrade_at(host, origin);
  };
  EXPECT_TRUE(upgrades("http://127.0.0.1:8080"));
  EXPECT_TRUE(upgrades("http://localhost:5173", "localhost:5173")) << "what `npm run dev` passes on";
  EXPECT_TRUE(upgrades("http://[::1]:8080", "[::1]:8080"));
  for (const char* origin :
       {"http://127.0.0.1:3000", "http://127.0.0.1", "http://localhost:8080", "https://127.0.0.1:8080",
        "127.0.0.1:8080", "ws://127.0.0.1:8080", "http://127.0.0.1:8080/", "http://127.0.0.1:80800",
        "http://elsewhere.example", "null", "file://", "http://127.0.0.1:8080.elsewhere.example", "http://"})
    EXPECT_FALSE(upgrades(origin)) << origin;
  EXPECT_FALSE(upgrades("http://localhost:3000", "localhost:8080"))
      << "a port of this machine may be anybody's";
  EXPECT_FALSE(upgrades("http://192.168.7.6:8080", "192.168.7.5:8080"));
}

TEST_F(WebServerTest, the_page_is_known_by_its_address_or_the_name_of_the_machine) {
  for (const std::string host : {"localhost", "localhost:8080", "192.168.7.5:8080", "[fd00::5]:8080", "robo",
                                 "robo:8080", "Robo:8080", "robo.local:8080", "robo.lab.example:8080"}) {
    EXPECT_TRUE(WebClient(port_).upgrade_at(host, "http://" + host)) << host;
    EXPECT_THAT(get_of(host, "/"), StartsWith("HTTP/1.1 200")) << host;
  }
}

TEST_F(WebServerTest, a_name_that_was_made_to_point_here_is_refused) {
  for (const std::string host :
       {"elsewhere.example", "elsewhere.example:8080", "192.168.7.5.elsewhere.example",
        "robo.elsewhere.example", "robots", "localhost.elsewhere.example", "1.2.3"}) {
    EXPECT_FALSE(WebClient(port_).upgrade_at(host, "http://" + host)) << host;
    const std::string answer = get_of(host, "/");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 421")) << host;
    EXPECT_THAT(answer, HasSubstr("by its address or as robo.lab.example"));
    EXPECT_THAT(answer, Not(HasSubstr("the page"))) << host;
  }
}

class WideOpenTest : public WebServerTest {
 protected:
  WideOpenTest() : WebServerTest([](WebOptions& options) { options.bind = "0.0.0.0"; }) {}
};

TEST_F(WideOpenTest, a_name_that_was_made_to_point_here_is_refused) {
  EXPECT_FALSE(WebClient(port_).upgrade_at("elsewhere.example:8080", "http://elsewhere.example:8080"));
  EXPECT_TRUE(WebClient(port_).upgrade_at("192.168.7.5:8080", "http://192.168.7.5:8080"));
  EXPECT_TRUE(WebClient(port_).upgrade()) << "no browser, no origin";
}

class NamedTest : public WebServerTest {
 protected:
  NamedTest() : WebServerTest([](WebOptions& options) { options.further_names = {"robots.example"}; }) {}
};

TEST_F(NamedTest, a_name_it_was_told_is_its_own_also_behind_a_proxy_that_speaks_tls) {
  EXPECT_THAT(get_of("robots.example", "/"), StartsWith("HTTP/1.1 200"));
  EXPECT_TRUE(WebClient(port_).upgrade_at("robots.example", "https://robots.example"));
  EXPECT_TRUE(WebClient(port_).upgrade_at("Robots.example:8080", "http://Robots.example:8080"));
  EXPECT_FALSE(WebClient(port_).upgrade_at("robots.example", "https://robots.example:444"));
  EXPECT_FALSE(WebClient(port_).upgrade_at("127.0.0.1", "https://127.0.0.1"));
  EXPECT_FALSE(WebClient(port_).upgrade_at("other.robots.example", "http://other.robots.example"));
}

/// The reason why the server closes the connection.
std::string close_reason(WebClient& viewer) {
  std::string last;
  do last = viewer.message();
  while (!last.empty() && last[0] != 8);
  return last;
}

/// As many viewers as there may be.
std::vector<std::unique_ptr<WebClient>> all_viewers(std::uint16_t port) {
  std::vector<std::unique_ptr<WebClient>> viewers;
  for (std::size_t k = 0; k < limits::kViewers; ++k) {
    viewers.push_back(std::make_unique<WebClient>(port));
    EXPECT_TRUE(viewers.back()->upgrade());
    EXPECT_EQ(viewers.back()->message()[0], 1);
  }
  return viewers;
}

TEST_F(WebServerTest, a_viewer_over_the_limit_is_refused_until_another_leaves) {
  auto viewers = all_viewers(port_);
  WebClient late(port_);
  ASSERT_TRUE(late.upgrade());
  EXPECT_THAT(close_reason(late), HasSubstr("as many viewers"));
  viewers.pop_back();
  EXPECT_TRUE(turn_until([this] {
    WebClient next(port_);
    return next.upgrade() && next.message()[0] == 1;
  }));
}

TEST_F(WebServerTest, viewers_of_one_address_do_not_shut_out_another) {
  const auto viewers = all_viewers(port_);
  WebClient late(port_, "127.0.0.2");
  ASSERT_TRUE(late.upgrade());
  EXPECT_EQ(late.message()[0], 1);
  EXPECT_THAT(close_reason(*viewers.front()), HasSubstr("gave way to another viewer"));
  EXPECT_FALSE(viewers.back()->closed());
}

class HastyTest : public WebServerTest {
 protected:
  HastyTest() : WebServerTest([](WebOptions& options) { options.viewer_quiet = 0; }) {}
};

TEST_F(HastyTest, the_viewer_that_was_quiet_longest_gives_way) {
  const auto viewers = all_viewers(port_);
  ASSERT_EQ(viewers.front()->message(turning())[0], 2);
  viewers.front()->send_text(R"({"do":"ack","frame":1})");
  viewers.front()->send_text(R"({"do":"pause"})");
  ASSERT_TRUE(turn_until([this] { return notes_.all() == "pause;"; }));
  WebClient late(port_);
  ASSERT_TRUE(late.upgrade());
  EXPECT_EQ(late.message()[0], 1);
  EXPECT_THAT(close_reason(*viewers[1]), HasSubstr("gave way to another viewer"));
  EXPECT_FALSE(viewers.front()->closed());
}

TEST_F(WebServerTest, a_page_loads_and_watches_whatever_the_number_of_slow_connections) {
  WebClient early(port_);
  ASSERT_TRUE(early.upgrade());
  std::vector<std::unique_ptr<WebClient>> slow;
  for (int k = 0; k < 300; ++k) {
    slow.push_back(std::make_unique<WebClient>(port_));
    if (k % 3 == 0) slow.back()->send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n");
    if (k % 3 == 1) slow.back()->send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
  }
  EXPECT_THAT(get("/"), EndsWith("<p>the page</p>"));
  EXPECT_THAT(get("/assets/main-1.js"), EndsWith("let x = 1"));
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  EXPECT_EQ(viewer.message()[0], 1);
  EXPECT_EQ(early.message()[0], 1);
  EXPECT_EQ(early.message(turning())[0], 2);
}

TEST_F(WebServerTest, viewers_who_come_all_at_once_are_no_more_than_the_limit) {
  constexpr std::size_t kCrowd = limits::kViewers + 20;
  std::promise<void> all_have_asked;
  loop_.post([asked = all_have_asked.get_future().share()] { asked.wait(); });
  std::vector<std::unique_ptr<WebClient>> crowd;
  for (std::size_t k = 0; k < kCrowd; ++k) {
    crowd.push_back(std::make_unique<WebClient>(port_));
    crowd.back()->ask_to_upgrade();
  }
  all_have_asked.set_value();
  std::size_t watching = 0;
  for (const auto& viewer : crowd) watching += viewer->upgraded() && viewer->message()[0] == 1;
  EXPECT_EQ(watching, limits::kViewers);
}

TEST_F(WebServerTest, a_viewer_that_does_not_acknowledge_gets_four_packets_and_others_go_on) {
  WebClient silent(port_), keen(port_);
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

TEST(Budget, a_page_gets_no_more_bytes_a_second) {
  constexpr std::uint32_t kBytes = 500;
  constexpr double kTurn = 0.05, kSeconds = 60;
  SmallWorld small(3);
  Notes notes;
  net::SimulatedNetwork network(1);
  replicate::SnapshotFeed feed(small.world, {}, [&network] { return network.now(); });
  WebServer server(network, {.page = kPage, .host_name = "here", .bytes_per_second = kBytes}, notes,
                   small.world, feed);
  ASSERT_TRUE(server.listen());
  net::SimulatedPage page = network.open_page(8080, {.path = "/live", .host = "here", .peer = "127.0.0.1:1"});
  network.run();
  std::size_t bytes = 0, largest = 0;
  for (double seconds = kTurn; seconds < kSeconds; seconds += kTurn) {
    small.tick();
    if (feed.wants_show()) feed.show(small.world, {});
    network.run_for(kTurn);
    for (const net::SimulatedPage::SocketMessage& message : page.take()) {
      if (message.is_text) continue;
      bytes += message.bytes.size();
      largest = std::max(largest, message.bytes.size());
      page.send("{\"do\":\"ack\",\"frame\":" + std::to_string(server.status().frames_sent) + "}");
    }
    // A burst of 200 bytes, and a packet that exceeds what is left.
    ASSERT_LE(static_cast<double>(bytes), kBytes * seconds + 200 + static_cast<double>(largest)) << seconds;
  }
  EXPECT_EQ(page.closed(), std::nullopt);
  EXPECT_GT(static_cast<double>(bytes), 0.8 * kBytes * kSeconds);
}

TEST_F(WebServerTest, commands_that_cannot_be_carried_out_never_end_the_connection) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  for (std::size_t k = 0; k < 2 * limits::kViewerFaults; ++k) {
    viewer.send_text(R"({"do":"drive","model":0,"forward":1,"sideways":0,"turn":0})");
    EXPECT_THAT(next_text(viewer, turning()), HasSubstr("no such robot to drive"));
  }
}

TEST_F(WebServerTest, commands_that_cannot_be_are_told_and_then_end_the_connection) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  for (std::size_t k = 0; k < limits::kViewerFaults; ++k) viewer.send_text(R"({"do":"pasue"})");
  const std::string notice = viewer.message();
  EXPECT_NE(notice.find("did you mean"), std::string::npos);
  std::string last = notice;
  while (!last.empty() && last[0] != 8) last = viewer.message();
  EXPECT_NE(last.find("too many invalid commands"), std::string::npos);
}

TEST_F(WebServerTest, a_message_over_the_limit_ends_the_connection) {
  WebClient viewer(port_);
  ASSERT_TRUE(viewer.upgrade());
  viewer.message();
  viewer.send_text(std::string(limits::kViewerCommandBytes + 1, ' '));
  while (!viewer.message(turning()).empty()) {
  }
  EXPECT_TRUE(viewer.ended());
}

class GuestsTest : public WebServerTest {
 protected:
  explicit GuestsTest(int people = 0, double join_period = 3600)
      : WebServerTest(
            [join_period](WebOptions& options) {
              options.guests = {{server::GuestRole::kAdmin, "the-admin", "Ada"},
                                {server::GuestRole::kDriver, "a-driver-", ""},
                                {server::GuestRole::kHuman, "somebody-", "Bob"},
                                {server::GuestRole::kObserver, "*", ""}};
              options.viewers = 4;
              options.join_period = join_period;
              options.place_of_body = [](const world::World&, std::uint32_t,
                                         const geom::Pose& X_WM) -> Result<geom::Pose> {
                if (X_WM.x > 100) return Error{"", "it is too far out there"};
                return X_WM.x > 50 ? geom::Pose{40, X_WM.y, X_WM.z, X_WM.a} : X_WM;
              };
            },
            people) {}
  explicit GuestsTest(const std::function<void(WebOptions&)>& change) : WebServerTest(change) {}
  /// The next text with `part` in it: texts about the population come in between, when they are due.
  std::string text_with(WebClient& viewer, const std::string& part) {
    std::string text;
    do text = next_text(viewer, turning());
    while (!text.empty() && text.find(part) == std::string::npos);
    return text;
  }
  /// The notice that a page gets for a command.
  std::string answer(WebClient& viewer, const std::string& command) {
    viewer.send_text(command);
    return text_with(viewer, "notice");
  }
  /// Until the page has heard of who watches what has `part`.
  bool hears(WebClient& viewer, const std::string& part) {
    for (int k = 0; k < 100 && viewer.people().find(part) == std::string::npos; ++k) {
      const std::string packet = viewer.message(turning());
      if (packet.empty()) return false;
      if (packet[0] == 2) viewer.send_text("{\"do\":\"ack\",\"frame\":" + std::to_string(packet[3]) + "}");
    }
    return viewer.people().find(part) != std::string::npos;
  }
};

constexpr const char* kDriveFirst = R"({"do":"drive","model":0,"forward":1,"sideways":0,"turn":0})";

TEST_F(GuestsTest, roles_decide_what_is_carried_out) {
  WebClient admin(port_), driver(port_), human(port_), observer(port_);
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  ASSERT_TRUE(driver.upgrade_with("a-driver-"));
  ASSERT_TRUE(human.upgrade_with("somebody-"));
  ASSERT_TRUE(observer.upgrade());
  admin.send_text(R"({"do":"pause"})");
  EXPECT_TRUE(turn_until([this] { return notes_.all() == "pause;"; }));
  for (WebClient* guest : {&driver, &human, &observer}) {
    guest->message();
    EXPECT_THAT(answer(*guest, R"({"do":"resume"})"), HasSubstr("may not do that"));
  }
  EXPECT_THAT(answer(observer, kDriveFirst), HasSubstr("a guest who is observer may not do that"));
  EXPECT_THAT(answer(human, kDriveFirst), HasSubstr("a guest who is human may not do that"));
  EXPECT_THAT(answer(driver, R"({"do":"say","text":"hi"})"), HasSubstr("a guest who is driver may not"));
  EXPECT_THAT(answer(human, R"({"do":"kick","viewer":1})"), HasSubstr("may not do that"));
  EXPECT_EQ(notes_.all(), "pause;");
  EXPECT_THAT(answer(driver, kDriveFirst), HasSubstr("no such robot to drive")) << "but may drive one";
}

TEST_F(GuestsTest, an_admin_finds_a_place_where_guests_have_all) {
  std::vector<std::unique_ptr<WebClient>> guests;
  for (int k = 0; k < 4; ++k) {
    guests.push_back(std::make_unique<WebClient>(port_));
    ASSERT_TRUE(guests.back()->upgrade_with("somebody-"));
    EXPECT_EQ(guests.back()->message()[0], 1);
  }
  WebClient fifth(port_), admin(port_);
  ASSERT_TRUE(fifth.upgrade_with("somebody-"));
  EXPECT_THAT(close_reason(fifth), HasSubstr("as many viewers"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_EQ(admin.message()[0], 1);
  EXPECT_THAT(close_reason(*guests.front()), HasSubstr("gave way to another viewer"));
}

TEST_F(GuestsTest, everybody_hears_who_is_there_and_what_they_may_do) {
  WebClient human(port_), admin(port_);
  ASSERT_TRUE(human.upgrade_with("somebody-"));
  EXPECT_TRUE(hears(
      human,
      R"({"viewer":1,"role":"human","name":"Bob"}],"you":1,"drives":false,"joins":true,"manages":false,"edits":false})"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_TRUE(hears(
      admin,
      R"({"viewer":2,"role":"admin","name":"Ada"}],"you":2,"drives":true,"joins":true,"manages":true,"edits":true})"));
  EXPECT_TRUE(hears(human, R"("name":"Ada")"));
  admin.send_text(R"({"do":"mute","viewer":1,"on":true})");
  EXPECT_TRUE(hears(human, R"("muted":true)"));
  EXPECT_THAT(answer(human, R"({"do":"say","text":"hi"})"), HasSubstr("an admin has muted you"));
}

TEST_F(GuestsTest, who_is_muted_stays_so_at_another_page) {
  WebClient admin(port_);
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  {
    WebClient human(port_);
    ASSERT_TRUE(human.upgrade_with("somebody-"));
    EXPECT_TRUE(hears(admin, R"("viewer":2)"));
    admin.send_text(R"({"do":"mute","viewer":2,"on":true})");
    EXPECT_TRUE(hears(human, R"("muted":true)"));
  }
  WebClient again(port_);
  ASSERT_TRUE(again.upgrade_with("somebody-"));
  again.message();
  EXPECT_THAT(answer(again, R"({"do":"say","text":"hi"})"), HasSubstr("an admin has muted you"));
  const std::uint64_t commands = status().commands;
  admin.send_text(R"({"do":"mute","viewer":3,"on":false})");
  ASSERT_TRUE(turn_until([&] { return status().commands > commands; }));
  EXPECT_THAT(answer(again, R"({"do":"say","text":"hi"})"), HasSubstr("only who has joined"));
}

TEST_F(GuestsTest, who_is_sent_out_leaves_with_all_pages) {
  WebClient admin(port_), one(port_), other(port_), observer(port_, "127.0.0.7");
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  ASSERT_TRUE(one.upgrade_with("somebody-"));
  ASSERT_TRUE(other.upgrade_with("somebody-"));
  ASSERT_TRUE(observer.upgrade());
  EXPECT_TRUE(hears(admin, R"("viewer":4)"));
  admin.send_text(R"({"do":"kick","viewer":2})");
  EXPECT_TRUE(turn_until([this] { return status().viewers == 2; }));
}

TEST_F(GuestsTest, who_is_sent_out_does_not_come_again_by_the_same_link) {
  WebClient human(port_), admin(port_), again(port_), observer(port_, "127.0.0.7");
  ASSERT_TRUE(human.upgrade_with("somebody-"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_TRUE(hears(admin, R"("viewer":1)"));
  EXPECT_THAT(answer(admin, R"({"do":"kick","viewer":2})"), HasSubstr("this is yourself"));
  EXPECT_THAT(answer(admin, R"({"do":"kick","viewer":9})"), HasSubstr("nobody has this number"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 1; }));
  again.upgrade_with("somebody-");
  EXPECT_THAT(again.message(), HasSubstr("an admin has sent you out"));
  EXPECT_TRUE(observer.upgrade()) << "others may still come";
  observer.message();
  EXPECT_EQ(status().viewers, 2u);
}

TEST_F(GuestsTest, who_is_sent_out_does_not_come_again_where_all_have_one_address) {
  WebClient observer(port_), driver(port_), admin(port_);
  ASSERT_TRUE(observer.upgrade());
  ASSERT_TRUE(driver.upgrade_with("a-driver-"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 2; }));
  WebClient again(port_), same(port_);
  ASSERT_TRUE(again.upgrade());
  EXPECT_THAT(again.message(), HasSubstr("an admin has sent you out"));
  ASSERT_TRUE(same.upgrade_with("the-admin"));
  EXPECT_THAT(same.message(), HasSubstr("\"name\":\"small\""));
}

TEST_F(WebServerTest, an_admin_without_a_token_does_not_shut_out_the_own_address) {
  WebClient observer(port_), elsewhere(port_, "127.0.0.7"), admin(port_);
  ASSERT_TRUE(observer.upgrade());
  ASSERT_TRUE(elsewhere.upgrade());
  ASSERT_TRUE(admin.upgrade());
  admin.send_text(R"({"do":"kick","viewer":1})");
  admin.send_text(R"({"do":"kick","viewer":2})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 1; }));
  WebClient again(port_), other(port_, "127.0.0.7"), inventor(port_, "127.0.0.7");
  ASSERT_TRUE(again.upgrade());
  EXPECT_THAT(again.message(), HasSubstr("\"name\":\"small\""));
  ASSERT_TRUE(other.upgrade());
  EXPECT_THAT(other.message(), HasSubstr("an admin has sent you out"));
  ASSERT_TRUE(inventor.upgrade_with("invented-1"));
  EXPECT_THAT(inventor.message(), HasSubstr("an admin has sent you out")) << "no list knows that token";
}

TEST_F(GuestsTest, who_is_sent_out_does_not_come_again_without_the_token) {
  WebClient human(port_, "127.0.0.7"), admin(port_);
  ASSERT_TRUE(human.upgrade_with("somebody-"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_TRUE(hears(admin, R"("viewer":1)"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 1; }));
  WebClient plain(port_, "127.0.0.7"), elsewhere(port_, "127.0.0.8"), as_another(port_, "127.0.0.7");
  plain.upgrade();
  EXPECT_THAT(plain.message(), HasSubstr("an admin has sent you out"));
  ASSERT_TRUE(elsewhere.upgrade());
  EXPECT_THAT(elsewhere.message(), HasSubstr("\"name\":\"small\""));
  ASSERT_TRUE(as_another.upgrade_with("a-driver-"));
  EXPECT_THAT(as_another.message(), HasSubstr("\"name\":\"small\""));
}

/// Behind a proxy at 127.0.0.7.
class ProxyTest : public WebServerTest {
 protected:
  ProxyTest()
      : WebServerTest([](WebOptions& options) {
          options.guests = {{server::GuestRole::kAdmin, "the-admin", "Ada"},
                            {server::GuestRole::kObserver, "*", ""}};
          options.proxies = *net::TrustedProxies::parse("127.0.0.7");
        }) {}
};

TEST_F(ProxyTest, who_is_sent_out_is_one_client_of_it) {
  WebClient one(port_, "127.0.0.7"), other(port_, "127.0.0.7"), admin(port_);
  ASSERT_TRUE(one.upgrade("X-Forwarded-For: 203.0.113.5\r\n"));
  ASSERT_TRUE(other.upgrade("X-Forwarded-For: 203.0.113.6\r\n"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 2; }));
  WebClient again(port_, "127.0.0.7"), liar(port_, "127.0.0.7"), next(port_, "127.0.0.7");
  again.upgrade("X-Forwarded-For: 203.0.113.5\r\n");
  EXPECT_THAT(again.message(), HasSubstr("an admin has sent you out"));
  liar.upgrade("X-Forwarded-For: 203.0.113.6\r\nX-Forwarded-For: 203.0.113.5\r\n");
  EXPECT_THAT(liar.message(), HasSubstr("an admin has sent you out")) << "the proxy's own line is the last";
  ASSERT_TRUE(next.upgrade("X-Forwarded-For: 203.0.113.7\r\n"));
  EXPECT_THAT(next.message(), HasSubstr("\"name\":\"small\""));
}

TEST_F(ProxyTest, who_comes_past_it_is_who_they_are) {
  WebClient direct(port_, "127.0.0.8"), admin(port_);
  ASSERT_TRUE(direct.upgrade("X-Forwarded-For: 203.0.113.5\r\n"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 1; }));
  WebClient again(port_, "127.0.0.8"), named(port_, "127.0.0.7");
  again.upgrade("X-Forwarded-For: 203.0.113.9\r\n");
  EXPECT_THAT(again.message(), HasSubstr("an admin has sent you out")) << "whatever address is invented";
  ASSERT_TRUE(named.upgrade("X-Forwarded-For: 203.0.113.5\r\n"));
}

/// The same without a list of guests: everybody is an admin.
class OpenProxyTest : public WebServerTest {
 protected:
  OpenProxyTest()
      : WebServerTest(
            [](WebOptions& options) { options.proxies = *net::TrustedProxies::parse("127.0.0.7"); }) {}
};

TEST_F(OpenProxyTest, who_comes_from_elsewhere_does_not_shut_out_the_machine_itself) {
  WebClient house(port_), other(port_, "127.0.0.7"), admin(port_, "127.0.0.7");
  ASSERT_TRUE(house.upgrade());
  ASSERT_TRUE(other.upgrade("X-Forwarded-For: 203.0.113.6\r\n"));
  ASSERT_TRUE(admin.upgrade("X-Forwarded-For: 203.0.113.5\r\n"));
  admin.send_text(R"({"do":"kick","viewer":1})");
  admin.send_text(R"({"do":"kick","viewer":2})");
  ASSERT_TRUE(turn_until([this] { return status().viewers == 1; }));
  WebClient again(port_), next(port_, "127.0.0.7");
  ASSERT_TRUE(again.upgrade());
  EXPECT_THAT(again.message(), HasSubstr("\"name\":\"small\""));
  next.upgrade("X-Forwarded-For: 203.0.113.6\r\n");
  EXPECT_THAT(next.message(), HasSubstr("an admin has sent you out"));
}

TEST_F(ProxyTest, what_names_no_address_is_refused) {
  WebClient page(port_, "127.0.0.7");
  const std::string reply = page.ask("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Forwarded-For: unknown\r\n\r\n");
  EXPECT_THAT(reply,
              AllOf(StartsWith("HTTP/1.1 400"), HasSubstr("invalid address \"unknown\" in X-Forwarded-For")));
}

/// Two admins.
class SharesTest : public GuestsTest {
 protected:
  explicit SharesTest(std::shared_ptr<world::Shares> shares = std::make_shared<world::Shares>())
      : GuestsTest([&shares](WebOptions& options) {
          options.guests = {{server::GuestRole::kAdmin, "the-admin", "Ada"},
                            {server::GuestRole::kAdmin, "the-other", "Bea"}};
          options.shares = shares;
        }),
        shares_(std::move(shares)) {}
  const std::shared_ptr<world::Shares> shares_;
};

TEST_F(SharesTest, of_what_may_be_brought_belong_to_the_token) {
  // As if it had brought the first robot, of four models, that often.
  for (std::size_t k = 0; k < limits::kBroughtByOneModels; k += 4)
    shares_->add(small_.world, "the-admin", SmallWorld::id(0));
  WebClient page(port_), same(port_), other(port_);
  ASSERT_TRUE(page.upgrade_with("the-admin"));
  ASSERT_TRUE(same.upgrade_with("the-admin"));
  ASSERT_TRUE(other.upgrade_with("the-other"));
  constexpr const char* kAdd = R"({"do":"add","robot":0,"x":3,"y":-4,"a":0})";
  EXPECT_THAT(answer(page, kAdd), HasSubstr("your share of the run is full"));
  EXPECT_THAT(answer(same, R"({"do":"copy","model":1,"x":3,"y":-4,"a":0})"),
              HasSubstr("your share of the run is full"));
  const std::size_t before = small_.world.models.size();
  other.send_text(kAdd);
  EXPECT_TRUE(turn_until([&] { return small_.world.models.size() == before + 4; }));
}

/// Somebody joins, and then the run begins again: their body has gone, and its id is another's.
class BodiesTest : public GuestsTest {
 protected:
  explicit BodiesTest(double join_period = 3600) : GuestsTest(1, join_period) {}
  void join(WebClient& guest) {
    filler_ = *world::spawn(small_.world, SmallWorld::robot(0), {7, 7, 0, 0});
    ASSERT_TRUE(guest.upgrade_with("somebody-"));
    guest.send_text(R"({"do":"join","name":"Bob","x":9,"y":9,"a":0})");
    ASSERT_TRUE(hears(guest, R"("body":)"));
    body_ = small_.world.id(small_.world.find("Bob"));
  }
  /// A robot comes, of which the part of this number has the id that the body had.
  void replace_body(std::uint32_t part) {
    ASSERT_TRUE(world::despawn(small_.world, body_));
    ASSERT_TRUE(world::despawn(small_.world, filler_));
    world::Population(small_.world).next_id() = body_.value - part;
    robot_ = *world::spawn(small_.world, SmallWorld::robot(0), {5, 5, 0, 0});
    ASSERT_TRUE(small_.world.row(body_));
  }

  world::ModelId filler_, body_, robot_;
};

TEST_F(BodiesTest, who_leaves_takes_no_part_of_a_robot_along) {
  {
    WebClient guest(port_);
    join(guest);
    ASSERT_FALSE(HasFatalFailure());
    replace_body(1);
  }
  EXPECT_TRUE(turn_until([this] { return status().viewers == 0 && notes_.posted() == 0; }));
  turn();
  EXPECT_TRUE(small_.world.row(robot_));
}

TEST_F(BodiesTest, are_driven_by_nobody_else) {
  auto guest = std::make_unique<WebClient>(port_);
  join(*guest);
  ASSERT_FALSE(HasFatalFailure());
  WebClient driver(port_), admin(port_);
  ASSERT_TRUE(driver.upgrade_with("a-driver-"));
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_TRUE(notes_.is_reserved(body_)) << "devices refuse commands";
  const std::string drive =
      R"({"do":"drive","forward":1,"sideways":0,"turn":0,"model":)" + std::to_string(body_.value) + "}";
  for (WebClient* other : {&driver, &admin})
    EXPECT_THAT(answer(*other, drive), HasSubstr("nobody drives another person"));
  guest.reset();
  EXPECT_TRUE(turn_until([this] { return !notes_.is_reserved(body_); }));
}

TEST_F(BodiesTest, come_where_there_is_a_place) {
  WebClient guest(port_);
  ASSERT_TRUE(guest.upgrade_with("somebody-"));
  guest.send_text(R"({"do":"join","name":"Bob","x":51,"y":9,"a":0.5})");
  ASSERT_TRUE(hears(guest, R"("body":)"));
  const geom::Pose& X_WM = small_.world.models.X_WM[small_.world.find("Bob")];
  EXPECT_NEAR(X_WM.x, 40, 2) << "not at 51: some ticks have passed";
  EXPECT_NEAR(X_WM.y, 9, 2);
}

TEST_F(BodiesTest, do_not_come_where_there_is_none) {
  WebClient guest(port_);
  ASSERT_TRUE(guest.upgrade_with("somebody-"));
  guest.message();
  EXPECT_THAT(answer(guest, R"({"do":"join","name":"Bob","x":101,"y":9,"a":0})"),
              HasSubstr("it is too far out there"));
  EXPECT_FALSE(small_.world.find("Bob"));
}

TEST_F(BodiesTest, whose_name_is_taken_get_another_and_hear_it) {
  ASSERT_TRUE(world::spawn(small_.world, SmallWorld::robot(0), {7, 7, 0, 0}, "Bob"));
  WebClient guest(port_);
  ASSERT_TRUE(guest.upgrade_with("somebody-"));
  guest.message();
  EXPECT_THAT(answer(guest, R"({"do":"join","name":"Bob","x":9,"y":9,"a":0})"),
              HasSubstr("somebody is called Bob already: you are Bob"));
}

TEST_F(BodiesTest, of_a_viewer_come_once_a_period_at_most) {
  WebClient guest(port_);
  join(guest);
  ASSERT_FALSE(HasFatalFailure());
  const std::size_t models = small_.world.models.size();
  for (int k = 0; k < 5; ++k)
    EXPECT_THAT(answer(guest, R"({"do":"join","name":"Bob","x":8,"y":8,"a":0})"), HasSubstr("just now"));
  EXPECT_EQ(small_.world.models.size(), models);
  EXPECT_TRUE(small_.world.row(body_)) << "the body stays";
}

class BodiesAgainTest : public BodiesTest {
 protected:
  BodiesAgainTest() : BodiesTest(0) {}
};

TEST_F(BodiesAgainTest, the_next_one_takes_the_place_of_the_former) {
  WebClient guest(port_);
  join(guest);
  ASSERT_FALSE(HasFatalFailure());
  guest.send_text(R"({"do":"join","name":"Bob","x":8,"y":8,"a":0})");
  EXPECT_TRUE(turn_until([&] { return !small_.world.row(body_) && small_.world.find("Bob"); }));
}

TEST_F(BodiesTest, are_not_mistaken_for_a_robot_that_has_their_id) {
  WebClient guest(port_);
  join(guest);
  ASSERT_FALSE(HasFatalFailure());
  const std::string of_body = R"(,"model":)" + std::to_string(body_.value);
  guest.send_text(R"({"do":"drive")" + of_body + R"(,"forward":1,"sideways":0,"turn":0})");
  ASSERT_TRUE(turn_until([&] {
    const world::PositionRow row = small_.world.position(body_);
    return small_.world.positions.command[row].x == 1;
  }));
  replace_body(0);
  EXPECT_THAT(text_with(guest, "\"gone\":[" + std::to_string(filler_.value)), HasSubstr("models"));
  for (const char* command : {R"({"do":"drive","forward":1,"sideways":0,"turn":0)", R"({"do":"remove")"})
    EXPECT_THAT(answer(guest, command + of_body + "}"), HasSubstr("may not do that")) << command;
  EXPECT_THAT(answer(guest, R"({"do":"say","text":"hi"})"), HasSubstr("only who has joined"));
}

TEST_F(GuestsTest, who_sees_a_recording_hears_that_nothing_in_it_can_be_changed) {
  notes_.fixed = "this is a recording";
  WebClient admin(port_);
  ASSERT_TRUE(admin.upgrade_with("the-admin"));
  EXPECT_TRUE(hears(admin, R"("drives":false,"joins":false,"manages":true,"edits":false})"));
}

TEST_F(GuestsTest, a_wrong_token_opens_nothing_and_the_limit_holds) {
  WebClient wrong(port_);
  wrong.upgrade_with("guessed-it");
  EXPECT_THAT(wrong.message(), HasSubstr("open the page by the link that you were given"));
  std::vector<std::unique_ptr<WebClient>> many;
  for (int k = 0; k < 6; ++k) {
    many.push_back(std::make_unique<WebClient>(port_));
    many.back()->upgrade();
  }
  EXPECT_TRUE(turn_until([this] { return status().viewers_refused == 2; }));
  EXPECT_EQ(status().viewers, 4u);
}

}  // namespace
}  // namespace playhouse::web_server
