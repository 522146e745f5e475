#pragma once

/// Every shader of the renderer. Positions are in E (view.h), in metres, light is linear.
///
/// Source: microfacets after Trowbridge and Reitz, visibility after Smith, Fresnel after Schlick, as in
/// appendix B
///   of the glTF 2.0 specification; fog after Koschmieder.

#include <string>

namespace playhouse::render {

/// How vertices come to their places: bodies that are rigid, or that bend with bones.
enum class Bends { kNo, kYes };
/// What fragments become; of depth nothing but that.
enum class Paints { kColor, kDepth, kSegments };

std::string vertex_shader(Bends bends, Paints paints);
std::string fragment_shader(Paints paints);
/// The sky, of colours alone, and the floor: triangles that cover the picture, of which a line is kept to one
/// side.
std::string background_vertex_shader();
std::string sky_fragment_shader();
std::string floor_fragment_shader(Paints paints);
/// A cloud of smoke: the far sides of its box.
std::string smoke_vertex_shader();
std::string smoke_fragment_shader();

}  // namespace playhouse::render
