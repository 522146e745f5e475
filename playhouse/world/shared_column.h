#pragma once

/// SharedColumn: a copy-on-write column: rows share the value of their prototype until they get
/// their own. Reads like a vector; writes go through own(). Thread: own values of different
/// rows may be read and written in parallel; a row gets its own value between phases only.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "playhouse/base/row.h"

namespace playhouse::world {

template <typename T>
class SharedColumn {
 public:
  using value_type = T;

  /// `prototype`: the column of the same table that holds each row's row of SceneDesc::models.
  explicit SharedColumn(const std::vector<std::uint32_t>& prototype) : prototype_(prototype) {}
  SharedColumn(const SharedColumn&) = default;
  /// Copies the values of a table whose rows have the same prototypes.
  SharedColumn& operator=(const SharedColumn& other) {
    shared_ = other.shared_;
    own_ = other.own_;
    at_ = other.at_;
    return *this;
  }

  /// Sets the prototype values, by row of SceneDesc::models. Before any row.
  void set_prototypes(std::vector<T> values) { shared_ = std::move(values); }

  std::size_t size() const { return prototype_.size(); }
  bool empty() const { return prototype_.empty(); }
  const T& operator[](std::size_t row) const {
    return is_own(row) ? own_[at_[row]] : shared_[prototype_[row]];
  }
  bool is_own(std::size_t row) const { return row < at_.size() && at_[row] != kShared; }
  /// The row's own value for writing; created as a copy of the prototype's.
  T& own(std::size_t row) {
    if (!is_own(row)) {
      own_.push_back(shared_[prototype_[row]]);
      if (at_.size() <= row) at_.resize(row + 1, kShared);
      at_[row] = static_cast<std::uint32_t>(own_.size() - 1);
    }
    return own_[at_[row]];
  }
  /// Writes only if the value differs. By value: the argument may refer to another row, which own() may move.
  void set(std::size_t row, T value) {
    if (is_own(row) || !is_same(operator[](row), value)) own(row) = std::move(value);
  }

  /// Reserves room for `rows` rows.
  void reserve(std::size_t rows) { at_.reserve(rows); }
  void clear() {
    at_.clear();
    own_.clear();
  }
  /// Removes the rows of these ranges {begin, end},
  /// ascending or empty, and moves the rows behind them up.
  template <typename Ranges>
  void erase(const Ranges& ranges) {
    std::size_t to = 0, from = 0;
    const auto keep_below = [&](std::size_t row) {
      for (; from < std::min(row, at_.size()); ++from) at_[to++] = at_[from];
    };
    for (const auto& range : ranges) {
      if (range.begin == range.end) continue;
      keep_below(range.begin);
      from = std::max<std::size_t>(from, range.end);
    }
    keep_below(at_.size());
    at_.resize(to);
    std::vector<T> kept;
    for (std::uint32_t& at : at_) {
      if (at == kShared) continue;
      kept.push_back(std::move(own_[at]));
      at = static_cast<std::uint32_t>(kept.size() - 1);
    }
    own_ = std::move(kept);
  }

  /// Calls visit(value) for every stored value.
  template <typename Visit>
  void each_kept(const Visit& visit) const {
    for (const T& value : shared_) visit(value);
    for (const T& value : own_) visit(value);
  }
  /// Memory of rows and values, without what values allocate themselves. [bytes]
  std::size_t bytes() const {
    return at_.capacity() * sizeof(std::uint32_t) + (shared_.capacity() + own_.capacity()) * sizeof(T);
  }

  /// Compares row by row, whether shared or own.
  friend bool operator==(const SharedColumn& a, const SharedColumn& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t row = 0; row < a.size(); ++row)
      if (!(a[row] == b[row])) return false;
    return true;
  }

 private:
  static constexpr std::uint32_t kShared = 0xFFFFFFFFu;

  /// Bitwise: -0 differs from 0.
  static bool is_same(const T& a, const T& b) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      return std::memcmp(&a, &b, sizeof(T)) == 0;
    } else {
      return a == b;
    }
  }

  const std::vector<std::uint32_t>& prototype_;
  std::vector<T> shared_, own_;
  std::vector<std::uint32_t>
      at_;  // row of own_, or kShared for a shared value (rows up to the last one with an own value)
};

/// A shared column that is indexed by rows of one table alone.
template <typename Table, typename T>
struct SharedByRow : SharedColumn<T> {
  using SharedColumn<T>::SharedColumn;
  const T& operator[](Row<Table> row) const { return SharedColumn<T>::operator[](row.index); }
  bool is_own(Row<Table> row) const { return SharedColumn<T>::is_own(row.index); }
  T& own(Row<Table> row) { return SharedColumn<T>::own(row.index); }
  void set(Row<Table> row, T value) { SharedColumn<T>::set(row.index, std::move(value)); }
};

}  // namespace playhouse::world
