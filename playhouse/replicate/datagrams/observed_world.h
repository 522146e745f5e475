#pragma once

/// ObservedWorld: an observer's replica, keyed by id, built only from the texts
/// and states of datagram.h. For observers in C++, and for tests. One thread.

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
#include "playhouse/replicate/datagrams/text_stream.h"
#include "playhouse/replicate/layout.h"

namespace playhouse::replicate {

struct ObservedModel {
  std::string name;
  std::optional<std::uint32_t> parent;  // id
  ModelState state;
  std::uint64_t tick = 0;  // of `state`; 0: initial state of the scene
  std::string says;

  ModelState start;
  Seq floor = 0;                                    // packets up to here are of another model
  Seq newest = 0;                                   // packet that `state` came in
  std::vector<std::pair<Seq, ModelState>> history;  // recent states: baselines of deltas
};

class ObservedWorld {
 public:
  /// Processes a text of the stream. Fails if it is malformed or contradicts earlier texts.
  Result<void> take_text(std::string_view text, Seq after);
  /// Applies the state of packet `seq`.
  Result<void> take_state(Seq seq, std::span<const std::byte> state);

  bool has_scene() const { return interval_ > 0; }
  /// True if the current state of every model has been received;
  /// before that some models are in their initial state.
  bool is_whole() const { return has_scene() && is_whole_; }
  const std::string& name() const { return name_; }
  /// Of the program (base/version.h).
  const std::string& build() const { return build_; }
  double interval() const { return interval_; }  // s per tick
  std::uint64_t tick() const { return tick_; }   // newest received
  bool paused() const { return paused_; }
  const std::map<std::uint32_t, ObservedModel>& models() const { return models_; }  // by id
  /// Texts for the user; clears them.
  std::vector<std::string> take_notices() { return std::exchange(notices_, {}); }

  /// Pose of a model in W. [m, rad]
  geom::Pose pose(std::uint32_t id) const;

 private:
  void keep(ObservedModel& model, Seq seq, const ModelState& state, std::uint64_t tick);

  std::string name_, build_;
  double interval_ = 0;
  std::uint64_t tick_ = 0;
  Seq newest_ = 0;  // packet that tick_ came in
  bool paused_ = false, is_whole_ = false;
  std::map<std::uint32_t, ObservedModel> models_;
  std::vector<std::string> notices_;
};

}  // namespace playhouse::replicate
