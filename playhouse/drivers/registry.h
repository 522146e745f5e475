#pragma once

/// Registry: the drivers of a program, for `driver ( name "..." )` sections of .cfg files.

#include <memory>
#include <optional>
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

/// The drivers of shared libraries.
struct PlugIns {
  /// Makes that of a section.
  Result<std::unique_ptr<device::Driver>> (*make)(const config::CfgSection&, const config::PluginField&,
                                                  Site&) = nullptr;
  bool (*is_there)(const config::PluginField&, Site&) = nullptr;
};

class Registry {
 public:
  /// A name of the original's that no driver has here, and what to write for it: "; ...".
  using Instead = std::pair<std::string_view, std::string_view>;

  /// `plug_ins` is empty in a program that loads none.
  Registry(std::vector<const DriverDefinition*> drivers, PlugIns plug_ins,
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
  /// Who makes the driver of a section: the program, or a library, or neither.
  struct Maker {
    const DriverDefinition* driver = nullptr;
    std::optional<config::PluginField> plugin = {};
    bool is_one() const { return driver != nullptr || plugin; }
  };
  struct WantedDriver {
    const config::CfgSection* section = nullptr;
    Maker maker;
  };
  Maker maker_of(const config::CfgSection& section, const config::CfgFile& file, Site& site) const;
  std::optional<config::PluginField> plugin_for(std::string_view name, const config::CfgFile& file,
                                                Site& site) const;
  std::vector<std::string_view> names() const;
  std::string_view what_has_its_place(std::string_view name) const;
  Result<void> check_provides(const config::CfgSection& section) const;
  std::string no_such_driver(const config::CfgSection& section, const config::CfgFile& file) const;
  std::vector<WantedDriver> drivers_to_make(const config::CfgFile& file, Site& site) const;
  static void warn_of_what_has_no_effect(const config::CfgFile& file, std::span<const WantedDriver> wanted,
                                         Site& site);

  std::vector<const DriverDefinition*> drivers_;
  PlugIns plug_ins_;
  std::span<const Instead> instead_;
};

}  // namespace playhouse::drivers
