import { Color } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import { Painted } from './painted';

const kSpacing = 0.06; // m between two points
const kJump = 1.5; // m: a longer step starts a new trail
const kLengthMost = 200; // points
const kRobotsMost = 400;
const kWidth = 0.025; // m

interface Trail {
  row: number;
  length: number;
  points: number[]; // x, y, ...
}

/** Where robots have been: a ribbon on the floor that fades. */
export class Trails {
  private readonly ribbon = new Painted('triangles', 1);
  private readonly trails: Trail[] = [];
  private readonly color = new Color();
  readonly object = this.ribbon.object;

  constructor(
    scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
  ) {
    scene.models.forEach((model, row) => {
      if (model.parent >= 0 || model.kind !== 'position' || this.trails.length >= kRobotsMost) return;
      this.trails.push({ row, length: Math.min(Math.max(model.trail ?? 20, 20), kLengthMost), points: [] });
    });
  }

  /** Takes down where everyone is; call once per drawn frame with motion. */
  record(): void {
    for (const { row, length, points } of this.trails) {
      const [x, y] = [this.motion.x[row], this.motion.y[row]];
      const far = points.length === 0 ? Infinity : Math.hypot(x - points[points.length - 2], y - points[points.length - 1]);
      if (far < kSpacing) continue;
      if (far > kJump) points.length = 0;
      points.push(x, y);
      if (points.length > length * 2) points.splice(0, points.length - length * 2);
    }
  }

  draw(): void {
    this.ribbon.begin();
    for (const { row, points } of this.trails) {
      this.color.setHex(this.replica.color[row] >>> 8);
      const color = [this.color.r, this.color.g, this.color.b];
      const count = points.length / 2;
      for (let k = 1; k < count; ++k) this.segment(points, k, color, k / count);
      if (count > 0) this.segment([...points.slice(-2), this.motion.x[row], this.motion.y[row]], 1, color, 1);
    }
    this.ribbon.end();
  }

  dispose(): void {
    this.ribbon.dispose();
  }

  private segment(points: number[], k: number, color: number[], age: number): void {
    const [ax, ay, bx, by] = points.slice(2 * k - 2, 2 * k + 2);
    const length = Math.hypot(bx - ax, by - ay);
    if (length < 1e-6) return;
    const nx = ((by - ay) / length) * kWidth;
    const ny = (-(bx - ax) / length) * kWidth;
    const alpha = 0.75 * age * age;
    const z = 0.004;
    for (const [x, y] of [[ax + nx, ay + ny], [ax - nx, ay - ny], [bx + nx, by + ny], [bx + nx, by + ny], [ax - nx, ay - ny], [bx - nx, by - ny]]) {
      this.ribbon.corner(x, y, z, color, alpha);
    }
  }
}
