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
};

/// The rows of a table, in order.
template <typename Table>
class RowsOf {
 public:
  struct Iterator {
    Row<Table> row;
    constexpr Row<Table> operator*() const { return row; }
    constexpr Iterator& operator++() {
      ++row.index;
      return *this;
    }
    constexpr bool operator==(const Iterator&) const = default;
  };
  constexpr explicit RowsOf(std::size_t size) : size_(static_cast<std::uint32_t>(size)) {}
  constexpr Iterator begin() const { return {{0}}; }
  constexpr Iterator end() const { return {{size_}}; }

 private:
  std::uint32_t size_;
};

/// A value for each row of a table, indexed by its rows alone.
template <typename Table, typename Value>
struct ByRow : std::vector<Value> {
  using std::vector<Value>::vector;
  Value& operator[](Row<Table> row) { return std::vector<Value>::operator[](row.index); }
  const Value& operator[](Row<Table> row) const { return std::vector<Value>::operator[](row.index); }
};

}  // namespace playhouse
