#pragma once

/// A COLLADA file as elements, with what its parts have in common: ids, transforms, lists of numbers.

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
  /// Fails on what is no XML, no COLLADA, or nested deeper than limits::kMeshDepth; on a unit that is none,
  /// on nodes that are too many or inside themselves, and on corners below 0.
  static Result<ColladaDocument> parse(std::string_view bytes);

  pugi::xml_node root() const { return root_; }
  /// The element that an address means, "#id"; none: it is not in this file.
  pugi::xml_node find(std::string_view address) const;
  /// Where a node of a scene is in F, with the units of this file in it; nothing if no scene has it. Nodes
  /// that are placed more than once are where they are first.
  std::optional<Affine> node_in_F(std::string_view address) const;
  /// The file's own axes and unit in F.
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

/// The numbers of an element's text, as many as there are, up to `most`.
std::vector<double> numbers_of(const pugi::xml_node& element, std::size_t most);
/// One number; nothing where the element has none.
std::optional<double> number_of(const pugi::xml_node& element);
/// What translate, rotate, scale and matrix elements in `parent` say, in their order.
Affine transform_of(const pugi::xml_node& parent);

}  // namespace playhouse::mesh
