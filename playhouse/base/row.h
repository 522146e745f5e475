#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace playhouse {

/// Typed index of a row in one table; indices of different tables do not mix. The default is "none".
template <typename Table>
struct Row {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::uint32_t index = kNone;

  constexpr bool valid() const { return index != kNone; }
  constexpr explicit operator bool() const { return valid(); }
  constexpr auto operator<=>(const Row&) const = default;
  /// The row that is `rows` behind it.
  constexpr Row operator+(std::uint32_t rows) const { return {index + rows}; }
  /// By how many rows it is behind `first`.
  constexpr std::uint32_t operator-(Row first) const { return index - first.index; }
  constexpr Row& operator++() {
    ++index;
    return *this;
  }
  constexpr Row& operator--() {
    --index;
    return *this;
  }
};

/// Consecutive rows of a table, in order: all of it, or those from `first` up to `end`, which is not one.
template <typename Table>
class RowsOf {
 public:
  struct RowIterator {
    Row<Table> row;
    constexpr Row<Table> operator*() const { return row; }
    constexpr RowIterator& operator++() {
      ++row;
      return *this;
    }
    constexpr bool operator==(const RowIterator&) const = default;
  };
  constexpr RowsOf() : RowsOf(0) {}
  constexpr explicit RowsOf(std::size_t size) : end_{static_cast<std::uint32_t>(size)} {}
  constexpr RowsOf(Row<Table> first, Row<Table> end) : first_(first), end_(end) {}
  constexpr RowIterator begin() const { return {first_}; }
  constexpr RowIterator end() const { return {end_}; }
  constexpr std::uint32_t size() const { return end_ - first_; }
  constexpr bool empty() const { return first_ == end_; }
  constexpr Row<Table> front() const { return first_; }
  /// Of these, from the `begin`-th up to the `end`-th, as workers share them.
  constexpr RowsOf part(std::size_t begin, std::size_t end) const { return {(*this)[begin], (*this)[end]}; }
  constexpr Row<Table> operator[](std::size_t i) const { return first_ + static_cast<std::uint32_t>(i); }

 private:
  Row<Table> first_{0}, end_;
};

/// A value for each row of a table, indexed by its rows alone.
template <typename Table, typename Value>
struct ByRow : std::vector<Value> {
  using std::vector<Value>::vector;
  Value& operator[](Row<Table> row) { return std::vector<Value>::operator[](row.index); }
  const Value& operator[](Row<Table> row) const { return std::vector<Value>::operator[](row.index); }
  RowsOf<Table> rows() const { return RowsOf<Table>(this->size()); }
  /// The values from a row on, for kernels.
  const Value* from(Row<Table> row) const { return this->data() + row.index; }
  Value* from(Row<Table> row) { return this->data() + row.index; }
  /// The row of back().
  Row<Table> last() const { return {static_cast<std::uint32_t>(this->size() - 1)}; }
  /// The row that the next value pushed back gets.
  Row<Table> next() const { return {static_cast<std::uint32_t>(this->size())}; }
};

/// Calls visit(run) for each longest run of rows with one value in the column.
template <typename Table, typename Value, typename Visit>
void each_run(RowsOf<Table> rows, const ByRow<Table, Value>& column, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && column[rows[end]] == column[rows[begin]]) ++end;
    visit(RowsOf<Table>(rows[begin], rows[end]));
  }
}

}  // namespace playhouse
