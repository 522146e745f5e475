#include "playhouse/drivers/isolated/plugin_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <string>
#include <thread>

#include "playhouse/base/limits.h"
#include "playhouse/drivers/isolated/plugin_start.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;

class PluginFrameTest : public ::testing::Test {
 protected:
  PluginFrameTest() { EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()), 0); }
  ~PluginFrameTest() override {
    for (const int end : ends_) ::close(end);
  }
  void say(std::span<const std::uint8_t> bytes) {
    ASSERT_EQ(::send(ends_[0], bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }
  std::string fault_of(std::span<const std::uint8_t> bytes) {
    say(bytes);
    FrameInput in(ends_[1]);
    EXPECT_EQ(in.read(true), FrameInput::ReadOutcome::kSome);
    const auto taken = in.take();
    return taken ? "" : taken.error().text;
  }

  std::array<int, 2> ends_{};
};

TEST_F(PluginFrameTest, arrives_as_it_was_sent_however_long_it_is) {
  const PluginFrame sent{.kind = PluginFrameKind::kPublish,
                         .flag = true,
                         .subtype = 7,
                         .device = 8,
                         .number = std::numeric_limits<std::uint64_t>::max(),
                         .time = 0.25,
                         .body = Bytes(300'000, std::byte{9})};
  std::thread sender([&] {
    FrameOutput out(ends_[0]);
    EXPECT_TRUE(out.send({.kind = PluginFrameKind::kSay, .body = bytes_of_text("first")}));
    EXPECT_TRUE(out.send(sent));
  });
  FrameInput in(ends_[1]);
  std::vector<PluginFrame> got;
  while (got.size() < 2) {
    ASSERT_EQ(in.read(true), FrameInput::ReadOutcome::kSome);
    for (auto frame = in.take(); frame && *frame; frame = in.take()) got.push_back(std::move(**frame));
  }
  sender.join();
  EXPECT_EQ(text_of(got[0].body), "first");
  EXPECT_EQ(got[1].kind, sent.kind);
  EXPECT_TRUE(got[1].flag);
  EXPECT_EQ(got[1].subtype, sent.subtype);
  EXPECT_EQ(got[1].device, sent.device);
  EXPECT_EQ(got[1].number, sent.number);
  EXPECT_EQ(got[1].time, sent.time);
  EXPECT_EQ(got[1].body, sent.body);
  EXPECT_EQ(in.read(false), FrameInput::ReadOutcome::kNothing);
  ::shutdown(ends_[0], SHUT_WR);
  EXPECT_EQ(in.read(false), FrameInput::ReadOutcome::kEnd);
}

TEST_F(PluginFrameTest, is_refused_if_it_is_none) {
  std::array<std::uint8_t, 32> head{};
  head[4] = static_cast<std::uint8_t>(PluginFrameKind::kSay) + 1;
  EXPECT_THAT(fault_of(head), HasSubstr("a frame of kind 18"));
  head.fill(0xFF);
  EXPECT_THAT(fault_of(head), HasSubstr("a frame of 4294967295 bytes: "));
  head.fill(0);
  EXPECT_EQ(fault_of(std::span(head).first(31)), "") << "the rest may come";
}

TEST_F(PluginFrameTest, waits_for_who_does_not_read) {
  FrameOutput out(ends_[0]);
  FrameOutput::FrameMark first = 0, last = 0;
  int frames = 1;
  for (first = last = out.offer({.kind = PluginFrameKind::kStep}); !out.is_waiting(); ++frames)
    last = out.offer({.kind = PluginFrameKind::kDatum, .body = Bytes(50'000, std::byte{9})});
  last = out.offer({.kind = PluginFrameKind::kClose});
  EXPECT_FALSE(out.is_waiting(first));
  EXPECT_TRUE(out.is_waiting(last));
  FrameInput in(ends_[1]);
  PluginFrame got;
  for (int taken = 0; taken < frames + 1; out.flush()) {
    ASSERT_EQ(in.read(false), FrameInput::ReadOutcome::kSome);
    for (auto frame = in.take(); frame && *frame; frame = in.take(), ++taken) got = std::move(**frame);
  }
  EXPECT_EQ(got.kind, PluginFrameKind::kClose);
  EXPECT_FALSE(out.is_waiting(last));
}

TEST_F(PluginFrameTest, to_who_goes_without_reading_is_told) {
  std::thread goes([&] { ::shutdown(ends_[1], SHUT_RDWR); });
  EXPECT_FALSE(FrameOutput(ends_[0]).send({.kind = PluginFrameKind::kDatum, .body = Bytes(2'000'000)}));
  goes.join();
}

TEST_F(PluginFrameTest, to_nobody_is_told) {
  ::shutdown(ends_[1], SHUT_RDWR);
  EXPECT_FALSE(FrameOutput(ends_[0]).send({.kind = PluginFrameKind::kStep}));
}

TEST(PluginStart, arrives_as_it_was_packed) {
  const PluginStart sent{"/a/load.so", {{"", "aio", 21, 3, 6665}}, {{"odometry", "position2d", 4, 0, 7000}}};
  const auto got = unpack_start(pack(sent));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->library, sent.library);
  ASSERT_EQ(got->provides.size(), 1u);
  EXPECT_EQ(got->provides[0].interf, "aio");
  ASSERT_EQ(got->uses.size(), 1u);
  EXPECT_EQ(got->uses[0].key, "odometry");
  EXPECT_EQ(got->uses[0].port, 7000u);
  Bytes cut = pack(sent);
  cut.pop_back();
  EXPECT_FALSE(unpack_start(cut));
}

TEST(RegisteredKeys, are_no_more_than_messages_can_be) {
  RegisteredKeys keys{{{0, 1}, {1, 2}}, {{1, 9}}, {}, {{{1, 3}, 7}}, 0.5};
  const auto got = unpack_keys(pack(keys), 2);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->commands, keys.commands);
  EXPECT_EQ(got->requests, keys.requests);
  EXPECT_EQ(got->passed_on, keys.passed_on);
  EXPECT_EQ(got->period, 0.5);
  RegisteredKeys many = keys;
  many.data.resize(100'000);
  EXPECT_FALSE(unpack_keys(pack(many), 2));
  keys.passed_on.resize(100'000);
  EXPECT_FALSE(unpack_keys(pack(keys), 2));
}

}  // namespace
}  // namespace playhouse::drivers
