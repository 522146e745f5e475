#pragma once

/// RetiredIndices: indices whose devices have all gone, in the order in which they went. The longest gone is
/// given again, once it has rested. A value; thread: the tick thread.
///
/// An index should not be given again while somebody means the device that had it before. Who has that open
/// and who asked for it by name is known to the io thread alone, at times of its own, and who gets which
/// address has to be the same in every run; so what decides here is how long ago, in simulated time, the
/// device went. The few that still have not read so by then, because they read too slowly or the run is
/// faster than its time, are refused by the server (docs/server.md).

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace playhouse::drivers {

class RetiredIndices {
 public:
  /// Simulated. [s]
  static constexpr double kRest = 60;

  /// One more device has the index.
  void hold(std::size_t index);
  /// One of them went, at `time` [s]; with the last of them the index retires. Asserts that there is one.
  void release(std::size_t index, double time);
  /// The index that retired first, if it has rested at `time` [s]; it is nobody's until somebody holds it.
  std::optional<std::size_t> take(double time);
  /// The run was taken back to `time` [s]: what retired later retired then.
  void go_back(double time);

  /// How many wait to be given again.
  std::size_t size() const { return order_.size(); }

 private:
  struct Retired {
    std::size_t index;
    double time;  // s
  };
  struct Place {
    std::size_t holders = 0;
    std::uint64_t number = 0;  // in order_, without any holders
  };
  std::map<std::size_t, Place> places_;     // by index: those held, and those that wait
  std::map<std::uint64_t, Retired> order_;  // ascending by number and by time
  std::uint64_t next_number_ = 0;
};

}  // namespace playhouse::drivers
