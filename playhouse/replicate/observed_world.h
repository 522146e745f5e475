#pragma once

/// ObservedWorld: what an observer holds, by ids: made of the texts and states of datagram.h by somebody who
/// has no world of its own. For observers in C++, and for tests. One thread.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/geom/pose.h"
#include "playhouse/replicate/layout.h"
#include "playhouse/replicate/text_stream.h"

namespace playhouse::replicate {

struct ObservedModel {
  std::string name;
  std::optional<std::uint32_t> parent;  // id
  ModelState state;
  std::uint64_t tick = 0;  // when it was so; 0: as the scene told
  std::string says;

  ModelState start;
  Seq floor = 0;                                    // packets up to here told of another model
  Seq newest = 0;                                   // packet of `state`
  std::vector<std::pair<Seq, ModelState>> history;  // of late packets, by which differences are told
};

class ObservedWorld {
 public:
  /// A text of the stream. Fails for what is none, and where it contradicts what came before.
  Result<void> take_text(std::string_view text, Seq after);
  /// The state of packet `seq`.
  Result<void> take_state(Seq seq, std::span<const std::byte> state);

  bool has_scene() const { return interval_ > 0; }
  /// Every model has come, and where it is: before that some are told as they were when they came into the
  /// world.
  bool is_whole() const { return has_scene() && is_whole_; }
  const std::string& name() const { return name_; }
  double interval() const { return interval_; }  // s of a tick
  std::uint64_t tick() const { return tick_; }   // the newest that was told of
  bool paused() const { return paused_; }
  const std::map<std::uint32_t, ObservedModel>& models() const { return models_; }  // by id
  /// Lines for who observes; clears them.
  std::vector<std::string> take_notices() { return std::exchange(notices_, {}); }

  /// Where a model is. [m, rad, W]
  geom::Pose pose(std::uint32_t id) const;

 private:
  void keep(ObservedModel& model, Seq seq, const ModelState& state, std::uint64_t tick);

  std::string name_;
  double interval_ = 0;
  std::uint64_t tick_ = 0;
  Seq newest_ = 0;  // packet that told of tick_
  bool paused_ = false, is_whole_ = false;
  std::map<std::uint32_t, ObservedModel> models_;
  std::vector<std::string> notices_;
};

}  // namespace playhouse::replicate
