// What ends a plug-in in a process of its own. What it does until then is tested beside what one in this process does
// (plugin_test.cc).

#include "playhouse/drivers/isolated/isolated_plugin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

namespace aio = wire::aio;
namespace op = wire::opaque;
using ::testing::StartsWith;
using Clock = std::chrono::steady_clock;

constexpr std::uint16_t kProvided[] = {aio::kCode, op::kCode}, kUsed[] = {op::kCode};

/// A program that no message reaches which is not valid.
class CheckingProgram final : public PluginProgram {
 public:
  double time() const override { return 1; }
  void publish(std::size_t provided, std::uint8_t subtype, std::vector<std::byte> body, double) override {
    ASSERT_LT(provided, std::size(kProvided));
    check(kProvided[provided], wire::MessageType::kData, subtype, body);
  }
  void command(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body) override {
    ASSERT_LT(used, std::size(kUsed));
    check(kUsed[used], wire::MessageType::kCmd, subtype, body);
  }
  void ask(std::size_t used, std::uint8_t subtype, std::span<const std::byte> body, AnswerHeard) override {
    ASSERT_LT(used, std::size(kUsed));
    check(kUsed[used], wire::MessageType::kReq, subtype, body);
  }
  void say(bool, std::string_view) override { ++passed; }

  int passed = 0;

 private:
  void check(std::uint16_t interf, wire::MessageType type, std::uint8_t subtype,
             std::span<const std::byte> body) {
    ++passed;
    const wire::MessageDef* const message = wire::find_message(interf, type, subtype);
    ASSERT_NE(message, nullptr);
    EXPECT_EQ(message->check(body), "");
  }
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

  CheckingProgram program;
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

TEST(IsolatedPlugin, that_sends_frames_without_sense_is_ended_and_passes_on_no_invalid_message) {
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

TEST(IsolatedPlugin, needs_a_program) {
  const auto started = IsolatedPlugin::start(
      {.program = "/nowhere", .library = "x", .name = "probe", .has_world = [] { return false; }});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().text, "starts no process: No such file or directory");
}

}  // namespace
}  // namespace playhouse::drivers
