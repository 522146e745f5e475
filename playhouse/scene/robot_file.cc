#include "playhouse/scene/robot_file.h"

// toml++ asserts that "[," begins with a key, and a release may assume it; what it does next finds the fault
// and tells it.
#undef NDEBUG
#define TOML_ASSERT(expr) static_cast<void>(0)
#define TOML_EXCEPTIONS 0
#include <fmt/format.h>
#include <toml++/toml.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {
namespace {

constexpr std::array<std::string_view, 7> kRobotKeys{"type",  "name",    "pose",   "port",
                                                     "color", "sensors", "devices"};
constexpr std::array<std::string_view, 2> kSensorKeys{"type", "pose"};
constexpr double kFarthest = 1e6;  // m

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  Result<std::vector<RobotDesc>> robots(const toml::table& file) {
    std::vector<RobotDesc> robots;
    const toml::node* const several = file.get("robot");
    if (several == nullptr) {
      if (const std::optional<RobotDesc> robot = read_robot(file)) robots.push_back(*robot);
      return fault_ ? Result<std::vector<RobotDesc>>(*fault_) : robots;
    }
    for (const auto& [key, node] : file)
      if (key.str() != "robot")
        fail(key.source(), in_quotes(key.str()) + " stands outside of the [[robot]] tables");
    const toml::array* const tables = several->as_array();
    if (tables == nullptr) {
      fail(several->source(), "robots are written as [[robot]] tables");
    } else if (tables->size() > kRobotsOfFile) {
      fail(several->source(), fmt::format("a file has {} robots at most", kRobotsOfFile));
    } else {
      for (const toml::node& node : *tables) read_one_of(node, robots);
    }
    return fault_ ? Result<std::vector<RobotDesc>>(*fault_) : robots;
  }

 private:
  void fail(const toml::source_region& where, std::string what) {
    if (!fault_) fault_ = Error{at(where), std::move(what)};
  }
  std::string at(const toml::source_region& where) const {
    return fmt::format("{}:{}", escaped(path_), where.begin.line == 0 ? 1 : where.begin.line);
  }

  void check_keys(const toml::table& table, std::span<const std::string_view> known) {
    for (const auto& [key, node] : table) {
      const std::string_view word = key.str();
      if (std::find(known.begin(), known.end(), word) == known.end())
        fail(key.source(), in_quotes(word) + " is unknown" + did_you_mean(word, known));
    }
  }

  void read_one_of(const toml::node& node, std::vector<RobotDesc>& robots) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) return fail(node.source(), "robots are written as [[robot]] tables");
    if (const std::optional<RobotDesc> robot = read_robot(*table)) robots.push_back(*robot);
  }

  std::optional<RobotDesc> read_robot(const toml::table& table) {
    check_keys(table, kRobotKeys);
    RobotDesc robot;
    robot.where = at(table.source());
    robot.type = text(table, "type");
    robot.name = text(table, "name");
    robot.color = text(table, "color");
    if (robot.type.empty()) fail(table.source(), "a robot has a type, as type = \"pioneer2dx\"");
    if (const std::optional<geom::Pose> pose = read_pose(table)) {
      robot.X_WR = *pose;
    } else {
      fail(table.source(), "a robot has a pose, as pose = [x, y, heading]");
    }
    if (const std::optional<int> port = integer(table, "port", 65535))
      robot.port = static_cast<std::uint16_t>(*port);
    read_sensors(table, robot);
    read_devices(table, robot);
    return robot;
  }

  /// "" where it is absent.
  std::string text(const toml::table& table, std::string_view key) {
    const toml::node* const node = table.get(key);
    if (node == nullptr) return {};
    const std::optional<std::string> text = node->value_exact<std::string>();
    if (text && !text->empty() && text->find('\0') == std::string::npos) return *text;
    fail(node->source(), in_quotes(key) + " is a text that is not empty");
    return {};
  }

  std::optional<int> integer(const toml::table& table, std::string_view key, int most) {
    const toml::node* const node = table.get(key);
    if (node == nullptr) return std::nullopt;
    const std::optional<std::int64_t> number = node->value_exact<std::int64_t>();
    if (number && *number >= 0 && *number <= most) return static_cast<int>(*number);
    fail(node->source(), fmt::format("{} is a whole number from 0 to {}", in_quotes(key), most));
    return std::nullopt;
  }

  /// [x, y, heading] in metres and degrees. None, perhaps with a fault, where there is none.
  std::optional<geom::Pose> read_pose(const toml::table& table) {
    const toml::node* const node = table.get("pose");
    if (node == nullptr) return std::nullopt;
    const toml::array* const array = node->as_array();
    std::array<double, 3> numbers{};
    bool sound = array != nullptr && array->size() == numbers.size();
    for (std::size_t i = 0; sound && i < numbers.size(); ++i) {
      const std::optional<double> number = (*array)[i].value<double>();
      sound = (*array)[i].is_number() && number && std::abs(*number) <= kFarthest;
      if (sound) numbers[i] = *number;
    }
    if (!sound) fail(node->source(), "a pose is [x, y, heading], three numbers in metres and degrees");
    return geom::Pose{numbers[0], numbers[1], 0, geom::normalize(numbers[2] * geom::kPi / 180)};
  }

  void read_sensors(const toml::table& table, RobotDesc& robot) {
    const toml::node* const node = table.get("sensors");
    if (node == nullptr) return;
    const toml::array* const array = node->as_array();
    if (array == nullptr) return fail(node->source(), "sensors are a list, as [\"sicklaser\"]");
    for (const toml::node& each : *array) {
      if (const std::optional<std::string> word = each.value_exact<std::string>(); word && is_word(*word)) {
        robot.sensors.push_back({*word, std::nullopt});
      } else if (const toml::table* const sensor = each.as_table()) {
        check_keys(*sensor, kSensorKeys);
        robot.sensors.push_back({text(*sensor, "type"), read_pose(*sensor)});
        if (!is_word(robot.sensors.back().type)) fail(each.source(), "a sensor has a type, one word");
      } else {
        fail(each.source(),
             "a sensor is a type, as \"sicklaser\", or {type = \"sicklaser\", pose = [x, y, heading]}");
      }
    }
  }

  static bool is_word(std::string_view text) {
    return !text.empty() && text.find_first_of(std::string_view(" \t\r\n\0", 5)) == std::string_view::npos;
  }

  void read_devices(const toml::table& table, RobotDesc& robot) {
    const toml::node* const node = table.get("devices");
    if (node == nullptr) return;
    const toml::table* const devices = node->as_table();
    if (devices == nullptr)
      return fail(node->source(), "devices are a table of first indices, as {laser = 1}");
    for (const auto& [key, value] : *devices)
      if (const std::optional<int> index = integer(*devices, key.str(), 65535))
        robot.first_index[std::string(key.str())] = *index;
  }

  const std::string& path_;
  std::optional<Error> fault_;  // the first
};

}  // namespace

Result<std::vector<RobotDesc>> read_robots(const std::string& text, const std::string& path) {
  const toml::parse_result file = toml::parse(std::string_view(text));
  if (!file)
    return Error{fmt::format("{}:{}", escaped(path), file.error().source().begin.line),
                 escaped(std::string(file.error().description()))};
  return Reader(path).robots(file.table());
}

}  // namespace playhouse::scene
