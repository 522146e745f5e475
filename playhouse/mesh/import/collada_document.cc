#include "playhouse/mesh/import/collada_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/mesh_limits.h"
#include "playhouse/geom/trig.h"
#include "playhouse/mesh/import/trimmed.h"

namespace playhouse::mesh {
namespace {

using geom::Vec3;

constexpr double kDegree = geom::kPi / 180;

/// Limits the nesting depth of elements.
class Depth final : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node&) override { return depth() < limits::kMeshDepth; }
};

/// In metres; default 1.
Result<double> unit_of(const pugi::xml_attribute& meter) {
  if (!meter) return 1.0;
  const std::string_view text = trimmed(meter.value());
  char* end = nullptr;
  const double unit = std::strtod(text.data(), &end);
  if (text.empty() || end != text.data() + text.size() || !(unit > 0) || !std::isfinite(unit))
    return Error{
        {},
        fmt::format("has an invalid unit of {} metres: a number above 0 is valid", in_quotes(meter.value()))};
  return unit;
}

Affine turn(const Vec3& axis, double degrees) {
  const geom::SinCos a = geom::sincos(degrees * kDegree);
  const Vec3 u = unit(axis, {0, 0, 1});
  Affine X;
  for (Vec3& e : X.axes) e = a.cos * e + a.sin * cross(u, e) + ((1 - a.cos) * dot(u, e)) * u;
  return X;
}

}  // namespace

std::string with_trimmed_colors(std::string_view bytes) {
  constexpr std::string_view kSpace = " \t\r\n", kColor = "<color";
  std::string trimmed;
  std::size_t kept = 0;
  for (std::size_t at = bytes.find(kColor); at != bytes.npos; at = bytes.find(kColor, at + kColor.size())) {
    const std::size_t end = bytes.find('>', at);
    if (end == bytes.npos) break;
    const std::size_t first = std::min(bytes.find_first_not_of(kSpace, end + 1), bytes.size());
    trimmed += bytes.substr(kept, end + 1 - kept);
    kept = first;
  }
  return trimmed += bytes.substr(kept);
}

std::vector<double> numbers_of(const pugi::xml_node& element, std::size_t most) {
  std::vector<double> numbers;
  const char* at = element.text().get();
  for (char* end = nullptr; numbers.size() < most; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) break;
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<double> number_of(const pugi::xml_node& element) {
  const std::vector<double> numbers = numbers_of(element, 1);
  if (numbers.empty()) return std::nullopt;
  return numbers[0];
}

Affine transform_of(const pugi::xml_node& parent) {
  Affine X;
  for (const pugi::xml_node& step : parent.children()) {
    const std::string_view name = step.name();
    if (name == "matrix") {
      const std::vector<double> m = numbers_of(step, 16);
      if (m.size() == 16)
        X = X * Affine{{{{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}}}, {m[3], m[7], m[11]}};
    } else if (name == "rotate") {
      const std::vector<double> r = numbers_of(step, 4);
      if (r.size() == 4) X = X * turn({r[0], r[1], r[2]}, r[3]);
    } else if (name == "translate" || name == "scale") {
      const std::vector<double> v = numbers_of(step, 3);
      if (v.size() != 3) continue;
      X = X * (name == "scale" ? Affine{{{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}}, {}}
                               : Affine{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {v[0], v[1], v[2]}});
    }
  }
  return X;
}

Result<ColladaDocument> ColladaDocument::parse(std::string_view bytes) {
  ColladaDocument made;
  const pugi::xml_parse_result parsed = made.document_->load_buffer(bytes.data(), bytes.size());
  if (!parsed)
    return Error{
        {}, fmt::format("cannot be read: invalid XML: {} at byte {}", parsed.description(), parsed.offset)};
  made.root_ = made.document_->child("COLLADA");
  if (!made.root_) return Error{{}, "cannot be read: it is not a COLLADA file"};
  Depth depth;
  if (!made.document_->traverse(depth))
    return Error{{}, fmt::format("has elements more than {} deep", limits::kMeshDepth)};

  const pugi::xml_node asset = made.root_.child("asset");
  const Result<double> unit = unit_of(asset.child("unit").attribute("meter"));
  if (!unit) return unit.error();
  const std::string_view up = asset.child("up_axis").text().get();
  if (up == "Z_UP") {
    made.X_FC_ = {};
  } else if (up == "X_UP") {
    made.X_FC_ = from_y_up() * Affine{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, {}};
  } else {
    made.X_FC_ = from_y_up();
  }
  for (Vec3& axis : made.X_FC_.axes) axis = *unit * axis;
  made.look_for_ids();
  if (const Result<void> placed = made.place_nodes(); !placed) return placed.error();
  if (const Result<void> checked = made.check_corners(); !checked) return checked.error();
  return made;
}

template <typename Visit>
void ColladaDocument::each_element(const Visit& visit) const {
  // In document order, iteratively.
  for (pugi::xml_node at = root_; at;) {
    visit(at);
    if (at.first_child()) {
      at = at.first_child();
      continue;
    }
    while (at && at != root_ && !at.next_sibling()) at = at.parent();
    at = at == root_ ? pugi::xml_node() : at.next_sibling();
  }
}

void ColladaDocument::look_for_ids() {
  each_element([this](const pugi::xml_node& at) {
    if (const pugi::xml_attribute id = at.attribute("id")) by_id_.try_emplace(id.value(), at);
  });
}

/// Indices of corners start at 0; Assimp would read negative ones as 0.
Result<void> ColladaDocument::check_corners() const {
  bool is_below = false;
  each_element([&](const pugi::xml_node& at) {
    is_below =
        is_below || (std::string_view(at.name()) == "p" && std::strchr(at.text().get(), '-') != nullptr);
  });
  if (is_below) return Error{{}, "is broken: a triangle has a corner that is not there"};
  return {};
}

Result<void> ColladaDocument::place_nodes() {
  struct Open {
    pugi::xml_node node;
    Affine X_FP;
    int depth;
  };
  std::vector<Open> open;
  for (const pugi::xml_node& scene : root_.child("library_visual_scenes").children("visual_scene"))
    for (const pugi::xml_node& node : scene.children("node")) open.push_back({node, X_FC_, 1});
  for (std::size_t looked = 0; !open.empty(); ++looked) {
    if (looked >= limits::kMeshNodes)
      return Error{{}, fmt::format("has too many nodes: up to {} are possible", limits::kMeshNodes)};
    const Open next = open.back();
    open.pop_back();
    const Affine X_FN = next.X_FP * transform_of(next.node);
    if (const pugi::xml_attribute id = next.node.attribute("id")) nodes_.try_emplace(id.value(), X_FN);
    if (next.depth > limits::kMeshDepth)
      return Error{
          {}, fmt::format("has nodes more than {} deep, or one that is inside itself", limits::kMeshDepth)};
    for (const pugi::xml_node& child : next.node.children("node"))
      open.push_back({child, X_FN, next.depth + 1});
    for (const pugi::xml_node& instance : next.node.children("instance_node"))
      if (const pugi::xml_node child = find(instance.attribute("url").value()))
        open.push_back({child, X_FN, next.depth + 1});
  }
  return {};
}

pugi::xml_node ColladaDocument::find(std::string_view address) const {
  if (!address.starts_with('#')) return {};
  const auto found = by_id_.find(address.substr(1));
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

std::optional<Affine> ColladaDocument::node_in_F(std::string_view address) const {
  if (!address.starts_with('#')) return std::nullopt;
  const auto found = nodes_.find(address.substr(1));
  if (found == nodes_.end()) return std::nullopt;
  return found->second;
}

}  // namespace playhouse::mesh
