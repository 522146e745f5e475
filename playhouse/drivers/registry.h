#pragma once

/// Registry: the drivers of a program, for `driver ( name "..." )` sections of .cfg files.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/config/cfg.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/site.h"

namespace playhouse::drivers {

/// Those of this library that were chosen at configure time (PLAYHOUSE_DRIVERS), in the order of their names; they know no simulator.
std::span<const DriverDefinition* const> core_drivers();

class Registry {
 public:
  using Factory = decltype(DriverDefinition::make);

  /// A name of the original's that no driver has here, and what to write for it: "; ...".
  using Instead = std::pair<std::string_view, std::string_view>;

  /// `plug_in` makes the driver of a section that names a shared library; null: this program loads none.
  Registry(std::vector<const DriverDefinition*> drivers, Factory plug_in,
           std::span<const Instead> instead = {});

  /// In the order of their names.
  std::span<const DriverDefinition* const> all() const { return drivers_; }
  /// That of a name, or null.
  const DriverDefinition* find(std::string_view name) const;
  /// What to write instead of a name that no driver has: "", " (did you mean "vfh"?)", or "; " and what
  /// this program has for it.
  std::string what_instead_of(std::string_view name) const;

  /// Makes the drivers of a file, in order, opens those with `alwayson`, and warns of
  /// fields that no driver read. Sections of drivers that this program lacks are left out with
  /// a warning, and so are those that require their devices. The drivers must outlive everything that refers to
  /// them.
  Result<std::vector<std::unique_ptr<device::Driver>>> make(const config::CfgFile& file, Site& site) const;

 private:
  Factory factory_of(const config::CfgSection& section) const;
  std::vector<std::string_view> names() const;
  std::string_view what_has_its_place(std::string_view name) const;
  std::string no_such_driver(const config::CfgSection& section) const;
  Result<void> check_provides(const config::CfgSection& section) const;
  std::vector<const config::CfgSection*> sections_to_make(const config::CfgFile& file, Site& site) const;

  std::vector<const DriverDefinition*> drivers_;
  Factory plug_in_;
  std::span<const Instead> instead_;
};

}  // namespace playhouse::drivers
