#pragma once

/// One device of a still world, open, with a driver in front of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers::testing {

class OneDevice : public ::testing::Test {
 protected:
  explicit OneDevice(const std::string& world) : still_(world), driver_(still_.devices, "stage") {}

  void open(std::uint16_t interf, const char* model) {
    const world::ModelRow row =
        interf == wire::simulation::kCode ? world::ModelRow{} : still_.world().find(model);
    driver_.add(kId, make_device(still_.devices, interf, row));
    ASSERT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  /// The last client closes it, and another one opens it.
  void reopen() {
    driver_.stop(kId);
    ASSERT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  template <typename Payload>
  void command(std::uint8_t subtype, const Payload& payload) {
    const std::vector<std::byte> body = wire::encode(payload);
    EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(wire::MessageType::kCmd), subtype, body}),
              device::Taken::kLatest);
    still_.run(0);
  }
  /// The answer to a request, which must have come by the next moment between ticks.
  OutputRecorder::RecordedAnswer ask(std::uint8_t subtype, std::span<const std::byte> body = {}) {
    driver_.request({kId, static_cast<std::uint8_t>(wire::MessageType::kReq), subtype, body},
                    device::Replier(still_.recorder, ++ticket_));
    still_.run(0);
    EXPECT_TRUE(still_.recorder.answers.contains(ticket_));
    return still_.recorder.answers[ticket_];
  }
  template <typename Payload>
  OutputRecorder::RecordedAnswer ask_with(std::uint8_t subtype, const Payload& payload) {
    return ask(subtype, wire::encode(payload));
  }
  template <typename Reply>
  Reply reply(const OutputRecorder::RecordedAnswer& answer) {
    EXPECT_TRUE(answer.ack);
    const Result<Reply> value = wire::decode<Reply>(answer.body);
    EXPECT_TRUE(value);
    return value ? *value : Reply{};
  }
  template <typename T>
  T last(std::uint8_t subtype) {
    for (auto it = still_.recorder.published.rbegin(); it != still_.recorder.published.rend(); ++it) {
      if (it->subtype != subtype) continue;
      EXPECT_EQ(it->device, kId);
      return *wire::decode<T>(it->body);
    }
    ADD_FAILURE() << "nothing was published";
    return {};
  }
  std::ptrdiff_t count(std::uint8_t subtype) const {
    return std::ranges::count(still_.recorder.published, subtype, &device::Publication::subtype);
  }
  double number(const std::string& name) {
    return reply<wire::DblpropReq>(ask_with(wire::kReqGetDblprop, wire::DblpropReq{wire::c_string(name), 0}))
        .value;
  }
  bool set_number(const std::string& name, double value) {
    return ask_with(wire::kReqSetDblprop, wire::DblpropReq{wire::c_string(name), value}).ack;
  }
  /// Puts ranges and intensities into a ranger's sensor.
  void measure(const char* ranger, std::uint32_t sensor, std::vector<float> ranges,
               std::vector<float> intensities) {
    world::World& world = still_.world();
    const world::ModelRow model = world.find(ranger);
    const world::SensorRow row = world.rangers.first_sensor[world.models.part[model]] + sensor;
    for (std::uint32_t i = 0; i < ranges.size(); ++i) {
      world.sensors.ranges[world.sensors.first_beam[row] + i] = ranges[i];
      world.sensors.intensities[world.sensors.first_beam[row] + i] = intensities[i];
    }
  }

  static constexpr device::DeviceId kId{3};
  StillDevices still_;
  SimulatedDriver driver_;
  std::uint64_t ticket_ = 0;
};

}  // namespace playhouse::drivers::testing
