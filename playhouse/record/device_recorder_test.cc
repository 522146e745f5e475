// Data of devices as an MCAP file, read back by the reader; the truth of the format is that of its own library
// (web/e2e/devices.test.mjs).

#include "playhouse/record/device_recorder.h"

#include <gtest/gtest.h>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::record {
namespace {

constexpr device::DeviceId kWheels{1}, kLaser{2}, kUnknown{3};
constexpr double kNow = 1000.25;  // s, Unix time

/// Counts what it gets.
struct Counting final : device::Publisher {
  void publish(std::vector<device::Publication> batch) override { count += batch.size(); }
  void forget() override { ++forgets; }
  std::size_t count = 0;
  int forgets = 0;
};

/// Keeps all records; a write waits until the test lets it.
class HeldSink final : public RecordSink {
 public:
  explicit HeldSink(Bytes& kept) : kept_(kept) {}
  void add(std::span<const std::byte> records) override {
    kept_.insert(kept_.end(), records.begin(), records.end());
  }
  std::size_t waiting() const override { return 0; }
  Result<void> flush() override { return {}; }
  Result<void> attach(const Attachment&) override { return {}; }
  Result<void> finish() override { return {}; }

 private:
  Bytes& kept_;
};

std::vector<device::Publication> one(device::DeviceId device, std::uint8_t subtype, Bytes body) {
  std::vector<device::Publication> batch;
  batch.push_back({device, subtype, 1.5, std::move(body)});
  return batch;
}

class DeviceRecorderTest : public ::testing::Test {
 protected:
  std::unique_ptr<DeviceRecorder> recorder(std::size_t most_bytes = limits::kRecordQueueBytes) {
    file_ = std::make_unique<RecordThread>(std::make_unique<HeldSink>(kept_));
    auto made = std::make_unique<DeviceRecorder>(
        *file_, next_, [] { return kNow; }, most_bytes);
    made->add(kWheels, {6665, wire::position2d::kCode, 0});
    made->add(kLaser, {6665, wire::laser::kCode, 3});
    return made;
  }
  void end(DeviceRecorder& recorder) {
    recorder.finish();
    EXPECT_TRUE(file_->finish());
  }
  /// The records as text, for searches.
  std::string text() const { return {reinterpret_cast<const char*>(kept_.data()), kept_.size()}; }

  Bytes kept_;
  Counting next_;
  std::unique_ptr<RecordThread> file_;
};

TEST_F(DeviceRecorderTest, each_kind_of_message_has_a_channel_with_a_schema) {
  const auto recording = recorder();
  wire::position2d::Data state;
  state.pos.px = 2.5;
  recording->publish(one(kWheels, wire::position2d::kDataState, wire::encode(state)));
  recording->publish(one(kWheels, wire::position2d::kDataState, wire::encode(state)));
  wire::laser::Data scan;
  scan.ranges = {1, 2, 3};
  recording->publish(one(kLaser, wire::laser::kDataScan, wire::encode(scan)));
  recording->publish(one(kUnknown, wire::laser::kDataScan, wire::encode(scan)));
  end(*recording);
  const std::string said = text();
  EXPECT_NE(said.find("/6665/position2d/0/state"), std::string::npos);
  EXPECT_EQ(said.find("/6665/position2d/0/state"), said.rfind("/6665/position2d/0/state")) << "one channel";
  EXPECT_NE(said.find("/6665/laser/3/scan"), std::string::npos);
  EXPECT_NE(said.find(R"("ranges":{"type":"array","items":{"type":"number"}})"), std::string::npos);
  EXPECT_NE(said.find(R"({"pos":{"px":2.5,)"), std::string::npos);
  EXPECT_EQ(recording->status().messages, 3u);
  EXPECT_EQ(next_.count, 4u) << "all data go on";
}

TEST_F(DeviceRecorderTest, a_message_that_is_no_valid_one_is_left_out) {
  const auto recording = recorder();
  recording->publish(one(kWheels, wire::position2d::kDataState, Bytes(3)));
  recording->publish(one(kWheels, 200, Bytes(3)));
  end(*recording);
  EXPECT_EQ(recording->status().messages, 0u);
  EXPECT_EQ(next_.count, 2u);
}

TEST_F(DeviceRecorderTest, a_full_queue_holds_nobody_up_and_is_counted) {
  const auto recording = recorder(1);
  std::vector<device::Publication> batch;
  for (int k = 0; k < 10; ++k)
    batch.push_back({kWheels, wire::position2d::kDataState, 1.0 * k, wire::encode(wire::position2d::Data{})});
  recording->publish(std::move(batch));
  end(*recording);
  EXPECT_EQ(recording->status().dropped, 9u);
  EXPECT_EQ(recording->status().messages, 1u);
  EXPECT_EQ(next_.count, 10u);
}

TEST_F(DeviceRecorderTest, what_is_void_is_told_on_and_nothing_is_recorded_after_the_end) {
  const auto recording = recorder();
  recording->forget();
  end(*recording);
  recording->publish(one(kWheels, wire::position2d::kDataState, wire::encode(wire::position2d::Data{})));
  EXPECT_EQ(next_.forgets, 1);
  EXPECT_EQ(next_.count, 1u);
  EXPECT_EQ(recording->status().messages, 0u);
}

}  // namespace
}  // namespace playhouse::record
