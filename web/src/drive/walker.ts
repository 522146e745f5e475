import type { Velocity } from './hands';
import { hullOf, type Obstacles } from './obstacles';
import type { PhysicsSolid } from '../protocol/scene';

/** Walking limits of a body, sent by the server on join. */
export interface Walk {
  engine: string;
  ahead: [min: number, max: number]; // m/s
  aside: [min: number, max: number]; // m/s, left
  turn: [min: number, max: number]; // rad/s
}

/** Pose and velocity of a body in the world frame. */
export interface Walking {
  x: number;
  y: number;
  a: number; // rad
  vx: number; // m/s
  vy: number;
}

const kGrip = 9.81; // m/s², maximum acceleration: friction of shoes on concrete (playhouse/arena/body_plan.cc, kShoe)
const kRub = 0.36; // friction of body and wall, both of default material (playhouse/arena/surface.cc)
const kPushes = 3; // collision iterations per step

/**
 * The engines' kinematics of walking, for client-side prediction. Arena: friction bounds
 * acceleration, and bodies slide along walls. Stage: bodies respond at once and stop on collision.
 */
export class Walker {
  private outline: number[] = []; // convex, in the body's frame; empty: unknown
  private height: [number, number] = [0, 0]; // of the outline, above the body's ground
  private obstacles: Obstacles | null = null;

  constructor(private readonly walk: Walk) {}

  /** Sets the collision shape of the body, and the static obstacles. */
  meet(body: PhysicsSolid[], obstacles: Obstacles): void {
    const points = body.flatMap((solid) => ('loop' in solid ? solid.loop : solid.corners.filter((_, k) => k % 3 !== 2)));
    const heights = body.flatMap((solid) => ('z' in solid ? solid.z : solid.corners.filter((_, k) => k % 3 === 2)));
    this.outline = hullOf(points);
    this.height = [Math.min(...heights), Math.max(...heights)];
    this.obstacles = obstacles;
  }

  /** One step at a wanted velocity in the body's frame; z: height of the ground under the body. */
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

  /** Resolves penetrations: removes the normal velocity, and reduces the tangential one by friction. */
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
