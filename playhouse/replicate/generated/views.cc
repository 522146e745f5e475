// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/replicate/views.h"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/quantize.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/world/traits.h"

namespace playhouse::replicate {
namespace {

std::uint32_t row_of_position(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kPosition ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_position(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  out.push_back(quantize(world.positions.velocity[row].x, 1000));
  out.push_back(quantize(world.positions.velocity[row].y, 1000));
  out.push_back(quantize(world.positions.velocity[row].a, 1000));
  out.push_back(quantize(world.positions.X_OM[row].x, 1000));
  out.push_back(quantize(world.positions.X_OM[row].y, 1000));
  out.push_back(quantize_angle(world.positions.X_OM[row].a));
  return true;
}

std::uint32_t row_of_fiducial(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kFiducial ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_fiducial(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.fiducials.measured_tick[row] == 0) return false;
  for (const auto& item : world.fiducials.hits[row]) {
    out.push_back(static_cast<std::int32_t>(item.target.value));
    out.push_back(static_cast<std::int32_t>(item.id));
    out.push_back(quantize(item.range, 1000));
    out.push_back(quantize_angle(item.bearing));
    out.push_back(quantize_angle(item.heading));
  }
  return true;
}

std::uint32_t row_of_blobfinder(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kBlobfinder ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_blobfinder(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.blobfinders.measured_tick[row] == 0) return false;
  for (const auto& item : world.blobfinders.blobs[row]) {
    out.push_back(static_cast<std::int32_t>(scene::rgba8(item.color)));
    out.push_back(static_cast<std::int32_t>(item.left));
    out.push_back(static_cast<std::int32_t>(item.right));
    out.push_back(quantize(item.range, 1000));
  }
  return true;
}

std::uint32_t row_of_bumper(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kBumper ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_bumper(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.bumpers.measured_tick[row] == 0) return false;
  for (const auto& item : world.bumpers.hits[row]) {
    out.push_back(static_cast<std::int32_t>(item.value));
  }
  return true;
}

std::uint32_t row_of_blinkenlight(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kBlinkenlight ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_blinkenlight(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  out.push_back(quantize(world.blinkenlights.period[row], 1000));
  out.push_back(quantize(world.blinkenlights.dutycycle[row], 1000));
  return true;
}

std::uint32_t row_of_gripper(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kGripper ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_gripper(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  out.push_back(quantize(world.grippers.paddles[row], 1000));
  out.push_back(static_cast<std::int32_t>(world.grippers.closing[row]));
  out.push_back(quantize(world.grippers.lift[row], 1000));
  out.push_back(static_cast<std::int32_t>(world.grippers.rising[row]));
  out.push_back(static_cast<std::int32_t>(world.grippers.held[row].value));
  out.push_back(static_cast<std::int32_t>(world.grippers.beams[row]));
  out.push_back(static_cast<std::int32_t>(world.grippers.contacts[row]));
  return true;
}

std::uint32_t row_of_actuator(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kActuator ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_actuator(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  out.push_back(quantize(world.actuators.position[row], 1000));
  out.push_back(quantize(world.actuators.velocity[row], 1000));
  return true;
}

std::uint32_t row_of_wifi(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kWifi ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_wifi(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.wifis.measured_tick[row] == 0) return false;
  for (const auto& item : world.wifis.links[row]) {
    out.push_back(static_cast<std::int32_t>(item.station.value));
    out.push_back(static_cast<std::int32_t>(item.level));
    out.push_back(static_cast<std::int32_t>(item.quality));
  }
  return true;
}

std::uint32_t row_of_camera(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kCamera ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_camera(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.cameras.measured_tick[row] == 0) return false;
  for (const auto& item : world.cameras.pixels[row]) {
    out.push_back(static_cast<std::int32_t>(item.sample));
  }
  return true;
}

std::uint32_t row_of_detector(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kDetector ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_detector(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.detectors.measured_tick[row] == 0) return false;
  for (const auto& item : world.detectors.finds[row]) {
    out.push_back(static_cast<std::int32_t>(item.target.value));
    out.push_back(quantize(item.range, 1000));
    out.push_back(quantize_angle(item.bearing));
    out.push_back(quantize(item.level, 1000));
    out.push_back(static_cast<std::int32_t>(item.bodies));
  }
  return true;
}

std::uint32_t row_of_custom(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kCustom ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_custom(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.customs.measured_tick[row] == 0) return false;
  for (const auto& item : world.customs.readings[row]) {
    out.push_back(quantize(item, 1000));
  }
  return true;
}

std::uint32_t row_of_imu(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kImu ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_imu(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.imus.measured_tick[row] == 0) return false;
  out.push_back(quantize(world.imus.reading[row].v.x, 1000));
  out.push_back(quantize(world.imus.reading[row].v.y, 1000));
  out.push_back(quantize(world.imus.reading[row].v.z, 1000));
  out.push_back(quantize(world.imus.reading[row].w.x, 1000));
  out.push_back(quantize(world.imus.reading[row].w.y, 1000));
  out.push_back(quantize(world.imus.reading[row].w.z, 1000));
  out.push_back(quantize_angle(world.imus.X_WE[row].a));
  return true;
}

std::uint32_t row_of_gps(const world::World& world, std::uint32_t model) {
  return world.models.kind[model] == scene::ModelKind::kGps ? world.models.part[model] : world::ModelRow::kNone;
}

bool capture_gps(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  if (world.receivers.measured_tick[row] == 0) return false;
  out.push_back(quantize(world.receivers.position[row].x, 1000));
  out.push_back(quantize(world.receivers.position[row].y, 1000));
  out.push_back(quantize(world.receivers.position[row].z, 1000));
  return true;
}

std::uint32_t row_of_pack(const world::World& world, std::uint32_t model) {
  return world::trait_row(world.packs, model);
}

bool capture_pack(const world::World& world, std::uint32_t row, std::vector<std::int32_t>& out) {
  out.push_back(quantize(world.packs.stored[row], 1));
  out.push_back(quantize(world.packs.capacity[row], 1));
  out.push_back(quantize(world.packs.watts[row], 1000));
  out.push_back(static_cast<std::int32_t>(world.packs.charging[row]));
  return true;
}

constexpr Code kCodesOfPosition[] = {Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kTurn};
constexpr Code kCodesOfFiducial[] = {Code::kVarint, Code::kZigzag, Code::kVarint, Code::kTurn, Code::kTurn};
constexpr Code kCodesOfBlobfinder[] = {Code::kRgba, Code::kVarint, Code::kVarint, Code::kVarint};
constexpr Code kCodesOfBumper[] = {Code::kZigzag};
constexpr Code kCodesOfBlinkenlight[] = {Code::kVarint, Code::kVarint};
constexpr Code kCodesOfGripper[] = {Code::kVarint, Code::kZigzag, Code::kVarint, Code::kZigzag, Code::kZigzag, Code::kVarint, Code::kVarint};
constexpr Code kCodesOfActuator[] = {Code::kZigzag, Code::kZigzag};
constexpr Code kCodesOfWifi[] = {Code::kVarint, Code::kZigzag, Code::kVarint};
constexpr Code kCodesOfCamera[] = {Code::kVarint};
constexpr Code kCodesOfDetector[] = {Code::kVarint, Code::kVarint, Code::kTurn, Code::kVarint, Code::kVarint};
constexpr Code kCodesOfCustom[] = {Code::kZigzag};
constexpr Code kCodesOfImu[] = {Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kTurn};
constexpr Code kCodesOfGps[] = {Code::kZigzag, Code::kZigzag, Code::kZigzag};
constexpr Code kCodesOfPack[] = {Code::kZigzag, Code::kZigzag, Code::kZigzag, Code::kVarint};

constexpr View kViews[14] = {
    {When::kSelected, false, false, kCodesOfPosition, row_of_position, capture_position},
    {When::kShown, true, true, kCodesOfFiducial, row_of_fiducial, capture_fiducial},
    {When::kShown, true, true, kCodesOfBlobfinder, row_of_blobfinder, capture_blobfinder},
    {When::kShown, true, true, kCodesOfBumper, row_of_bumper, capture_bumper},
    {When::kSelected, false, false, kCodesOfBlinkenlight, row_of_blinkenlight, capture_blinkenlight},
    {When::kChanged, true, false, kCodesOfGripper, row_of_gripper, capture_gripper},
    {When::kSelected, false, false, kCodesOfActuator, row_of_actuator, capture_actuator},
    {When::kShown, true, true, kCodesOfWifi, row_of_wifi, capture_wifi},
    {When::kSelected, true, true, kCodesOfCamera, row_of_camera, capture_camera},
    {When::kShown, true, true, kCodesOfDetector, row_of_detector, capture_detector},
    {When::kShown, true, true, kCodesOfCustom, row_of_custom, capture_custom},
    {When::kShown, true, false, kCodesOfImu, row_of_imu, capture_imu},
    {When::kShown, true, false, kCodesOfGps, row_of_gps, capture_gps},
    {When::kSelected, false, false, kCodesOfPack, row_of_pack, capture_pack},
};

}  // namespace

std::span<const View> views() { return kViews; }

std::uint8_t state_bits(const world::World& world, std::uint32_t model) {
  [[maybe_unused]] const std::uint32_t row = world.models.part[model];
  unsigned bits = world.models.subscribers[model] > 0 ? 1 : 0;
  switch (world.models.kind[model]) {
    case scene::ModelKind::kPosition:
      if (world.positions.stall[row]) bits |= 2;
      if (world.positions.motor_on[row]) bits |= 4;
      break;
    case scene::ModelKind::kBlinkenlight:
      if (world.blinkenlights.lit[row]) bits |= 2;
      if (world.blinkenlights.enabled[row]) bits |= 4;
      break;
    case scene::ModelKind::kLightindicator:
      if (world.lightindicators.lit[row]) bits |= 2;
      break;
    case scene::ModelKind::kActuator:
      if (world.actuators.stall[row]) bits |= 2;
      if (world.actuators.motor_on[row]) bits |= 4;
      if (world.actuators.braked[row]) bits |= 8;
      break;
    default:
      break;
  }
  return static_cast<std::uint8_t>(bits);
}

bool may_be_watched(scene::ModelKind kind) {
  switch (kind) {
    case scene::ModelKind::kRanger:
    case scene::ModelKind::kFiducial:
    case scene::ModelKind::kBlobfinder:
    case scene::ModelKind::kBumper:
    case scene::ModelKind::kWifi:
    case scene::ModelKind::kCamera:
    case scene::ModelKind::kDetector:
    case scene::ModelKind::kCustom:
    case scene::ModelKind::kImu:
    case scene::ModelKind::kGps:
      return true;
    default:
      return false;
  }
}

namespace {

void tell_position(const scene::ModelDesc& model, std::string& text) {
  if (!model.position) return;
  static constexpr std::string_view kWordsOfDrive[] = {"diff", "omni", "walk", "car"};
  text += ",\"drive\":" + quoted(kWordsOfDrive[static_cast<std::size_t>(model.position->drive)]);
  fmt::format_to(std::back_inserter(text), ",\"trail\":{}", number(model.trail_length));
}

void tell_ranger(const scene::ModelDesc& model, std::string& text) {
  std::string all;
  for (const scene::RangerSensorDesc& each : model.sensors) {
    std::string fields;
    fmt::format_to(std::back_inserter(fields), ",\"pose\":{}", pose(each.X_BS));
    fmt::format_to(std::back_inserter(fields), ",\"size\":{}", size(each.size));
    fields += ",\"range\":[" + number(each.range_min) + ',' + number(each.range_max) + "]";
    fmt::format_to(std::back_inserter(fields), ",\"fov\":{}", number(each.fov));
    fmt::format_to(std::back_inserter(fields), ",\"samples\":{}", number(each.samples));
    fmt::format_to(std::back_inserter(fields), ",\"color\":{}", color(each.color));
    all += (all.empty() ? "{" : ",{") + fields.substr(1) + '}';
  }
  text += ",\"sensors\":[" + all + ']';
}

void tell_fiducial(const scene::ModelDesc& model, std::string& text) {
  if (!model.fiducial) return;
  fmt::format_to(std::back_inserter(text), ",\"range\":{}", number(model.fiducial->range_max));
  fmt::format_to(std::back_inserter(text), ",\"fov\":{}", number(model.fiducial->fov));
}

void tell_blobfinder(const scene::ModelDesc& model, std::string& text) {
  if (!model.blobfinder) return;
  fmt::format_to(std::back_inserter(text), ",\"fov\":{}", number(model.blobfinder->fov));
  fmt::format_to(std::back_inserter(text), ",\"pan\":{}", number(model.blobfinder->pan));
  text += ",\"image\":[" + number(model.blobfinder->width) + ',' + number(model.blobfinder->height) + "]";
}

void tell_bumper(const scene::ModelDesc& model, std::string& text) {
  if (!model.bumper) return;
  fmt::format_to(std::back_inserter(text), ",\"bpose\":{}", list(model.bumper->X_BS, [](const auto& each) { return pose(each); }));
  fmt::format_to(std::back_inserter(text), ",\"blength\":{}", list(model.bumper->blength, [](const auto& each) { return number(each); }));
}

void tell_gripper(const scene::ModelDesc& model, std::string& text) {
  if (!model.gripper) return;
  text += ",\"paddle\":[" + number(model.gripper->paddle_length) + ',' + number(model.gripper->paddle_width) + ',' + number(model.gripper->paddle_height) + "]";
}

void tell_actuator(const scene::ModelDesc& model, std::string& text) {
  if (!model.actuator) return;
  static constexpr std::string_view kWordsOfType[] = {"linear", "rotational"};
  text += ",\"joint\":" + quoted(kWordsOfType[static_cast<std::size_t>(model.actuator->type)]);
  fmt::format_to(std::back_inserter(text), ",\"lowest\":{}", number(model.actuator->min_position));
  fmt::format_to(std::back_inserter(text), ",\"highest\":{}", number(model.actuator->max_position));
  text += ",\"axis\":[" + number(model.actuator->axis_x) + ',' + number(model.actuator->axis_y) + ',' + number(model.actuator->axis_z) + "]";
}

void tell_camera(const scene::ModelDesc& model, std::string& text) {
  if (!model.camera) return;
  text += ",\"resolution\":[" + number(model.camera->width) + ',' + number(model.camera->height) + "]";
  text += ",\"view\":[" + number(model.camera->fov_horizontal) + ',' + number(model.camera->fov_vertical) + "]";
  static constexpr std::string_view kWordsOfImage[] = {"color", "gray", "depth", "segmentation"};
  text += ",\"shows\":" + quoted(kWordsOfImage[static_cast<std::size_t>(model.camera->image)]);
}

void tell_detector(const scene::ModelDesc& model, std::string& text) {
  if (!model.detector) return;
  text += ",\"reach\":[" + number(model.detector->range_min) + ',' + number(model.detector->range_max) + "]";
  fmt::format_to(std::back_inserter(text), ",\"fov\":{}", number(model.detector->fov));
}

void tell_custom(const scene::ModelDesc& model, std::string& text) {
  if (!model.custom) return;
  fmt::format_to(std::back_inserter(text), ",\"library\":{}", quoted(model.custom->library));
}

void tell_gps(const scene::ModelDesc& model, std::string& text) {
  if (!model.gps) return;
  fmt::format_to(std::back_inserter(text), ",\"satellites\":{}", number(model.gps->satellites));
}

}  // namespace

void tell_kind(const scene::ModelDesc& model, std::string& text) {
  switch (model.kind) {
    case scene::ModelKind::kPosition:
      tell_position(model, text);
      break;
    case scene::ModelKind::kRanger:
      tell_ranger(model, text);
      break;
    case scene::ModelKind::kFiducial:
      tell_fiducial(model, text);
      break;
    case scene::ModelKind::kBlobfinder:
      tell_blobfinder(model, text);
      break;
    case scene::ModelKind::kBumper:
      tell_bumper(model, text);
      break;
    case scene::ModelKind::kGripper:
      tell_gripper(model, text);
      break;
    case scene::ModelKind::kActuator:
      tell_actuator(model, text);
      break;
    case scene::ModelKind::kCamera:
      tell_camera(model, text);
      break;
    case scene::ModelKind::kDetector:
      tell_detector(model, text);
      break;
    case scene::ModelKind::kCustom:
      tell_custom(model, text);
      break;
    case scene::ModelKind::kGps:
      tell_gps(model, text);
      break;
    default:
      break;
  }
  std::string traits;
  if (scene::has_pack(model)) traits += R"(,"pack")";
  if (!traits.empty()) text += R"(,"traits":[)" + traits.substr(1) + ']';
}

std::string_view kind_name(scene::ModelKind kind) {
  switch (kind) {
    case scene::ModelKind::kPlain:
      return "plain";
    case scene::ModelKind::kPosition:
      return "position";
    case scene::ModelKind::kRanger:
      return "ranger";
    case scene::ModelKind::kFiducial:
      return "fiducial";
    case scene::ModelKind::kBlobfinder:
      return "blobfinder";
    case scene::ModelKind::kBumper:
      return "bumper";
    case scene::ModelKind::kBlinkenlight:
      return "blinkenlight";
    case scene::ModelKind::kLightindicator:
      return "lightindicator";
    case scene::ModelKind::kGripper:
      return "gripper";
    case scene::ModelKind::kActuator:
      return "actuator";
    case scene::ModelKind::kWifi:
      return "wifi";
    case scene::ModelKind::kCamera:
      return "camera";
    case scene::ModelKind::kDetector:
      return "detector";
    case scene::ModelKind::kCustom:
      return "custom";
    case scene::ModelKind::kImu:
      return "imu";
    case scene::ModelKind::kGps:
      return "gps";
  }
  return "";
}

}  // namespace playhouse::replicate
