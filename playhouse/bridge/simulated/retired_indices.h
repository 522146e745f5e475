#pragma once

/// RetiredIndices: a pool of indices whose devices have all been removed, first
/// in, first out, reused after a rest period. A value; thread: the tick thread.
///
/// An index must not be reused while a client may still refer to its previous device.
/// Which clients have it open is known to the io thread only, at unpredictable times,
/// but addresses have to be the same in every run; so the criterion is the simulated
/// time since removal. Clients that have not noticed by then, because they read slowly
/// or the run is faster than real time, are rejected by the server (docs/server.md).

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace playhouse::drivers {

class RetiredIndices {
 public:
  /// Rest period in simulated time. [s]
  static constexpr double kRest = 60;

  /// Adds a holder of the index.
  void hold(std::size_t index);
  /// Removes a holder at `time` [s]; after the last one the index retires. Asserts that there is one.
  void release(std::size_t index, double time);
  /// The longest retired index, if it has rested at `time` [s]; the caller has to hold() it.
  std::optional<std::size_t> take(double time);
  /// The run was rewound to `time` [s]: later retirements are moved to that time.
  void rewind_to(double time);

  /// Number of retired indices.
  std::size_t size() const { return order_.size(); }

 private:
  struct Retired {
    std::size_t index;
    double time;  // s
  };
  struct IndexHolders {
    std::size_t holders = 0;
    std::uint64_t number = 0;  // key in order_, if without holders
  };
  std::map<std::size_t, IndexHolders> places_;  // held and retired, by index
  std::map<std::uint64_t, Retired> order_;      // ascending by number and by time
  std::uint64_t next_number_ = 0;
};

}  // namespace playhouse::drivers
