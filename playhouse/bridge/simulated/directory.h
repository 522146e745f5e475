#pragma once

/// Directory: which devices expose each model, whoever made them: automatic devices,
/// configuration sections, drivers that convert data of others. Source of the name
/// lists for clients and the page. Modified during a run on the tick thread only;
/// others read it between two ticks, like the world (publisher_thread.h).

#include <map>
#include <span>
#include <string>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

class Directory {
 public:
  /// Registers a device of a model. No effect if `model` is none: such a device belongs to the whole world.
  void add(world::ModelId model, device::Address address);
  /// No effect if the device has no model.
  void remove(device::Address address);

  /// The devices of a model, in the order of registration.
  std::span<const device::Address> devices_of(world::ModelId model) const;
  /// The model of a device; none if it has none.
  world::ModelId model_of(device::Address address) const;
  /// All registered devices, by address.
  std::vector<device::Address> devices() const;
  std::size_t size() const { return models_.size(); }

 private:
  std::map<world::ModelId, std::vector<device::Address>> devices_;
  std::map<device::Address, world::ModelId> models_;
};

/// A model's devices in text form: "position2d:0", with the
/// port in front ("6666:position2d:0") if that is not `port`.
std::vector<std::string> device_names(const Directory& directory, world::ModelId model, std::uint32_t port);

/// The devices of a model and all its parts, as "position2d:7 laser:7":
/// in tree order, each with its port in front if that is not `port`.
std::string devices_below(const world::World& world, const Directory& directory, world::ModelRow model,
                          std::uint32_t port);

/// Reply to a client's query for models and their devices (docs/drivers.md).
struct ModelList {
  std::string text;        // one line per model: id, name, type, parent's name, devices; tab-separated
  std::uint32_t next = 0;  // id to continue from; 0: complete
};
/// From id `first` on, at most limits::kListedModels models, and
/// beyond the first one at most limits::kModelListBytes of text.
ModelList list_models(const world::World& world, const Directory& directory, std::uint32_t first);

}  // namespace playhouse::drivers
