import { Color, Group } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import { Painted } from './painted';

const kRing = 20; // corners
const kInk = new Color(0xe08a00);

/** What fiducial finders see: a line to each marker, a ring where it stands and a tick for its heading. */
export class Sightings {
  readonly group = new Group();
  private readonly lines = new Painted('lines', 4);

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
  ) {
    this.group.add(this.lines.object);
  }

  draw(): void {
    this.lines.begin();
    const color = [kInk.r, kInk.g, kInk.b];
    for (const [row, hits] of this.replica.views('fiducial')) {
      const [x, y, a] = [this.motion.x[row], this.motion.y[row], this.motion.a[row]];
      for (const hit of hits) {
        const tx = x + Math.cos(a + hit.bearing) * hit.range;
        const ty = y + Math.sin(a + hit.bearing) * hit.range;
        const size = this.scene.models[this.replica.rows.get(hit.target) ?? -1]?.size ?? [0.2, 0.2, 0.2];
        const radius = Math.max(Math.hypot(size[0], size[1]) * 0.6, 0.12);
        const z = Math.max(this.motion.z[row], 0.02);
        this.line(x, y, tx, ty, z, color, 0.55);
        this.ring(tx, ty, z, radius, color);
        const heading = a + hit.heading;
        this.line(tx, ty, tx + Math.cos(heading) * radius * 1.5, ty + Math.sin(heading) * radius * 1.5, z, color, 1);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }

  private ring(x: number, y: number, z: number, radius: number, color: number[]): void {
    for (let k = 0; k < kRing; ++k) {
      const a = (k / kRing) * 2 * Math.PI;
      const b = ((k + 1) / kRing) * 2 * Math.PI;
      this.line(x + Math.cos(a) * radius, y + Math.sin(a) * radius, x + Math.cos(b) * radius, y + Math.sin(b) * radius, z, color, 0.9);
    }
  }

  private line(ax: number, ay: number, bx: number, by: number, z: number, color: number[], alpha: number): void {
    this.lines.corner(ax, ay, z, color, alpha);
    this.lines.corner(bx, by, z, color, alpha);
  }
}
