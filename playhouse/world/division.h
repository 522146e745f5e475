#pragma once

/// Division: how the nodes of a cluster share the work of a phase. All have the same
/// frozen state; each computes a share of the rows, and takes the results of the others.

#include <cstddef>
#include <span>
#include <vector>

namespace playhouse::world {

/// The share of one node: number `index` of `count` shares of nearly the same size.
struct Share {
  std::size_t index = 0, count = 1;

  /// Its rows of `rows`: [begin(rows), end(rows)). The shares cover all rows once.
  std::size_t begin(std::size_t rows) const { return rows * index / count; }
  std::size_t end(std::size_t rows) const { return rows * (index + 1) / count; }
};

/// The work of a phase in one tick. Thread: tick.
class DividedWork {
 public:
  virtual ~DividedWork() = default;
  /// Computes a share, and appends the results to `out`.
  virtual void compute(Share share, std::vector<std::byte>& out) = 0;
  /// Takes the results of a share that another node computed. False, with an undefined
  /// part of them taken, on bytes that compute() of that share does not append.
  virtual bool take(Share share, std::span<const std::byte> results) = 0;
};

class Division {
 public:
  virtual ~Division() = default;
  /// Has every share computed by a node, and gives its results to all others. Blocks
  /// until this node has them all. All nodes call it with the same work in the same order.
  virtual void run(DividedWork& work) = 0;
};

}  // namespace playhouse::world
