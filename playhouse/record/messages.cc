#include "playhouse/record/messages.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/record/message_type.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/camera.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/generated/part_names.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/values.h"

namespace playhouse::record {
namespace {

constexpr double kNearlyAStep = 0.999;  // between the last beam of a circle and its first one

const std::string kRule = std::string(80, '=') + "\n";
const std::string kTime = kRule + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const std::string kHeader =
    kRule + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + kTime;

const std::string kVector = kRule + "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n";
const std::string kQuaternion =
    kRule + "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n";

const std::map<std::string, std::string>& fixed_schemas() {
  static const std::map<std::string, std::string> kTexts{
      {kTransforms, "geometry_msgs/TransformStamped[] transforms\n" + kRule +
                        "MSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring child_frame_id\n"
                        "geometry_msgs/Transform transform\n" +
                        kRule +
                        "MSG: geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\n"
                        "geometry_msgs/Quaternion rotation\n" +
                        kVector + kQuaternion + kHeader},
      {kOdometry,
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
       "geometry_msgs/TwistWithCovariance twist\n" +
           kRule +
           "MSG: geometry_msgs/PoseWithCovariance\ngeometry_msgs/Pose pose\n"
           "float64[36] covariance\n" +
           kRule +
           "MSG: geometry_msgs/Pose\ngeometry_msgs/Point position\n"
           "geometry_msgs/Quaternion orientation\n" +
           kRule + "MSG: geometry_msgs/Point\nfloat64 x\nfloat64 y\nfloat64 z\n" + kRule +
           "MSG: geometry_msgs/TwistWithCovariance\ngeometry_msgs/Twist twist\n"
           "float64[36] covariance\n" +
           kRule +
           "MSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\n"
           "geometry_msgs/Vector3 angular\n" +
           kVector + kQuaternion + kHeader},
      {kImu,
       "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
       "float64[9] orientation_covariance\n"
       "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
       "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n" +
           kVector + kQuaternion + kHeader},
      {kFix,
       "std_msgs/Header header\nsensor_msgs/NavSatStatus status\nfloat64 latitude\nfloat64 longitude\n"
       "float64 altitude\nfloat64[9] position_covariance\nuint8 COVARIANCE_TYPE_UNKNOWN=0\n"
       "uint8 COVARIANCE_TYPE_APPROXIMATED=1\nuint8 COVARIANCE_TYPE_DIAGONAL_KNOWN=2\n"
       "uint8 COVARIANCE_TYPE_KNOWN=3\nuint8 position_covariance_type\n" +
           kRule +
           "MSG: sensor_msgs/NavSatStatus\nint8 STATUS_NO_FIX=-1\nint8 STATUS_FIX=0\n"
           "int8 STATUS_SBAS_FIX=1\nint8 STATUS_GBAS_FIX=2\nint8 status\nuint16 SERVICE_GPS=1\n"
           "uint16 SERVICE_GLONASS=2\nuint16 SERVICE_COMPASS=4\nuint16 SERVICE_GALILEO=8\nuint16 service\n" +
           kHeader},
      {kCameraInfo,
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] d\n"
       "float64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\nuint32 binning_y\n"
       "sensor_msgs/RegionOfInterest roi\n" +
           kRule +
           "MSG: sensor_msgs/RegionOfInterest\nuint32 x_offset\nuint32 y_offset\nuint32 height\n"
           "uint32 width\nbool do_rectify\n" +
           kHeader},
      {kPointCloud,
       "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
       "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n" +
           kRule +
           "MSG: sensor_msgs/PointField\nuint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\n"
           "uint8 INT32=5\nuint8 UINT32=6\nuint8 FLOAT32=7\nuint8 FLOAT64=8\n"
           "string name\nuint32 offset\nuint8 datatype\nuint32 count\n" +
           kHeader},
      {kLaserScan,
       "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
       "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
       "float32[] ranges\nfloat32[] intensities\n" +
           kHeader},
      {kImage,
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\n"
       "uint32 step\nuint8[] data\n" +
           kHeader},
      {kRanges, "builtin_interfaces/Time stamp\nfloat32[] ranges  # m\nfloat32[] intensities\n" + kTime},
      {kEvent,
       "builtin_interfaces/Time stamp\nstring event\nstring model\nuint32 id\nstring other\n" + kTime},
      {kSpeech, "builtin_interfaces/Time stamp\nstring model\nuint32 id\nstring text\n" + kTime},
      {kState, "uint64 tick\nuint8[] state\n"},
      {kChange, "uint64 tick\nstring change\nstring model\nstring fields  # JSON\nuint8[] packed\n"},
      {kCheck, "uint64 tick\nuint64 hash\nuint64 sensed_hash\n"},
  };
  return kTexts;
}

template <typename Number>
const char* number_type() {
  if constexpr (std::is_same_v<Number, double>) return "float64";
  if constexpr (std::is_same_v<Number, float>) return "float32";
  if constexpr (std::is_same_v<Number, std::uint64_t>) return "uint64";
  if constexpr (std::is_same_v<Number, std::int32_t>) return "int32";
  return sizeof(Number) == 4 ? "uint32" : "uint8";
}

template <typename Number>
void put_number(CdrWriter& out, Number number) {
  if constexpr (std::is_enum_v<Number>) {
    out.number(static_cast<std::uint8_t>(number));
  } else {
    out.number(number);
  }
}

/// Number and type of a value's components, if uniform.
template <typename T>
struct Shape {
  std::size_t count = 0;
  std::string type;
  Shape() {
    T value{};
    world::each_number(value, [&](auto number) {
      const std::string found = number_type<decltype(number)>();
      type = count == 0 || found == type ? found : "float64";
      ++count;
    });
  }
};

/// A message within that has names for the numbers of a value, in their order: the same bytes as an array.
struct Named {
  const char* type;
  const char* text;  // of the type, in a schema
};
template <typename T>
constexpr Named kNamed{nullptr, nullptr};
template <>
constexpr Named kNamed<geom::Pose>{
    "playhouse/Pose", "float64 x  # m\nfloat64 y  # m\nfloat64 z  # m\nfloat64 heading  # rad\n"};
template <>
constexpr Named kNamed<geom::Twist>{"playhouse/Motion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 heading\n"};
template <>
constexpr Named kNamed<geom::Vec3>{"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"};
template <>
constexpr Named kNamed<geom::Tilt>{"playhouse/Tilt", "float64 x  # rad\nfloat64 y  # rad\n"};

template <>
constexpr Named kNamed<geom::SpatialVelocity>{"playhouse/MotionInSpace",
                                              "float64 x\nfloat64 y\nfloat64 z\nfloat64 turn_x\n"
                                              "float64 turn_y\nfloat64 turn_z\n"};

template <typename T>
std::string field_type() {
  if constexpr (std::is_same_v<T, std::string>) {
    return "string";
  } else if constexpr (world::kIsList<T>) {
    return Shape<typename T::value_type>().type + "[]";
  } else {
    if (kNamed<T>.type != nullptr) return kNamed<T>.type;
    const Shape<T> shape;
    return shape.count == 1 ? shape.type : shape.type + "[" + std::to_string(shape.count) + "]";
  }
}

/// Writes a value's components in the type given by Shape.
template <typename T>
void put_numbers(CdrWriter& out, const T& value, bool as_doubles) {
  world::each_number(value, [&](auto number) {
    if constexpr (std::is_arithmetic_v<decltype(number)>) {
      if (as_doubles) return out.number(static_cast<double>(number));
    }
    put_number(out, number);
  });
}

template <typename T>
void put_field(CdrWriter& out, const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    out.text(value);
  } else if constexpr (world::kIsList<T>) {
    using Element = typename T::value_type;
    static const Shape<Element> kShape;
    out.count(value.size() * kShape.count);
    for (const Element& element : value) put_numbers(out, element, kShape.type == "float64");
  } else {
    static const Shape<T> kShape;
    put_numbers(out, value, kShape.type == "float64");
  }
}

/// Images have messages of their own, and settings are changes of the run.
template <typename Column>
bool is_told(const Column& column) {
  if (std::is_same_v<typename Column::Values::value_type, std::vector<world::Pixel>>) return false;
  return world::is_saved(column.role) && column.role != world::Role::kSetting &&
         !std::string_view(column.name).ends_with(".measured_tick");
}

/// Columns that are named by their frames, and what they are.
constexpr std::pair<std::string_view, const char*> kFieldNames[] = {
    {"positions.X_OM", "odometry"},
    {"positions.X_WO", "odometry_origin"},
    {"actuators.X_PJ", "joint"},
    {"imus.X_WB", "pose"},
    {"imus.tilt_WB", "tilt"},
    {"imus.v_WB", "velocity"},
    {"imus.X_WE", "estimated_pose"},
    {"imus.tilt_WE", "estimated_tilt"},
    {"imus.v_WE", "estimated_velocity"},
    {"motes.X_WB", "pose"},
    {"motes.tilt_WB", "tilt"},
    {"motes.v_WB", "velocity"},
    {"receivers.p_WB", "true_position"},
};

/// Field name of a column: that of the table above, else its own.
std::string field_name(std::string_view column) {
  const auto named = std::ranges::find(kFieldNames, column, &std::pair<std::string_view, const char*>::first);
  return named != std::end(kFieldNames) ? named->second : std::string(column.substr(column.find('.') + 1));
}

template <typename Table>
std::string table_schema() {
  std::string text = "builtin_interfaces/Time stamp\n";
  std::map<std::string, std::string> within;  // messages in it
  world::each_column_of<Table>([&](const auto& column) {
    if (!is_told(column)) return;
    using Value = typename std::remove_cvref_t<decltype(column)>::Values::value_type;
    text += field_type<Value>() + " " + field_name(column.name);
    if (kNamed<Value>.type != nullptr) within[kNamed<Value>.type] = kNamed<Value>.text;
    std::string note = column.unit;
    if (column.frame[0] != '\0') note += (note.empty() ? "" : "; ") + std::string(column.frame);
    if constexpr (world::kIsList<Value> && !std::is_same_v<Value, std::string>)
      if (const std::size_t count = Shape<typename Value::value_type>().count; count > 1)
        note += (note.empty() ? "" : "; ") + std::to_string(count) + std::string(kNumbersEach) +
                world::kPartNames<typename Value::value_type>;
    if constexpr (std::is_same_v<Value, world::ModelId> || std::is_same_v<Value, std::vector<world::ModelId>>)
      note += (note.empty() ? "" : "; ") + std::string(kNoModel);
    text += note.empty() ? "\n" : "  # " + note + "\n";
  });
  for (const auto& [type, fields] : within) text += kRule + "MSG: " + type + "\n" + fields;
  return text + kTime;
}

template <typename Table>
world::Range rows_of(const world::World& world, world::ModelRow model) {
  return world::range_of<Table>(world, model, world::Per::kRow);
}

template <typename Table>
concept Measuring = requires(Table rows) {
  rows.measured_tick;
};

template <typename Table, Table world::Tables::*kTable>
TableMessages messages_of(const std::string& word) {
  std::string name = word;
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return {
      .schema = "playhouse/msg/" + name,
      .topic = word,
      .text = table_schema<Table>(),
      .measures = Measuring<Table>,
      .has =
          [](const world::World& world, world::ModelRow model) {
            const world::Range rows = rows_of<Table>(world, model);
            return rows.begin != rows.end;
          },
      .is_fresh =
          [](const world::World& world, world::ModelRow model) {
            if constexpr (Measuring<Table>)
              return world::numbered((world.*kTable).measured_tick)[rows_of<Table>(world, model).begin] ==
                     world.tick();
            return false;
          },
      .message =
          [](std::uint64_t ns, const world::World& world, world::ModelRow model) {
            const std::uint32_t row = rows_of<Table>(world, model).begin;
            CdrWriter out;
            out.time(ns);
            world::each_column_of<Table>([&](const auto& column) {
              if (is_told(column)) put_field(out, column.of(world.*kTable)[row]);
            });
            return out.message();
          },
  };
}

template <std::size_t kNth>
void add_kind(std::vector<TableMessages>& all) {
  constexpr auto kTable = std::get<kNth>(world::kKindTables);
  using Table = std::remove_cvref_t<decltype(std::declval<world::World>().*kTable)>;
  if constexpr (!std::is_same_v<Table, world::Rangers>) {
    constexpr scene::ModelKind kKind = world::kKindOf<Table>;
    TableMessages messages = messages_of<Table, kTable>(std::string(replicate::kind_name(kKind)));
    messages.measures = messages.measures && replicate::may_be_watched(kKind);
    all.push_back(std::move(messages));
  }
}

template <std::size_t kNth>
void add_trait(std::vector<TableMessages>& all) {
  constexpr auto kTable = std::get<kNth>(world::kTraitTables);
  using Table = std::remove_cvref_t<decltype(std::declval<world::World>().*kTable)>;
  const std::string name = world::ColumnsOf<Table>::kTable;
  all.push_back(messages_of<Table, kTable>(name.substr(0, name.size() - 1)));  // "packs": pack
}

/// REP 117: a range at one of its limits is not a range, but an infinity.
std::vector<float> with_infinity(std::span<const float> ranges, const scene::RangerSensorDesc& sensor) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  const auto least = static_cast<float>(sensor.range_min), most = static_cast<float>(sensor.range_max);
  std::vector<float> seen(ranges.begin(), ranges.end());
  for (float& range : seen)
    if (range >= most)
      range = kNone;
    else if (range <= least && least > 0)
      range = -kNone;
  return seen;
}

}  // namespace

void put_header(CdrWriter& out, std::uint64_t ns, const std::string& frame) {
  out.time(ns);
  out.text(frame);
}

std::string schema_text(const std::string& name) {
  const auto found = fixed_schemas().find(name);
  if (found != fixed_schemas().end()) return found->second;
  const auto table = std::ranges::find(table_messages(), name, &TableMessages::schema);
  PLAYHOUSE_ASSERT(table != table_messages().end());
  return table->text;
}

const std::vector<TableMessages>& table_messages() {
  static const std::vector<TableMessages> kAll = [] {
    std::vector<TableMessages> all;
    [&]<std::size_t... kNth>(std::index_sequence<kNth...>) {
      (add_kind<kNth>(all), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(world::kKindTables)>>());
    [&]<std::size_t... kNth>(std::index_sequence<kNth...>) {
      (add_trait<kNth>(all), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(world::kTraitTables)>>());
    return all;
  }();
  return kAll;
}

Bytes transforms_message(std::uint64_t ns, std::span<const Transform> transforms) {
  CdrWriter out;
  out.count(transforms.size());
  for (const Transform& each : transforms) {
    put_header(out, ns, each.parent);
    out.text(each.child);
    const geom::Quaternion q = geom::orientation(each.X.X.a, each.X.tilt);
    for (const double number : {each.X.X.x, each.X.X.y, each.X.X.z, q.x, q.y, q.z, q.w}) out.number(number);
  }
  return out.message();
}

bool repeats_first_beam(const scene::RangerSensorDesc& sensor) {
  if (sensor.samples <= 1) return false;
  const double step = sensor.fov / (sensor.samples - 1);
  return 2 * geom::kPi - sensor.fov < step * kNearlyAStep;
}

Bytes scan_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                   world::ModelRow model, world::SensorRow sensor) {
  const world::RangerRow ranger = world.models.part[model];
  const std::uint32_t nth = sensor - world.rangers.first_sensor[ranger];
  const scene::RangerSensorDesc& desc = world.desc(model).sensors[nth];
  const double step = desc.samples > 1 ? desc.fov / (desc.samples - 1) : 0;
  const world::BeamRow first = world.sensors.first_beam[sensor];
  const bool is_circle = repeats_first_beam(desc);
  const std::size_t count = world.sensors.beam_count[sensor] - (is_circle ? 1 : 0);
  const double angle_max = desc.fov / 2 - (is_circle ? step : 0);
  const double scan_time = static_cast<double>(world::update_ticks(world, model)) * world.scene().interval;
  CdrWriter out;
  put_header(out, ns, frame);
  for (const double number : {-desc.fov / 2, angle_max, step, 0.0, scan_time, desc.range_min, desc.range_max})
    out.number(static_cast<float>(number));
  out.floats(with_infinity(std::span(world.sensors.ranges.from(first), count), desc));
  out.floats(std::span(world.sensors.intensities.from(first), count));
  return out.message();
}

Bytes image_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                    world::ModelRow model) {
  const scene::CameraDesc& camera = *world.desc(model).camera;
  const auto width = static_cast<std::uint32_t>(camera.width);
  const auto size = static_cast<std::uint32_t>(world::bytes_per_pixel(camera.image));
  CdrWriter out;
  put_header(out, ns, frame);
  out.number(static_cast<std::uint32_t>(camera.height));
  out.number(width);
  out.text(size == 3 ? "rgb8" : size == 2 ? "16UC1" : "mono8");
  out.number(std::uint8_t{0});
  out.number(width * size);
  const world::KindRow row = world.models.part[model];
  const std::vector<std::uint8_t> data = world::image_bytes(camera.image, world.cameras.pixels[row]);
  out.bytes(std::as_bytes(std::span(data)));
  return out.message();
}

Bytes ranges_message(std::uint64_t ns, const world::World& world, world::ModelRow model) {
  const world::Range beams = world::range_of<world::Sensors>(world, model, world::Per::kBeam);
  std::vector<float> ranges;
  for (const scene::RangerSensorDesc& sensor : world.desc(model).sensors) {
    const std::size_t first = beams.begin + ranges.size();
    const std::vector<float> seen = with_infinity(
        std::span(world.sensors.ranges).subspan(first, static_cast<std::size_t>(sensor.samples)), sensor);
    ranges.insert(ranges.end(), seen.begin(), seen.end());
  }
  CdrWriter out;
  out.time(ns);
  out.floats(ranges);
  out.floats(std::span(world.sensors.intensities).subspan(beams.begin, beams.end - beams.begin));
  return out.message();
}

}  // namespace playhouse::record
