#pragma once

/// Recorder: what happens to a world, as records of a file: poses and what is selected, for tools that draw
/// them; and for us the state at the start and now and then, what changed between any two ticks, and hashes,
/// from which Rerun makes the same run again. docs/recording.md lists the channels. Thread: tick.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/record/messages.h"
#include "playhouse/record/record_thread.h"
#include "playhouse/record/selection.h"
#include "playhouse/scene/source_text.h"
#include "playhouse/world/control.h"
#include "playhouse/world/witness.h"

namespace playhouse::record {

/// Of the attachment that is the run at the start, a file of world/saved_run.h.
inline constexpr const char* kStartName = "start.run";

/// Simulated time between two states of a recording. [s]
inline constexpr double kStatePeriod = 10;

class Recorder final : public world::Witness {
 public:
  /// Both outlive the recorder. What is selected and does nothing but measure is watched from the run's first
  /// tick on, which changes nothing else (world::watch).
  Recorder(RecordThread& file, Selection selection, world::Control& control);

  /// The world as the run begins. Fails where that cannot be written.
  Result<void> begin(const world::World& world, const scene::SourceFiles& sources);
  /// For every entry of world.changes, in their order.
  void follow(const world::World& world, const world::Change& change);
  /// The run is over.
  void end(const world::World& world);

  void before_changes(const world::World& world) override;
  void after_changes(const world::World& world) override;
  void ticked(const world::World& world) override;

 private:
  /// What one model's messages need.
  struct Recorded {
    world::ModelId model;
    const TableMessages* table = nullptr;  // null: a ranger, or the images of a camera
    std::uint32_t sensor = 0;              // of the ranger, where each has a scan
    bool scans = false;
    bool images = false;
    std::string topic, frame;
    Bytes last;  // message without its time
  };
  struct Framed {
    world::ModelId model, parent;  // parent none: the world
    std::uint32_t sensor = 0;
    bool is_sensor = false;
    Transform last;
  };

  void look_around(const world::World& world);
  void add_model(const world::World& world, world::ModelRow model);
  void add_ranger(const world::World& world, world::ModelRow model);
  void watch_all(world::World& world);
  std::string label(const world::World& world, world::ModelRow model) const;
  void record_poses(const world::World& world, bool all);
  void record_models(const world::World& world);
  void record_state(const world::World& world);
  void record_check(const world::World& world);
  /// None where there are as many as a file can have.
  std::optional<std::uint16_t> channel_of(const std::string& topic, const std::string& schema);
  void put_message(const world::World& world, const std::string& topic, const std::string& schema,
                   const Bytes& body);
  std::uint64_t ns() const;
  void give_up(const Error& why);
  void hand_over();

  RecordThread& file_;
  const Selection selection_;
  world::Control& control_;

  Bytes out_;  // of this tick
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::pair<std::string, std::string>, std::uint16_t> channels_;  // by topic and schema
  std::vector<std::uint32_t> sequence_;                                    // by channel
  bool full_ = false;  // limits::kRecordChannels was reached

  std::uint64_t steps_ = 0;       // ticks that were done, also those that were taken back
  std::uint64_t population_ = 0;  // of which the lists are
  bool known_ = false;
  std::vector<Recorded> recorded_;
  std::vector<Framed> frames_;
  std::vector<world::ModelId> measuring_;            // that have to be watched, ascending
  std::map<world::ModelId, std::uint64_t> watched_;  // in which life

  bool runs_again_ = true;  // states can be saved
  Bytes before_, state_;
  std::uint64_t last_state_ = 0;                // in steps
  std::uint64_t state_ticks_ = 1, second_ = 1;  // ticks
  double interval_ = 0.1;                       // s
};

}  // namespace playhouse::record
