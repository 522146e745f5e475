#include "playhouse/bridge/simulated/joining.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/config/text/expand.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/speech.h"

namespace playhouse::drivers {
namespace {

using world::World;

constexpr std::size_t kMostSensors = 64;  // limit for one robot

/// "TYPE" or "TYPE X Y HEADING" [m, rad].
Result<RobotRequest::SensorRequest> parse_sensor(const std::string& text) {
  std::istringstream words(text);
  RobotRequest::SensorRequest sensor;
  words >> sensor.type;
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const std::optional<double> number = config::parse_number(word);
    if (!number) return Error{"", in_quotes(text) + ": a sensor is a type, or a type with x, y and heading"};
    numbers.push_back(*number);
  }
  if (numbers.size() == 3) sensor.X_RS = geom::Pose{numbers[0], numbers[1], 0, numbers[2]};
  if (sensor.type.empty() || (!numbers.empty() && numbers.size() != 3))
    return Error{"", in_quotes(text) + ": a sensor is a type, or a type with x, y and heading"};
  return sensor;
}

/// A resolved type: a prototype, and the model to copy, if it is named by a model.
struct Type {
  std::uint32_t prototype = 0;
  world::ModelRow like;
};

/// Suggestions for an unknown type, of robots or of other models.
std::string nearest_types(const World& world, std::string_view word, bool robots) {
  std::set<std::string> names;
  for (const scene::ModelDesc& desc : world.scene().models)
    if (desc.parent < 0 && (desc.kind == scene::ModelKind::kPosition) == robots && !desc.prototype.empty())
      names.insert(desc.prototype);
  const std::vector<std::string_view> words(names.begin(), names.end());
  const std::string meant = did_you_mean(word, words);
  if (!meant.empty() || words.empty()) return meant;
  return fmt::format("; there are {}", fmt::join(words, ", "));
}

Result<Type> find_type(const World& world, const std::string& word, bool robot) {
  const std::vector<scene::ModelDesc>& models = world.scene().models;
  std::optional<Type> found;
  if (const auto type = world.scene().robot_types.find(word); type != world.scene().robot_types.end())
    found = Type{type->second, {}};
  for (std::uint32_t row = 0; row < models.size() && !found; ++row)
    if (models[row].parent < 0 && models[row].prototype == word) found = Type{row, {}};
  if (const world::ModelRow model = world.find(word); !found && model) {
    const world::ModelRow top = world.models.root[model];
    found = Type{world.models.desc[top], top};
  }
  const std::string what = robot ? "robot" : "sensor";
  if (!found)
    return Error{"", fmt::format("the world has no type of {} {}{}", what, in_quotes(word),
                                 nearest_types(world, word, robot))};
  if ((models[found->prototype].kind == scene::ModelKind::kPosition) != robot)
    return Error{
        "", fmt::format("{} is not a {}: it is a {}", in_quotes(word), what, models[found->prototype].type)};
  return *found;
}

std::string name_for(const World& world, const std::string& wanted, const std::string& type) {
  if (!wanted.empty()) return wanted;
  return world.find(type) ? world::fresh_name(world, type) : type;
}

Result<scene::Color> color_of(const std::string& name) {
  const std::optional<scene::Color> color = scene::color_by_name(name);
  if (!color) return Error{"", "there is no color " + in_quotes(name) + scene::color_hint(name)};
  return *color;
}

/// Pose of a sensor on a robot: as in world files, on its top if that stacks.
geom::Pose place_on(const World& world, const Joined& joined, const Type& type,
                    const RobotRequest::SensorRequest& sensor) {
  const scene::ModelDesc& robot = world.desc(world.row(joined.robot));
  const geom::Pose said = world.scene().models[type.prototype].X_PM;
  geom::Pose X_RS = sensor.X_RS.value_or(said);
  X_RS.z = said.z + (robot.stacks_children ? robot.size.z : 0);
  return X_RS;
}

/// Spawns a sensor, not attached yet. Returns where it goes.
Result<world::AttachedChild> make_sensor(world::Journal& journal, Joined& joined,
                                         const RobotRequest::SensorRequest& sensor) {
  const World& world = journal.world();
  const Result<Type> type = find_type(world, sensor.type, false);
  if (!type) return type.error();
  const std::string wanted = joined.name + "-" + sensor.type;
  const Result<world::ModelId> came =
      journal.spawn(type->prototype, world.models.X_WM[world.row(joined.robot)],
                    world.find(wanted) ? world::fresh_name(world, wanted) : wanted);
  if (!came) return came.error();
  joined.sensors.push_back(*came);
  return world::AttachedChild{*came, place_on(world, joined, *type, sensor)};
}

Result<void> add_sensors(world::Journal& journal, Joined& joined,
                         std::span<const RobotRequest::SensorRequest> sensors) {
  world::changes::Attach attach{{}, joined.robot, {}};
  for (const RobotRequest::SensorRequest& sensor : sensors) {
    const Result<world::AttachedChild> made = make_sensor(journal, joined, sensor);
    if (!made) return made.error();
    attach.children.push_back(made->child);
    attach.X_PC.push_back(made->X_PC);
  }
  return journal.apply(std::move(attach));
}

}  // namespace

Result<RobotRequest> parse_join_request(std::string_view type, std::string_view value) {
  double place[3];
  if (value.size() < sizeof place) return Error{"", "x, y and heading are needed, as three float64"};
  std::memcpy(place, value.data(), sizeof place);
  RobotRequest request;
  request.type = type;
  request.X_WR = {place[0], place[1], 0, place[2]};
  if (!world::is_place(request.X_WR)) return Error{"", "invalid pose: not finite, or too far away"};
  std::vector<std::string> texts;
  for (std::string_view rest = value.substr(sizeof place); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\0'), rest.size());
    texts.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (!texts.empty()) request.name = texts[0];
  if (texts.size() > 1) request.color = texts[1];
  if (!request.name.empty() && !world::can_be_said(request.name))
    return Error{"", fmt::format("invalid name: a line of up to {} bytes is valid", limits::kSayBytes)};
  if (texts.size() > 2 + kMostSensors)
    return Error{"", fmt::format("a robot brings {} sensors at most", kMostSensors)};
  for (std::size_t i = 2; i < texts.size(); ++i) {
    Result<RobotRequest::SensorRequest> sensor = parse_sensor(texts[i]);
    if (!sensor) return sensor.error();
    request.sensors.push_back(std::move(*sensor));
  }
  return request;
}

Result<std::vector<std::uint32_t>> types_of(const World& world, const RobotRequest& request) {
  const Result<Type> robot = find_type(world, request.type, true);
  if (!robot) return robot.error();
  std::vector<std::uint32_t> types{robot->prototype};
  for (const RobotRequest::SensorRequest& sensor : request.sensors) {
    const Result<Type> type = find_type(world, sensor.type, false);
    if (!type) return type.error();
    types.push_back(type->prototype);
  }
  return types;
}

Result<Joined> join(world::Journal& journal, const RobotRequest& request) {
  const World& world = journal.world();
  if (const Result<void> room = world::check_budget(world); !room) return room.error();
  const Result<Type> type = find_type(world, request.type, true);
  // Validates everything before the first spawn: atomic.
  if (const auto known = types_of(world, request); !known) return known.error();
  std::optional<scene::Color> color;
  if (!request.color.empty()) {
    const Result<scene::Color> read = color_of(request.color);
    if (!read) return read.error();
    color = *read;
  } else if (type->like) {
    color = world.models.color[type->like];
  }
  geom::Pose X_WR = request.X_WR;
  X_WR.z = world.scene().models[type->prototype].X_PM.z;
  if (const Result<void> near = check_near(world, X_WR); !near) return near.error();
  if (!is_free(world, type->prototype, X_WR))
    return Error{"", fmt::format("the place at {:.2f} {:.2f} is occupied", X_WR.x, X_WR.y)};
  const Result<world::ModelId> came =
      journal.spawn(type->prototype, X_WR, name_for(world, request.name, request.type));
  if (!came) return came.error();
  const world::ModelRow row = world.row(*came);
  if (color) journal.apply(world::changes::SetColor{*came, *color});
  Joined joined{*came, world.name(row), {}};
  if (const Result<void> added = add_sensors(journal, joined, request.sensors); !added) {
    leave(journal, std::span(&joined, 1));
    return added.error();
  }
  return joined;
}

/// After a restart other models may have the ids.
void leave(world::Journal& journal, std::span<const Joined> joined) {
  const World& world = journal.world();
  std::vector<world::ModelId> gone, attached;
  for (const Joined& each : joined) {
    for (const world::ModelId sensor : each.sensors) {
      const world::ModelRow row = world.row(sensor);
      if (!row || world.desc(row).parent >= 0 || !world.name(row).starts_with(each.name + "-")) continue;
      if (world.models.parent_id[row]) attached.push_back(sensor);
      gone.push_back(sensor);
    }
    const world::ModelRow robot = world.row(each.robot);
    if (robot && !world.models.parent_id[robot] && world.name(robot) == each.name) gone.push_back(each.robot);
  }
  if (!attached.empty()) static_cast<void>(journal.apply(world::changes::Detach{std::move(attached)}));
  if (!gone.empty()) static_cast<void>(journal.apply(world::changes::Despawn{std::move(gone)}));
}

}  // namespace playhouse::drivers
