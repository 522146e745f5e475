// What a program sees of devices that the real server retires: the server of
// clients/tests/retiring_server.cc.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "fake_server.h"

namespace playhouse_c {
namespace {

constexpr double kLong = 30.0;  // an answer is not waited for: it comes, or something hangs

/// The program, with pipes to and from it.
class RetiringServer {
 public:
  RetiringServer() {
    const char *program = std::getenv("PLAYHOUSE_RETIRING_SERVER");
    if (program == nullptr) throw std::runtime_error("PLAYHOUSE_RETIRING_SERVER names no program");
    int to[2], from[2];
    if (pipe(to) != 0 || pipe(from) != 0) throw std::runtime_error("no pipes");
    child_ = fork();
    if (child_ == 0) {
      dup2(to[0], 0);
      dup2(from[1], 1);
      for (const int fd : {to[0], to[1], from[0], from[1]}) close(fd);
      execl(program, program, static_cast<char *>(nullptr));
      _exit(127);
    }
    close(to[0]);
    close(from[1]);
    to_ = fdopen(to[1], "w");
    from_ = fdopen(from[0], "r");
    address_ = line();
  }
  ~RetiringServer() {
    std::fclose(to_);
    waitpid(child_, nullptr, 0);
    std::fclose(from_);
  }

  const std::string &address() const { return address_; }
  void tell(std::initializer_list<const char *> words) {
    for (const char *each : words) {
      std::fprintf(to_, "%s\n", each);
      std::fflush(to_);
      ASSERT_EQ(line(), "done");
    }
  }

 private:
  std::string line() {
    char text[256] = "";
    const std::string read = std::fgets(text, sizeof text, from_) != nullptr ? text : "";
    return read.substr(0, read.find('\n'));
  }

  pid_t child_ = 0;
  std::FILE *to_ = nullptr, *from_ = nullptr;
  std::string address_;
};

class RetiringDevice : public ::testing::Test {
 protected:
  RetiringDevice() { server_.tell({"add 0", "add 3"}); }
  Client connect(ph_mode mode) { return connected(server_.address(), mode, kLong); }
  ph_position2d *open(const Client &client, int index) {
    ph_error error = {PH_OK, ""};
    ph_position2d *robot = ph_position2d_open(client.get(), index, PH_ACCESS_ALL, &error);
    EXPECT_NE(robot, nullptr) << error.text;
    return robot;
  }
  std::string told() const {
    return server_.address().substr(server_.address().find(':') + 1) +
           ":position2d:3 is gone: the server retired it";
  }
  RetiringServer server_;
};

class RetiredDevice : public RetiringDevice, public ::testing::WithParamInterface<ph_mode> {};

INSTANTIATE_TEST_SUITE_P(, RetiredDevice, ::testing::Values(PH_MODE_PUSH, PH_MODE_PULL));

TEST_P(RetiredDevice, ItGivesItsLastDataAndFailsAtOnceFromThenOn) {
  const Client client = connect(GetParam());
  ph_position2d *gone = open(client, 3), *other = open(client, 0);
  server_.tell({"publish 3 1", "retire 3", "publish 0 2"});
  while (!ph_device_gone(ph_position2d_device(gone)) || !ph_device_has_data(ph_position2d_device(other))) {
    ASSERT_EQ(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, nullptr), PH_OK);
  }
  ph_state state{};
  ph_geometry geometry;
  EXPECT_WORKS(ph_position2d_state(gone, &state, &error));
  EXPECT_EQ(state.pose.x, 1.0);
  EXPECT_WORKS(ph_position2d_next_data(gone, PH_OWN_TIMEOUT, &error));  // its last
  EXPECT_FAILS(ph_position2d_drive(gone, 1, 0, 0, &error), PH_DEVICE_GONE, told());
  EXPECT_FAILS(ph_position2d_geometry(gone, &geometry, &error), PH_DEVICE_GONE, told());
  EXPECT_FAILS(ph_position2d_next_data(gone, PH_OWN_TIMEOUT, &error), PH_DEVICE_GONE, told());
  EXPECT_WORKS(ph_position2d_close(gone, &error));
  EXPECT_FALSE(ph_device_is_open(ph_position2d_device(gone)));
  EXPECT_WORKS(ph_position2d_geometry(other, &geometry, &error));
}

TEST_P(RetiredDevice, WaitingForItsDataDoesNotWait) {
  const Client client = connect(GetParam());
  ph_position2d *gone = open(client, 3);
  server_.tell({"retire 3"});
  EXPECT_FAILS(ph_position2d_next_data(gone, PH_OWN_TIMEOUT, &error), PH_DEVICE_GONE, told());
  EXPECT_TRUE(ph_client_connected(client.get()));
}

TEST_P(RetiredDevice, ItLeavesItsAddressToAnotherAndDoesNotBecomeIt) {
  const Client client = connect(GetParam());
  ph_position2d *gone = open(client, 3);
  server_.tell({"publish 3 1", "retire 3", "add 3"});
  ph_position2d *following = open(client, 3);
  EXPECT_TRUE(ph_device_gone(ph_position2d_device(gone)));
  server_.tell({"publish 3 2"});
  while (!ph_device_has_data(ph_position2d_device(following))) {
    ASSERT_EQ(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, nullptr), PH_OK);
  }
  ph_state state{};
  EXPECT_WORKS(ph_position2d_state(following, &state, &error));
  EXPECT_EQ(state.pose.x, 2.0);
  EXPECT_FALSE(ph_device_gone(ph_position2d_device(following)));
  EXPECT_FALSE(ph_position2d_state(gone, &state, nullptr) == PH_OK && state.pose.x == 2.0);
  ph_position2d_free(gone);
  ph_geometry geometry;
  EXPECT_WORKS(ph_position2d_geometry(following, &geometry, &error));
}

TEST_F(RetiringDevice, ARequestBeforeItIsToldIsRefused) {
  const Client client = connect(PH_MODE_PULL);
  ph_position2d *gone = open(client, 3);
  server_.tell({"retire 3"});
  ph_geometry geometry;
  EXPECT_FAILS(ph_position2d_geometry(gone, &geometry, &error), PH_REQUEST_REFUSED, "was refused");
  ASSERT_EQ(ph_client_read(client.get(), PH_OWN_TIMEOUT, nullptr, nullptr), PH_OK);
  EXPECT_FAILS(ph_position2d_geometry(gone, &geometry, &error), PH_DEVICE_GONE, told());
}

}  // namespace
}  // namespace playhouse_c
