#pragma once

/// Nearest intersections of rays from one point with triangles.
///
/// Rays of a scanner have their origin in common, and their neighbours nearly the direction. Up to 128 of
/// them are a fan, which is tested as a whole: its pyramid against the sixteen boxes of a node at once; a box
/// from the stack against sixteen groups of the rays and what those have hit already; the triangles of a leaf
/// against the sides of each block of sixteen rays, and those between them against its rays. A batch that
/// spans more than a fan should is cut in halves.
///
/// In: the index of triangles, rays.
///
/// Out: of each ray the distance of the nearest hit, its owner, normal and angle. No ray passes between
/// triangles that have corners in common. Double precision decides where single precision does not tell: at
/// edges, and where rays graze a triangle. The same bits with every instruction set (float16_plain.inc,
/// float16_avx2.inc, float16_avx512.inc).
///
/// Cost: among 200,000 triangles and 1,000 boxes 40 ns per ray of 1,800 beams in a turn, 170 ns of 360
/// (arena_bench).
///
/// Source: Reshetov, Soupikov, Hurley, "Multi-level ray tracing algorithm", 2005 (pyramids); Davidovic,
/// Engelhardt, Georgiev, Slusallek, Dachsbacher, "3D rasterization: a bridge between rasterization and ray
/// casting", 2012 (edge functions of rays from one point).

#include "playhouse/arena/sensing/ray_batch.h"
#include "playhouse/arena/sensing/ray_index.h"

namespace playhouse::arena {

void cast_rays(const RayIndex& index, RayBatch& rays);

}  // namespace playhouse::arena
