// A browser that is a script: what it says, how it ends and what it leaves behind is for each test to choose.

#include "playhouse/app/pictures/browser.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/app/pictures/devtools.h"
#include "playhouse/base/testing/wait.h"
#include "playhouse/base/testing_folder.h"

namespace playhouse::app {
namespace {

using testing::HasSubstr;

constexpr double kLong = 60;  // s; of waits that end by themselves

class ABrowser : public testing::Test {
 protected:
  /// Starts one that does this, in the folder of the test.
  void start(const std::string& script) {
    std::ofstream(folder_ / "browser") << "#!/bin/sh\ncd '" << folder_.path().string() << "'\n"
                                       << script << "\n";
    std::filesystem::permissions(folder_ / "browser", std::filesystem::perms::owner_all);
    const Result<void> started = browser_->start(folder_ / "browser");
    ASSERT_TRUE(started) << started.error().text;
  }

  std::string file(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  static std::string fault(const Result<std::string>& received) {
    return received ? "received: " + *received : received.error().text;
  }
  static std::string fault(const Result<boost::json::object>& answer) {
    return answer ? "answered: " + boost::json::serialize(*answer) : answer.error().text;
  }
  std::string call_fault(double seconds = kLong) {
    return fault(DevTools(*browser_).call("Page.enable", {}, seconds));
  }

  const TestFolder folder_;
  const Interrupt interrupt_;
  std::unique_ptr<Browser> browser_ = std::make_unique<Browser>(interrupt_);
};

TEST_F(ABrowser, sends_and_receives_messages_that_a_zero_byte_ends) {
  start(R"(printf 'one\0tw' >&4; printf 'o\0' >&4; head -c 6 <&3 > heard; printf 'three\0' >&4; sleep 600)");
  for (const char* const message : {"one", "two"})
    EXPECT_EQ(fault(browser_->receive(patience())), std::string("received: ") + message);
  browser_->send("hello");
  EXPECT_EQ(fault(browser_->receive(patience())), "received: three");
  EXPECT_EQ(file("heard"), std::string("hello\0", 6));
}

TEST_F(ABrowser, takes_messages_that_are_larger_than_a_pipe_both_ways_at_once) {
  start(R"(head -c 3000000 /dev/zero | tr '\0' a >&4; printf '\0' >&4; head -c 2000001 <&3 | wc -c > count
    printf 'done\0' >&4; sleep 600)");
  browser_->send(std::string(2000000, 'b'));
  const Result<std::string> large = browser_->receive(patience());
  ASSERT_TRUE(large) << large.error().text;
  EXPECT_EQ(large->size(), 3000000u);
  EXPECT_EQ(fault(browser_->receive(patience())), "received: done");
  EXPECT_EQ(std::stoi(file("count")), 2000001);
}

TEST_F(ABrowser, that_ends_early_is_told_with_its_exit_code) {
  start("exit 7");
  EXPECT_EQ(fault(browser_->receive(patience())), "ended with exit code 7");
}

TEST_F(ABrowser, that_is_killed_is_told_with_the_signal) {
  start("kill -9 $$");
  EXPECT_EQ(fault(browser_->receive(patience())), "ended by signal 9");
}

TEST_F(ABrowser, that_says_nothing_is_waited_for_no_longer_than_wanted) {
  start("exec sleep 600");
  EXPECT_EQ(fault(browser_->receive(Browser::Deadline())), "does not answer in time");
}

TEST_F(ABrowser, that_is_waited_for_is_left_when_a_signal_comes) {
  start("exec sleep 600");
  std::raise(SIGINT);
  EXPECT_EQ(fault(browser_->receive(patience())), "was interrupted");
}

TEST_F(ABrowser, that_is_no_program_does_not_start) {
  std::ofstream(folder_ / "browser") << "#!/no/such/shell\n";
  std::filesystem::permissions(folder_ / "browser", std::filesystem::perms::owner_all);
  const Result<void> started = browser_->start(folder_ / "browser");
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().text, HasSubstr("does not start: "));
}

TEST_F(ABrowser, leaves_neither_processes_nor_files_behind) {
  ASSERT_EQ(::mkfifo((folder_ / "held").c_str(), 0600), 0);
  const int held = ::open((folder_ / "held").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  start(R"(for word in "$@"; do case "$word" in --user-data-dir=*) folder="${word#*=}";; esac; done
    mkdir -p "$folder" && echo much > "$folder/cache" && echo "$folder" > profile && echo "$TMPDIR" > temporary
    exec 5> held; sleep 600 & printf 'ready\0' >&4; exec sleep 600)");
  EXPECT_EQ(fault(browser_->receive(patience())), "received: ready");
  const std::filesystem::path profile = file("profile").substr(0, file("profile").size() - 1);
  EXPECT_TRUE(std::filesystem::exists(profile / "cache"));
  EXPECT_EQ(profile.parent_path().string() + "\n", file("temporary"));
  browser_.reset();
  EXPECT_FALSE(std::filesystem::exists(profile.parent_path()));
  pollfd ended{held, POLLIN, 0};
  EXPECT_EQ(::poll(&ended, 1, 60000), 1);
  EXPECT_TRUE(ended.revents & POLLHUP) << "a process still holds the pipe";
  ::close(held);
}

TEST_F(ABrowser, prints_into_nothing) {
  start(R"(all=; for k in 0 1 2; do all="$all$(readlink /proc/$$/fd/$k) "; done; echo "$all" > streams
    printf 'ready\0' >&4; exec sleep 600)");
  EXPECT_EQ(fault(browser_->receive(patience())), "received: ready");
  EXPECT_EQ(file("streams"), "/dev/null /dev/null /dev/null \n");
}

TEST_F(ABrowser, answers_calls_between_events_and_answers_to_what_was_only_told) {
  start(R"(printf '{"id":1,"result":{}}\0{"method":"Page.loaded","params":{"at":5}}\0' >&4
    printf '{"id":2,"result":{"name":"page"}}\0{"id":3,"error":{"message":"no such method"}}\0' >&4; sleep 600)");
  DevTools tools(*browser_);
  std::vector<std::string> heard;
  tools.on_events([&](std::string_view event, const boost::json::object& about) {
    heard.push_back(std::string(event) + boost::json::serialize(about));
  });
  tools.tell("Fetch.fulfillRequest", {});
  EXPECT_EQ(fault(tools.call("Target.createTarget", {{"url", "about:blank"}}, kLong)),
            R"(answered: {"name":"page"})");
  EXPECT_THAT(heard, testing::ElementsAre(R"(Page.loaded{"at":5})"));
  EXPECT_EQ(fault(tools.call("Page.fly", {}, kLong)), "refuses Page.fly: no such method");
}

TEST_F(ABrowser, whose_page_throws_is_told_with_the_first_line_of_that) {
  start(
      R"(printf '{"id":1,"result":{"exceptionDetails":{"text":"Uncaught","exception":{"description":"Error: too large\\n  at draw"}}}}\0' >&4
    printf '{"id":2,"result":{"result":{"type":"string","value":"png"}}}\0' >&4; sleep 600)");
  DevTools tools(*browser_);
  const Result<boost::json::value> thrown = tools.evaluate("draw()", kLong);
  ASSERT_FALSE(thrown);
  EXPECT_EQ(thrown.error().text, "cannot draw it: too large");
  const Result<boost::json::value> drawn = tools.evaluate("draw()", kLong);
  ASSERT_TRUE(drawn) << drawn.error().text;
  EXPECT_EQ(*drawn, "png");
}

TEST_F(ABrowser, whose_page_crashes_is_not_waited_for) {
  start(R"(printf '{"method":"Inspector.targetCrashed","params":{}}\0' >&4; sleep 600)");
  EXPECT_EQ(call_fault(), "lost its page: it crashed");
}

TEST_F(ABrowser, that_sends_what_is_no_message_is_told_with_that) {
  start(R"(printf '{"id":1,\0' >&4; sleep 600)");
  EXPECT_EQ(call_fault(), R"(sent an invalid message: "{"id":1,")");
}

TEST_F(ABrowser, that_sends_another_kind_of_json_is_told_too) {
  start(R"(printf '[1]\0' >&4; sleep 600)");
  EXPECT_EQ(call_fault(), R"(sent an invalid message: "[1]")");
}

TEST_F(ABrowser, that_never_answers_a_call_is_given_up) {
  start(R"(printf '{"id":99,"result":{}}\0' >&4; sleep 600)");
  EXPECT_EQ(call_fault(0.05), "does not answer in time");
}

TEST(FindProgram, takes_the_first_name_that_is_a_program_in_a_folder_of_the_path) {
  const TestFolder folder;
  for (const char* const place : {"a", "b"}) std::filesystem::create_directory(folder / place);
  std::filesystem::create_directory(folder / "a/chrome");  // a folder is none
  std::ofstream(folder / "a/chromium") << "no program";
  for (const char* const name : {"b/chrome", "b/other"}) {
    std::ofstream(folder / name) << "#!/bin/sh\n";
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
  }
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (folder / "a:" + (folder / "b") + ":").c_str(), 1);
  constexpr const char* kThere[] = {"chromium", "chrome", "other"};
  constexpr const char* kNotThere[] = {"chromium"};
  EXPECT_EQ(find_program(kThere), folder / "b/chrome");
  EXPECT_EQ(find_program(kNotThere), std::nullopt);
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace playhouse::app
