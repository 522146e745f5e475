#include "playhouse/world/saving/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/packing.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/drawing.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/radio_messages.h"
#include "playhouse/world/saving/hash_values.h"
#include "playhouse/world/saving/packed_values.h"
#include "playhouse/world/speech.h"

namespace playhouse::world {
namespace {

template <typename Values>
PLAYHOUSE_PER_TYPE Result<void> put_column(Packer& out, const char* name, const Values& values) {
  out.text(name);
  out.varint(values.size());
  bool good = true;
  for (std::size_t row = 0; row < values.size(); ++row) good = put_value(out, values[row]) && good;
  if (good) return {};
  return Error{{}, fmt::format("{} has an invalid value, or a place too far away", name)};
}

Error damaged(std::string_view what) {
  return Error{{}, fmt::format("is damaged: {}", what)};
}

/// Reads the header of the expected column; returns its number of values.
Result<std::uint64_t> get_head(Unpacker& in, const char* name) {
  const std::string found = in.text();
  const std::uint64_t size = in.varint();
  if (!in.ok()) return damaged("it ends too early");
  if (found != name)
    return Error{
        {},
        fmt::format("has column {} where {} is expected: another version wrote it", in_quotes(found), name)};
  if (size > in.left()) return damaged(fmt::format("{} has more values than there are bytes", name));
  return size;
}

/// Reads the header of the expected column with so many values.
Result<void> check_head(Unpacker& in, const char* name, std::size_t expected) {
  const Result<std::uint64_t> size = get_head(in, name);
  if (!size) return size.error();
  if (*size == expected) return {};
  return damaged(fmt::format("{} has {} values where {} are expected", name, *size, expected));
}

/// Reads as many values as expected.
template <typename Values>
PLAYHOUSE_PER_TYPE Result<void> get_values(Unpacker& in, const char* name, Values& values) {
  for (std::size_t row = 0; row < values.size(); ++row) {
    typename Values::value_type value{};
    if (!get_value(in, value)) return damaged(fmt::format("{} has an invalid value", name));
    if constexpr (kIsShared<Values>) {
      values.set(row, value);
    } else {
      values[row] = std::move(value);
    }
  }
  return {};
}

template <typename T>
Result<void> get_column(Unpacker& in, const char* name, std::vector<T>& values) {
  const Result<std::uint64_t> size = get_head(in, name);
  if (!size) return size.error();
  values.resize(static_cast<std::size_t>(*size));
  return get_values(in, name, values);
}

/// The population as read, before validation.
struct Census {
  std::vector<ModelId> id, parent;
  std::vector<std::uint32_t> desc;
};

/// True if the rows from `top` on are a complete tree of the scene, with
/// consecutive ids, as despawn() requires. Sets `count` to its size.
bool is_tree(const Census& census, std::size_t top, const scene::SceneDesc& scene, std::size_t& count) {
  const std::uint32_t first = census.desc[top];
  count = scene::tree_size(scene, first);
  if (count == 0 || top + count > census.id.size()) return false;
  for (std::uint32_t i = 1; i < count; ++i) {
    const auto parent = static_cast<std::uint32_t>(scene.models[first + i].parent) - first;
    if (census.desc[top + i] != first + i || census.id[top + i].value != census.id[top].value + i ||
        census.parent[top + i].value != census.id[top].value + parent)
      return false;
  }
  return true;
}

Result<void> check(const Census& census, std::uint32_t next_id, const Serials& serials,
                   const scene::SceneDesc& scene) {
  const std::size_t count = census.id.size();
  if (census.desc.size() != count || census.parent.size() != count)
    return damaged("its columns differ in length");
  for (std::size_t row = 0; row < count; ++row) {
    if (row > 0 && census.id[row] <= census.id[row - 1]) return damaged("its models are out of order");
    if (census.id[row].value >= next_id || serials.is_in_gap(census.id[row]))
      return damaged("a model has an id that was never given");
    if (census.desc[row] >= scene.models.size()) return damaged("a model is not in its scene");
  }
  for (std::size_t top = 0, size = 0; top < count; top += size)
    if (!is_tree(census, top, scene, size)) return damaged("a model lacks a part");
  return {};
}

/// Keeps subscriptions of models that are in both states.
class KeptUsers {
  template <typename Of>
  static auto users_of(Of& models, ModelRow row) {
    return std::tie(models.subscribers[row], models.controllers[row], models.watchers[row]);
  }

 public:
  explicit KeptUsers(const World& world) {
    const Models& models = world.models;
    for (const ModelRow row : models.rows()) users_[models.id[row]] = users_of(models, row);
    for (const CameraRow row : world.cameras.rows())
      if (world.cameras.stereo_open[row]) stereo_.insert(models.id[world.cameras.model[row]]);
  }
  void give_back(World& world) const {
    Models& models = world.models;
    for (const ModelRow row : models.rows()) {
      const auto kept = users_.find(models.id[row]);
      if (kept != users_.end()) users_of(models, row) = kept->second;
    }
    for (const CameraRow row : world.cameras.rows())
      world.cameras.stereo_open[row] = stereo_.contains(models.id[world.cameras.model[row]]);
  }

 private:
  std::map<ModelId, std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> users_;
  std::set<ModelId> stereo_;  // cameras whose pairs are read
};

class Loader {
 public:
  Loader(World& world, Unpacker& in) : world_(world), in_(in), population_(world) {}
  Loader(World& world, Unpacker& in, std::uint64_t seed) : Loader(world, in) { seed_ = seed; }

  Result<void> load() {
    const KeptUsers users(world_);
    if (const Result<void> read = read_head(); !read) return read;
    if (const Result<void> read = read_population(); !read) return read;
    if (const Result<void> read = read_columns(); !read) return read;
    for (const ModelRow row : world_.models.rows())
      if (world_.models.root[row] == row) place(row);
    users.give_back(world_);
    ++world_.said_;
    ++world_.drawn_;
    world_.events.add({Event::EventKind::kReload, {}, {}, 0, Mobility::kFixed});
    return read_deciders();
  }

 private:
  Result<void> read_head() {
    const std::uint64_t seed = in_.u64();
    if (seed_) {
      population_.seed() = *seed_;
    } else if (seed != world_.seed() && in_.ok()) {
      return damaged("it has another seed");
    }
    tick_ = in_.u64();
    next_id_ = in_.u32();
    if (!read_gaps()) return damaged("its ids have an invalid gap");
    const std::uint64_t given = in_.varint();
    if (!in_.ok() || given > in_.left()) return damaged("it ends too early");
    if (tick_ > kTicksMost) return damaged("its time is out of range");
    for (std::uint64_t i = 0; i < given; ++i) {
      Population::Given entry;
      ModelId id;
      const bool good = get_value(in_, id) && get_value(in_, entry.name) && get_value(in_, entry.X_WM);
      if (!good || (!given_.empty() && id <= given_.rbegin()->first))
        return damaged("it has an invalid name");
      given_.emplace(id, std::move(entry));
    }
    return {};
  }

  bool read_gaps() {
    const std::uint64_t count = in_.varint();
    if (!in_.ok() || count > in_.left()) return false;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint32_t begin = in_.u32(), end = in_.u32();
      if (!in_.ok() || end >= next_id_ || !serials_.add({begin, end})) return false;
    }
    return true;
  }

  Result<void> read_population() {
    Census census;
    Result<void> read = get_column(in_, "models.id", census.id);
    if (read) read = get_column(in_, "models.desc", census.desc);
    if (read) read = get_column(in_, "models.parent_id", census.parent);
    if (read) read = check(census, next_id_, serials_, world_.scene());
    if (!read) return read;
    population_.clear();
    population_.serials() = std::move(serials_);
    if (const Result<void> room = population_.check_room(census.desc); !room) return room;
    for (std::size_t row = 0; row < census.id.size(); ++row)
      population_.append(census.id[row], census.desc[row], {}, {});
    world_.models.parent_id.assign(census.parent.begin(), census.parent.end());
    population_.next_id() = next_id_;
    population_.given() = std::move(given_);
    world_.tick_ = tick_;
    return population_.derive() ? Result<void>() : damaged("its models do not form trees");
  }

  Result<void> read_columns() {
    Result<void> result;
    each_column(
        [&](const auto& column, auto& values) {
          if (!result || !is_saved(column.role) || column.role == Role::kPopulation) return;
          result = check_head(in_, column.name, values.size());
          if (result) result = get_values(in_, column.name, values);
        },
        world_);
    if (result) result = check_ticks();
    if (result) result = check_tilts();
    if (result) result = check_messages();
    if (result) result = check_drawings();
    return result ? check_says() : result;
  }

  /// Rejects measurements in the future, which would block sensors until then.
  Result<void> check_ticks() {
    bool ahead = false;
    each_kind_table([&]<typename Table>(Table Tables::*table) {
      if constexpr (requires(Table rows) { rows.measured_tick; })
        for (const std::uint64_t tick : (world_.*table).measured_tick) ahead = ahead || tick > tick_;
    });
    return ahead ? damaged("a sensor measured in the future") : Result<void>{};
  }

  Result<void> check_tilts() {
    if (!world_.upright) return {};
    for (const ModelRow row : world_.models.rows())
      if (world_.models.tilt_PM[row] != geom::Tilt{})
        return Error{{}, "has models that are tilted, and this engine keeps all upright"};
    return {};
  }

  Result<void> check_messages() const {
    for (const WifiRow radio : world_.wifis.rows())
      if (!are_whole(outgoing_of(world_.wifis, {radio})) || !are_whole(incoming_of(world_.wifis, {radio})))
        return damaged("a message of a radio is not whole");
    return {};
  }

  Result<void> check_drawings() const {
    bool good = true;
    world_.models.drawing.each_kept(
        [&](const std::vector<DrawnCorner>& drawing) { good = good && is_drawing(drawing); });
    return good ? Result<void>{} : damaged("a model has a drawing with incomplete shapes");
  }

  Result<void> check_says() const {
    bool good = true;
    world_.models.say.each_kept([&](const std::string& text) { good = good && can_be_said(text); });
    return good ? Result<void>{} : damaged("a model says what is not a line of text");
  }

  void place(ModelRow row) {
    world::place(world_.models, row);
    for (const ModelRow child : world_.children(row)) place(child);
  }

  Result<void> read_deciders() {
    for (const std::unique_ptr<Decider>& decider : world_.deciders) decider->follow(world_);
    const std::uint64_t count = in_.varint();
    if (!in_.ok() || count != world_.deciders.size()) return damaged("it has other controllers");
    for (const std::unique_ptr<Decider>& decider : world_.deciders) {
      if (in_.text() != decider->name()) return damaged("it has other controllers");
      if (!decider->load(world_, in_))
        return damaged(fmt::format("the state of controller {} is invalid", in_quotes(decider->name())));
    }
    return in_.ok() && in_.at_end() ? Result<void>() : damaged("something follows its end");
  }

  static constexpr std::uint64_t kTicksMost = 1ull << 53;  // time() is exact up to here

  World& world_;
  Unpacker& in_;
  Population population_;
  std::optional<std::uint64_t> seed_;  // overrides the saved seed
  std::uint64_t tick_ = 0;
  std::uint32_t next_id_ = 0;
  Serials serials_;
  std::map<ModelId, Population::Given> given_;
};

template <typename T>
std::uint64_t hash_of(const World& world, const T& value) {
  Hash hash;
  add_value(hash, world, value);
  return hash.value();
}

std::uint64_t hash_of(const World& world, const Decider& decider) {
  Hash hash;
  decider.hash(world, hash);
  return hash.value();
}

template <typename Values>
PLAYHOUSE_PER_TYPE bool are_same(const World& a, const Values& values_a, const World& b,
                                 const Values& values_b, Range range) {
  if (range.end > values_b.size()) return false;
  for (std::uint32_t i = range.begin; i < range.end; ++i)
    if (hash_of(a, values_a[i]) != hash_of(b, values_b[i])) return false;
  return true;
}

/// The first differing column of a model, in the same row of both worlds.
std::optional<std::string> differing_column(const World& a, const World& b, ModelRow row) {
  std::optional<std::string> found;
  const bool sensed = a.models.controllers[row] > 0 || b.models.controllers[row] > 0;
  each_value_of(
      a, row,
      [&](const auto& column, const auto& values_a, const auto& values_b, Range range) {
        if (found || !(is_done(column.role) || (sensed && column.role == Role::kSensed))) return;
        if (!are_same(a, values_a, b, values_b, range)) found = column.name;
      },
      a, b);
  return found;
}

}  // namespace

std::string Difference::text() const {
  return model ? fmt::format("model {}, column {}", model.value, column) : column;
}

Result<void> save_state(const World& world, std::vector<std::byte>& bytes) {
  Packer out(bytes);
  out.u64(world.seed());
  out.u64(world.tick());
  out.u32(Population::next_id(world));
  const std::span<const Serials::Gap> gaps = Population::serials(world).gaps();
  out.varint(gaps.size());
  for (const Serials::Gap& gap : gaps) {
    out.u32(gap.begin);
    out.u32(gap.end);
  }
  const auto& given = Population::given(world);
  out.varint(given.size());
  for (const auto& [id, entry] : given) {
    put_value(out, id);
    put_value(out, entry.name);
    put_value(out, entry.X_WM);
  }
  Result<void> put;
  each_column(
      [&](const auto& column, const auto& values) {
        if (put && is_saved(column.role)) put = put_column(out, column.name, values);
      },
      world);
  if (!put) return put;
  out.varint(world.deciders.size());
  for (const std::unique_ptr<Decider>& decider : world.deciders) {
    out.text(decider->name());
    if (const Result<void> saved = decider->save(out); !saved) return saved;
  }
  return {};
}

std::uint64_t tick_of(std::span<const std::byte> state) {
  Unpacker in(state);
  in.u64();  // the seed
  return in.u64();
}

Result<void> load_state(World& world, std::span<const std::byte> state) {
  Unpacker in(state);
  return Loader(world, in).load();
}

Result<void> load_state(World& world, std::span<const std::byte> state, std::uint64_t seed) {
  Unpacker in(state);
  return Loader(world, in, seed).load();
}

std::optional<Difference> first_difference(const World& a, const World& b) {
  if (a.tick() != b.tick()) return Difference{{}, "tick"};
  const RowsOf<ModelTable> in_both(std::min(a.models.size(), b.models.size()));
  for (const ModelRow row : in_both) {
    if (a.serial(row) != b.serial(row))
      return Difference{std::min(a.models.id[row], b.models.id[row]), "models.id"};
    if (std::optional<std::string> column = differing_column(a, b, row))
      return Difference{a.models.id[row], std::move(*column)};
  }
  if (a.models.size() != b.models.size()) {
    const World& longer = a.models.size() > b.models.size() ? a : b;
    return Difference{longer.models.id[*in_both.end()], "models.id"};
  }
  for (std::size_t i = 0; i < std::min(a.deciders.size(), b.deciders.size()); ++i)
    if (hash_of(a, *a.deciders[i]) != hash_of(b, *b.deciders[i]))
      return Difference{{}, fmt::format("controller {}", a.deciders[i]->name())};
  if (a.hash() != b.hash()) return Difference{{}, "hash"};
  return std::nullopt;
}

}  // namespace playhouse::world
