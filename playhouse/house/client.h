#pragma once

/// SimulatedClient: a Player client of a simulated house. Most behave: what they ask is answered once, and
/// they get data of what they opened. Others stall, vanish or send anything. Each follows its own random
/// numbers. Thread: one for the whole house.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "playhouse/base/hash.h"
#include "playhouse/net/simulated.h"
#include "playhouse/wire/header.h"

namespace playhouse::house {

enum class Manner : std::uint8_t {
  kReads,     // gets data as they come
  kPulls,     // asks for them
  kStalls,    // does not read for some time, then reads on
  kVanishes,  // ends without a word, in the middle of a message
  kGarbles,   // sends messages with wrong bytes
};
inline constexpr std::size_t kManners = 5;

class SimulatedClient {
 public:
  /// Connects to the port, which must be open, of a world whose devices publish each `period` [s].
  SimulatedClient(net::SimulatedNetwork& network, std::uint16_t port, Manner manner, double period,
                  std::uint64_t seed);

  Manner manner() const { return manner_; }
  /// Sends some messages; before a tick.
  void act();
  /// Reads what has come, and looks whether it may have; after a tick. `now` [s].
  void hear(double now);
  /// Data may be missing up to then [s]: the network is cut, or the run goes on from another tick.
  void excuse_until(double time);
  /// Asks no more, and reads on.
  void finish();
  /// Ends the connection.
  void leave();
  /// It has no connection any more.
  bool is_over() const { return over_; }
  /// Requests that are not answered.
  std::size_t waits_for() const { return asked_.size(); }
  std::size_t answered() const { return answered_; }
  /// What it was sent and should not have been; none: nothing.
  const std::optional<std::string>& fault() const { return fault_; }
  /// Of all that it has heard.
  std::uint64_t digest() const { return digest_.value(); }
  /// Does as if the next answer had not come, for tests of what is found.
  void lose_an_answer() { loses_answer_ = true; }
  /// Does as if the data of the next tick had not come, likewise.
  void lose_a_tick() { loses_tick_ = true; }

 private:
  /// By sequence number, interface, index and subtype.
  using RequestKey = std::tuple<std::uint32_t, std::uint16_t, std::uint16_t, std::uint8_t>;

  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }
  bool behaves() const { return manner_ != Manner::kGarbles && manner_ != Manner::kVanishes; }
  std::vector<std::byte> any_bytes(std::size_t most);
  std::vector<std::byte> any_message();
  std::vector<std::byte> request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                 const std::vector<std::byte>& body);
  void send(std::vector<std::byte> bytes);
  void take(const wire::Header& header, std::span<const std::byte> body);
  void answer(const wire::Header& header);
  void look_at_data(const wire::Header& header);
  void wrong(std::string what);

  net::SimulatedPeer peer_;
  const Manner manner_;
  const double period_;  // s
  std::mt19937_64 random_;
  std::vector<std::byte> heard_;  // less than a message
  bool greeted_ = false, finishes_ = false, over_ = false, stalled_ = false;
  bool loses_answer_ = false, loses_tick_ = false;
  std::uint32_t next_ = 1;  // sequence number
  std::set<RequestKey> asked_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, double> data_times_;  // by interface and index: the last
  double excused_until_ = 0, now_ = 0;                                    // s
  std::size_t answered_ = 0;
  std::optional<std::string> fault_;
  Hash digest_;
};

}  // namespace playhouse::house
