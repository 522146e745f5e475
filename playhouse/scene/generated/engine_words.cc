// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/scene/generated/engine_words.h"

#include <algorithm>

namespace playhouse::scene {
namespace {

void add_arena_words(const PositionDesc& from, std::set<std::string_view>& words) {
  if (from.max_force) words.insert("max_force");
  if (from.max_power) words.insert("max_power");
}

void add_arena_words(const RangerSensorDesc& from, std::set<std::string_view>& words) {
  static const RangerSensorDesc unsaid;
  if (from.rings != unsaid.rings) words.insert("rings");
  if (from.errors != unsaid.errors) words.insert("error");
}

}  // namespace

void add_arena_words(const PlainDesc& from, std::set<std::string_view>& words) {
  static const PlainDesc unsaid;
  if (from.roll != unsaid.roll || from.pitch != unsaid.pitch) words.insert("tilt");
  if (from.friction != unsaid.friction) words.insert("friction");
  if (from.friction_x != unsaid.friction_x || from.friction_y != unsaid.friction_y) words.insert("friction_axes");
  if (from.material != unsaid.material) words.insert("material");
  if (from.restitution) words.insert("restitution");
  if (from.roughness) words.insert("roughness");
  if (from.lamp != unsaid.lamp) words.insert("lamp");
}

void add_arena_words(const WorldDesc& from, std::set<std::string_view>& words) {
  static const WorldDesc unsaid;
  if (from.gravity != unsaid.gravity) words.insert("gravity");
  if (from.ground != unsaid.ground) words.insert("ground");
  if (from.sun_heading != unsaid.sun_heading || from.sun_elevation != unsaid.sun_elevation || from.sun_brightness != unsaid.sun_brightness) words.insert("sun");
  if (from.fog != unsaid.fog) words.insert("fog");
}

void add_arena_words(const KindDescs& from, std::set<std::string_view>& words) {
  if (from.position) add_arena_words(*from.position, words);
  for (const RangerSensorDesc& part : from.sensors) add_arena_words(part, words);
}

}  // namespace playhouse::scene
