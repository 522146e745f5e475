import { Color } from 'three';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import { Painted } from './painted';

const kSpacing = 0.06; // m between two points
const kJump = 1.5; // m: a larger step is a teleport, which starts a new trail
const kLengthMost = 200; // points
const kRobotsMost = 400;
const kWidth = 0.03; // m, half

interface Trail {
  row: number;
  length: number;
  points: number[]; // x, y, ...
  ticks: number[]; // tick of each point
}

/** Trails of robots: a fading ribbon on the floor. */
export class Trails {
  private readonly ribbon = new Painted('triangles', 1);
  private readonly trails: Trail[] = [];
  private readonly color = new Color();
  readonly object = this.ribbon.object;

  constructor(
    scene: Scene,
    private readonly replica: Replica,
    before: Trails | null = null,
  ) {
    const known = new Map(before?.trails.map((trail) => [before.replica.scene.models[trail.row].id, trail]));
    scene.models.forEach((model, row) => {
      if (model.parent >= 0 || model.kind !== 'position' || this.trails.length >= kRobotsMost) return;
      const { points, ticks } = known.get(model.id) ?? { points: [], ticks: [] };
      this.trails.push({ row, length: Math.min(Math.max(model.trail ?? 20, 20), kLengthMost), points, ticks });
    });
  }

  /** Records the positions; call once per packet. */
  record(): void {
    const { tick } = this.replica;
    for (const { row, length, points, ticks } of this.trails) {
      // After a rewind, drop the points of the future.
      while (ticks.length > 0 && ticks[ticks.length - 1] > tick) ticks.pop();
      points.length = 2 * ticks.length;
      const [x, y] = [this.replica.x[row] / 1000, this.replica.y[row] / 1000];
      const far = points.length === 0 ? Infinity : Math.hypot(x - points[points.length - 2], y - points[points.length - 1]);
      if (far < kSpacing) continue;
      if (far > kJump) points.length = ticks.length = 0;
      points.push(x, y);
      ticks.push(tick);
      if (ticks.length <= length) continue;
      points.shift();
      points.shift();
      ticks.shift();
    }
  }

  draw(): void {
    this.ribbon.begin();
    for (const { row, points } of this.trails) {
      this.color.setHex(this.replica.color[row] >>> 8);
      this.lay(points, [this.color.r, this.color.g, this.color.b]);
    }
    this.ribbon.end();
  }

  dispose(): void {
    this.ribbon.dispose();
  }

  /** A ribbon with shared edges (mitred), so that turns have no gaps. */
  private lay(points: number[], color: number[]): void {
    const count = points.length / 2;
    const z = 0.004;
    let [lx, ly, rx, ry] = [0, 0, 0, 0];
    for (let k = 0; k < count; ++k) {
      const [before, behind] = [Math.max(k - 1, 0) * 2, Math.min(k + 1, count - 1) * 2];
      const [dx, dy] = [points[behind] - points[before], points[behind + 1] - points[before + 1]];
      const half = kWidth / Math.max(Math.hypot(dx, dy), 1e-6);
      const [nlx, nly] = [points[2 * k] - dy * half, points[2 * k + 1] + dx * half];
      const [nrx, nry] = [points[2 * k] + dy * half, points[2 * k + 1] - dx * half];
      if (k > 0) {
        const alpha = (0.85 * k) / count;
        for (const [x, y] of [[lx, ly], [rx, ry], [nlx, nly], [nlx, nly], [rx, ry], [nrx, nry]]) this.ribbon.corner(x, y, z, color, alpha);
      }
      [lx, ly, rx, ry] = [nlx, nly, nrx, nry];
    }
  }
}
