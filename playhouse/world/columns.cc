#include "playhouse/world/columns.h"

#include <cstddef>
#include <tuple>

namespace playhouse::world {
namespace {

/// Bytes of a table's listed columns.
template <typename Table>
constexpr std::size_t listed_bytes() {
  std::size_t bytes = 0;
  each_column_of<Table>([&]<typename Of>(const Column<Table, Of>&) { bytes += sizeof(Of); });
  return bytes;
}

static_assert(std::apply([]<typename... Table>(Table Tables::*...) { return (sizeof(Table) + ...); },
                         kTables) == sizeof(Tables),
              "a table is not in the list");
static_assert(std::apply([]<typename... Table>(
                             Table Tables::*...) { return ((listed_bytes<Table>() == sizeof(Table)) && ...); },
                         kTables),
              "a column of a table is not in its list");

}  // namespace
}  // namespace playhouse::world
