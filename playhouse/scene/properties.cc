#include "playhouse/scene/properties.h"

#include <algorithm>
#include <cmath>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/rng.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::scene {
namespace {

constexpr char kFlat[2] = {};  // what warnings of such sizes and poses are about

}  // namespace

void LoadState::add(Error fault) {
  ++faults;
  const auto same = [&fault](const Error& known) {
    return known.where == fault.where && known.text == fault.text;
  };
  if (!error) {
    error = std::move(fault);
  } else if (!same(*error) && std::ranges::none_of(others, same)) {  // one per macro, not per instance
    others.push_back(std::move(fault));
  }
  over = over || others.size() + 1 >= limits::kWarningsOfAKind;
}

void LoadState::end(Error fault) {
  add(std::move(fault));
  over = true;
}

config::SourceLine Properties::where(std::string_view key) const {
  const config::Field* field = fields_.find(key);
  return field ? field->where : where_;
}

std::optional<double> Properties::scaled(const config::Field& field, std::size_t element, char scale) const {
  const std::string_view text = field.values[element].text;
  const std::optional<double> value = config::parse_number(text);
  if (!value || std::abs(*value) > kLargestNumber) {
    state_.fail(field.where, in_quotes(field.key) + " needs a number" + (value ? " of at most 1e9" : "") +
                                 ", found " + in_quotes(text));
    return std::nullopt;
  }
  return *value * (scale == 'L' ? state_.units.length : scale == 'A' ? state_.units.angle : 1.0);
}

std::span<const config::Value> Properties::elements(std::string_view key, std::size_t count,
                                                    std::string_view form) const {
  const config::Field* field = fields_.find(key);
  if (!field) return {};
  if (field->values.size() < count) {
    state_.fail(field->where, in_quotes(key) + " needs " + std::to_string(count) +
                                  (count == 1 ? " value" : " values " + std::string(form)) + ", found " +
                                  std::to_string(field->values.size()));
    return {};
  }
  if (field->values.size() > count) {
    state_.warnings.add(config::Warning::kValue, field->where,
                        in_quotes(key) + " takes " + std::to_string(count) +
                            (count == 1 ? " value" : " values") + ", found " +
                            std::to_string(field->values.size()) + "; the others have no effect");
  }
  return std::span(field->values).first(count);
}

bool Properties::tuple(std::string_view key, std::string_view scales, std::span<double> out,
                       std::string_view form) const {
  if (elements(key, scales.size(), form).empty()) return false;
  const config::Field& field = *fields_.find(key);
  for (std::size_t i = 0; i < scales.size(); ++i) out[i] = scaled(field, i, scales[i]).value_or(out[i]);
  return true;
}

double Properties::number(std::string_view key, double otherwise) const {
  double value[1] = {otherwise};
  tuple(key, "N", value, {});
  return value[0];
}

double Properties::length(std::string_view key, double otherwise) const {
  double value[1] = {otherwise};
  tuple(key, "L", value, {});
  return value[0];
}

double Properties::angle(std::string_view key, double otherwise) const {
  double value[1] = {otherwise};
  tuple(key, "A", value, {});
  return value[0];
}

int Properties::integer(std::string_view key, int otherwise) const {
  const double value = number(key, otherwise);
  const int whole = static_cast<int>(value);  // bounded by kLargestNumber; truncated as in the original
  if (whole != value)
    state_.warnings.add(config::Warning::kValue, where(key),
                        in_quotes(key) +
                            " takes a whole number: " + std::string(fields_.find(key)->values.front().text) +
                            " is read as " + std::to_string(whole));
  return whole;
}

std::string Properties::text(std::string_view key, std::string_view otherwise) const {
  const config::Field* field = fields_.find(key);
  if (!field) return std::string(otherwise);
  if (field->values.empty()) {
    state_.fail(field->where, in_quotes(key) + " needs a text in quotes, found an empty tuple");
    return {};
  }
  return std::string(field->values.front().text);
}

std::vector<std::string> Properties::texts(std::string_view key) const {
  std::vector<std::string> texts;
  if (const config::Field* field = fields_.find(key)) {
    for (const config::Value& value : field->values) texts.emplace_back(value.text);
  }
  return texts;
}

bool Properties::has_flat_size() const {
  const config::Field* size = fields_.find("size");
  return size && size->values.size() == 2;
}

bool Properties::is_flat(std::string_view key, std::size_t count, std::string_view now) const {
  const config::Field* field = fields_.find(key);
  if (!field || field->values.size() != count) return false;
  const std::string_view which = count == 3 ? "without z" : "without height";
  state_.warnings.add_old(
      &kFlat[count - 2], field->where,
      in_quotes(key) + " " + std::string(which) + " is of older versions: write " + std::string(now));
  return true;
}

std::optional<geom::Pose> Properties::pose(std::string_view key) const {
  double v[4] = {};
  if (is_flat(key, 3, "[x y z heading]")) {
    tuple(key, "LLA", v, "");
    return geom::Pose{v[0], v[1], 0, geom::normalize(v[2])};
  }
  if (!tuple(key, "LLLA", v, "[x y z heading]")) return std::nullopt;
  return geom::Pose{v[0], v[1], v[2], geom::normalize(v[3])};
}

geom::Size Properties::size(std::string_view key, geom::Size otherwise) const {
  double v[3] = {otherwise.x, otherwise.y, otherwise.z};
  if (is_flat(key, 2, "[x y z]")) {
    tuple(key, "LL", v, "");
  } else {
    tuple(key, "LLL", v, "[x y z]");
  }
  if (v[0] < 0 || v[1] < 0 || v[2] < 0) state_.fail(where(key), in_quotes(key) + " must not be negative");
  return {v[0], v[1], v[2]};
}

Color Properties::color(Color otherwise, std::size_t row) const {
  if (!has("color")) {
    double v[4] = {otherwise.r, otherwise.g, otherwise.b, otherwise.a};
    tuple("color_rgba", "NNNN", v, "[red green blue alpha] from 0 to 1");
    if (std::ranges::any_of(v, [](double part) { return part < 0 || part > 1; }))
      state_.warnings.add(config::Warning::kValue, where("color_rgba"),
                          "\"color_rgba\" takes values from 0 to 1; others are cut to that");
    for (double& part : v) part = std::clamp(part, 0.0, 1.0);
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]),
            static_cast<float>(v[3])};
  }
  const std::string name = text("color", "");
  if (name == "random") {
    ++state_.random_colors;
    Rng rng(0, 0, {Purpose::kColor, static_cast<std::uint32_t>(row)});
    const auto channel = [&rng] { return static_cast<float>(rng.uniform()); };
    const float r = channel(), g = channel(), b = channel();
    return {r, g, b, 1};
  }
  if (const auto known = color_by_name(name)) return *known;
  state_.warnings.add(config::Warning::kColor, where("color"),
                      "unknown color " + in_quotes(name) + ", red is used",
                      [&name] { return color_hint(name); });
  return {1, 0, 0, 1};
}

}  // namespace playhouse::scene
