#pragma once

/// Setting: what is in a house. Each seed draws a part of the program: with all of it in every run some states
/// hide others, and a run takes several times as long.
/// Source: Groce, Zhang, Eide, Chen, Regehr, "Swarm testing", ISSTA 2012.

#include <algorithm>
#include <cstdint>

namespace playhouse::house {

struct Setting {
  bool is_arena = false, is_cluster = false;
  bool has_pages = true, has_observers = true, has_robots = true;  // robots that join from other machines
  bool has_drivers = true, has_recording = true, has_people = true;
  bool disk_fails = false, crashes = true;
  double interval = 0.1;  // s of simulated time in a tick
  double turn = 0.1;      // s between two turns of people and clients

  /// Of what devices publish: each update_interval, which is not less than a tick. [s]
  double period() const { return std::max(interval, 0.1); }
};

Setting setting_of(std::uint64_t seed);

}  // namespace playhouse::house
