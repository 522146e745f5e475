// What many open devices publish, for any number of workers. Out of scope here: what each message says
// (devices_test.cc).

#include "playhouse/bridge/simulated/sources.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/simulated/auto_map.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

/// Robots that publish under six interfaces, at two intervals.
std::string world_of(int robots) {
  std::string text = "interval_sim 100\n";
  for (int k = 0; k < robots; ++k)
    text += fmt::format(R"(
position( name "r{}" pose [{} 1 0 {}] update_interval {} joules 100
  ranger( sensor( samples 30 fov 180 ) )
  ranger( sensor( pose [0.1 0 0 0] ) sensor( pose [0 0.1 0 90] ) )
  fiducial() gripper() )
)",
                        k, k, k % 360, 100 + 100 * (k % 2));
  return text;
}

using Message = std::tuple<std::uint32_t, std::uint8_t, double, std::vector<std::byte>>;

/// All devices of a world, open.
class AllOpen {
 public:
  AllOpen(const std::string& world, unsigned workers)
      : still_(world, workers), driver_(still_.devices, "stage") {
    world::Sensors& sensors = still_.world().sensors;
    for (const world::BeamRow beam : sensors.ranges.rows())
      sensors.ranges[beam] = static_cast<float>(beam.index % 977) / 128;
    const std::vector<MappedDevice> devices = AutoMap().of_world(still_.world());
    // In another order than that of the models.
    for (std::size_t i = 0; i < devices.size(); ++i) {
      const device::DeviceId id{static_cast<std::uint32_t>(i * 7 % devices.size())};
      const MappedDevice& mapped = devices[id.row];
      driver_.add(id, make_device(still_.devices, mapped.interf, mapped.model));
      EXPECT_TRUE(driver_.start(id));
      if (i % 500 == 0) still_.run(0);  // before the inbox is full
    }
    still_.run(0);
    count_ = devices.size();
  }
  std::size_t open() { return still_.devices.sources().size(); }
  void close_every_third() {
    for (std::uint32_t row = 0; row < count_; row += 3) driver_.stop({row});
  }
  void run(int ticks) { still_.run(ticks); }
  int batches() const { return still_.recorder.batches; }
  std::vector<Message> published() const {
    std::vector<Message> all;
    for (const device::Publication& each : still_.recorder.published)
      all.emplace_back(each.device.row, each.subtype, each.timestamp, each.body);
    return all;
  }

 private:
  testing::StillDevices still_;
  SimulatedDriver driver_;
  std::size_t count_ = 0;
};

TEST(Sources, of_many_devices_give_the_same_batch_for_any_number_of_workers) {
  const std::string world = world_of(200);
  std::vector<Message> expected;
  for (const unsigned workers : {1u, 2u, 4u}) {
    AllOpen devices(world, workers);
    ASSERT_GT(devices.open(), 1500u);
    devices.run(3);
    devices.close_every_third();
    devices.run(3);
    EXPECT_EQ(devices.batches(), 6) << "one a tick";
    if (workers == 1) expected = devices.published();
    ASSERT_GT(expected.size(), 6000u);
    EXPECT_TRUE(devices.published() == expected) << workers;
  }
}

/// Says its number, in ticks that it divides.
struct Number final : DataSource {
  explicit Number(std::uint32_t number) : number(number) {}
  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (world.tick() % number == 0) out.push_back({{number}, 0, world.time(), {}});
  }
  std::uint32_t number;
};

TEST(Sources, come_in_the_order_in_which_they_were_added_behind_what_is_there) {
  const scene::SceneDesc scene = run::testing::scene_of("interval_sim 100\n");
  run::testing::StillEngine engine(scene, 3);
  Sources sources;
  std::vector<std::shared_ptr<Number>> numbers;
  for (std::uint32_t number = 1000; number > 0; --number) {
    numbers.push_back(std::make_shared<Number>(number));
    sources.add(numbers.back());
  }
  std::vector<device::Publication> batch;
  const auto emit = [&] {
    for (std::size_t range = sources.ranges(); range > 0; --range)
      sources.emit_range(engine.world(), range - 1);
    sources.join(batch);
  };
  const auto rows = [&] {
    std::vector<std::uint32_t> found;
    for (const device::Publication& each : std::exchange(batch, {})) found.push_back(each.device.row);
    return found;
  };
  for (int k = 0; k < 600; ++k) engine.step();
  batch.push_back({{7777}, 0, 0, {}});
  emit();
  EXPECT_THAT(rows(), ElementsAreArray({7777, 600, 300, 200, 150, 120, 100, 75, 60, 50, 40, 30, 25,
                                        24,   20,  15,  12,  10,  8,   6,   5,  4,  3,  2,  1}));
  emit();
  EXPECT_EQ(rows().size(), 24u) << "nothing is left of the last call";
  for (const std::shared_ptr<Number>& number : numbers) sources.remove(*number);
  emit();
  EXPECT_THAT(rows(), IsEmpty());
}

}  // namespace
}  // namespace playhouse::drivers
