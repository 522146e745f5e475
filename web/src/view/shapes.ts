import { BufferAttribute, BufferGeometry, ExtrudeGeometry, Path, Shape } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Solid } from '../protocol/scene';

type Loop = number[]; // x, y, x, y, ...

const kUprightsMost = 40; // corners
const kStairsLeast = 12; // corners
const kThinMost = 2.5; // pixels: smoothing would make thinner walls self-intersect
const kStepMost = 6; // pixels: longer edges are walls, not stair steps

/** Extrudes a shape into one geometry in the body's frame; null if it is empty. */
export function geometryOf(solids: Solid[]): BufferGeometry | null {
  const parts: BufferGeometry[] = [];
  for (const solid of solids) {
    const outlines = outlinesOf(drawnLoops(solid));
    if (outlines.length === 0) continue;
    const depth = Math.max(solid.z[1] - solid.z[0], 1e-3);
    const part = new ExtrudeGeometry(outlines, { depth, bevelEnabled: false });
    parts.push(part.translate(0, 0, solid.z[0]));
  }
  return parts.length === 0 ? null : mergeGeometries(parts);
}

/** Outlines of a shape as line segments: rims, and vertical edges if there are few corners. */
export function edgesOf(solids: Solid[]): BufferGeometry {
  const points: number[] = [];
  for (const solid of solids) {
    const z = solid.z;
    for (const loop of drawnLoops(solid)) {
      const uprights = loop.length <= kUprightsMost * 2;
      for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
        points.push(loop[j], loop[j + 1], z[1], loop[i], loop[i + 1], z[1]);
        if (!uprights) continue;
        points.push(loop[j], loop[j + 1], z[0], loop[i], loop[i + 1], z[0]);
        points.push(loop[i], loop[i + 1], z[0], loop[i], loop[i + 1], z[1]);
      }
    }
  }
  return new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
}

/** Loops for drawing: smoothed, unless the walls are thin. */
export function drawnLoops(solid: Solid): Loop[] {
  return isThin(solid.loops) ? solid.loops : solid.loops.map(smoothed);
}

/** Whether a traced bitmap is a line drawing with walls about 1 pixel wide: mean width = area / (perimeter / 2). */
function isThin(loops: Loop[]): boolean {
  const pixel = Math.min(...loops.map((loop) => stairsPixel(loop) || Infinity));
  if (!Number.isFinite(pixel)) return false;
  const area = loops.reduce((sum, loop) => sum + areaOf(loop), 0);
  const outline = loops.reduce((sum, loop) => sum + perimeterOf(loop), 0);
  return Math.abs(area) / (outline / 2) < kThinMost * pixel;
}

/**
 * Smooths a loop traced from a bitmap, which is a staircase along pixels: the midpoints
 * of the steps lie on the intended line. Corners between long straight edges stay.
 */
export function smoothed(loop: Loop): Loop {
  const pixel = stairsPixel(loop);
  if (pixel === 0) return loop;
  const middles: Loop = [];
  const count = loop.length / 2;
  const point = (k: number) => [loop[(2 * k) % loop.length], loop[(2 * k + 1) % loop.length]];
  const isLong = (k: number) => distance(point(k), point(k + 1)) > kStepMost * pixel;
  for (let k = 0; k < count; ++k) {
    const [a, b] = [point(k), point(k + 1)];
    if (isLong(k) && isLong(k + count - 1)) middles.push(...a);
    if (!isLong(k)) middles.push((a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    else middles.push(...between(a, b, 1.5 * pixel), ...between(b, a, 1.5 * pixel));
  }
  return thinned(middles, pixel / 2);
}

/** Pixel size, if the loop has many edges and all are axis-parallel; else 0. */
function stairsPixel(loop: Loop): number {
  if (loop.length < kStairsLeast * 2) return 0;
  let pixel = Infinity;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    const [dx, dy] = [Math.abs(loop[i] - loop[j]), Math.abs(loop[i + 1] - loop[j + 1])];
    if (Math.min(dx, dy) > 1e-6) return 0;
    if (dx + dy > 1e-6) pixel = Math.min(pixel, dx + dy);
  }
  return pixel;
}

function distance(a: number[], b: number[]): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

/** The point at this distance from a towards b. */
function between(a: number[], b: number[], far: number): number[] {
  const t = far / distance(a, b);
  return [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
}

/** Removes points within `tolerance` of the line between their neighbours. */
function thinned(loop: Loop, tolerance: number): Loop {
  const count = loop.length / 2;
  const half = Math.floor(count / 2);
  const kept = new Uint8Array(count + 1);
  kept[0] = kept[half] = 1;
  thin(loop, 0, half, tolerance, kept);
  thin(loop, half, count, tolerance, kept);
  return loop.filter((_, i) => kept[i >> 1]);
}

/** Marks the points to keep between two kept ones (Ramer 1972; Douglas and Peucker 1973). */
function thin(loop: Loop, first: number, last: number, tolerance: number, kept: Uint8Array): void {
  const open: [number, number][] = [[first, last]];
  const at = (k: number, axis: number) => loop[(2 * k + axis) % loop.length];
  for (let span = open.pop(); span; span = open.pop()) {
    const [a, b] = span;
    const [dx, dy] = [at(b, 0) - at(a, 0), at(b, 1) - at(a, 1)];
    const length = Math.hypot(dx, dy);
    let [farthest, far] = [-1, tolerance];
    for (let k = a + 1; k < b; ++k) {
      const [ex, ey] = [at(k, 0) - at(a, 0), at(k, 1) - at(a, 1)];
      const off = length > 0 ? Math.abs(dx * ey - dy * ex) / length : Math.hypot(ex, ey);
      if (off > far) [farthest, far] = [k, off];
    }
    if (farthest < 0) continue;
    kept[farthest] = 1;
    open.push([a, farthest], [farthest, b]);
  }
}

/** Height above the body's frame. */
export function heightOf(solids: Solid[]): number {
  return solids.reduce((height, solid) => Math.max(height, solid.z[1]), 0);
}

/** Groups loops into outlines with holes: a loop inside an odd number of others is a hole of the smallest one. */
export function outlinesOf(loops: Loop[]): Shape[] {
  const usable = loops.filter((loop) => loop.length >= 6);
  const areas = usable.map((loop) => Math.abs(areaOf(loop)));
  const shapes = new Map<number, Shape>();
  const holes: [hole: number, owner: number][] = [];
  usable.forEach((loop, k) => {
    const around = usable.map((_, j) => j).filter((j) => areas[j] > areas[k] && contains(usable[j], loop[0], loop[1]));
    if (around.length % 2 === 0) shapes.set(k, trace(new Shape(), loop));
    else holes.push([k, around.reduce((a, b) => (areas[a] < areas[b] ? a : b))]);
  });
  for (const [hole, owner] of holes) shapes.get(owner)?.holes.push(trace(new Path(), usable[hole]));
  return [...shapes.values()];
}

function perimeterOf(loop: Loop): number {
  let sum = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) sum += Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]);
  return sum;
}

export function areaOf(loop: Loop): number {
  let area = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    area += loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
  }
  return area / 2;
}

function contains(loop: Loop, x: number, y: number): boolean {
  let inside = false;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    const crosses = loop[i + 1] > y !== loop[j + 1] > y;
    if (crosses && x < ((loop[j] - loop[i]) * (y - loop[i + 1])) / (loop[j + 1] - loop[i + 1]) + loop[i]) inside = !inside;
  }
  return inside;
}

function trace<P extends Path>(path: P, loop: Loop): P {
  path.moveTo(loop[0], loop[1]);
  for (let i = 2; i < loop.length; i += 2) path.lineTo(loop[i], loop[i + 1]);
  path.closePath();
  return path;
}
