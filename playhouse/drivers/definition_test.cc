// What is told of each driver, against what the driver does.

#include "playhouse/drivers/definition.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/amcl/amcl_options.h"
#include "playhouse/drivers/nd/nd_options.h"
#include "playhouse/drivers/vfh/vfh_options.h"
#include "playhouse/drivers/wavefront/wavefront_options.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kOneRobot = "position( name \"r0\" size [0.4 0.4 0.2] )";
constexpr const char* kAnyInterface = "laser";

using Devices = std::vector<DeviceText>;

/// What a section may name, as told: each number of devices once.
std::vector<Devices> choices(std::span<const DeviceText> told) {
  std::vector<Devices> all{{}};
  Devices alternatives;
  for (const DeviceText& device : told) {
    if (is_alternative(device.many)) {
      alternatives.push_back(device);
      continue;
    }
    std::vector<Devices> more = device.many == HowMany::kOneOrNone ? all : std::vector<Devices>();
    for (Devices with : all) {
      with.insert(with.end(), device.many == HowMany::kAny ? 2 : 1, device);
      more.push_back(with);
    }
    all = more;
  }
  if (alternatives.empty()) return all;
  std::vector<Devices> more;
  if (alternatives[0].many == HowMany::kOneOfTheseOrNone) more = all;
  for (const Devices& fixed : all) {
    for (std::size_t count = 1; count <= alternatives.size(); ++count) {
      if (count > 1 && alternatives[0].many != HowMany::kSomeOfThese) continue;
      for (std::size_t first = 0; first + count <= alternatives.size(); ++first) {
        more.push_back(fixed);
        for (std::size_t i = 0; i < count; ++i) more.back().push_back(alternatives[first + i]);
      }
    }
  }
  return more;
}

std::string interface_of(const DeviceText& device) {
  return std::string(device.interf.empty() ? kAnyInterface : device.interf);
}

/// "output:::position2d:3" and so on, from index `first`.
std::string addresses(const Devices& devices, std::size_t first, std::string_view server, bool with_keys) {
  std::string text;
  for (const DeviceText& device : devices) {
    const std::string key = with_keys && !device.key.empty() ? fmt::format("{}:::", device.key) : "";
    text += fmt::format(" \"{}{}{}:{}\"", key, server, interface_of(device), first++);
  }
  return text;
}

/// A section, and one of "dummy" with what it requires.
std::string file_with(const DriverDefinition& driver, const Devices& provides, const Devices& uses,
                      const std::string& more) {
  const bool is_remote = driver.name == "passthrough";
  std::string text = fmt::format("driver( name \"{}\"\n{}", driver.name, more);
  if (!provides.empty()) text += fmt::format(" provides [{} ]", addresses(provides, 100, "", true));
  if (!uses.empty())
    text += fmt::format(" requires [{} ]", addresses(uses, 0, is_remote ? "lab:6665:" : "", true));
  text += " )\n";
  if (!uses.empty() && !is_remote)
    text += fmt::format("driver( name \"dummy\" provides [{} ] )\n", addresses(uses, 0, "", false));
  return text;
}

/// What the drivers of a file say, and what they asked its first section for.
struct Outcome {
  std::string error;
  std::vector<std::string> warnings;
  std::set<std::string, std::less<>> asked;
};

Outcome outcome_of(const std::string& text) {
  config::MemoryFiles none({});
  const Result<config::CfgFile> file = config::load_cfg_text(text, "test.cfg", none);
  if (!file) return {file.error().line(), {}, {}};
  testing::MemorySite site(kOneRobot);
  const auto drivers = all_drivers().make(*file, site.site());
  const auto warnings = site.site().warnings();
  return {drivers ? "" : drivers.error().line(),
          {warnings.begin(), warnings.end()},
          file->drivers.front().asked()};
}

std::string image_of_two_pixels() {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "definition_test.pgm";
  std::ofstream(path) << "P2 2 1 255 0 255";
  return path.string();
}

/// Options that have no default, or one in words, with a value.
std::string value_of(const std::vector<Option>& all, const Option& option) {
  static const std::map<std::string, std::string> kValues = {
      {"port", "\"/dev/robot\""},      {"connect_rate", "[9600 38400]"},
      {"worldfile", "\"some.world\""}, {"model", "\"r0\""},
      {"token", "\"guest\""},          {"resolution", "0.5"},
      {"remote_host", "\"attic\""},    {"remote_port", "7000"},
      {"origin", "[1 2 3]"},           {"filename", '"' + image_of_two_pixels() + '"'}};
  if (!option.otherwise.empty()) return option.otherwise;
  const bool is_word = option.type == "string" && option.told != "required" && option.told != "none" &&
                       option.told.find(' ') == std::string::npos && !option.told.empty();
  if (is_word) return fmt::format("\"{}\"", option.told);
  if (const auto found = kValues.find(option.name); found != kValues.end()) return found->second;
  const auto same = std::ranges::find(all, option.told, &Option::name);
  return same == all.end() ? "0" : value_of(all, *same);
}

bool is_of_sensor(std::string_view option) {
  return option.starts_with("laser_") || option.starts_with("ranger_") || option.starts_with("sonar_");
}

/// All options but those of the other sensors.
std::string with_all(const std::vector<Option>& options, const Devices& uses) {
  std::string text;
  for (const Option& option : options) {
    const bool is_of_other = std::ranges::none_of(uses, [&](const DeviceText& device) {
      return option.name.starts_with(fmt::format("{}_", device.interf));
    });
    if (!is_of_sensor(option.name) || !is_of_other)
      text += fmt::format(" {} {}", option.name, value_of(options, option));
  }
  return text;
}

/// What its section needs in any case.
std::string required_of(const DriverDefinition& driver) {
  const std::vector<Option> options = options_of(driver);
  std::string text;
  for (const Option& option : options)
    if (option.told.starts_with("required") || option.name == "worldfile" || option.name == "model")
      text += fmt::format(" {} {}", option.name, value_of(options, option));
  return text;
}

/// The choices of "stage" are those of its model.
std::vector<Devices> provided_by(const DriverDefinition& driver) {
  if (driver.name == "stage") return {{{"simulation"}, {"position2d"}}};
  return choices(driver.provides);
}

class EachDriver : public ::testing::TestWithParam<const DriverDefinition*> {};

TEST_P(EachDriver, is_made_with_the_devices_and_options_that_are_told_and_asks_for_no_others) {
  const DriverDefinition& driver = *GetParam();
  const std::vector<Option> options = options_of(driver);
  std::set<std::string, std::less<>> told = {"name", "provides", "requires", "alwayson", "plugin"};
  for (const Option& option : options) told.insert(option.name);
  std::set<std::string, std::less<>> asked;
  for (const Devices& provides : provided_by(driver)) {
    for (const Devices& uses : choices(driver.uses)) {
      const std::string text = file_with(driver, provides, uses, with_all(options, uses));
      const Outcome outcome = outcome_of(text);
      EXPECT_EQ(outcome.error, "") << text;
      EXPECT_THAT(outcome.warnings, IsEmpty()) << text;
      asked.insert(outcome.asked.begin(), outcome.asked.end());
    }
  }
  EXPECT_EQ(asked, told);
}

TEST_P(EachDriver, needs_no_option_that_is_not_told_to_be_required) {
  const DriverDefinition& driver = *GetParam();
  const Outcome outcome = outcome_of(
      file_with(driver, provided_by(driver).front(), choices(driver.uses).front(), required_of(driver)));
  EXPECT_EQ(outcome.error, "");
}

TEST_P(EachDriver, warns_of_another_word_with_the_nearest_option) {
  const DriverDefinition& driver = *GetParam();
  for (const Option& option : options_of(driver)) {
    if (option.name.starts_with("ranger_") || option.name.starts_with("sonar_") || option.name.ends_with(']'))
      continue;
    const std::string slip = option.name + "q";
    const Outcome outcome =
        outcome_of(file_with(driver, provided_by(driver).front(), choices(driver.uses).front(),
                             required_of(driver) + fmt::format(" {} 1", slip)));
    EXPECT_EQ(outcome.error, "");
    EXPECT_THAT(
        outcome.warnings,
        ElementsAre(HasSubstr(fmt::format("\"{}\" is not used by driver \"{}\" (did you mean \"{}\"?)", slip,
                                          driver.name, option.name))));
  }
}

TEST_P(EachDriver, is_refused_without_a_device_that_is_told_and_with_another_one) {
  const DriverDefinition& driver = *GetParam();
  const std::string more = required_of(driver);
  const Devices provides = provided_by(driver).front(), uses = choices(driver.uses).front();
  const bool provides_any =
      std::ranges::any_of(driver.provides, [](const DeviceText& device) { return device.interf.empty(); });
  Devices another = provides;
  another.push_back({"audio"});
  if (!provides_any) EXPECT_NE(outcome_of(file_with(driver, another, uses, more)).error, "");
  for (std::size_t i = 0; i < uses.size(); ++i) {
    Devices fewer = uses;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(outcome_of(file_with(driver, provides, fewer, more)).error, "") << uses[i].interf;
  }
  if (uses.empty()) return;
  another = uses;
  another.push_back({"audio"});
  EXPECT_NE(outcome_of(file_with(driver, provides, another, more)).error, "");
}

TEST_P(EachDriver, has_a_sentence_for_all_that_is_told) {
  const DriverDefinition& driver = *GetParam();
  EXPECT_TRUE(driver.doc.ends_with('.'));
  EXPECT_FALSE(driver.provides.empty() && driver.uses.empty());
  EXPECT_NE(driver.make, nullptr);
  for (const Option& option : options_of(driver)) EXPECT_TRUE(option.doc.ends_with('.')) << option.name;
  for (const PropertyText& property : driver.properties)
    EXPECT_TRUE(property.doc.ends_with('.')) << property.name;
}

INSTANTIATE_TEST_SUITE_P(Drivers, EachDriver, ::testing::ValuesIn(all_drivers().all()),
                         [](const auto& each) { return std::string(each.param->name); });

/// The option of a name, "DEFAULT UNIT".
std::string default_of(const DriverDefinition& driver, std::string_view name) {
  const std::vector<Option> options = options_of(driver);
  const auto found = std::ranges::find(options, name, &Option::name);
  if (found == options.end()) return "no such option";
  return fmt::format("{} {} {}", found->type, found->otherwise.empty() ? found->told : found->otherwise,
                     found->unit);
}

TEST(DriverDefinitions, tell_the_defaults_that_a_bare_section_gets) {
  config::MemoryFiles none({});
  const auto file = config::load_cfg_text("driver( name \"any\" provides [\"opaque:0\"] )", "test.cfg", none);
  const config::CfgSection& bare = file->drivers.front();
  const NdOptions nd = *nd_options(bare);
  EXPECT_EQ(default_of(kNdDriver, "goal_tol"),
            fmt::format("[length angle] [{} {:.6g}] m, deg", nd.goal_distance, geom::degrees(nd.goal_angle)));
  EXPECT_EQ(default_of(kNdDriver, "laser_buffer"), fmt::format("int {} ", nd.laser_buffer));
  EXPECT_EQ(default_of(kNdDriver, "sonar_bad_transducers"), "[int ...] [] ");
  const VfhOptions vfh = *vfh_options(bare);
  EXPECT_EQ(default_of(kVfhDriver, "sector_angle"), fmt::format("int {} deg", 360 / vfh.sectors));
  EXPECT_EQ(default_of(kVfhDriver, "max_speed_wide_opening"), "length max_speed m/s");
  EXPECT_EQ(vfh.max_speed_wide, vfh.max_speed);
  const AmclOptions amcl = *amcl_options(bare, "sonar");
  EXPECT_EQ(default_of(kAmclDriver, "sonar_range_max"), fmt::format("length {} m", amcl.max_range));
  EXPECT_EQ(default_of(kAmclDriver, "init_pose_var"), "[length length angle] [1 1 360] m, m, deg");
  EXPECT_EQ(amcl.start.cov, AmclOptions().start.cov);
  const WavefrontOptions wavefront = *wavefront_options(bare);
  EXPECT_EQ(default_of(kWavefrontDriver, "add_rotational_waypoints"),
            fmt::format("bool {:d} ", wavefront.turns));
  EXPECT_EQ(default_of(kWavefrontDriver, "request_map"), "  ");
}

TEST(DriverDefinitions, are_in_the_order_of_their_names_and_found_by_them) {
  EXPECT_TRUE(std::ranges::is_sorted(all_drivers().all(), {}, &DriverDefinition::name));
  for (const DriverDefinition* driver : all_drivers().all())
    EXPECT_EQ(all_drivers().find(driver->name), driver);
  EXPECT_EQ(all_drivers().find("statgrabdriver"), all_drivers().find("health"));
  EXPECT_EQ(all_drivers().find(""), nullptr);
  EXPECT_EQ(all_drivers().what_instead_of("vhf"), " (did you mean \"vfh\"?)");
  EXPECT_EQ(all_drivers().what_instead_of("writelog"), "; the option --record records a run");
}

}  // namespace
}  // namespace playhouse::drivers
