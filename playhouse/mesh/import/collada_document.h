#pragma once

/// A COLLADA file as a DOM, with common queries: ids, transforms, number lists.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/mesh/affine.h"

namespace playhouse::mesh {

class ColladaDocument {
 public:
  /// Fails on invalid XML, on documents that are not COLLADA or nested beyond limits::kMeshDepth,
  /// on an invalid unit, on too many or recursive nodes, and on negative indices.
  static Result<ColladaDocument> parse(std::string_view bytes);

  pugi::xml_node root() const { return root_; }
  /// Resolves a reference "#id"; none if it is not in this file.
  pugi::xml_node find(std::string_view address) const;
  /// Transform of a scene node to F, including the unit of the file; none if no scene
  /// contains it. A node instantiated several times has the transform of its first instance.
  std::optional<Affine> node_in_F(std::string_view address) const;
  /// The file's axes and unit in F.
  const Affine& X_FC() const { return X_FC_; }

 private:
  template <typename Visit>
  void each_element(const Visit& visit) const;
  void look_for_ids();
  Result<void> place_nodes();
  Result<void> check_corners() const;

  std::unique_ptr<pugi::xml_document> document_ = std::make_unique<pugi::xml_document>();
  pugi::xml_node root_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;
  std::map<std::string, Affine, std::less<>> nodes_;  // by id
  Affine X_FC_;
};

/// The text of a COLLADA file without white space in front of numbers of colors, which Assimp refuses.
std::string with_trimmed_colors(std::string_view bytes);
/// Parses the numbers in an element's text, at most `most`.
std::vector<double> numbers_of(const pugi::xml_node& element, std::size_t most);
/// Parses one number; none if there is none.
std::optional<double> number_of(const pugi::xml_node& element);
/// Product of the translate, rotate, scale and matrix elements in `parent`, in order.
Affine transform_of(const pugi::xml_node& parent);

}  // namespace playhouse::mesh
