#include "playhouse/scene/text/repeats.h"

#include <algorithm>
#include <array>

namespace playhouse::scene {
namespace {

constexpr std::array<std::string_view, 5> kOwnWords = {"name", "pose", "color", "color_rgba",
                                                       "fiducial_return"};

void append(std::string& key, char mark, std::string_view text) {
  key += mark;
  key += std::to_string(text.size());
  key += ' ';
  key += text;
}

void append(std::string& key, const config::Field& field) {
  append(key, '=', field.key);
  for (const config::Value& value : field.values) append(key, '-', value.text);
  // File references are relative to the referring file.
  if (field.key == "bitmap" || field.key == "mesh" || field.key == "look")
    append(key, '@', std::to_string(field.where.file));
}

void append(std::string& key, const config::Section& section) {
  append(key, '(', section.name);
  for (const config::Field& field : section.fields) {
    append(key, field);
    // Messages about a controller show the line of its model.
    if (field.key == "ctrl")
      append(key, '@', std::to_string(section.where.file) + ":" + std::to_string(section.where.line));
  }
  for (const config::Section& inner : section.sections) append(key, inner);
  key += ')';
}

/// Compares parts, or roots without per-tree values.
bool is_same(const ModelDesc& a, const ModelDesc& b) {
  return static_cast<const PlainDesc&>(a) == static_cast<const PlainDesc&>(b) &&
         static_cast<const KindDescs&>(a) == static_cast<const KindDescs&>(b) && a.type == b.type &&
         a.kind == b.kind && a.stacked == b.stacked && a.stacks_children == b.stacks_children &&
         a.blocks == b.blocks && a.moving_blocks == b.moving_blocks && a.bitmaps == b.bitmaps &&
         a.mesh == b.mesh && a.look == b.look && a.body == b.body && a.kept == b.kept;
}

/// Default names start with the parent's, so equal ones imply equal parents.
bool is_same_part(const ModelDesc& a, const ModelDesc& b, const ModelDesc& top_a, const ModelDesc& top_b) {
  const bool same_line = a.where.file == b.where.file && a.where.line == b.where.line;
  return a.name == token_in(b.name, top_b.name, top_a.name) &&
         a.alias == token_in(b.alias, top_b.name, top_a.name) && (a.ctrl.empty() || same_line) &&
         is_same(a, b);
}

}  // namespace

std::string repeat_key(const config::Section& section) {
  std::string key(section.name);
  for (const config::Field& field : section.fields) {
    if (std::ranges::find(kOwnWords, field.key) == kOwnWords.end()) {
      append(key, field);
    } else {
      append(key, '=', field.key);
    }
  }
  for (const config::Section& inner : section.sections) append(key, inner);
  return key;
}

bool is_same_tree(std::span<const ModelDesc> a, std::span<const ModelDesc> b) {
  if (a.size() != b.size()) return false;
  ModelDesc top = b[0];
  top.X_PM = a[0].X_PM;
  top.color = a[0].color;
  top.fiducial_return = a[0].fiducial_return;
  if (!is_same(a[0], top)) return false;
  for (std::size_t i = 1; i < a.size(); ++i)
    if (!is_same_part(a[i], b[i], a[0], b[0])) return false;
  return true;
}

}  // namespace playhouse::scene
