#pragma once

/// SharedColumns: arrays in shared memory, with a directory at its front, so that
/// another process finds them by name without copying. docs/gym.md specifies the
/// layout. The memory is anonymous: it is freed when the last process closes it.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::drivers::gym {

class SharedColumns {
 public:
  /// Description of a column; `dtype` is numpy's code ("<f4").
  struct ColumnFormat {
    std::string_view name;
    std::string_view dtype;
    std::uint32_t rows = 0, columns = 0;  // columns 0: a one-dimensional array
    std::size_t value_bytes = 0;
  };

  SharedColumns() = default;
  SharedColumns(const SharedColumns&) = delete;
  SharedColumns& operator=(const SharedColumns&) = delete;
  ~SharedColumns();

  /// Allocates all columns, zeroed. Call once. Fails if the system is out of memory.
  Result<void> make(std::span<const ColumnFormat> columns);

  /// File descriptor for the other process.
  int descriptor() const { return descriptor_; }
  /// Values of the n-th column.
  template <typename T>
  T* values(std::size_t column) const {
    return reinterpret_cast<T*>(memory_ + offsets_[column]);
  }

 private:
  int descriptor_ = -1;
  std::byte* memory_ = nullptr;
  std::size_t bytes_ = 0;
  std::vector<std::size_t> offsets_;
};

}  // namespace playhouse::drivers::gym
