#pragma once

/// DeviceRecorder: records the data of a server's devices, without a world: a channel for each kind of message of each
/// device, in JSON by the names of the definitions (docs/recording.md). Publishing never waits for the disk: what a
/// full queue cannot take is dropped and counted. Threads: publish(), forget() and status(): any; a thread of its own
/// converts what is published.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"
#include "playhouse/record/record_thread.h"

namespace playhouse::record {

class DeviceRecorder final : public device::Publisher {
 public:
  struct RecordingStatus {
    std::uint64_t messages = 0, bytes = 0;  // of JSON, recorded
    std::uint64_t dropped = 0;              // messages: the queue was full
  };

  /// What is published goes to `next` as well; both must outlive it. `clock` gives Unix time [s], from any thread.
  DeviceRecorder(RecordThread& file, device::Publisher& next, std::function<double()> clock,
                 std::size_t most_bytes = limits::kRecordQueueBytes);
  ~DeviceRecorder() override { finish(); }

  /// From now on the data of this device are recorded, under its address. Any thread.
  void add(device::DeviceId device, device::Address address);
  /// Hands over what is queued, and records no more.
  void finish();

  void publish(std::vector<device::Publication> batch) override;
  void forget() override { next_.forget(); }
  RecordingStatus status() const;

 private:
  struct Arrival {
    device::Address address;
    std::uint8_t subtype = 0;
    double time = 0, timestamp = 0;  // s; of arrival, and the device's
    std::vector<std::byte> body;
  };
  struct RecordedChannel {
    std::uint16_t id = 0;
    std::uint32_t sequence = 0;
  };

  void run();
  void put_message(const Arrival& heard, Bytes& out);
  /// Null at the limit on channels. `json` is the first message, whose members make the schema.
  RecordedChannel* channel_of(const Arrival& heard, const std::string& message, std::string_view json,
                              Bytes& out);

  RecordThread& file_;
  device::Publisher& next_;
  const std::function<double()> clock_;
  const std::size_t most_bytes_;

  // Of the thread.
  std::map<std::pair<device::Address, std::uint8_t>, RecordedChannel> channels_;  // by device and subtype
  std::map<std::string, std::uint16_t> schemas_;                                  // by message
  bool full_ = false;

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::map<device::DeviceId, device::Address> recorded_;
  std::vector<Arrival> waiting_;
  std::size_t waiting_bytes_ = 0;
  RecordingStatus status_;
  bool ending_ = false;

  std::thread thread_;
};

}  // namespace playhouse::record
