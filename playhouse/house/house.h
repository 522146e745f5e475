#pragma once

/// House: the whole program on a simulated network and clock: server, simulated world, its devices, a
/// recording on a disk that may fail, pages, observers, clients that behave and others, robots that come and go, also
/// from other machines, rewinds, and crashes after which it is started again. One seed decides everything, so that a run that breaks an invariant of
/// ARCHITECTURE.md can be repeated. Truth: the invariants, which no part of the program knows of.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "playhouse/house/setting.h"

namespace playhouse::house {

/// What is broken on purpose, for tests of what is found.
enum class Sabotage : std::uint8_t {
  kNone,
  kLosesAnswer,  // one answer does not reach its client
  kLosesTick,    // one client does not get the data of one tick
  kLosesFrame,   // one page does not get the changes of one frame
  kLosesChange,  // one change is missing in the recording
};

struct HouseOptions {
  std::uint64_t seed = 1;
  double seconds = 200;  // simulated, until all clients leave
  Sabotage sabotage = Sabotage::kNone;
  std::optional<Setting> setting = {};  // none: that of the seed
};

struct Report {
  std::optional<std::string> fault;  // the first invariant that was broken
  double simulated = 0;              // s
  std::size_t answers = 0, clients = 0, spawned = 0, rewinds = 0, checks = 0;
  std::size_t pages = 0, frames = 0;      // frames that held the whole world
  std::size_t cuts = 0;                   // of the network
  std::size_t nodes = 0;                  // of a cluster
  std::size_t machines = 0, crashes = 0;  // that brought robots; of the program
  bool disk_failed = false;
  std::uint64_t digest = 0;  // of the world, and of what clients heard: the same for the same seed
};

/// Runs a house. `folder` is for its recording, and must exist.
Report run_house(const HouseOptions& options, const std::string& folder);

}  // namespace playhouse::house
