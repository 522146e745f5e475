#include "playhouse/controllers/loaded.h"

#include <algorithm>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log_at.h"
#include "playhouse/libraries/thrown_by.h"

namespace playhouse::controllers {
namespace {

using world::World;

// Libraries with another layout must be rejected:
// increment kControllerVersion together with these sizes.
static_assert(kControllerVersion == 2 && sizeof(Robot) == 272 && sizeof(Ranger) == 56 &&
              sizeof(Sighting) == 32);

}  // namespace

/// Rows of the robot's parts; an unused ranger stays unused.
void Loaded::find_rows(const World& world, Seat& seat) {
  seat.model = world.row(seat.id);
  seat.position = position_of(world, seat.model);
  std::vector<world::RangerRow> rangers = rangers_of(world, seat.model);
  for (std::size_t k = 0; k < rangers.size() && k < seat.rangers.size(); ++k)
    if (!seat.rangers[k].used) rangers[k] = {};
  seat.ranger_rows = std::move(rangers);
  seat.finders = finders_of(world, seat.model);
}

void Loaded::resolve(const World& world, std::size_t i) {
  find_rows(world, *seats_[i]);
}

Result<void> Loaded::join(World& world, const Post& post) {
  auto made = library_->make<Controller>();
  if (!made) return made.error();
  auto seat = std::make_unique<Seat>();
  seat->controller = std::move(*made);
  seat->id = post.model;
  seat->controller_name = post.name;
  seat->arguments = post.arguments;
  seat->stream = {Purpose::kController, world.serial(post.model), post.order};
  find_rows(world, *seat);
  seat->name = world.name(seat->model);
  seat->seen.assign(seat->ranger_rows.size(), 0);
  for (const world::RangerRow row : seat->ranger_rows) {
    const world::ModelRow model = world.rangers.model[row];
    seat->bearings.push_back(bearings_of(world, seat->model, row));
    seat->ranger_names.push_back(world.name(model));
    Ranger& ranger = seat->rangers.emplace_back();
    for (const scene::RangerSensorDesc& sensor : world.desc(model).sensors) {
      ranger.range_max = std::max(ranger.range_max, static_cast<float>(sensor.range_max));
    }
  }
  for (std::size_t k = 0; k < seat->rangers.size(); ++k) {
    seat->rangers[k].bearings = seat->bearings[k];
    seat->rangers[k].name = seat->ranger_names[k];
  }
  seat->robot.name = seat->name;
  seat->robot.arguments = seat->arguments;
  seat->robot.rangers = seat->rangers;

  show(world, *seat);
  std::string text;
  if (const char* why = libraries::thrown_by(text, [&] { seat->controller->start(seat->robot); }))
    return Error{{}, why};
  world::subscribe_controller(world, seat->model);
  for (std::size_t k = 0; k < seat->rangers.size(); ++k) {
    if (seat->rangers[k].used) {
      world::subscribe_controller(world, world.rangers.model[seat->ranger_rows[k]]);
    } else {  // otherwise it would see measurements made for others
      seat->ranger_rows[k] = {};
      seat->rangers[k].ranges = {};
    }
  }
  for (const world::FiducialRow finder : seat->finders)
    world::subscribe_controller(world, world.fiducials.model[finder]);
  if (take_orders(world, *seat)) give(world, *seat);
  seats_.push_back(std::move(seat));
  gives_.push_back(0);
  return {};
}

/// Copies columns to the controller's view.
void Loaded::show(const World& world, Seat& seat) {
  Robot& robot = seat.robot;
  robot.time = world.time();
  robot.dt = world.scene().interval;
  if (seat.position) {
    const world::PositionRow row = seat.position;
    robot.pose = world.positions.X_OM[row];
    robot.velocity = world.positions.velocity[row];
    robot.stalled = world.positions.stall[row] != 0;
  } else {
    robot.pose = world.models.X_WM[seat.model];
  }
  for (std::size_t k = 0; k < seat.rangers.size(); ++k) {
    const world::RangerRow row = seat.ranger_rows[k];
    if (!row) continue;
    const std::uint64_t measured = world.rangers.measured_tick[row];
    seat.rangers[k].ranges =
        std::span(world.sensors.ranges.from(first_beam(world, row)), seat.bearings[k].size());
    seat.rangers[k].fresh = measured != seat.seen[k];
    seat.seen[k] = measured;
  }
  seat.sightings.clear();
  for (const world::FiducialRow finder : seat.finders) {
    for (const world::FiducialHit& hit : world.fiducials.hits[finder]) {
      seat.sightings.push_back({hit.id, hit.range, hit.bearing, hit.heading});
    }
  }
  robot.sightings = seat.sightings;
  robot.random = Rng(world.seed(), world.tick(), seat.stream);
  robot.flags = world.models.flags[seat.model];
  if (const std::string& say = world.models.say[seat.model]; robot.say != say) robot.say = say;
  robot.order = Robot::Order::kNone;
}

bool Loaded::take_orders(World& world, Seat& seat) {
  const Robot& robot = seat.robot;
  bool applied = true;
  if (seat.position && robot.order == Robot::Order::kDrive) {
    applied = world::command_velocity(world, seat.position, robot.twist);
  } else if (seat.position && robot.order == Robot::Order::kGoTo) {
    applied = world::command_position(world, seat.position, robot.goal);
  }
  if (!applied) {
    end(world, seat, "its command has a number that is not finite or far too large");
    return false;
  }
  seat.more_flags = std::int64_t{robot.flags} - world.models.flags[seat.model];
  seat.says = robot.say != world.models.say[seat.model];
  return seat.more_flags != 0 || seat.says;
}

void Loaded::give(World& world, const Seat& seat) {
  world::add_flags(world, seat.model, seat.more_flags);
  if (seat.says) world::set_say(world, seat.model, seat.robot.say);
}

void Loaded::end(World& world, Seat& seat, const char* why) {
  seat.ended = true;
  if (seat.position) drive(world, seat.position, 0, 0);
  log::error_at(world.scene().at(world.where(seat.model)), "controller {} of {} ended: {}",
                in_quotes(seat.controller_name), in_quotes(seat.name), why);
}

void Loaded::decide(World& world, std::size_t begin, std::size_t end_row) {
  for (std::size_t i = begin; i < end_row; ++i) {
    Seat& seat = *seats_[i];
    gives_[i] = 0;
    if (seat.ended) continue;
    show(world, seat);
    std::string text;
    if (const char* why = libraries::thrown_by(text, [&] { seat.controller->decide(seat.robot); })) {
      end(world, seat, why);
    } else {
      gives_[i] = take_orders(world, seat);
    }
  }
}

void Loaded::deliver(World& world) {
  for (const std::uint32_t i : by_id())
    if (gives_[i]) give(world, *seats_[i]);
}

/// False: the controller cannot be saved; `why` is its exception, if any.
bool Loaded::remember(const Seat& seat, std::string& memory, std::string& why) const {
  constexpr std::uint32_t kSaves = 2;  // first version with Controller::save
  bool saved = false;
  if (library_->version() >= kSaves)
    libraries::thrown_by(why, [&] { saved = seat.controller->save(memory); });
  return saved;
}

void Loaded::hash_of(std::size_t i, Hash& hash) const {
  hash.add(std::uint64_t{seats_[i]->ended});
  std::string memory, why;
  if (!remember(*seats_[i], memory, why)) return;
  for (const char letter : memory) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(letter)));
}

Result<void> Loaded::save_of(std::size_t i, Packer& out) const {
  const Seat& seat = *seats_[i];
  std::string memory, why;
  if (!remember(seat, memory, why)) {
    if (why.empty()) why = "it does not override Controller::save (docs/controllers.md)";
    return Error{{},
                 "controller " + in_quotes(seat.controller_name) + " of " + in_quotes(seat.name) +
                     " cannot be saved: " + why};
  }
  out.u8(seat.ended);
  out.varint(seat.seen.size());
  for (const std::uint64_t tick : seat.seen) out.u64(tick);
  out.text(memory);
  return {};
}

bool Loaded::load_of(World& world, std::size_t i, Unpacker& in) {
  Seat& seat = *seats_[i];
  seat.ended = in.u8() != 0;
  if (in.varint() != seat.seen.size()) return false;
  for (std::uint64_t& tick : seat.seen) tick = in.u64();
  const std::string memory = in.text();
  if (!in.ok()) return false;
  std::string text;
  const char* const why = libraries::thrown_by(text, [&] { seat.controller->load(memory); });
  if (why != nullptr && !seat.ended) end(world, seat, why);
  return true;
}

}  // namespace playhouse::controllers
