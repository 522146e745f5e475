#pragma once

/// All shaders of the renderer. Positions in E (view.h), in metres; linear light.
///
/// Source: microfacets after Trowbridge and Reitz, visibility after Smith, Fresnel after Schlick, as in
/// appendix B
///   of the glTF 2.0 specification; fog after Koschmieder.

#include <string>

namespace playhouse::render {

/// Vertex transformation: rigid, or skinned.
enum class Bends { kNo, kYes };
/// Output of fragments; depth writes depth only.
enum class Paints { kColor, kDepth, kSegments };
/// What is drawn: all, or what is beyond a plane, for what a mirror shows (the uniform `cut`).
enum class Shown { kAll, kBeyondPlane };

std::string vertex_shader(Bends bends, Paints paints, Shown shown = Shown::kAll);
std::string fragment_shader(Paints paints);
/// Colours of surfaces some of which are mirrors.
std::string mirror_fragment_shader();
/// Background: the sky, for colour, and the floor:
/// a full-screen triangle, clipped at the horizon.
std::string background_vertex_shader();
std::string sky_fragment_shader();
std::string floor_fragment_shader(Paints paints);
/// A smoke volume, drawn by the back faces of its box.
std::string smoke_vertex_shader();
std::string smoke_fragment_shader(Shown shown = Shown::kAll);

}  // namespace playhouse::render
