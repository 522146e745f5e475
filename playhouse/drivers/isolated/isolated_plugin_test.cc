// What ends a plug-in in a process of its own. What it does until then is tested beside what one in this process does
// (plugin_test.cc).

#include "playhouse/drivers/isolated/isolated_plugin.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/drivers/isolated/plugin_start.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/opaque.h"

namespace playhouse::drivers {
namespace {

namespace aio = wire::aio;
namespace op = wire::opaque;
using ::testing::AnyOf;
using ::testing::StartsWith;
using Clock = std::chrono::steady_clock;

/// A program that counts what it is told.
class CountingProgram final : public PluginProgram {
 public:
  double time() const override { return 1; }
  void publish(std::size_t, std::uint8_t, std::vector<std::byte>, double) override { ++passed; }
  void command(std::size_t, std::uint8_t, std::span<const std::byte>) override { ++passed; }
  void ask(std::size_t, std::uint8_t, std::span<const std::byte>, AnswerHeard) override { ++passed; }
  void say(bool, std::string_view) override { ++passed; }

  int passed = 0;
};

/// A section with the field `fault`.
class FaultSection final : public PluginSection {
 public:
  explicit FaultSection(std::string fault) : fault_(std::move(fault)) {}
  bool has(std::string_view) const override { return false; }
  std::size_t count(std::string_view) const override { return 0; }
  double number(std::string_view, double otherwise, std::size_t) const override { return otherwise; }
  double length(std::string_view, double otherwise, std::size_t) const override { return otherwise; }
  double angle(std::string_view, double otherwise, std::size_t) const override { return otherwise; }
  int integer(std::string_view, int otherwise, std::size_t) const override { return otherwise; }
  bool flag(std::string_view, bool otherwise) const override { return otherwise; }
  std::string text(std::string_view key, std::string_view otherwise, std::size_t) const override {
    return key == "fault" ? fault_ : std::string(otherwise);
  }
  std::string filename(std::string_view, std::string_view otherwise) const override {
    return std::string(otherwise);
  }

 private:
  std::string fault_;
};

/// The probe with a fault, and what its hook for commands throws.
class FaultyProbe {
 public:
  explicit FaultyProbe(const std::string& fault) {
    auto started = IsolatedPlugin::start({.program = "/proc/self/exe",
                                          .library = TEST_LIBRARIES "/probe.so",
                                          .name = "probe",
                                          .has_world = [] { return false; }});
    EXPECT_TRUE(started);
    plugin = std::move(*started);
    plugin->join(program, {{"", "aio", aio::kCode, 0, 6665}, {"", "opaque", op::kCode, 0, 6665}},
                 {{"", "opaque", op::kCode, 1, 6665}});
    plugin->configure(FaultSection(fault));
    plugin->watch([this](const std::string& text) { ended.set_value(text); });
  }
  std::string thrown() const {
    try {
      plugin->registered().commands.at({0, aio::kCmdState})(wire::encode(aio::Cmd{0, 3.5f}));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing";
  }

  CountingProgram program;
  std::promise<std::string> ended;
  std::unique_ptr<IsolatedPlugin> plugin;
};

TEST(IsolatedPlugin, that_ends_its_process_is_told_and_thrown) {
  const std::pair<const char*, const char*> cases[] = {
      {"aborts", "its process was ended by SIGABRT"},
      {"leaves a child", "its process was ended by SIGABRT"},
      {"segfaults", "its process was ended by SIGSEGV"},
      {"exits", "its process ended with exit code 3"},
  };
  for (const auto& [fault, told] : cases) {
    FaultyProbe probe(fault);
    EXPECT_EQ(probe.thrown(), told);
    EXPECT_EQ(probe.ended.get_future().get(), told);
    EXPECT_EQ(probe.thrown(), told) << "once more";
  }
}

TEST(IsolatedPlugin, that_ends_its_process_between_two_calls_is_told) {
  FaultyProbe probe("aborts later");
  probe.thrown();
  EXPECT_EQ(probe.ended.get_future().get(), "its process was ended by SIGABRT");
}

TEST(IsolatedPlugin, that_says_anything_at_all_is_ended) {
  FaultyProbe probe("babbles");
  EXPECT_THAT(probe.thrown(), StartsWith("its process broke the rules: a frame of "));
  EXPECT_THAT(probe.ended.get_future().get(), StartsWith("its process broke the rules: a frame of "));
}

TEST(IsolatedPlugin, that_sends_frames_without_sense_is_ended) {
  int passed = 0, ended = 0;
  for (int seed = 0; seed < 60; ++seed) {
    FaultyProbe probe("rambles " + std::to_string(seed));
    const std::string thrown = probe.thrown();
    probe.plugin->end(Clock::time_point());
    passed += probe.program.passed;
    if (thrown.starts_with("its process broke the rules: ")) ++ended;
  }
  EXPECT_GT(passed, 0);
  EXPECT_GT(ended, 0);
}

TEST(IsolatedPlugin, that_does_not_come_back_is_killed) {
  FaultyProbe probe("blocks");
  std::thread killer([&] { probe.plugin->kill("it has not come back"); });
  EXPECT_EQ(probe.thrown(), "it has not come back");
  killer.join();
  EXPECT_EQ(probe.ended.get_future().get(), "it has not come back");
}

TEST(IsolatedPlugin, ends_by_itself_or_in_its_time) {
  FaultyProbe good("");
  EXPECT_EQ(good.thrown(), "nothing");
  good.plugin->end(Clock::time_point::max());
  FaultyProbe bad("stays");
  bad.plugin->end(Clock::time_point());
  for (FaultyProbe* probe : {&good, &bad})
    EXPECT_EQ(probe->ended.get_future().wait_for(std::chrono::seconds(0)), std::future_status::timeout)
        << "it was to end";
}

/// As it is sent.
std::string bytes_of(const PluginFrame& frame) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  EXPECT_TRUE(FrameOutput(ends[0]).send(frame));
  std::string bytes(4096, ' ');
  const ssize_t got = ::recv(ends[1], bytes.data(), bytes.size(), 0);
  EXPECT_GT(got, 0);
  bytes.resize(static_cast<std::size_t>(got));
  for (const int end : ends) ::close(end);
  return bytes;
}

std::string times(int count, const std::string& text) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

/// A process that follows no rule but those of a script, in a folder with a pipe, `fifo`, and what it may say:
/// `configured`, which lets configure() return, `lines` for the log, `questions` about time, and `requests` to another
/// driver, more than may wait for an answer.
class ScriptedPlugin {
 public:
  explicit ScriptedPlugin(const std::string& script) {
    write("configured", bytes_of({.kind = PluginFrameKind::kRegistered,
                                  .body = pack(RegisteredKeys{{{0, aio::kCmdState}}, {}, {}, {}, 0})}) +
                            bytes_of({.kind = PluginFrameKind::kReturned}));
    write("questions", times(2048, bytes_of({.kind = PluginFrameKind::kAskTime})));
    write("lines", times(2048, bytes_of({.kind = PluginFrameKind::kSay, .body = bytes_of_text("x")})));
    write("requests", times(limits::kRequestQueue + 100, bytes_of({.kind = PluginFrameKind::kAskOther,
                                                                   .subtype = op::kReqData,
                                                                   .body = wire::encode(op::Data{{1}})})));
    EXPECT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
    write("script", "#!/bin/sh\ncd " + folder.path().string() + "\n" + script);
    std::filesystem::permissions(folder / "script", std::filesystem::perms::owner_all);
    auto started = IsolatedPlugin::start(
        {.program = folder / "script", .library = "x.so", .name = "script", .has_world = [] {
           return true;
         }});
    EXPECT_TRUE(started);
    plugin = std::move(*started);
    plugin->join(program, {{"", "aio", aio::kCode, 0, 6665}}, {{"", "opaque", op::kCode, 1, 6665}});
  }
  void begin() {
    plugin->configure(FaultSection(""));
    plugin->watch([this](const std::string& text) { ended.set_value(text); });
  }
  std::string thrown_by_configure() const {
    try {
      plugin->configure(FaultSection(""));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing";
  }
  std::string thrown_by_command(std::size_t bytes) const {
    try {
      plugin->registered().commands.at({0, aio::kCmdState})(Bytes(bytes));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing";
  }

  TestFolder folder;
  CountingProgram program;
  std::promise<std::string> ended;
  std::unique_ptr<IsolatedPlugin> plugin;

 private:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
  }
};

constexpr const char* kReadsNothing =
    "its process broke the rules: it asks again and has not read the answer";

TEST(IsolatedPlugin, that_asks_and_reads_no_answer_is_ended) {
  EXPECT_EQ(ScriptedPlugin("cat questions >&3; kill -STOP $$").thrown_by_configure(), kReadsNothing);
  ScriptedPlugin later("cat configured questions >&3; kill -STOP $$");
  later.begin();
  EXPECT_EQ(later.ended.get_future().get(), kReadsNothing);
}

TEST(IsolatedPlugin, that_leaves_a_child_which_goes_on_is_told) {
  for (const std::string group : {"", "setsid "}) {
    const std::string goes_on = " sh -c 'while cat $0; do :; done >&3' ", exits = " & exit 7";
    ScriptedPlugin says("cat configured >&3; " + group + goes_on + "lines" + exits);
    says.begin();
    EXPECT_EQ(says.ended.get_future().get(), "its process ended with exit code 7");
    ScriptedPlugin asks("cat configured >&3; " + group + goes_on + "questions" + exits);
    asks.begin();
    EXPECT_THAT(asks.ended.get_future().get(), AnyOf(kReadsNothing, "its process ended with exit code 7"));
  }
}

TEST(IsolatedPlugin, that_reads_nothing_holds_up_no_hook_when_it_has_ended) {
  ScriptedPlugin killed("setsid sh -c 'cat configured >&3; read go < fifo' & kill -STOP $$");
  killed.begin();
  std::thread killer([&] { killed.plugin->kill("it has not come back"); });
  EXPECT_EQ(killed.thrown_by_command(limits::kBodyBytes), "it has not come back") << "a child has the socket";
  killer.join();
  std::ofstream(killed.folder / "fifo") << "go\n";
  ScriptedPlugin ended("cat configured >&3; read go < fifo; exit 7");
  ended.begin();
  std::thread ender([&] { std::ofstream(ended.folder / "fifo") << "go\n"; });
  EXPECT_EQ(ended.thrown_by_command(limits::kBodyBytes), "its process ended with exit code 7");
  ender.join();
}

TEST(IsolatedPlugin, whose_requests_get_no_answer_may_go_on_asking) {
  ScriptedPlugin asks("cat configured requests >&3; exit 7");
  asks.begin();
  EXPECT_EQ(asks.ended.get_future().get(), "its process ended with exit code 7");
  EXPECT_GT(asks.program.passed, static_cast<int>(limits::kRequestQueue));
}

TEST(IsolatedPlugin, leaves_no_process_of_its_group) {
  ScriptedPlugin parent("cat configured >&3; exec 4> fifo; sleep 4242 & exit 7");
  parent.begin();
  const int alive = ::open((parent.folder / "fifo").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_GE(alive, 0);
  EXPECT_EQ(parent.ended.get_future().get(), "its process ended with exit code 7");
  char none = 0;
  EXPECT_EQ(::read(alive, &none, 1), 0) << "nobody has it open any more";
  ::close(alive);
}

TEST(IsolatedPlugin, needs_a_program) {
  const auto started = IsolatedPlugin::start(
      {.program = "/nowhere", .library = "x", .name = "probe", .has_world = [] { return false; }});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().text, "starts no process: No such file or directory");
}

}  // namespace
}  // namespace playhouse::drivers
