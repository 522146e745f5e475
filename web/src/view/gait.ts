const kSettle = 6; // 1/s
const kJump = 0.5; // m between two frames: a larger step is a teleport
const kStill = 0.02; // m/s
const kStillTurn = 0.05; // rad/s
const kTurnStep = 1.3; // rad of turning in place per two steps

/** Gait of a walker: stride phase and smoothed velocity, derived from the drawn poses. */
export class Gait {
  phase = 0; // rad; 2 pi per stride of two steps
  speed = 0; // m/s ahead, smoothed
  aside = 0; // m/s to the left, smoothed
  turning = 0; // rad/s to the left, smoothed
  age = 0; // s, phase of breathing

  constructor(
    private x: number,
    private y: number,
    private a: number,
  ) {}

  /** Updates from a new pose after `seconds`. False at rest. */
  walk(x: number, y: number, a: number, seconds: number): boolean {
    const [dx, dy] = [x - this.x, y - this.y];
    const turned = Math.atan2(Math.sin(a - this.a), Math.cos(a - this.a));
    [this.x, this.y, this.a] = [x, y, a];
    if (seconds <= 0) return false;
    const near = Math.hypot(dx, dy) < kJump;
    const ahead = near ? Math.cos(a) * dx + Math.sin(a) * dy : 0;
    const left = near ? Math.cos(a) * dy - Math.sin(a) * dx : 0;
    const t = 1 - Math.exp(-kSettle * seconds);
    this.age += seconds;
    this.speed += t * (ahead / seconds - this.speed);
    this.aside += t * (left / seconds - this.aside);
    this.turning += t * ((near ? turned / seconds : 0) - this.turning);
    const way = near ? Math.hypot(dx, dy) : 0;
    this.phase += 2 * Math.PI * (way / strideOf(this.pace) + (near ? ((1 - this.walking) * Math.abs(turned)) / kTurnStep : 0));
    return this.pace > kStill || Math.abs(this.turning) > kStillTurn;
  }

  /** Speed, in any direction. [m/s] */
  get pace(): number {
    return Math.hypot(this.speed, this.aside);
  }

  /** Weight of walking, 0 to 1. */
  get walking(): number {
    return smooth(this.pace / 0.4);
  }

  /** Weight of running, 0 to 1. */
  get running(): number {
    return smooth((this.pace - 1.5) / 0.6);
  }

  /** Weight of stepping in place, 0 to 1. */
  get stepping(): number {
    return (1 - this.walking) * smooth(Math.abs(this.turning) / 0.6);
  }
}

export function gaitOf(x: number, y: number, a = 0): Gait {
  return new Gait(x, y, a);
}

/** Stride length (two steps) of a person of 1.75 m at a speed. [m] */
export function strideOf(speed: number): number {
  return Math.min(0.5 + 0.55 * speed, 2.4);
}

export function smooth(t: number): number {
  const u = Math.min(Math.max(t, 0), 1);
  return u * u * (3 - 2 * u);
}
