#pragma once

/// SharedColumn: a column of which most rows have what their prototype says, kept once for all of them. Reads
/// like a vector; who writes says so with own(). Thread: reads and writes of values that are a row's own may
/// go on at once for different rows; a row gets one of its own between phases.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace playhouse::world {

template <typename T>
class SharedColumn {
 public:
  using value_type = T;

  /// Of the table in which this column is a row's row of SceneDesc::models.
  explicit SharedColumn(const std::vector<std::uint32_t>& prototype) : prototype_(prototype) {}
  SharedColumn(const SharedColumn&) = default;
  /// The values of a table whose rows have the same prototypes.
  SharedColumn& operator=(const SharedColumn& other) {
    shared_ = other.shared_;
    own_ = other.own_;
    at_ = other.at_;
    return *this;
  }

  /// What the prototypes say, by row of SceneDesc::models. Before any row.
  void set_prototypes(std::vector<T> values) { shared_ = std::move(values); }

  std::size_t size() const { return prototype_.size(); }
  bool empty() const { return prototype_.empty(); }
  const T& operator[](std::size_t row) const {
    return is_own(row) ? own_[at_[row]] : shared_[prototype_[row]];
  }
  bool is_own(std::size_t row) const { return row < at_.size() && at_[row] != kShared; }
  /// The row's own value, which is what it had until it is written.
  T& own(std::size_t row) {
    if (!is_own(row)) {
      own_.push_back(shared_[prototype_[row]]);
      if (at_.size() <= row) at_.resize(row + 1, kShared);
      at_[row] = static_cast<std::uint32_t>(own_.size() - 1);
    }
    return own_[at_[row]];
  }
  /// Nothing becomes the row's own that it has already. By value: it may be another row's, and those move.
  void set(std::size_t row, T value) {
    if (is_own(row) || !is_same(operator[](row), value)) own(row) = std::move(value);
  }

  /// Room for what rows have for themselves, if it is `rows` that have.
  void reserve(std::size_t rows) { at_.reserve(rows); }
  void clear() {
    at_.clear();
    own_.clear();
  }
  /// What the rows of these ranges {begin, end}, ascending or empty, have for themselves goes; those behind
  /// them move up.
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

  /// Calls visit(value) for every value that is kept.
  template <typename Visit>
  void each_kept(const Visit& visit) const {
    for (const T& value : shared_) visit(value);
    for (const T& value : own_) visit(value);
  }
  /// Memory of rows and values, without what values have elsewhere. [bytes]
  std::size_t bytes() const {
    return at_.capacity() * sizeof(std::uint32_t) + (shared_.capacity() + own_.capacity()) * sizeof(T);
  }

  /// The same values, whoever has them.
  friend bool operator==(const SharedColumn& a, const SharedColumn& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t row = 0; row < a.size(); ++row)
      if (!(a[row] == b[row])) return false;
    return true;
  }

 private:
  static constexpr std::uint32_t kShared = 0xFFFFFFFFu;

  /// To the bit: -0 is not 0.
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
      at_;  // row of own_, or kShared (rows up to the last that has something of its own)
};

}  // namespace playhouse::world
