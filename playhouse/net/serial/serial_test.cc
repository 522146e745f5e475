#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "playhouse/base/testing_folder.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/net/simulated.h"
#include "playhouse/net/testing_bytes.h"

namespace playhouse::net {
namespace {

struct SerialLog final : SerialEvents {
  std::unique_ptr<SerialLine> line;
  std::string bytes, end;
  void open(Result<std::unique_ptr<SerialLine>> opened) {
    ASSERT_TRUE(opened) << opened.error().line();
    line = std::move(*opened);
    line->start(*this);
  }
  void send(const std::string& text) { line->send(std::as_bytes(std::span(text))); }
  void received(std::span<const std::byte> part) override { bytes += text(part); }
  void ended(const std::string& why) override { end = why; }
};

class Terminal : public ::testing::Test {
 protected:
  /// True once it is; the loop sees to what is ready meanwhile.
  template <typename Condition>
  bool comes(const Condition& is_so) {
    for (int turn = 0; turn < 100000 && !is_so(); ++turn) loop_.poll();
    return is_so();
  }
  std::string at(const char* name) const { return folder_.path() / name; }

  TestFolder folder_;
  IoLoop loop_;
};

TEST_F(Terminal, a_port_and_the_terminal_it_leads_to_carry_bytes_both_ways) {
  SerialLog robot, host;
  robot.open(loop_.open_terminal(at("robot"), {}));
  host.open(loop_.open_serial(at("robot"), {.baud = 38400, .parity = SerialParity::kNone, .stop_bits = 2}));
  std::string every_byte;
  for (int value = 0; value < 256; ++value) every_byte += static_cast<char>(value);
  host.send(every_byte);
  robot.send(every_byte + every_byte);
  EXPECT_TRUE(comes([&] { return robot.bytes.size() == 256 && host.bytes.size() == 512; }));
  EXPECT_EQ(robot.bytes, every_byte) << "none of them is taken for a command of a terminal";
  EXPECT_EQ(host.bytes, every_byte + every_byte);
  EXPECT_EQ(robot.line->settings(), host.line->settings());
  ASSERT_TRUE(host.line->set({.baud = 500000}));  // that no constant of termios.h is for
  EXPECT_EQ(robot.line->settings().baud, 500000);
}

TEST_F(Terminal, a_port_belongs_to_one_and_can_be_opened_again) {
  SerialLog robot, host;
  robot.open(loop_.open_terminal(at("robot"), {}));
  host.open(loop_.open_serial(at("robot"), {}));
  EXPECT_EQ(loop_.open_serial(at("robot"), {}).error().line(),
            at("robot") + ": is in use by another program");
  host.line.reset();
  robot.send("lost");
  host.open(loop_.open_serial(at("robot"), {}));
  robot.send("heard");
  EXPECT_TRUE(comes([&] { return !host.bytes.empty(); }));
  EXPECT_EQ(host.bytes, "heard");
}

TEST_F(Terminal, nobody_who_reads_holds_up_the_newer_bytes) {
  SerialLog robot, host;
  robot.open(loop_.open_terminal(at("robot"), {}));
  host.open(loop_.open_serial(at("robot"), {}));
  const std::string old(1000, 'o');
  for (int k = 0; k < 100; ++k) robot.send(old);
  robot.send("new");
  EXPECT_TRUE(comes([&] { return host.bytes.ends_with("new"); }));
}

TEST_F(Terminal, a_link_goes_with_its_terminal_and_no_file_is_replaced) {
  SerialLog robot;
  std::filesystem::create_symlink("/dev/pts/99999", at("robot"));  // that a killed program left
  robot.open(loop_.open_terminal(at("robot"), {}));
  EXPECT_EQ(loop_.open_terminal(at("robot"), {}).error().line(),
            at("robot") + ": cannot be made: File exists");
  robot.line.reset();
  EXPECT_FALSE(std::filesystem::is_symlink(at("robot")));
  std::ofstream(at("notes")) << "text";
  EXPECT_EQ(loop_.open_terminal(at("notes"), {}).error().line(),
            at("notes") + ": cannot be made: File exists");
  EXPECT_EQ(loop_.open_serial(at("notes"), {}).error().line(), at("notes") + ": is no serial port");
  EXPECT_EQ(loop_.open_serial(at("none"), {}).error().line(),
            at("none") + ": cannot be opened: No such file or directory");
}

TEST_F(Terminal, a_port_ends_when_its_device_goes) {
  SerialLog robot, host;
  robot.open(loop_.open_terminal(at("robot"), {}));
  host.open(loop_.open_serial(at("robot"), {}));
  robot.line.reset();
  EXPECT_TRUE(comes([&] { return !host.end.empty(); }));
}

struct Cable : ::testing::Test {
  SimulatedNetwork network{7};
  SerialLog robot, host;
  void SetUp() override {
    robot.open(network.open_terminal("/dev/robot", {}));
    host.open(network.open_serial("/dev/robot", {}));
  }
};

TEST_F(Cable, bytes_take_ten_bits_each) {
  host.send(std::string(96, 'a'));
  network.run_for(0.099);
  EXPECT_LT(robot.bytes.size(), 96u);
  network.run_for(0.002);
  EXPECT_EQ(robot.bytes, std::string(96, 'a'));
}

TEST_F(Cable, other_speeds_make_other_bytes) {
  ASSERT_TRUE(host.line->set({.baud = 19200}));
  host.send(std::string(100, 'a'));
  network.run_for(1);
  EXPECT_EQ(robot.bytes.size(), 100u);
  EXPECT_LT(std::ranges::count(robot.bytes, 'a'), 10);
}

TEST_F(Cable, some_bytes_are_lost_and_some_changed) {
  network.serial().faults = {.loss = 0.1, .change = 0.1};
  host.send(std::string(1000, 'a'));
  network.run_for(2);
  EXPECT_NEAR(static_cast<double>(robot.bytes.size()), 900, 50);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(robot.bytes, 'a')), 810, 50);
}

TEST_F(Cable, a_pulled_plug_ends_the_port_alone) {
  network.serial().unplug("/dev/robot");
  network.run_for(0);
  EXPECT_EQ(host.end, "is gone");
  host.line.reset();
  EXPECT_FALSE(network.open_serial("/dev/robot", {}));
  network.serial().plug("/dev/robot");
  host.open(network.open_serial("/dev/robot", {}));
  host.send("again");
  network.run_for(1);
  EXPECT_EQ(robot.bytes, "again");
}

}  // namespace
}  // namespace playhouse::net
