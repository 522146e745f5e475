import type { Velocity } from './hands';
import { hullOf, type Obstacles } from './obstacles';
import type { PhysicsSolid } from '../protocol/scene';

/** How a body walks, as the program says when somebody joins. */
export interface Walk {
  engine: string;
  ahead: [min: number, max: number]; // m/s
  aside: [min: number, max: number]; // m/s, left
  turn: [min: number, max: number]; // rad/s
}

/** Where a body is and how it moves, in the world. */
export interface Walking {
  x: number;
  y: number;
  a: number; // rad
  vx: number; // m/s
  vy: number;
}

const kGrip = 9.81; // m/s², what friction of feet on concrete gives (playhouse/arena/body_plan.cc, kShoe)
const kRub = 0.36; // friction of a body along a wall, both of no stated material (playhouse/arena/surface.cc)
const kPushes = 3; // out of obstacles that touch each other, a step

/**
 * The kinematics by which engines move who walks, for a page that shows its own body before the program does. The arena's
 * friction bounds how fast the velocity changes, and bodies slide along walls; in the stage engine they obey at once and stop.
 */
export class Walker {
  private outline: number[] = []; // convex, in the body's frame; nothing: it is not known yet
  private height: [number, number] = [0, 0]; // of the outline, above the body's ground
  private obstacles: Obstacles | null = null;

  constructor(private readonly walk: Walk) {}

  /** What physics takes the body and what stands still for. */
  meet(body: PhysicsSolid[], obstacles: Obstacles): void {
    const points = body.flatMap((solid) => ('loop' in solid ? solid.loop : solid.corners.filter((_, k) => k % 3 !== 2)));
    const heights = body.flatMap((solid) => ('z' in solid ? solid.z : solid.corners.filter((_, k) => k % 3 === 2)));
    this.outline = hullOf(points);
    this.height = [Math.min(...heights), Math.max(...heights)];
    this.obstacles = obstacles;
  }

  /** On by a short time at a wanted velocity in the body's frame; z is the ground that it stands on. */
  step(body: Walking, wanted: Velocity, z: number, seconds: number): void {
    const { walk } = this;
    const [ahead, left] = [within(wanted.forward, walk.ahead), within(wanted.sideways, walk.aside)];
    const [c, s] = [Math.cos(body.a), Math.sin(body.a)];
    this.accelerate(body, c * ahead - s * left, s * ahead + c * left, seconds);
    const before = { ...body };
    body.x += body.vx * seconds;
    body.y += body.vy * seconds;
    body.a += within(wanted.turn, walk.turn) * seconds;
    if (this.outline.length < 6 || !this.obstacles) return;
    if (this.slides) this.slide(body, z);
    else if (this.pushOf(body, z) && !this.pushOf(before, z)) Object.assign(body, before, { vx: 0, vy: 0 });
  }

  private get slides(): boolean {
    return this.walk.engine === 'arena';
  }

  private accelerate(body: Walking, vx: number, vy: number, seconds: number): void {
    const [dx, dy] = [vx - body.vx, vy - body.vy];
    const change = Math.hypot(dx, dy);
    const share = this.slides && change > kGrip * seconds ? (kGrip * seconds) / change : 1;
    body.vx += share * dx;
    body.vy += share * dy;
  }

  /** Out of what it has walked into; what of its motion went there is lost, and some of the rest by friction. */
  private slide(body: Walking, z: number): void {
    for (let k = 0; k < kPushes; ++k) {
      const push = this.pushOf(body, z);
      if (!push) return;
      body.x += push.depth * push.x;
      body.y += push.depth * push.y;
      const into = -(body.vx * push.x + body.vy * push.y);
      if (into <= 0) continue;
      body.vx += into * push.x;
      body.vy += into * push.y;
      const speed = Math.hypot(body.vx, body.vy);
      const left = speed > 0 ? Math.max(0, 1 - (kRub * into) / speed) : 0;
      body.vx *= left;
      body.vy *= left;
    }
  }

  private pushOf({ x, y, a }: Walking, z: number) {
    const [c, s] = [Math.cos(a), Math.sin(a)];
    const outline = this.outline.map((_, i, p) => (i % 2 === 0 ? x + c * p[i] - s * p[i + 1] : y + s * p[i - 1] + c * p[i]));
    return this.obstacles!.push(outline, [z + this.height[0], z + this.height[1]]);
  }
}

function within(value: number, [least, most]: [number, number]): number {
  return Math.min(Math.max(value, least), most);
}
