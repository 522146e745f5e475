#include "playhouse/drivers/motion/bumper_safe.h"

#include <utility>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

BumperSafe::BumperSafe(Shell& shell)
    : PositionGuard(shell), bumpers_(shell.client().queue(kBumper, kStatesKept)) {
  shell.on_request(wire::position2d::kReqMotorPower,
                   [this](const device::Message& message, device::Replier replier) {
                     const auto power = wire::decode<wire::position2d::PowerConfig>(message.body);
                     if (power && power->state != 0) {
                       const std::lock_guard lock(mutex_);
                       allowed_ = pressed_;
                     }
                     shell_.client().forward(kForwarded, message.subtype, message.body, std::move(replier));
                   });
}

void BumperSafe::opened() {
  const std::lock_guard lock(mutex_);
  pressed_.clear();
  allowed_.clear();
}

void BumperSafe::take_news(std::vector<device::Publication>& more) {
  Forwarder::take_news(more);
  for (const device::Publication& message : bumpers_.take()) {
    if (message.subtype != wire::bumper::kDataState) continue;
    Result<wire::bumper::Data> data = wire::decode<wire::bumper::Data>(message.body);
    if (data) take_bumpers(std::move(data->bumpers));
  }
  look_again();
}

void BumperSafe::take_bumpers(std::vector<std::uint8_t> pressed) {
  const std::lock_guard lock(mutex_);
  pressed_ = std::move(pressed);
  allowed_.resize(pressed_.size());
  for (std::size_t i = 0; i < pressed_.size(); ++i)
    if (pressed_[i] == 0) allowed_[i] = 0;
}

bool BumperSafe::forbids(const CommandedMotion&) const {
  for (std::size_t i = 0; i < pressed_.size(); ++i)
    if (pressed_[i] != 0 && (i >= allowed_.size() || allowed_[i] == 0)) return true;
  return false;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_bumper_safe(const config::CfgSection& section, Site& site) {
  return make_algorithm<BumperSafe>(section, site,
                                    {.provides = {{"position2d"}}, .uses = {{"position2d"}, {"bumper"}}});
}

constexpr DeviceText kBumperSafeProvides[] = {{"position2d"}};
constexpr DeviceText kBumperSafeUses[] = {{"position2d", {}, HowMany::kOne, "is the robot"},
                                          {"bumper", {}, HowMany::kOne, "is on the robot"}};

}  // namespace

constinit const DriverDefinition kBumperSafeDriver{
    .name = "bumper_safe",
    .doc =
        "Stops a robot whose bumper is pressed, and lets it drive once it is released or its motors are "
        "switched on.",
    .provides = kBumperSafeProvides,
    .uses = kBumperSafeUses,
    .make = make_bumper_safe,
};

}  // namespace playhouse::drivers
