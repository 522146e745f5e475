#pragma once

/// Workers: the threads that share the rows of a phase. A phase gives a body that fills rows [begin, end) of
/// its own columns from frozen ones; which thread takes which range must not matter, and does not where that
/// is kept. Thread: the tick thread calls run(); the body runs on any worker.

#include <cstddef>
#include <memory>

namespace playhouse::world {

class Workers {
 public:
  /// `count` threads, the caller included; 1 runs everything in the caller. 0 counts as 1.
  explicit Workers(unsigned count);
  ~Workers();

  unsigned count() const { return count_; }

  /// Calls body(begin, end) for ranges of about `grain` rows that cover [0, rows) once; returns when all are
  /// done.
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

  /// Number of the calling thread, below count(), for scratch memory inside a body.
  unsigned current() const;

 private:
  struct Arena;
  using Call = void (*)(const void* body, std::size_t begin, std::size_t end);
  void run_ranges(std::size_t rows, std::size_t grain, const void* body, Call call);

  unsigned count_;
  std::unique_ptr<Arena> arena_;  // none with one worker
};

}  // namespace playhouse::world
