#pragma once

/// SharedColumns: arrays in memory that another process maps, with a table of them at its front, so that it
/// finds them by name and copies nothing. docs/gym.md draws the layout. The memory has no name: it ends with
/// the last who has it open.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::drivers::gym {

inline constexpr std::uint32_t kLayoutVersion = 1;

class SharedColumns {
 public:
  /// What one column holds; `dtype` is numpy's word for it ("<f4").
  struct Column {
    std::string_view name;
    std::string_view dtype;
    std::uint32_t rows = 0, columns = 0;  // columns 0: one value a row, without a second dimension
    std::size_t value_bytes = 0;
  };

  SharedColumns() = default;
  SharedColumns(const SharedColumns&) = delete;
  SharedColumns& operator=(const SharedColumns&) = delete;
  ~SharedColumns();

  /// Once. All values are 0. Fails where the system has no memory for it.
  Result<void> make(std::span<const Column> columns);

  /// For the other process.
  int descriptor() const { return descriptor_; }
  /// Of the n-th column.
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
