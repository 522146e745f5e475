// A driver of aio:0 and opaque:0 over another opaque, for plugin_test.cc and isolated_plugin_test.cc. What a person sees of it are the bytes
// that it publishes.

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "playhouse/drivers/plugin/plugin.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/opaque.h"

namespace aio = playhouse::wire::aio;
namespace op = playhouse::wire::opaque;
namespace pd = playhouse::drivers;

namespace {

constexpr std::size_t kAio = 0, kOwn = 1, kOther = 0;

op::Data bytes_of(const std::string& text) {
  return {{text.begin(), text.end()}};
}

/// Frames of the exchange with the program (isolated/plugin_frame.h), valid each, that make no sense.
void ramble(int seed) {
  std::minstd_rand random(static_cast<unsigned>(seed) + 1);
  const auto any = [&random](unsigned less) { return static_cast<std::uint8_t>(random() % less); };
  for (int frames = 0; frames < 20; ++frames) {
    std::array<std::uint8_t, 32 + 24> frame{};
    const std::uint8_t size = any(24);
    frame[0] = size;
    frame[4] = any(18);  // kind
    frame[5] = any(2);   // flag
    frame[6] = any(4);   // subtype
    frame[8] = any(3);   // device
    frame[16] = any(3);  // number
    frame[31] = any(255);
    for (std::size_t k = 0; k < size; ++k) frame[32 + k] = any(3);
    [[maybe_unused]] const ssize_t written = write(3, frame.data(), 32u + size);
  }
}

/// Ends, and a child that has all descriptors does not, until the program has closed its socket.
void leave_child() {
  if (fork() == 0) {
    pollfd socket{3, 0, 0};
    poll(&socket, 1, -1);
    _exit(0);
  }
  std::abort();
}

/// What no driver should do.
void do_wrong(std::string_view fault) {
  if (fault == "throws") throw std::runtime_error("it is\nburnt");
  if (fault == "aborts") std::abort();
  if (fault == "leaves a child") leave_child();
  if (fault == "aborts later") std::thread([] { std::abort(); }).detach();
  if (fault == "exits") std::exit(3);
  if (fault == "blocks")
    for (;;) pause();
  if (fault == "babbles") {
    constexpr std::string_view kText = "No frame, but text, as if it had printed to a wrong descriptor.\n";
    [[maybe_unused]] const ssize_t written = write(3, kText.data(), kText.size());
  }
  if (fault.starts_with("rambles ")) ramble(std::atoi(fault.substr(8).data()));
  if (fault == "segfaults") {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer has a handler
    std::raise(SIGSEGV);
  }
}

class Probe : public pd::Plugin {
 public:
  ~Probe() override {
    if (fault_ == "stays") do_wrong("blocks");
  }

 private:
  void configure(const pd::PluginSection& section) override {
    fault_ = section.text("fault", "");
    read_ = told(section);
    if (fault_ == "rejects") throw std::invalid_argument("there is\nno port");
    const std::size_t of_command = fault_ == "device" ? 7 : kAio;
    on_command<aio::Cmd>(of_command, fault_ == "subtype" ? 9 : aio::kCmdState,
                         [this](const aio::Cmd& set) { take(set.voltage); });
    if (section.flag("passes", false)) {
      pass_on(kOwn, kOther);
    } else {
      on_request<op::Data>(kOwn, op::kReqData, [this](const op::Data& asked, pd::PluginReply reply) {
        answer(asked, std::move(reply));
      });
    }
    if (!uses().empty())
      on_data<op::Data>(kOther, op::kDataState, [this](const op::Data& seen, double) {
        publish(kOwn, op::kDataState, op::Data{{seen.data.rbegin(), seen.data.rend()}});
      });
    step_every(section.number("period", 0));
  }

  static std::string told(const pd::PluginSection& section) {
    char text[99];
    std::snprintf(text, sizeof text, "%g %g %.2f %d %d %zu %s %d %d %s %s", section.number("period", 0),
                  section.length("length", 0), section.angle("angle", 0), section.integer("absent", 7),
                  section.integer("absent", -1), section.count("words"), section.text("words", "", 1).c_str(),
                  section.flag("sure", false), section.has("absent"), section.filename("file", "").c_str(),
                  section.text("absent", "none").c_str());
    return text;
  }

  void answer(const op::Data& asked, pd::PluginReply reply) {
    const std::string text(asked.data.begin(), asked.data.end());
    if (text == "?") return reply.ack(bytes_of(read_));
    const auto shared = std::make_shared<pd::PluginReply>(std::move(reply));
    if (text.starts_with("value of "))
      ask<op::Data>(
          kOther, op::kReqData, bytes_of(text.substr(9)),
          [shared](const std::optional<op::Data>& value) { shared->ack(value ? *value : bytes_of("none")); });
    else if (text.starts_with("ack of "))
      ask(kOther, op::kReqData, bytes_of(text.substr(7)),
          [shared](bool ack) { shared->ack(bytes_of(ack ? "yes" : "no")); });
    else if (text == "nobody")
      ask(99, op::kReqData, [shared](bool ack) { shared->ack(bytes_of(ack ? "yes" : "no")); });
    else if (!text.empty())
      shared->ack(asked);
  }

  /// What is no message of its devices.
  void say_nonsense() {
    publish(99, op::kDataState, op::Data{});
    publish(kOwn, 77, op::Data{});
    publish(kOwn, op::kDataState, op::Data{}, std::nan(""));
    command(99, op::kCmdData, op::Data{});
    ask(99, op::kReqData, [](bool) {});
  }

  void take(float voltage) {
    do_wrong(fault_);
    if (fault_ == "says nonsense") say_nonsense();
    publish(kAio, aio::kDataState, aio::Data{{voltage}}, 12.5);
  }
  void open() override {
    if (fault_ == "fails to open" && ++opens_ % 2 != 0) throw std::runtime_error("there is\nno port");
    say("open");
  }
  void close() override {
    if (fault_ == "fails to open") say("close");
    if (!uses().empty()) command(kOther, op::kCmdData, bytes_of("stop"));
  }
  void step() override { say("step"); }
  void say(const std::string& text) { publish(kOwn, op::kDataState, bytes_of(text)); }

  std::string fault_, read_;
  int opens_ = 0;
};

}  // namespace

PLAYHOUSE_DRIVER(Probe)
