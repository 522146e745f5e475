#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <string>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/commands/keyboard.h"
#include "playhouse/app/discovery/found_servers.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/base/fail.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse_client/client.h"

namespace playhouse::app {
namespace {

namespace p2d = wire::position2d;

constexpr double kStepForward = 0.1;                 // m/s per key
constexpr double kStepTurn = std::numbers::pi / 12;  // rad/s per key
constexpr double kScaleStep = 1.25;                  // factor per + or -
constexpr int kKeyPatience = 50;                     // ms

/// State of the controls.
struct Wheel {
  double forward = 0, turn = 0;  // m/s, rad/s
  double scale = 1;

  void press(Key key) {
    switch (key) {
      case Key::kForward:
        forward += kStepForward * scale;
        break;
      case Key::kBackward:
        forward -= kStepForward * scale;
        break;
      case Key::kLeft:
        turn += kStepTurn * scale;
        break;
      case Key::kRight:
        turn -= kStepTurn * scale;
        break;
      case Key::kStop:
        forward = turn = 0;
        break;
      case Key::kFaster:
        change_scale(kScaleStep);
        break;
      case Key::kSlower:
        change_scale(1 / kScaleStep);
        break;
      case Key::kQuit:
      case Key::kOther:
        break;
    }
  }
  void change_scale(double factor) {
    scale *= factor;
    forward *= factor;
    turn *= factor;
  }
};

Result<void> send(client::Device& robot, const Wheel& wheel) {
  return robot.command(p2d::kCmdVel, p2d::CmdVel{{wheel.forward, 0, wheel.turn}, 1});
}

/// Unlike fmt::print it does not throw: a lost terminal must not leave the robot driving.
void say(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void show(const client::Device& robot, const Wheel& wheel) {
  const auto state = robot.latest<p2d::Data>(p2d::kDataState);
  if (!state) return;
  say(fmt::format("\r{:+.2f} m/s {:+.2f} rad/s   at {:.2f} {:.2f} {:.2f}{}   ", wheel.forward, wheel.turn,
                  state->pos.px, state->pos.py, state->pos.pa,
                  state->stall != 0 ? "  blocked" : "         "));
}

Result<void> drive_by_keys(client::Client& client, client::Device& robot, const Interrupt& interrupt) {
  Keyboard keyboard;
  const bool shows = isatty(STDOUT_FILENO) == 1;
  Wheel wheel;
  while (interrupt.signal() == 0) {
    if (const std::optional<Key> key = keyboard.wait(kKeyPatience)) {
      if (*key == Key::kQuit) break;
      wheel.press(*key);
      if (const Result<void> sent = send(robot, wheel); !sent) return sent.error();
    }
    if (const Result<std::size_t> read = client.read(client::Seconds(0)); !read && interrupt.signal() == 0) {
      return read.error();
    }
    if (shows) show(robot, wheel);
  }
  return send(robot, Wheel{});
}

bool drives(std::uint16_t interf) {
  return interf == p2d::kCode;
}

}  // namespace

int drive(const DriveOptions& options) {
  const bool is_robot_alone = options.device.empty();
  const Result<DeviceArgument> wanted =
      is_robot_alone ? DeviceArgument{{}, options.server} : parse_wanted_device(options.device);
  if (!wanted) return fail(wanted.error(), kUsage);
  if (wanted->address && !drives(wanted->address->interf))
    return fail({"", "drive needs a position2d device or a robot's name"}, kUsage);
  const Result<NamedServer> server =
      is_robot_alone ? server_of_robot(options.server) : reach_server(options.server);
  if (!server) return fail(server.error(), kUsage);
  Result<client::Client> client = client::Client::connect(
      server->address.host, server->address.port, {.mode = client::Mode::kPush, .token = options.token});
  if (!client) return fail(server->explain(client.error()));
  const Result<DeviceName> name = find_device(*client, *wanted, &drives);
  if (!name) return fail(name.error());
  Result<client::Device> robot = client::Device::open(*client, name->interf, name->index);
  if (!robot)
    return fail({robot.error().where, robot.error().text + "; playhouse devices lists what there is"});
  const Interrupt interrupt;  // the robot has to be stopped from here on
  say("w a s d or arrows drive, space stops, + and - change the speed, q ends\n");
  if (const Result<void> done = drive_by_keys(*client, *robot, interrupt); !done) return fail(done.error());
  say("\n");
  return interrupt.exit_code(kDone);
}

}  // namespace playhouse::app
