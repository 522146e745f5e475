#include "playhouse/bridge/stage_driver/stage_driver.h"

#include <fmt/format.h>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/simulated/simulated_world.h"
#include "playhouse/scene/kinds.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {
namespace {

constexpr DeviceText kStageProvides[] = {
    {"simulation", {}, HowMany::kOneOrNone, "the world"},
    {{}, {}, HowMany::kAny, "what the section's model and its parts have (playhouse kinds NAME)"},
};

struct StageOptions {
  std::string world, model;  // empty: none
};

StageOptions stage_options(SectionFields fields) {
  StageOptions options;
  options.world =
      fields.filename({"worldfile",
                       "The world, relative to the folder of the configuration file; the first section of "
                       "the driver needs it, no other may have it.",
                       {},
                       "none"});
  options.model = fields.text(
      {"model", "The model that provides the devices: its full name or default name.", {}, "none"});
  fields.no_effect({"usegui", "The page in the browser is an option of the command line."});
  return options;
}

Result<void> open_world(const config::CfgSection& section, const std::string& path, Site& site) {
  const bool has_world = section.has("worldfile");
  if (simulation_of(site) != nullptr) {
    if (has_world) return Error{section.at("worldfile"), "the world is open already; only one is possible"};
    return {};
  }
  if (!has_world) {
    return Error{section.at(),
                 "the first driver \"stage\" needs a worldfile" + section.slip_for("worldfile")};
  }
  const Result<void> opened = site.open_world(path);
  if (opened) return opened;
  // Errors inside the world have a line of their own; others are reported where the world is named.
  const Error& fault = opened.error();
  if (fault.where.empty()) return Error{section.at("worldfile"), fault.text};
  return fault.where == escaped(path) ? Error{section.at("worldfile"), "world file " + fault.line()} : fault;
}

/// The model that a section names; none if it names none.
Result<world::ModelRow> section_model(const config::CfgSection& section, const std::string& name,
                                      const world::World& world) {
  if (name.empty()) return world::ModelRow{};
  const world::ModelRow model = world.find(name);
  if (model) return model;
  std::vector<std::string> all;
  for (const world::ModelRow row : world.models.rows()) all.push_back(world.name(row));
  const std::vector<std::string_view> names(all.begin(), all.end());
  return Error{section.at("model"),
               fmt::format("the world has no model {}{}", in_quotes(name), did_you_mean(name, names))};
}

/// The first model that `fits` in depth-first preorder; none if there is none.
template <typename Fits>
world::ModelRow find_model(const world::World& world, world::ModelRow top, const Fits& fits) {
  if (fits(top)) return top;
  for (const world::ModelRow child : world.children(top)) {
    if (const world::ModelRow found = find_model(world, {child}, fits)) return found;
  }
  return {};
}

/// The first model that is left for an interface; if several devices cannot share a model, those that the
/// automatic map lists for it come first: a sonar is a ring before it is a laser.
world::ModelRow find_free(const world::World& world, world::ModelRow top, std::uint16_t interf, Site& site) {
  const auto fits_still = [&](world::ModelRow model) {
    return fits(world, model, interf) && !world_of(site)->taken_models().contains({interf, model.index});
  };
  if (is_shared(interf)) return find_model(world, top, fits_still);
  const world::ModelRow listed = find_model(world, top, [&](world::ModelRow model) {
    return is_listed(world, model, interf) && fits_still(model);
  });
  return listed ? listed : find_model(world, top, fits_still);
}

Result<world::ModelRow> choose_model(const config::CfgSection& section, const config::DeviceAddress& provided,
                                     std::uint16_t interf, world::ModelRow top, Site& site) {
  if (interf == wire::simulation::kCode) return world::ModelRow{};
  if (!top) {
    return Error{section.at("provides"), fmt::format("{} needs a model: add `model \"name\"`{}",
                                                     in_quotes(provided.text()), section.slip_for("model"))};
  }
  const world::World& world = simulation_of(site)->world();
  const world::ModelRow model = find_free(world, top, interf, site);
  if (!model) {
    return Error{section.at("provides"), fmt::format("model {} has nothing left for {}",
                                                     in_quotes(world.name(top)), in_quotes(provided.text()))};
  }
  if (!is_shared(interf)) world_of(site)->taken_models().emplace(interf, model.index);
  return model;
}

Result<void> add_device(const config::CfgSection& section, const config::DeviceAddress& provided,
                        world::ModelRow top, SimulatedDriver& driver, Site& site) {
  const Result<device::Address> address = site.resolve(provided);
  if (!address) return Error{section.at("provides"), address.error().text};
  if (!is_simulated(address->interf))
    return Error{section.at("provides"),
                 fmt::format("driver \"stage\" has no interface {}", in_quotes(provided.interf))};
  const Result<world::ModelRow> model = choose_model(section, provided, address->interf, top, site);
  if (!model) return model.error();
  const Result<void> added = add_simulated_device(site, driver, *address, *model);
  return added ? added : Error{section.at("provides"), added.error().text};
}

}  // namespace

constinit const DriverDefinition kStageDriver{
    .name = "stage",
    .doc = "Devices of the simulated models of a world file.",
    .provides = kStageProvides,
    .read_options = reading<stage_options>,
    .make = make_stage_driver,
};

Result<std::unique_ptr<device::Driver>> make_stage_driver(const config::CfgSection& section, Site& site) {
  const StageOptions options = stage_options(section);
  if (const Result<void> opened = open_world(section, options.world, site); !opened) return opened.error();
  const Result<world::ModelRow> top = section_model(section, options.model, simulation_of(site)->world());
  if (!top) return top.error();
  auto driver = std::make_unique<SimulatedDriver>(*model_devices_of(site), "stage");
  for (const config::DeviceAddress& provided : section.addresses("provides")) {
    if (const Result<void> added = add_device(section, provided, *top, *driver, site); !added)
      return added.error();
  }
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
