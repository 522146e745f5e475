#pragma once

/// A world for tests of devices: what they answer and publish is remembered.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/bridge/simulated/model_devices.h"
#include "playhouse/device/driver.h"
#include "playhouse/run/testing/still_engine.h"

namespace playhouse::drivers::testing {

/// Remembers what drivers answer and publish.
class OutputRecorder final : public device::Outlet, public device::Publisher {
 public:
  struct RecordedAnswer {
    bool ack = false;
    std::vector<std::byte> body;
  };
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override {
    answers[ticket] = {ack, std::move(body)};
  }
  void publish(std::vector<device::Publication> batch) override {
    ++batches;
    for (device::Publication& publication : batch) published.push_back(std::move(publication));
  }
  std::map<std::uint64_t, RecordedAnswer> answers;
  std::vector<device::Publication> published;
  int batches = 0;
};

/// A still world with its devices.
struct StillDevices : run::testing::StillSimulation {
  explicit StillDevices(const std::string& text, unsigned workers = 1) : StillSimulation(text, workers) {}

  OutputRecorder recorder;
  ModelDevices devices{simulation, recorder};
};

}  // namespace playhouse::drivers::testing
