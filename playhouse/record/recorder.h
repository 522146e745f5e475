#pragma once

/// Recorder: records a run: poses and selected data, for visualisation tools; and for
/// replay the initial state, keyframes, all changes between ticks, and hashes, from
/// which Rerun reproduces the run. docs/recording.md lists the channels. Thread: tick.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/config/text/source_text.h"
#include "playhouse/record/frames.h"
#include "playhouse/record/messages.h"
#include "playhouse/record/record_thread.h"
#include "playhouse/record/selection.h"
#include "playhouse/run/follower.h"
#include "playhouse/world/control.h"

namespace playhouse::record {

/// Name of the attachment with the initial state, a file of world/saving/saved_run.h.
inline constexpr const char* kStartName = "start.run";
/// The attachment before that, with the number of the format behind it (base/formats.h): its content is the
/// build that recorded.
inline constexpr std::string_view kFormatName = "playhouse recording ";

/// Simulated time between two keyframes of a recording. [s]
inline constexpr double kStatePeriod = 10;

class Recorder final : public run::Follower {
 public:
  /// Both must outlive the recorder. Selected sensors are subscribed as a
  /// watcher from the first tick on, without side effects (world::watch).
  Recorder(RecordThread& file, Selection selection, world::Control& control);

  /// Writes the initial state of the run. Fails if that cannot be written.
  Result<void> begin(const world::World& world, const config::SourceFiles& sources);
  /// Ends the recording.
  void end(const world::World& world);

  void happened(const world::World& world, const world::Event& event) override;
  void changed(const world::World& world, std::span<const world::Change> changes) override;
  void ticked(const world::World& world) override;

 private:
  /// What a channel tells of its model.
  enum class Told : std::uint8_t {
    kTable,
    kRanges,
    kScan,
    kCloud,
    kImage,
    kCameraInfo,
    kImu,
    kFix,
    kOdometry,
  };
  /// Recording state of one model's channel.
  struct Recorded {
    world::ModelId model;
    Told told = Told::kTable;
    const TableMessages* table = nullptr;  // of kTable
    std::uint32_t sensor = 0;              // of the ranger, if it has a channel per sensor
    std::string topic, model_frame, frame;
    Bytes last;  // last message without its time
  };
  struct Framed {
    world::ModelId model, parent;  // parent none: the world
    FrameKind kind = FrameKind::kModel;
    std::uint32_t sensor = 0;
    Transform last;
    std::uint64_t step = 0;  // of steps_, when `last` was recorded
  };

  void look_around(const world::World& world);
  void add_model(const world::World& world, world::ModelRow model);
  void add_standard(const world::World& world, world::ModelRow model);
  void add_ranger(const world::World& world, world::ModelRow model);
  void add_channel(const world::World& world, world::ModelRow model, Told told, FrameKind frame,
                   const std::string& topic, std::uint32_t sensor = 0);
  void add_frame(const world::World& world, world::ModelRow model, FrameKind kind, std::uint32_t sensor = 0);
  void watch_all(world::Journal& journal);
  std::string label(const world::World& world, world::ModelRow model);
  std::string label_of(const world::World& world, world::ModelId model);
  void record_poses(const world::World& world, bool all);
  void record_models(const world::World& world);
  static bool is_due(const world::World& world, world::ModelRow model, const Recorded& channel);
  static const char* schema_of(const Recorded& channel);
  /// Empty if there is nothing to tell.
  Bytes message_of(const world::World& world, world::ModelRow model, const Recorded& channel) const;
  void record_change(const world::World& world, const world::Change& change);
  void record_speech(const world::World& world);
  void record_state(const world::World& world);
  void record_check(const world::World& world);
  /// None at the limit on channels.
  std::optional<std::uint16_t> channel_of(const std::string& topic, const std::string& schema);
  void put_message(const world::World& world, const std::string& topic, const std::string& schema,
                   const Bytes& body, std::uint64_t ago = 0);
  /// The same with a time of the world. [s]
  void put_message_at(double time, const std::string& topic, const std::string& schema, const Bytes& body,
                      std::uint64_t ago = 0);
  /// Time of the file, so many ticks ago. [ns]
  std::uint64_t ns(std::uint64_t ago = 0) const;
  void give_up(const Error& why);
  void hand_over();

  RecordThread& file_;
  const Selection selection_;
  std::map<std::string, world::ModelId> labels_;  // and whose they are, or were
  world::Control& control_;

  Bytes out_;  // of this tick
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::pair<std::string, std::string>, std::uint16_t> channels_;  // by topic and schema
  std::vector<std::uint32_t> sequence_;                                    // by channel
  bool full_ = false;  // limits::kRecordChannels was reached

  std::uint64_t steps_ = 0;       // ticks run, including those undone by a rewind
  std::uint64_t population_ = 0;  // version of the lists below
  bool known_ = false;
  std::vector<Recorded> recorded_;
  std::vector<Framed> frames_;
  std::map<world::ModelId, std::string> spoken_;     // by those who say something
  std::optional<std::uint64_t> said_;                // World::said() of that,
  std::uint64_t speakers_ = 0;                       // and its population
  std::vector<world::ModelId> measuring_;            // need watching, ascending
  std::map<world::ModelId, std::uint64_t> watched_;  // incarnation being watched

  bool runs_again_ = true;  // states can be saved
  Bytes state_;
  std::uint64_t tick_ = 0;                      // of the world before changes
  std::uint64_t last_state_ = 0;                // in steps
  std::uint64_t state_ticks_ = 1, second_ = 1;  // ticks
  double interval_ = 0.1;                       // s
};

}  // namespace playhouse::record
