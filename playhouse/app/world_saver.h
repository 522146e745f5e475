#pragma once

/// WorldSaver: saves worlds as world files in the
/// background, so that no tick waits for the disk.

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "playhouse/scene/scene_desc.h"
#include "playhouse/world/world.h"

namespace playhouse::app {

class WorldSaver {
 public:
  WorldSaver() = default;
  ~WorldSaver() { finish(); }
  WorldSaver(const WorldSaver&) = delete;
  WorldSaver& operator=(const WorldSaver&) = delete;

  /// Queues a save of the present world; replaces a pending one for the same
  /// file. The outcome is logged. Tick thread; costs as much as as_scene().
  void save(const world::World& world, const std::string& file);

  /// Waits for pending saves. True if all saves so far succeeded. Tick thread.
  bool finish();

 private:
  struct SaveJob {
    std::string file;
    scene::SceneDesc standing;
    double time = 0;  // s, simulated
  };
  void run();
  static bool write(SaveJob job);

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<SaveJob> jobs_;
  bool ending_ = false, all_saved_ = true;
  std::thread thread_;  // started by the first job; owned by the tick thread
};

}  // namespace playhouse::app
