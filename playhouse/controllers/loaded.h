#pragma once

/// Loaded: all robots that run the controller of one shared
/// library; copies columns into Robot, and its commands back.

#include <memory>

#include "playhouse/controllers/batch.h"
#include "playhouse/controllers/controller.h"
#include "playhouse/libraries/shared_library.h"

namespace playhouse::controllers {

class Loaded final : public Batch {
 public:
  Loaded(std::string name, std::shared_ptr<libraries::SharedLibrary> library)
      : Batch(std::move(name)), library_(std::move(library)) {}

  /// If a controller throws, this is logged once, its robot stops, and it is not called again.
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void deliver(world::World& world) override;

 private:
  /// A controller object and its robot.
  struct Seat {
    std::unique_ptr<Controller> controller;
    world::ModelId id;
    world::ModelRow model;
    world::PositionRow position;  // none: it does not drive
    std::string controller_name, name;
    std::vector<std::string> arguments;
    std::vector<world::RangerRow> ranger_rows;  // none: unused
    std::vector<std::uint64_t> seen;            // tick of the last scan passed, per ranger
    std::vector<std::string> ranger_names;
    std::vector<std::vector<float>> bearings;
    std::vector<Ranger> rangers;
    std::vector<world::FiducialRow> finders;
    std::vector<Sighting> sightings;      // reused
    Stream stream{Purpose::kController};  // of random numbers
    Robot robot;
    std::int64_t more_flags = 0;  // increment of flags
    bool says = false;            // robot.say has changed
    bool ended = false;
  };

  /// Makes a controller for the model, calls start(), and subscribes the rangers it uses.
  Result<void> join(world::World& world, const Post& post) override;
  void leave(std::size_t i) override { erase_at(i, seats_, gives_); }
  void resolve(const world::World& world, std::size_t i) override;
  /// A controller's memory is part of the hash if it implements save().
  void hash_of(std::size_t i, Hash& hash) const override;
  Result<void> save_of(std::size_t i, Packer& out) const override;
  /// A controller that throws at its own memory is ended as one that throws in decide().
  bool load_of(world::World& world, std::size_t i, Unpacker& in) override;

  bool remember(const Seat& seat, std::string& memory, std::string& why) const;
  static void find_rows(const world::World& world, Seat& seat);
  static void show(const world::World& world, Seat& seat);
  /// Converts orders to commands. True if give() has work.
  static bool take_orders(world::World& world, Seat& seat);
  static void give(world::World& world, const Seat& seat);
  static void end(world::World& world, Seat& seat, const char* why);

  std::shared_ptr<libraries::SharedLibrary> library_;  // outlives the seats
  std::vector<std::unique_ptr<Seat>> seats_;
  std::vector<std::uint8_t> gives_;  // per seat: give() has work in this tick
};

}  // namespace playhouse::controllers
