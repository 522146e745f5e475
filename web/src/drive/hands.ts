/** Normalised command from keys, gamepad and touch stick: each component in [-1, 1], 1: full speed. */
export interface Hands {
  forward: number;
  sideways: number; // 1: left
  turn: number; // 1: left
}

/** In the robot's frame. */
export interface Velocity {
  forward: number; // m/s
  sideways: number; // m/s
  turn: number; // rad/s
}

export const kStill: Velocity = { forward: 0, sideways: 0, turn: 0 };

const kFull: Velocity = { forward: 0.6, sideways: 0.6, turn: 1.6 }; // robots clamp to their own limits
const kUnhurried = 0.5; // fraction of full speed, for keys without Shift
const kDeadZone = 0.15; // fraction of full deflection: sticks do not rest exactly at zero

const kKeys: Record<string, Partial<Hands>> = {
  w: { forward: 1 },
  arrowup: { forward: 1 },
  s: { forward: -1 },
  arrowdown: { forward: -1 },
  a: { turn: 1 },
  arrowleft: { turn: 1 },
  d: { turn: -1 },
  arrowright: { turn: -1 },
  q: { sideways: 1 },
  e: { sideways: -1 },
};

/** The pressed keys by physical position (KeyboardEvent.code), so that Shift in between does not lose a release. */
export class HeldKeys {
  private readonly held = new Map<string, Partial<Hands>>();

  press(code: string, key: string): void {
    const hands = kKeys[key.toLowerCase()];
    if (hands) this.held.set(code, hands);
  }

  release(code: string): void {
    this.held.delete(code);
  }

  clear(): void {
    this.held.clear();
  }

  hands(fast: boolean): Hands {
    const { forward, sideways, turn } = sum([...this.held.values()]);
    const scale = fast ? 1 : kUnhurried;
    return { forward: forward * scale, sideways: sideways * scale, turn: turn * scale };
  }
}

/** Left stick: drive and turn; right stick: sideways. */
export function handsOfAxes(axes: readonly number[]): Hands {
  const [x, y] = pastDeadZone(axes[0] ?? 0, axes[1] ?? 0);
  const [side] = pastDeadZone(axes[2] ?? 0, 0);
  return { forward: 0 - y, sideways: 0 - side, turn: 0 - x };
}

/** Radial dead zone: zero inside, rescaled to [0, 1] outside. */
export function pastDeadZone(x: number, y: number): [number, number] {
  const way = Math.hypot(x, y);
  if (!(way > kDeadZone)) return [0, 0];
  const scale = Math.min((way - kDeadZone) / (1 - kDeadZone), 1) / way;
  return [x * scale, y * scale];
}

/** Sum of several commands, clamped to [-1, 1]. */
export function sum(all: Partial<Hands>[]): Hands {
  const total = (part: keyof Hands) => Math.min(Math.max(all.reduce((so_far, hands) => so_far + (hands[part] ?? 0), 0), -1), 1);
  return { forward: total('forward'), sideways: total('sideways'), turn: total('turn') };
}

/** Velocity, rounded to 1 mm/s and 1 mrad/s. */
export function velocityOf(hands: Hands): Velocity {
  const round = (value: number) => Math.round(value * 1000) / 1000 + 0;
  return { forward: round(hands.forward * kFull.forward), sideways: round(hands.sideways * kFull.sideways), turn: round(hands.turn * kFull.turn) };
}

export function isStill(velocity: Velocity): boolean {
  return velocity.forward === 0 && velocity.sideways === 0 && velocity.turn === 0;
}
