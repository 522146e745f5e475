#pragma once

/// WorldSaver: writes worlds as they stand into world files, on a thread of its own, so that no tick waits
/// for a disk.

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

  /// The world of now is to be in the file soon; one that waits for the same file gives way. The log says
  /// what became of it. Tick thread; costs what as_scene() does.
  void save(const world::World& world, const std::string& file);

  /// Waits for what is to be saved. True if all of it was, from the beginning on. Tick thread.
  bool finish();

 private:
  struct Job {
    std::string file;
    scene::SceneDesc standing;
    double time = 0;  // s, simulated
  };
  void run();
  static bool write(Job job);

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<Job> jobs_;
  bool ending_ = false, all_saved_ = true;
  std::thread thread_;  // from the first job on; the tick thread's
};

}  // namespace playhouse::app
