#pragma once

/// SimulatedViewer: a page of a simulated house: it holds the world as the program's texts and packets describe it, and
/// has a person in it who drives, joins, speaks, and carries robots. What it holds must be the world of one
/// tick. Thread: one for the whole house.

#include <boost/json/object.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/hash.h"
#include "playhouse/house/shown_worlds.h"
#include "playhouse/net/simulated.h"
#include "playhouse/replicate/delta.h"

namespace playhouse::house {

enum class PageManner : std::uint8_t {
  kWatches,   // acknowledges what it gets, and sends commands
  kStalls,    // does not read for some time, then reads on
  kVanishes,  // ends without a word
  kGarbles,   // sends what is no command
};
inline constexpr std::size_t kPageManners = 4;

class SimulatedViewer {
 public:
  /// Opens the WebSocket from this address. `shown` must outlive it.
  SimulatedViewer(net::SimulatedNetwork& network, std::uint16_t port, const std::string& address,
                  const ShownWorlds& shown, PageManner manner, std::uint64_t seed);

  /// Sends some commands; before a tick.
  void act();
  /// Takes what has come; after a tick. `patience`: the longest that a page that reads may hear nothing [s].
  void hear(double patience);
  /// The network does not carry all: silence counts from then on [s].
  void excuse_until(double time);
  void leave();
  /// It has no connection any more.
  bool is_over() const { return over_; }
  /// What it holds and should not; none: nothing.
  const std::optional<std::string>& fault() const { return fault_; }
  std::size_t frames() const { return frames_; }
  /// Frames that held a whole world.
  std::size_t whole_frames() const { return whole_frames_; }
  /// Of the frames and models that it has got; not of the scene, which names the commit of the program.
  std::uint64_t digest() const { return digest_.value(); }
  /// Does as if the next frame with changes had none, for tests of what is found.
  void lose_changes() { loses_changes_ = true; }

 private:
  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  double draw_place() { return draw(100) / 10.0 - 5; }
  bool behaves() const { return manner_ == PageManner::kWatches || manner_ == PageManner::kStalls; }
  std::uint32_t any_model();
  std::string any_command();
  void take_text(std::string_view text);
  void take_models(const boost::json::object& text);
  void take_frame(std::span<const std::byte> packet);
  void wrong(std::string what);

  net::SimulatedNetwork& network_;
  net::SimulatedPage page_;
  const ShownWorlds& shown_;
  const PageManner manner_;
  std::mt19937_64 random_;
  std::map<std::uint32_t, std::vector<std::int64_t>> starts_;  // by id: the model's first state, as told
  bool has_scene_ = false;
  std::optional<replicate::Replica> replica_;
  bool stalled_ = false, over_ = false, loses_changes_ = false;
  double heard_;  // s
  std::size_t frames_ = 0, whole_frames_ = 0;
  std::optional<std::string> fault_;
  Hash digest_;
};

}  // namespace playhouse::house
