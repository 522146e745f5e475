// A driver of aio:0 and opaque:0 over another opaque, for plugin_test.cc. What a person sees of it are the bytes
// that it publishes.

#include <stdexcept>
#include <string>

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

class Probe : public pd::Plugin {
  void configure(const pd::PluginSection& section) override {
    fault_ = section.text("fault", "");
    if (fault_ == "rejects") throw std::invalid_argument("there is\nno port");
    const std::size_t of_command = fault_ == "device" ? 7 : kAio;
    on_command<aio::Cmd>(of_command, fault_ == "subtype" ? 9 : aio::kCmdState,
                         [this](const aio::Cmd& set) { take(set.voltage); });
    on_request<op::Data>(kOwn, op::kReqData, [](const op::Data& asked, pd::PluginReply reply) {
      if (!asked.data.empty()) reply.ack(asked);
    });
    if (!uses().empty())
      on_data<op::Data>(kOther, op::kDataState, [this](const op::Data& seen, double) {
        publish(kOwn, op::kDataState, op::Data{{seen.data.rbegin(), seen.data.rend()}});
      });
    step_every(section.number("period", 0));
  }

  void take(float voltage) {
    if (fault_ == "throws") throw std::runtime_error("it is\nburnt");
    publish(kAio, aio::kDataState, aio::Data{{voltage}}, 12.5);
  }
  void open() override { say("open"); }
  void close() override {
    if (!uses().empty()) command(kOther, op::kCmdData, bytes_of("stop"));
  }
  void step() override { say("step"); }
  void say(const std::string& text) { publish(kOwn, op::kDataState, bytes_of(text)); }

  std::string fault_;
};

}  // namespace

PLAYHOUSE_DRIVER(Probe)
