#include "playhouse/web_server/speech_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/replicate/small_world.h"

namespace playhouse::web_server {
namespace {

using replicate::SmallWorld;

class SpeechLogTest : public testing::Test {
 protected:
  void say(int robot, const std::string& text) {
    world::set_say(small_.world, {SmallWorld::robot(robot)}, text);
  }
  /// A tick, and what the log makes of it.
  void tick() {
    small_.tick();
    note();
  }
  void note() {
    replicate::capture(small_.world, {}, layout_, {}, snapshot_);
    log_.note(snapshot_);
  }
  std::string text() { return log_.text() ? *log_.text() : ""; }
  std::size_t lines() {
    const std::string all = text(), mark = "\"tick\"";
    std::size_t count = 0;
    for (std::size_t at = all.find(mark); at != std::string::npos; at = all.find(mark, at + 1)) ++count;
    return count;
  }

  SmallWorld small_{3};
  const replicate::Prototypes prototypes_{small_.world.scene()};
  std::shared_ptr<const replicate::Layout> layout_ =
      std::make_shared<const replicate::Layout>(small_.world, prototypes_, nullptr);
  replicate::Snapshot snapshot_;
  SpeechLog log_;
};

TEST_F(SpeechLogTest, has_each_text_once_with_its_tick_model_and_name) {
  EXPECT_EQ(log_.text(), nullptr);
  say(0, "good \"morning\"");
  tick();
  tick();
  say(1, "hello");
  tick();
  EXPECT_EQ(text(),
            "{\"said\":[{\"tick\":1,\"model\":1,\"name\":\"r0\",\"text\":\"good \\\"morning\\\"\"},"
            "{\"tick\":3,\"model\":5,\"name\":\"r1\",\"text\":\"hello\"}]}\n");
  say(0, "");
  tick();
  say(0, "good \"morning\"");
  tick();
  EXPECT_EQ(lines(), 3u) << "said again after a silence";
}

TEST_F(SpeechLogTest, forgets_what_is_said_after_the_moment_that_the_run_goes_back_to) {
  say(0, "before");
  tick();
  say(0, "after");
  tick();
  EXPECT_THAT(text(), testing::HasSubstr("after"));
  replicate::Snapshot past = snapshot_;
  past.tick = 1;
  log_.note(past);
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("after")));
  EXPECT_THAT(text(), testing::HasSubstr("before"));
}

TEST_F(SpeechLogTest, keeps_the_last_lines_within_its_limits) {
  for (int k = 0; k < 120; ++k) {
    say(0, "line " + std::to_string(k));
    tick();
  }
  EXPECT_EQ(lines(), SpeechLog::kLinesMost);
  EXPECT_THAT(text(), testing::HasSubstr("line 70"));
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("line 69")));
  for (int k = 0; k < 60; ++k) {
    say(0, std::string(1000, static_cast<char>('a' + k % 26)));
    tick();
  }
  EXPECT_LE(text().size(), SpeechLog::kBytesMost + 100);
  EXPECT_GT(lines(), 20u);
}

}  // namespace
}  // namespace playhouse::web_server
