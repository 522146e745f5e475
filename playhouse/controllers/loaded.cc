#include "playhouse/controllers/loaded.h"

#include <algorithm>
#include <exception>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"

namespace playhouse::controllers {
namespace {

using world::World;

// A library built with another layout of these must not be loaded: raise kControllerVersion with these
// numbers.
static_assert(kControllerVersion == 1 && sizeof(Robot) == 272 && sizeof(Ranger) == 56 &&
              sizeof(Sighting) == 32);

/// Calls `what` and gives the text of what it throws, as one line, or nullptr. It lives as long as `text`.
template <typename Call>
const char* thrown_by(std::string& text, const Call& what) {
  try {
    what();
    return nullptr;
  } catch (const std::exception& error) {
    text = escaped(error.what());
  } catch (...) {
    text = "threw something that is no std::exception";
  }
  return text.c_str();
}

}  // namespace

Result<void> Loaded::add(World& world, const Post& post) {
  auto made = library_.make();
  if (!made) return made.error();
  auto seat = std::make_unique<Seat>();
  seat->controller = std::move(*made);
  seat->model = post.model;
  seat->position = position_of(world, post.model);
  seat->controller_name = post.name;
  seat->name = world.desc(post.model).name;
  seat->arguments = post.arguments;
  seat->ranger_rows = rangers_of(world, post.model);
  seat->finders = finders_of(world, post.model);
  seat->stream = {Purpose::kController, post.model.index, post.order};
  seat->seen.assign(seat->ranger_rows.size(), 0);
  for (const world::RangerRow row : seat->ranger_rows) {
    const scene::ModelDesc& desc = world.desc(world.rangers.model[row.index]);
    seat->bearings.push_back(bearings_of(world, post.model, row));
    Ranger& ranger = seat->rangers.emplace_back();
    ranger.name = desc.name;
    for (const scene::RangerSensorDesc& sensor : desc.sensors) {
      ranger.range_max = std::max(ranger.range_max, static_cast<float>(sensor.range_max));
    }
  }
  for (std::size_t k = 0; k < seat->rangers.size(); ++k) seat->rangers[k].bearings = seat->bearings[k];
  seat->robot.name = seat->name;
  seat->robot.arguments = seat->arguments;
  seat->robot.rangers = seat->rangers;
  seat->robot.say = world.models.say[post.model.index];

  show(world, *seat);
  std::string text;
  if (const char* why = thrown_by(text, [&] { seat->controller->start(seat->robot); })) return Error{{}, why};
  world::subscribe_controller(world, post.model);
  for (std::size_t k = 0; k < seat->rangers.size(); ++k) {
    if (seat->rangers[k].used) {
      world::subscribe_controller(world, world.rangers.model[seat->ranger_rows[k].index]);
    } else {  // else it would see what it measures for others
      seat->ranger_rows[k] = {};
      seat->rangers[k].ranges = {};
    }
  }
  for (const world::FiducialRow finder : seat->finders)
    world::subscribe_controller(world, world.fiducials.model[finder.index]);
  apply_command(world, *seat);
  seats_.push_back(std::move(seat));
  return {};
}

/// Columns to senses.
void Loaded::show(const World& world, Seat& seat) {
  Robot& robot = seat.robot;
  robot.time = world.time();
  robot.dt = world.scene().interval;
  if (seat.position) {
    const std::uint32_t row = seat.position.index;
    robot.pose = world.positions.X_OM[row];
    robot.velocity = world.positions.velocity[row];
    robot.stalled = world.positions.stall[row] != 0;
  } else {
    robot.pose = world.models.X_WM[seat.model.index];
  }
  for (std::size_t k = 0; k < seat.rangers.size(); ++k) {
    const world::RangerRow row = seat.ranger_rows[k];
    if (!row) continue;
    const std::uint64_t measured = world.rangers.measured_tick[row.index];
    seat.rangers[k].ranges =
        std::span(world.sensors.ranges).subspan(first_beam(world, row), seat.bearings[k].size());
    seat.rangers[k].fresh = measured != seat.seen[k];
    seat.seen[k] = measured;
  }
  seat.sightings.clear();
  for (const world::FiducialRow finder : seat.finders) {
    for (const world::FiducialHit& hit : world.fiducials.hits[finder.index]) {
      seat.sightings.push_back({hit.id, hit.range, hit.bearing, hit.heading});
    }
  }
  robot.sightings = seat.sightings;
  robot.random = Rng(world.seed(), world.tick(), seat.stream);
  robot.flags = world.models.flags[seat.model.index];
  robot.order = Robot::Order::kNone;
}

/// Orders to columns.
void Loaded::apply_command(World& world, Seat& seat) {
  const Robot& robot = seat.robot;
  bool applied = true;
  if (seat.position && robot.order == Robot::Order::kDrive) {
    applied = world::command_velocity(world, seat.position, robot.twist);
  } else if (seat.position && robot.order == Robot::Order::kGoTo) {
    applied = world::command_position(world, seat.position, robot.goal);
  }
  if (!applied) return end(world, seat, "its command has a number that is not finite or far too large");
  world.models.flags[seat.model.index] = robot.flags;
  std::string& say = world.models.say[seat.model.index];
  if (say != robot.say) say = robot.say;
}

void Loaded::end(World& world, Seat& seat, const char* why) {
  seat.ended = true;
  if (seat.position) drive(world, seat.position, 0, 0);
  log::error("{}: controller {} of {} ended: {}", world.scene().at(world.desc(seat.model).where),
             in_quotes(seat.controller_name), in_quotes(seat.name), why);
}

void Loaded::decide(World& world, std::size_t begin, std::size_t end_row) {
  for (std::size_t i = begin; i < end_row; ++i) {
    Seat& seat = *seats_[i];
    if (seat.ended) continue;
    show(world, seat);
    std::string text;
    if (const char* why = thrown_by(text, [&] { seat.controller->decide(seat.robot); })) {
      end(world, seat, why);
    } else {
      apply_command(world, seat);
    }
  }
}

void Loaded::hash(Hash& hash) const {
  for (const std::unique_ptr<Seat>& seat : seats_) hash.add(std::uint64_t{seat->ended});
}

}  // namespace playhouse::controllers
