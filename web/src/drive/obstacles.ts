import type { PhysicsSolid } from '../protocol/scene';

const kCell = 2; // m
const kSlop = 0.005; // m of tolerated penetration of a walker: poses are sent in whole millimetres

type Points = number[]; // x, y, x, y, ...

/** Static obstacle in plan view: a convex outline, or a single edge of a concave one. */
interface Obstacle {
  points: Points;
  z: [min: number, max: number];
}

/** Minimum translation out of an obstacle: unit vector and depth. */
export interface Push {
  x: number;
  y: number;
  depth: number; // m
}

/** Static obstacles in a uniform grid, for collision of a walker. */
export class Obstacles {
  private readonly cells = new Map<string, Obstacle[]>();

  constructor(solids: PhysicsSolid[]) {
    for (const solid of solids) for (const obstacle of obstaclesOf(solid)) this.add(obstacle);
  }

  /** The deepest penetration of a convex outline with this height range; null if it is free. */
  push(outline: Points, z: [min: number, max: number]): Push | null {
    let deepest: Push | null = null;
    const box = boxOf(outline);
    for (const obstacle of this.near(box)) {
      if (obstacle.z[0] >= z[1] || obstacle.z[1] <= z[0]) continue;
      const push = apart(outline, obstacle.points);
      if (push && push.depth > kSlop && push.depth > (deepest?.depth ?? 0)) deepest = push;
    }
    return deepest && { ...deepest, depth: deepest.depth - kSlop };
  }

  private add(obstacle: Obstacle): void {
    for (const key of cellsOf(boxOf(obstacle.points))) {
      const cell = this.cells.get(key);
      if (cell) cell.push(obstacle);
      else this.cells.set(key, [obstacle]);
    }
  }

  private near(box: Box): Set<Obstacle> {
    return new Set(cellsOf(box).flatMap((key) => this.cells.get(key) ?? []));
  }
}

function obstaclesOf(solid: PhysicsSolid): Obstacle[] {
  if ('corners' in solid) {
    const heights = solid.corners.filter((_, k) => k % 3 === 2);
    const flat = solid.corners.filter((_, k) => k % 3 !== 2);
    return [{ points: hullOf(flat), z: [Math.min(...heights), Math.max(...heights)] }];
  }
  const { loop, z } = solid;
  if (isConvex(loop)) return [{ points: loop, z }];
  return edges(loop).map((points) => ({ points, z }));
}

function edges(loop: Points): Points[] {
  return Array.from({ length: loop.length / 2 }, (_, k) => {
    const next = (2 * k + 2) % loop.length;
    return [loop[2 * k], loop[2 * k + 1], loop[next], loop[next + 1]];
  });
}

/** Whether the loop turns in one direction only, exactly once around. */
export function isConvex(loop: Points): boolean {
  let turned = 0;
  for (let i = 0, n = loop.length; i < n; i += 2) {
    const [ax, ay] = [loop[(i + 2) % n] - loop[i], loop[(i + 3) % n] - loop[i + 1]];
    const [bx, by] = [loop[(i + 4) % n] - loop[(i + 2) % n], loop[(i + 5) % n] - loop[(i + 3) % n]];
    const angle = Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
    if (angle < -1e-6) return false;
    turned += angle;
  }
  return turned < 2 * Math.PI + 0.1;
}

/** The convex hull, counter-clockwise (Andrew 1979). */
export function hullOf(points: Points): Points {
  const all = Array.from({ length: points.length / 2 }, (_, k) => [points[2 * k], points[2 * k + 1]]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (from: number[][]) => {
    const kept: number[][] = [];
    for (const p of from) {
      while (kept.length > 1 && cross(kept[kept.length - 2], kept[kept.length - 1], p) <= 0) kept.pop();
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  const hull = [...half(all), ...half(all.reverse())];
  return (hull.length > 0 ? hull : all.slice(0, 1)).flat();
}

function cross(o: number[], a: number[], b: number[]): number {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/** Minimum translation between two convex outlines, or outline and edge (separating axes); null: no overlap. */
function apart(mine: Points, other: Points): Push | null {
  let best: Push | null = null;
  for (const points of [mine, other]) {
    for (let i = 0, n = points.length; i < n; i += 2) {
      const [dx, dy] = [points[(i + 2) % n] - points[i], points[(i + 3) % n] - points[i + 1]];
      const length = Math.hypot(dx, dy);
      if (length < 1e-9) continue;
      const push = along(mine, other, dy / length, -dx / length);
      if (!push) return null;
      if (!best || push.depth < best.depth) best = push;
    }
  }
  return best;
}

function along(mine: Points, other: Points, x: number, y: number): Push | null {
  const [low, high] = spanOf(mine, x, y);
  const [from, to] = spanOf(other, x, y);
  if (high <= from || low >= to) return null;
  return high - from < to - low ? { x: -x, y: -y, depth: high - from } : { x, y, depth: to - low };
}

function spanOf(points: Points, x: number, y: number): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 2) {
    const at = points[i] * x + points[i + 1] * y;
    low = Math.min(low, at);
    high = Math.max(high, at);
  }
  return [low, high];
}

type Box = [x_min: number, y_min: number, x_max: number, y_max: number];

function boxOf(points: Points): Box {
  const [x_min, x_max] = spanOf(points, 1, 0);
  const [y_min, y_max] = spanOf(points, 0, 1);
  return [x_min, y_min, x_max, y_max];
}

function cellsOf([x_min, y_min, x_max, y_max]: Box): string[] {
  const keys: string[] = [];
  for (let x = Math.floor(x_min / kCell); x <= Math.floor(x_max / kCell); ++x)
    for (let y = Math.floor(y_min / kCell); y <= Math.floor(y_max / kCell); ++y) keys.push(`${x},${y}`);
  return keys;
}
