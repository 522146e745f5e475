#pragma once

/// Workers: the threads of a phase. A phase passes a body that fills rows [begin,
/// end) of its own columns from frozen ones; the result must not depend on which thread
/// gets which range. Thread: the tick thread calls run(); the body runs on any worker.

#include <cstddef>
#include <memory>

namespace playhouse::world {

class Workers {
 public:
  /// A pool of `count` threads including the caller; 0 counts as 1, which runs everything in the caller.
  explicit Workers(unsigned count);
  ~Workers();

  unsigned count() const { return count_; }

  /// Parallel for: calls body(begin, end) for ranges of about `grain`
  /// rows that cover [0, rows) once. Blocks until all are done.
  template <typename Body>
  void run(std::size_t rows, std::size_t grain, const Body& body) {
    if (count_ == 1 || rows <= grain) {
      if (rows > 0) body(std::size_t{0}, rows);
      return;
    }
    run_ranges(rows, grain, &body, [](const void* b, std::size_t begin, std::size_t end) {
      (*static_cast<const Body*>(b))(begin, end);
    });
  }

  /// Index of the calling thread, below count(), for scratch buffers.
  unsigned current() const;

 private:
  struct Arena;
  using Call = void (*)(const void* body, std::size_t begin, std::size_t end);
  void run_ranges(std::size_t rows, std::size_t grain, const void* body, Call call);

  unsigned count_;
  std::unique_ptr<Arena> arena_;  // null with one worker
};

}  // namespace playhouse::world
