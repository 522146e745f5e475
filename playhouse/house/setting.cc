#include "playhouse/house/setting.h"

#include <array>
#include <random>

namespace playhouse::house {
namespace {

constexpr std::array kIntervals = {0.05, 0.1, 0.2, 0.4};  // s
constexpr std::array kTurns = {0.1, 0.2, 0.5, 1.0};       // s

}  // namespace

Setting setting_of(std::uint64_t seed) {
  std::mt19937_64 random(seed ^ 0x5E771265u);
  const auto one_in = [&](std::uint64_t count) { return random() % count == 0; };
  Setting setting;
  setting.is_arena = one_in(16);  // ten times as much to compute
  // Each machine of a cluster repeats the world, too much of it in Arena.
  setting.is_cluster = !setting.is_arena && one_in(10);
  setting.has_pages = one_in(2);
  setting.has_observers = one_in(2);
  setting.has_robots = one_in(2);
  setting.has_drivers = one_in(3);
  setting.has_recording = one_in(2);
  setting.has_people = one_in(2);
  setting.disk_fails = one_in(3);
  setting.crashes = one_in(2);
  setting.interval = kIntervals[random() % kIntervals.size()];
  setting.turn = kTurns[random() % kTurns.size()];
  return setting;
}

}  // namespace playhouse::house
