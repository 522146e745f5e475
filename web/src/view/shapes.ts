import { ExtrudeGeometry, Path, Shape, type BufferGeometry } from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import type { Solid } from '../protocol/scene';

type Loop = number[]; // x, y, x, y, ...

/** A shape of the scene as one geometry in the body's frame; null when it encloses nothing. */
export function geometryOf(solids: Solid[]): BufferGeometry | null {
  const parts: BufferGeometry[] = [];
  for (const solid of solids) {
    const outlines = outlinesOf(solid.loops);
    if (outlines.length === 0) continue;
    const depth = Math.max(solid.z[1] - solid.z[0], 1e-3);
    const part = new ExtrudeGeometry(outlines, { depth, bevelEnabled: false });
    parts.push(part.translate(0, 0, solid.z[0]));
  }
  return parts.length === 0 ? null : mergeGeometries(parts);
}

/** Highest point above the body's frame. */
export function heightOf(solids: Solid[]): number {
  return solids.reduce((height, solid) => Math.max(height, solid.z[1]), 0);
}

/** Loops sorted into outlines with their holes: a loop inside an odd number of others is a hole of the smallest. */
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
