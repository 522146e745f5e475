#pragma once

/// Bodies: the solids of a scene as columns. A solid is one closed polygon extruded in z; a block is one
/// solid, every contour of a bitmap is one. Solids of trees that move come first, in the order of the trees,
/// so that a tree's solids and vertices are consecutive; what stands still follows. Frames: W world, M the
/// model that owns the solid.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/world/world.h"

namespace playhouse::stage {

using geom::Pose;
using geom::Rotation;
using geom::Vec2;

/// Trees of models that hold at least one model that drives.
struct Trees {
  std::vector<std::uint32_t> root;                       // model row of the top                        (t)
  std::vector<std::uint32_t> first_model, models;        // rows, parents first: models[first_model[t] ..]
  std::vector<std::uint32_t> first_position, positions;  // position rows of the tree
  std::vector<std::uint32_t> first_solid;                // solids first_solid[t] .. first_solid[t + 1] - 1
  std::vector<std::uint32_t> of_root;  // model row of a top -> tree row, or Row::kNone (models)
  std::size_t size() const { return root.size(); }
};

struct Solids {
  // What a solid is.
  std::vector<std::uint32_t> model, root;   // rows of world::Models
  std::vector<std::uint32_t> tree;          // row of Trees, or Row::kNone
  std::vector<double> z_min_M, z_max_M;     // m
  std::vector<Vec2> center_M;               // mean of the vertices                                    [m]
  std::vector<double> radius;               // of the circle about the centre that holds the solid     [m]
  std::vector<double> width;                // smallest extent                                         [m]
  std::vector<std::uint8_t> convex;         // 1: a convex polygon
  std::vector<std::uint8_t> obstacle;       // 1: collides
  std::vector<double> ranger_return;        // below 0: rangers do not see it
  std::vector<std::uint32_t> first_vertex;  // (n + 1)
  // Counter-clockwise vertices, the first of each polygon again at its end.                            [m]
  // (vertices)
  std::vector<Vec2> p_M;
  std::size_t moving = 0;  // rows below this belong to trees

  // Where it is.                              written by: place
  std::vector<Vec2> center;          // in W                                                    [m]
  std::vector<double> z_min, z_max;  // in W                                                    [m]
  std::vector<Vec2> p;  // vertices in W, and kSpare more to read past the end           [m] (vertices)
  static constexpr std::size_t kSpare = 4;

  std::size_t size() const { return model.size(); }
  std::span<const Vec2> polygon(std::size_t row) const {
    return {p.data() + first_vertex[row], first_vertex[row + 1] - first_vertex[row] - 1};
  }
};

Trees make_trees(const world::World& world);
Solids make_solids(const world::World& world, Trees& trees);

/// Puts the solids [begin, end) where their models are.
void place(Solids& solids, const world::Models& models, std::size_t begin, std::size_t end);

/// Where one tree would be: a proposal, or a step on the way to it. Rows count from the tree's first.
struct TreeShape {
  std::span<Pose> X_PM, X_WM;    // (models of the tree)
  std::span<Rotation> rotation;  // of X_WM (models of the tree)
  std::span<Vec2> center, p;     // (solids of the tree), (their vertices)
};

}  // namespace playhouse::stage
