#include "playhouse/drivers/health/health.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
namespace health = wire::health;

constexpr const char* kMemory =
    "MemTotal:        1000 kB\nMemFree:          100 kB\nMemAvailable:     600 kB\n"
    "SwapCached:         3 kB\nSwapTotal:        200 kB\nSwapFree:         150 kB\n";

TEST(CpuTimes, are_those_of_all_processors_together) {
  const auto times = read_cpu_times("cpu  10 1 5 70 7 2 3 4 99 99\ncpu0 1 1 1 1 1 1 1 1 1 1\nintr 5\n");
  ASSERT_TRUE(times);
  EXPECT_EQ(*times, (CpuTimes{77, 14, 11}));
  EXPECT_EQ(*read_cpu_times("cpu 10 1 5 70"), (CpuTimes{70, 5, 11}));
  for (const char* text : {"", "cpu", "cpu 1 2 3", "cpu 1 2 x 4", "cpu0 1 2 3 4", "cpu -1 2 3 4"})
    EXPECT_FALSE(read_cpu_times(text)) << text;
}

TEST(MemoryLoad, counts_what_the_kernel_would_give_as_free) {
  const auto load = read_memory_load(kMemory);
  ASSERT_TRUE(load);
  EXPECT_EQ(load->memory, (health::Memory{1024000, 409600, 614400}));
  EXPECT_EQ(load->swap, (health::Memory{204800, 51200, 153600}));
  const auto old = read_memory_load("MemTotal: 1000 kB\nMemFree: 100 kB\nSwapTotal: 0 kB\nSwapFree: 0 kB\n");
  ASSERT_TRUE(old);
  EXPECT_EQ(old->memory.free, 102400);
  EXPECT_EQ(old->swap, health::Memory{});
  for (const char* text : {"", "MemTotal: 1000 kB\nMemFree: 100 kB\n",
                           "MemTotal: 1 kB\nMemFree: 2 kB\nSwapTotal: 0 kB\nSwapFree: 0 kB\n",
                           "MemTotal: 99999999999999999 kB\nMemFree: 1 kB\nSwapTotal: 0 kB\nSwapFree: 0 kB\n",
                           "MemTotal: kB\nMemFree: 1 kB\nSwapTotal: 0 kB\nSwapFree: 0 kB\n"})
    EXPECT_FALSE(read_memory_load(text)) << text;
}

TEST(CpuShares, add_up_to_all_that_passed) {
  EXPECT_EQ(*cpu_shares({100, 10, 10}, {150, 20, 50}), (health::Cpu{50, 10, 40}));
  EXPECT_EQ(*cpu_shares({100, 10, 10}, {90, 10, 11}), (health::Cpu{0, 0, 100})) << "one goes back";
  EXPECT_FALSE(cpu_shares({100, 10, 10}, {100, 10, 10}));
}

/// A machine whose files say what a test wants.
class HealthTest : public ::testing::Test {
 protected:
  HealthTest() { driver.set_device({5}); }
  void run_for(double seconds) { site.network().run_for(seconds); }
  std::size_t count() const { return site.recorder.published.size(); }
  health::Data last() const { return *wire::decode<health::Data>(site.recorder.published.back().body); }

  testing::MemorySite site{""};
  std::map<std::string, std::string> files{{"/proc/stat", "cpu 0 0 0 0"}, {"/proc/meminfo", kMemory}};
  Health driver{
      site.site(), "health", 1, [this](const std::string& path) -> Result<std::string> {
        const auto found = files.find(path);
        return found == files.end() ? Result<std::string>(Error{"", "no such file"}) : found->second;
      }};
};

TEST_F(HealthTest, tells_the_load_of_each_interval_while_it_is_open) {
  run_for(5);
  EXPECT_EQ(count(), 0u);
  ASSERT_TRUE(driver.start({5}));
  run_for(0.9);
  EXPECT_EQ(count(), 0u) << "shares are of an interval";
  files["/proc/stat"] = "cpu 10 0 15 75";
  run_for(0.2);
  ASSERT_EQ(count(), 1u);
  EXPECT_EQ(site.recorder.published.back().device, device::DeviceId{5});
  EXPECT_EQ(site.recorder.published.back().subtype, health::kDataState);
  EXPECT_EQ(last(), (health::Data{{75, 15, 10}, {1024000, 409600, 614400}, {204800, 51200, 153600}}));
  files["/proc/stat"] = "cpu 110 0 15 75";
  run_for(1);
  ASSERT_EQ(count(), 2u);
  EXPECT_EQ(last().cpu_usage, (health::Cpu{0, 0, 100}));
  driver.stop({5});
  files["/proc/stat"] = "cpu 200 0 15 75";
  run_for(5);
  EXPECT_EQ(count(), 2u);
}

TEST_F(HealthTest, says_nothing_while_a_file_is_malformed_or_no_time_has_passed) {
  files["/proc/stat"] = "what";
  ASSERT_TRUE(driver.start({5}));
  run_for(2.5);
  files["/proc/stat"] = "cpu 1 1 1 1";  // the first of two readings
  run_for(1);
  EXPECT_EQ(count(), 0u);
  run_for(1);
  EXPECT_EQ(count(), 0u) << "nothing has passed";
  files["/proc/stat"] = "cpu 2 1 1 2";
  files.erase("/proc/meminfo");
  run_for(1);
  EXPECT_EQ(count(), 0u);
  files["/proc/stat"] = "cpu 3 1 1 3";
  files["/proc/meminfo"] = kMemory;
  run_for(1);
  ASSERT_EQ(count(), 1u);
  EXPECT_EQ(last().cpu_usage, (health::Cpu{50, 0, 50}));
}

TEST(HealthSection, has_two_names_and_an_interval) {
  const auto fault = [](const std::string& fields) {
    return testing::MemorySite("").build("driver( provides [\"health:0\"] " + fields + " )");
  };
  for (const std::string name : {"health", "statgrabdriver"}) {
    testing::MemorySite site("");
    ASSERT_EQ(site.build("driver( name \"" + name + "\" provides [\"health:0\"] interval 0.5 )"), "");
    EXPECT_EQ(site.driver({6665, health::kCode, 0}).name(), name);
  }
  EXPECT_THAT(fault("name \"health\" interval 0.01"), HasSubstr("test.cfg:1: interval is 0.1 at least"));
}

}  // namespace
}  // namespace playhouse::drivers
