#pragma once

/// Directory: which devices show each model of the world, whoever made them: automatic devices, sections of a
/// configuration file, a driver that converts another one's data. Lists of names for clients and for the page
/// are made of it. During a run devices come and go with their models, and it is the tick thread's; others
/// read it as they do the world, while that stands between two ticks (publisher_thread.h).

#include <map>
#include <span>
#include <string>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

class Directory {
 public:
  /// The device at `address` shows `model`. Does nothing for no model: that device is of the whole world.
  void add(world::ModelId model, device::Address address);
  /// Does nothing for a device that shows no model.
  void remove(device::Address address);

  /// The devices of a model, in the order in which they were added.
  std::span<const device::Address> devices_of(world::ModelId model) const;
  /// The model that a device shows; none if it shows none.
  world::ModelId model_of(device::Address address) const;
  /// All that show a model, by address.
  std::vector<device::Address> devices() const;
  std::size_t size() const { return models_.size(); }

 private:
  std::map<world::ModelId, std::vector<device::Address>> devices_;
  std::map<device::Address, world::ModelId> models_;
};

/// A model's devices as people write them: "position2d:0", and with the port in front ("6666:position2d:0")
/// where that is not `port`.
std::vector<std::string> device_names(const Directory& directory, world::ModelId model, std::uint32_t port);

/// The devices of a model and of all inside it, as "position2d:7 laser:7": in the order of the tree, without
/// ports.
std::string devices_below(const world::World& world, const Directory& directory, world::ModelRow model);

/// The answer to a client that asks for the names of models and their devices (docs/drivers.md).
struct ModelList {
  std::string text;        // one line per model: id, name, type, parent's name, devices; separated by tabs
  std::uint32_t next = 0;  // the id to ask from next; 0: there are no more
};
/// From id `first` on, at most limits::kListedModels models, and after the first of them no more than
/// limits::kModelListBytes of text.
ModelList list_models(const world::World& world, const Directory& directory, std::uint32_t first);

}  // namespace playhouse::drivers
