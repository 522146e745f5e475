#include "playhouse/world/saving/sensed_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "playhouse/world/columns.h"
#include "playhouse/world/saving/packed_values.h"

namespace playhouse::world {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

/// How the numbers of a run are packed. They are compared as bits: -0 is not 0, and the largest of ranges is
/// the largest as bits.
enum class Packed : std::uint8_t {
  kAll,     // each
  kTwo,     // two, and a bit for each that is the second: intensities mostly, of beams that hit and miss
  kSparse,  // one, a bit for each that is another, and those: ranges where most beams miss
};

template <std::size_t>
struct BitsOf;
template <>
struct BitsOf<1> {
  using Type = std::uint8_t;
};
template <>
struct BitsOf<4> {
  using Type = std::uint32_t;
};
template <>
struct BitsOf<8> {
  using Type = std::uint64_t;
};
template <typename T>
using Bits = typename BitsOf<sizeof(T)>::Type;

template <typename T>
Bits<T> bits_of(T value) {
  return std::bit_cast<Bits<T>>(value);
}

template <typename T>
void put_raw(std::span<const T> values, std::vector<std::byte>& out) {
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// A bit for each number that is not `usual`, in whole bytes.
template <typename T>
void put_others(std::span<const T> values, Bits<T> usual, std::vector<std::byte>& out) {
  for (std::size_t i = 0; i < values.size(); i += 8) {
    unsigned bits = 0;
    const std::size_t count = std::min<std::size_t>(8, values.size() - i);
    for (std::size_t k = 0; k < count; ++k)
      bits |= static_cast<unsigned>(bits_of(values[i + k]) != usual) << k;
    out.push_back(static_cast<std::byte>(bits));
  }
}

/// Branch-free: hits are unpredictable.
template <typename T>
void pack_numbers(std::span<const T> values, std::vector<std::byte>& out) {
  Bits<T> least = std::numeric_limits<Bits<T>>::max(), most = 0;
  for (const T value : values) {
    least = std::min(least, bits_of(value));
    most = std::max(most, bits_of(value));
  }
  std::size_t others = 0, thirds = 0;
  for (const T value : values) {
    const unsigned is_other = bits_of(value) != most;
    others += is_other;
    thirds += is_other & static_cast<unsigned>(bits_of(value) != least);
  }
  const Packed how = thirds == 0 ? Packed::kTwo : others > values.size() / 2 ? Packed::kAll : Packed::kSparse;
  out.push_back(static_cast<std::byte>(how));
  if (how == Packed::kAll) return put_raw(values, out);
  put_raw(std::span<const Bits<T>>(&most, 1), out);
  if (how == Packed::kTwo) put_raw(std::span<const Bits<T>>(&least, 1), out);
  put_others(values, most, out);
  if (how == Packed::kTwo) return;
  for (const T& value : values)
    if (bits_of(value) != most) put_raw(std::span(&value, 1), out);
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
  const T either[] = {usual, second};
  const auto is_other = [&](std::size_t i) { return std::to_integer<unsigned>(bits[i / 8]) >> i % 8 & 1; };
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = either[is_other(i)];
  if (how == Packed::kTwo) return true;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_other(i) != 0) values[i] = get_raw<T>(in);
  return in.ok();
}

/// The values [begin, end) of a column.
template <typename T>
PLAYHOUSE_PER_TYPE void pack_run(const std::vector<T>& values, Range run, std::vector<std::byte>& out) {
  if constexpr (std::is_arithmetic_v<T>) {
    pack_numbers(std::span(values).subspan(run.begin, run.end - run.begin), out);
  } else {
    Packer to(out);
    for (std::uint32_t row = run.begin; row < run.end; ++row) put_value(to, values[row]);
  }
}

template <typename T>
PLAYHOUSE_PER_TYPE void pack_run(const std::vector<std::vector<T>>& lists, Range run,
                                 std::vector<std::byte>& out) requires std::is_arithmetic_v<T> {
  for (std::uint32_t row = run.begin; row < run.end; ++row) {
    Packer(out).varint(lists[row].size());
    pack_numbers(std::span<const T>(lists[row]), out);
  }
}

template <typename T>
PLAYHOUSE_PER_TYPE bool unpack_run(std::vector<T>& values, Range run, Unpacker& in) {
  if constexpr (std::is_arithmetic_v<T>) {
    return unpack_numbers(std::span(values).subspan(run.begin, run.end - run.begin), in);
  } else {
    for (std::uint32_t row = run.begin; row < run.end; ++row)
      if (!get_value(in, values[row])) return false;
    return true;
  }
}

template <typename T>
PLAYHOUSE_PER_TYPE bool unpack_run(std::vector<std::vector<T>>& lists, Range run,
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
bool each_run(const World& world, std::span<const ModelRow> models, std::span<const KindRow> rows, Per per,
              const Visit& visit) {
  Range run;
  for (const KindRow row : rows) {
    const Range next = range_of<Table>(world, models[row.index], per);
    if (next.begin == next.end) continue;
    if (next.begin != run.end) {
      if (run.begin != run.end && !visit(run)) return false;
      run.begin = next.begin;
    }
    run.end = next.end;
  }
  return run.begin == run.end || visit(run);
}

/// The models of a kind, by row of its table.
std::span<const ModelRow> models_of(const World& world, scene::ModelKind kind) {
  std::span<const ModelRow> models;
  of_kind(kind, [&](auto table) { models = (world.*table).model; });
  return models;
}

/// Calls visit(values, run) for all measurements of the sensors; false at the first false.
template <typename Of, typename Visit>
bool each_sensed(Of& world, scene::ModelKind kind, std::span<const KindRow> rows, const Visit& visit) {
  bool good = true;
  const std::span<const ModelRow> models = models_of(world, kind);
  const auto each_of = [&]<typename Table>(Table Tables::*table) {
    if constexpr (std::is_same_v<decltype(kKindOf<Table>), const scene::ModelKind>)
      if (kKindOf<Table> != kind) return;
    each_column_of<Table>([&](const auto& column) {
      using Values = typename std::remove_cvref_t<decltype(column)>::Values;
      if constexpr (!kIsShared<Values>) {  // these are never measured
        if (column.role != Role::kSensed || !good) return;
        good = each_run<Table>(world, models, rows, column.per,
                               [&](Range run) { return visit(column.of(world.*table), run); });
      }
    });
  };
  std::apply([&](auto... table) { (each_of(table), ...); }, kTables);
  return good;
}

}  // namespace

void pack_sensed(const World& world, scene::ModelKind kind, std::span<const KindRow> rows,
                 std::vector<std::byte>& out) {
  each_sensed(world, kind, rows,
              [&](const auto& values, Range run) { return pack_run(values, run, out), true; });
}

bool unpack_sensed(World& world, scene::ModelKind kind, std::span<const KindRow> rows, Unpacker& in) {
  return each_sensed(world, kind, rows, [&](auto& values, Range run) { return unpack_run(values, run, in); });
}

}  // namespace playhouse::world
