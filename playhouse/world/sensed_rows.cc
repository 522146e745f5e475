#include "playhouse/world/sensed_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "playhouse/world/columns.h"
#include "playhouse/world/packed_values.h"

namespace playhouse::world {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

/// How the numbers of a run are packed.
enum class Packed : std::uint8_t {
  kAll,     // each
  kTwo,     // two, and a bit for each that is the second: intensities mostly, of beams that hit and miss
  kSparse,  // the largest, a bit for each that is another, and those: ranges where most beams miss
};

/// A bit for each number, in whole bytes.
template <typename T, typename IsSet>
void pack_bits(std::span<const T> values, const IsSet& is_set, std::vector<std::byte>& out) {
  for (std::size_t i = 0; i < values.size(); i += 8) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 8 && i + k < values.size(); ++k)
      bits |= static_cast<unsigned>(is_set(values[i + k])) << k;
    out.push_back(static_cast<std::byte>(bits));
  }
}

/// Compares bits, not values: -0 is not 0.
template <typename T>
bool same(T a, T b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

template <typename T>
void put_raw(std::span<const T> values, std::vector<std::byte>& out) {
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

template <typename T>
void pack_numbers(std::span<const T> values, std::vector<std::byte>& out) {
  const auto start = [&](Packed how) { out.push_back(static_cast<std::byte>(how)); };
  const T first = values.empty() ? T{} : values.front();
  const auto other = std::ranges::find_if(values, [&](T value) { return !same(value, first); });
  const T second = other == values.end() ? first : *other;
  if (std::ranges::all_of(values, [&](T value) { return same(value, first) || same(value, second); })) {
    start(Packed::kTwo);
    put_raw(std::span<const T>({first, second}), out);
    return pack_bits(
        values, [&](T value) { return !same(value, first); }, out);
  }
  const T most = *std::ranges::max_element(values);
  const auto is_other = [&](T value) { return !same(value, most); };
  const auto others = static_cast<std::size_t>(std::ranges::count_if(values, is_other));
  if (others > values.size() / 2) {
    start(Packed::kAll);
    return put_raw(values, out);
  }
  start(Packed::kSparse);
  put_raw(std::span<const T>({most}), out);
  pack_bits(values, is_other, out);
  for (const T value : values)
    if (is_other(value)) put_raw(std::span<const T>({value}), out);
}

template <typename T>
T get_raw(Unpacker& in) {
  T value{};
  const std::span<const std::byte> bytes = in.bytes(sizeof(T));
  if (!bytes.empty()) std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

template <typename T>
bool unpack_numbers(std::span<T> values, Unpacker& in) {
  const auto how = static_cast<Packed>(in.u8());
  if (how == Packed::kAll) {
    const std::span<const std::byte> bytes = in.bytes(values.size_bytes());
    if (in.ok() && !bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return in.ok();
  }
  if (how != Packed::kTwo && how != Packed::kSparse) return false;
  const T usual = get_raw<T>(in), second = how == Packed::kTwo ? get_raw<T>(in) : T{};
  const std::span<const std::byte> bits = in.bytes((values.size() + 7) / 8);
  if (!in.ok()) return false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_other = (std::to_integer<unsigned>(bits[i / 8]) >> i % 8 & 1) != 0;
    values[i] = !is_other ? usual : how == Packed::kTwo ? second : get_raw<T>(in);
  }
  return in.ok();
}

/// The values [begin, end) of a column.
template <typename T>
void pack_run(const std::vector<T>& values, Range run, std::vector<std::byte>& out) {
  if constexpr (std::is_arithmetic_v<T>) {
    pack_numbers(std::span(values).subspan(run.begin, run.end - run.begin), out);
  } else {
    Packer to(out);
    for (std::uint32_t row = run.begin; row < run.end; ++row) put_value(to, values[row]);
  }
}

template <typename T>
void pack_run(const std::vector<std::vector<T>>& lists, Range run,
              std::vector<std::byte>& out) requires std::is_arithmetic_v<T> {
  for (std::uint32_t row = run.begin; row < run.end; ++row) {
    Packer(out).varint(lists[row].size());
    pack_numbers(std::span<const T>(lists[row]), out);
  }
}

template <typename T>
bool unpack_run(std::vector<T>& values, Range run, Unpacker& in) {
  if constexpr (std::is_arithmetic_v<T>) {
    return unpack_numbers(std::span(values).subspan(run.begin, run.end - run.begin), in);
  } else {
    for (std::uint32_t row = run.begin; row < run.end; ++row)
      if (!get_value(in, values[row])) return false;
    return true;
  }
}

template <typename T>
bool unpack_run(std::vector<std::vector<T>>& lists, Range run,
                Unpacker& in) requires std::is_arithmetic_v<T> {
  for (std::uint32_t row = run.begin; row < run.end; ++row) {
    const std::uint64_t size = in.varint();
    if (!in.ok() || size > 8 * in.left()) return false;  // a number takes a bit at least
    lists[row].resize(static_cast<std::size_t>(size));
    if (!unpack_numbers(std::span(lists[row]), in)) return false;
  }
  return true;
}

/// Calls visit(run) for the runs of consecutive values that sensors have in the columns of a table.
template <typename Table, typename Visit>
bool each_run(const World& world, std::span<const ModelRow> models, std::span<const std::uint32_t> rows,
              Per per, const Visit& visit) {
  Range run;
  for (const std::uint32_t row : rows) {
    const Range next = range_of<Table>(world, models[row].index, per);
    if (next.begin == next.end) continue;
    if (next.begin != run.end) {
      if (run.begin != run.end && !visit(run)) return false;
      run.begin = next.begin;
    }
    run.end = next.end;
  }
  return run.begin == run.end || visit(run);
}

/// Calls visit(values, run) for all measurements of the sensors; false at the first false.
template <typename Of, typename Visit>
bool each_sensed(Of& world, scene::ModelKind kind, std::span<const std::uint32_t> rows, const Visit& visit) {
  bool good = true;
  of_kind(kind, [&](auto of_kind_table) {
    const std::span<const ModelRow> models = (world.*of_kind_table).model;
    const auto each_of = [&]<typename Table>(Table Tables::*table) {
      if constexpr (std::is_same_v<decltype(kKindOf<Table>), const scene::ModelKind>)
        if (kKindOf<Table> != kind) return;
      each_column_of<Table>([&](const auto& column) {
        using Values = typename std::remove_cvref_t<decltype(column)>::Values;
        if constexpr (!kIsShared<Values>) {  // these are never measured
          if (column.role != Role::kSensed || !good) return;
          good = each_run<Table>(world, models, rows, column.per,
                                 [&](Range run) { return visit((world.*table).*column.values, run); });
        }
      });
    };
    std::apply([&](auto... table) { (each_of(table), ...); }, kTables);
  });
  return good;
}

}  // namespace

void pack_sensed(const World& world, scene::ModelKind kind, std::span<const std::uint32_t> rows,
                 std::vector<std::byte>& out) {
  each_sensed(world, kind, rows,
              [&](const auto& values, Range run) { return pack_run(values, run, out), true; });
}

bool unpack_sensed(World& world, scene::ModelKind kind, std::span<const std::uint32_t> rows, Unpacker& in) {
  return each_sensed(world, kind, rows, [&](auto& values, Range run) { return unpack_run(values, run, in); });
}

}  // namespace playhouse::world
