#include "playhouse/controllers/fasr.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "playhouse/base/in_quotes.h"

namespace playhouse::controllers {
namespace {

constexpr double kSourceReach = 2, kSinkReach = 1;  // m, Stage's
constexpr double kCruise = 0.4;                     // m/s
constexpr double kSlow = 0.1;                       // m/s, if the way is not ahead
constexpr double kAhead = 0.7;                      // rad, to either side
constexpr double kStop = 0.4;                       // m: what is nearer ahead is turned away from on the spot
constexpr double kTurnMost = 1;                     // rad/s
constexpr double kLane = 0.3;       // rad to the right of the way: those who come pass on the left
constexpr double kEscape = 0.2;     // m/s
constexpr double kBackwards = 0.7;  // share of escapes
constexpr std::uint32_t kEscapeLeast = 8, kEscapeSpread = 16;  // scans
constexpr double kChange = 0.0005;  // probability, at each scan without a flag, of choosing a task
constexpr std::string_view kWaiting = "Waiting...";
constexpr double kPlaces = 2;  // per metre: resolution for recomputing routes to a moving end

geom::Vec2 rounded(geom::Vec2 p) {
  return {std::round(p.x * kPlaces) / kPlaces, std::round(p.y * kPlaces) / kPlaces};
}

/// Transfers a flag. False if the first has none, or the other is full.
bool move_flag(world::World& world, world::ModelRow from, world::ModelRow to) {
  const std::vector<std::int32_t>& flags = world.models.flags;
  if (flags[from.index] == 0 || flags[to.index] == std::numeric_limits<std::int32_t>::max()) return false;
  world::add_flags(world, from, -1);
  world::add_flags(world, to, 1);
  return true;
}

/// Sets or clears the waiting text; other texts stay.
void say_waiting(world::World& world, world::ModelRow robot, bool waits) {
  const std::string& says = world.models.say[robot];
  if (waits != (says == kWaiting) && (waits || says == kWaiting))
    world::set_say(world, robot, waits ? kWaiting : "");
}

std::uint32_t drawn_choice(std::size_t count, Rng random) {
  return static_cast<std::uint32_t>(random.bits() % count);
}

}  // namespace

std::vector<std::array<std::string, 2>> Fasr::ends_of(const Post& post) const {
  std::vector<std::array<std::string, 2>> ends;
  if (arguments_ == Arguments::kTasks)
    for (const std::string& task : post.arguments) ends.push_back({task + "_source", task + "_sink"});
  if (!ends.empty()) return ends;
  ends.push_back({"source", "sink"});
  for (std::size_t k = 0; k < post.arguments.size() && k < 2; ++k) ends[0][k] = post.arguments[k];
  return ends;
}

Result<void> Fasr::join(world::World& world, const Post& post) {
  std::vector<std::array<world::ModelId, 2>> tasks;
  for (const std::array<std::string, 2>& names : ends_of(post)) {
    tasks.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const world::ModelRow found = world.find(names[k]);
      if (!found) return Error{{}, "needs a model " + in_quotes(names[k])};
      tasks.back()[k] = world.id(found);
    }
  }
  if (const Result<void> joined = steering_.join(world, post); !joined) return joined;
  model_.push_back(world.row(post.model));
  std::vector<std::uint32_t>& choices = choices_.emplace_back();
  for (const auto& [source, sink] : tasks) choices.push_back(task_of(world, source, sink, model_.back()));
  choice_.push_back(
      drawn_choice(choices.size(), Rng(world.seed(), world.tick(), steering_.stream(model_.size() - 1))));
  exchange_.push_back(Exchange::kNothing);
  escaping_.push_back(0);
  speed_.push_back(0);
  turn_.push_back(0);
  return {};
}

std::uint32_t Fasr::task_of(const world::World& world, world::ModelId source, world::ModelId sink,
                            world::ModelRow robot) {
  const geom::Size& size = world.desc(robot).size;
  const double clearance = std::sqrt(size.x * size.x + size.y * size.y) / 2;
  const auto found = std::ranges::find_if(tasks_, [&](const TransportTask& task) {
    return task.source.model == source && task.sink.model == sink && task.clearance == clearance &&
           task.height == size.z;
  });
  const auto row = static_cast<std::uint32_t>(found - tasks_.begin());
  if (found == tasks_.end())
    tasks_.push_back({{source, kSourceReach, {}, {}, {}}, {sink, kSinkReach, {}, {}, {}}, clearance, size.z});
  return row;
}

void Fasr::leave_rest(std::size_t i) {
  steering_.leave_rest(i);
  erase_at(i, model_, choices_, exchange_);
}

void Fasr::resolve(const world::World& world, std::size_t i) {
  model_[i] = world.row(id(i));
  steering_.resolve(world, model_[i], i);
}

void Fasr::prepare(const world::World& world, bool rebuilt) {
  for (TransportTask& task : tasks_) prepare(world, rebuilt, task);
}

/// Routes depend on the present state only, so they are the same after a load.
void Fasr::prepare(const world::World& world, bool rebuilt, TransportTask& task) {
  for (TaskEnd* end : {&task.source, &task.sink}) {
    end->row = world.row(end->model);
    if (!end->row) return;
    const geom::Vec2 p_W = rounded(world.models.X_WM[end->row].xy());
    rebuilt = rebuilt || !end->ways || p_W != end->p_W;
    end->p_W = p_W;
  }
  if (!rebuilt) return;
  const auto make = [&](TaskEnd& end, const std::vector<geom::Vec2>& oncoming_W) {
    end.ways.emplace(world, end.p_W, end.reach, task.clearance, task.height, oncoming_W);
  };
  make(task.sink, {});
  make(task.source, task.sink.ways->route(task.source.p_W));
}

void Fasr::choose(const world::World& world, std::size_t i) {
  if (choices_[i].size() == 1 || world.models.flags[model_[i]] > 0) return;
  Rng random(world.seed(), world.tick(), steering_.stream(i));
  if (random.uniform() < kChange) choice_[i] = drawn_choice(choices_[i].size(), random);
}

const Fasr::TaskEnd* Fasr::goal(std::size_t i, bool loaded) const {
  const TransportTask& task = this->task(i);
  return !task.source.row || !task.sink.row ? nullptr : loaded ? &task.sink : &task.source;
}

bool Fasr::is_there(const world::World& world, std::size_t i, const TaskEnd& end) const {
  const geom::Vec2 off = world.models.X_WM[end.row].xy() - world.models.X_WM[model_[i]].xy();
  return geom::dot(off, off) < end.reach * end.reach;
}

bool Fasr::go(world::World& world, std::size_t i, const TaskEnd& end) {
  const geom::Pose& X_WM = world.models.X_WM[model_[i]];
  const std::optional<geom::Vec2> next_W = end.ways->next(X_WM.xy());
  if (!next_W) return false;
  const geom::Vec2 next_M = geom::transform(geom::inverse(X_WM), *next_W);
  const double wanted = geom::normalize(geom::atan2(next_M.y, next_M.x) - kLane);
  const std::optional<FreeWay> way =
      free_way(steering_.beams(world, i), steering_.fan(i), task(i).clearance, wanted);
  if (!way) return false;
  const double speed = way->ahead < kStop ? 0 : std::fabs(way->bearing) > kAhead ? kSlow : kCruise;
  drive(world, steering_.robot(i), speed, std::clamp(way->bearing, -kTurnMost, kTurnMost));
  return true;
}

bool Fasr::escape(world::World& world, std::size_t i) {
  const world::PositionRow robot = steering_.robot(i);
  if (world.positions.stall[robot]) {
    Rng random(world.seed(), world.tick(), steering_.stream(i));
    escaping_[i] = kEscapeLeast + static_cast<std::uint32_t>(random.bits() % kEscapeSpread);
    speed_[i] = random.uniform() < kBackwards ? -kEscape : kEscape;
    turn_[i] = random.uniform() - 0.5;
  }
  if (escaping_[i] == 0) return false;
  --escaping_[i];
  drive(world, robot, speed_[i], turn_[i]);
  return true;
}

void Fasr::decide(world::World& world, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    exchange_[i] = Exchange::kNothing;
    if (!steering_.is_new_scan(world, i)) continue;
    choose(world, i);
    const bool loaded = world.models.flags[model_[i]] > 0;
    const TaskEnd* const to = goal(i, loaded);
    const bool there = to && is_there(world, i, *to);
    if (there) exchange_[i] = loaded ? Exchange::kGives : Exchange::kTakes;
    if (escape(world, i) || (to && !there && go(world, i, *to))) continue;
    steering_.steer(world, i);
  }
}

void Fasr::deliver(world::World& world) {
  for (const std::uint32_t i : by_id()) {
    const TransportTask& task = this->task(i);
    const bool takes = exchange_[i] == Exchange::kTakes;
    say_waiting(world, model_[i], takes && !move_flag(world, task.source.row, model_[i]));
    if (exchange_[i] == Exchange::kGives) move_flag(world, model_[i], task.sink.row);
  }
}

}  // namespace playhouse::controllers
