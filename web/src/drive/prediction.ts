import { turn } from '../motion';
import { isStill, kStill, type Velocity } from './hands';
import type { Walker, Walking } from './walker';

const kStep = 0.01; // s, the longest
const kSmooth = 0.12; // s in which an error of the prediction is drawn a third as large
const kSnap = 1; // m: a larger one is no error, the body was put elsewhere
const kHorizonMost = 1; // s that is predicted ahead of the program
const kDrift = 0.1; // of what a further command tells of the delay
const kAgrees = 0.03; // m: nearer to what was predicted than that, the body moved as predicted
const kTraceMost = 300; // steps
const kToldMost = 200; // commands, where the program never says that they count
const kLeast = 1e-9; // s

/** A pose in the plane. */
export interface Place {
  x: number;
  y: number;
  a: number;
}

/** The own body as the program shows it in some tick. */
export interface Shown extends Place {
  tick: number;
  z: number;
  /** Local seconds that a tick takes; 0: time stands still. */
  tickSeconds: number;
}

/** What the body was told, and when: here, and in ticks of the program once that has said so. */
interface Told {
  input: number;
  velocity: Velocity;
  at: number; // s, local
  tick: number | null; // it counts in the ticks after this one
}

/**
 * The own body before the program shows it: commands move it at once by the same kinematics. Each pose that comes is where
 * commands up to some number had brought it (the program tells which), and what was told since is carried out again
 * from there. Where that comes out otherwise than drawn, the difference fades.
 */
export class Prediction {
  private told: Told[] = []; // the first is the newest that counts in what was shown last
  private given = 0;
  private body: Walking | null = null;
  private time = 0; // s, local: of the body
  private z = 0;
  private before: Shown | null = null;
  private trace: (Walking & { time: number })[] = []; // where the body was, ascending
  private off: Place = { x: 0, y: 0, a: 0 }; // drawn so far from the body
  private faded = 0; // s, local
  private anchor: { at: number; tick: number } | null = null; // what the program did in this tick was told then

  constructor(
    private readonly walker: Walker,
    private readonly interval: number, // s of the program, a tick
  ) {}

  /** The body is told to move so from now on. Returns the command's number. */
  command(velocity: Velocity, now: number): number {
    this.advance(now);
    this.told.push({ input: ++this.given, velocity, at: now, tick: null });
    if (this.told.length > kToldMost) this.told.shift();
    return this.given;
  }

  /** The program tells that a command counts in the ticks after this one. */
  counts(input: number, tick: number): void {
    for (const told of this.told) if (told.input <= input && told.tick === null) this.date(told, tick);
  }

  private date(told: Told, tick: number): void {
    told.tick = tick;
    const before = this.told[this.told.indexOf(told) - 1];
    const period = this.before?.tickSeconds ?? 0;
    const known = this.anchor ? this.anchor.at + (tick - this.anchor.tick) * period : told.at;
    // From a stand the delay is what this command had; while it walks, sudden changes would be seen.
    const at = !before || isStill(before.velocity) ? told.at : known + kDrift * (told.at - known);
    this.anchor = { at, tick };
  }

  /** What the program shows. */
  correct(shown: Shown, now: number): void {
    const drawn = this.at(now);
    if (this.before && shown.tick < this.before.tick) this.forget();
    const counted = this.told.findLastIndex(({ tick }) => tick !== null && tick < shown.tick);
    if (counted > 0) this.told.splice(0, counted);
    this.z = shown.z;
    this.time = this.timeOf(shown, now);
    const [vx, vy] = this.velocityOf(shown);
    this.body = { x: shown.x, y: shown.y, a: shown.a, vx, vy };
    this.before = shown;
    while (this.trace.length > 0 && this.trace[this.trace.length - 1].time > this.time) this.trace.pop();
    this.advance(now);
    this.fade(drawn, now);
  }

  /** Where to draw the body now; null until it was shown. */
  at(now: number): Place | null {
    if (!this.body) return null;
    this.advance(now);
    const left = Math.exp(-(now - this.faded) / kSmooth);
    this.off = { x: this.off.x * left, y: this.off.y * left, a: this.off.a * left };
    this.faded = now;
    const { x, y, a } = this.body;
    return { x: x + this.off.x, y: y + this.off.y, a: a + this.off.a };
  }

  /** When what the program shows was told here: between the newest command that counts in it and the next. */
  private timeOf({ tick, tickSeconds }: Shown, now: number): number {
    if (tickSeconds <= 0) return now;
    const counts = this.told.length > 0 && this.told[0].tick !== null && this.told[0].tick < tick;
    const [counted, next] = counts ? this.told : [undefined, this.told[0]];
    const known = this.anchor ? this.anchor.at + (tick - this.anchor.tick) * tickSeconds : now;
    return Math.min(Math.max(known, counted?.at ?? -Infinity, now - kHorizonMost), next?.at ?? now, now);
  }

  /** How it moves: as predicted for then where it is there, else as it moved from the tick shown before. [m/s] */
  private velocityOf(shown: Shown): [number, number] {
    const then = this.trace.findLast(({ time }) => time <= this.time + kLeast);
    if (then && Math.hypot(then.x - shown.x, then.y - shown.y) < kAgrees) return [then.vx, then.vy];
    const seconds = this.before ? (shown.tick - this.before.tick) * this.interval : 0;
    if (seconds <= 0) return this.body ? [this.body.vx, this.body.vy] : [0, 0];
    const [dx, dy] = [shown.x - this.before!.x, shown.y - this.before!.y];
    return Math.hypot(dx, dy) > kSnap ? [0, 0] : [dx / seconds, dy / seconds];
  }

  private advance(now: number): void {
    const { body, before } = this;
    if (!body || !before) return;
    if (before.tickSeconds <= 0 || now - this.time > 2 * kHorizonMost) this.time = now;
    const rate = this.interval / before.tickSeconds; // of the program's time
    while (this.time < now - kLeast) {
      const [velocity, until] = this.wanted(this.time);
      const seconds = Math.min(kStep, now - this.time, until - this.time);
      this.walker.step(body, velocity, this.z, seconds * rate);
      this.time += seconds;
      this.trace.push({ ...body, time: this.time });
      if (this.trace.length > kTraceMost) this.trace.shift();
    }
  }

  /** What counts at a moment, and until when. */
  private wanted(time: number): [Velocity, number] {
    const k = this.told.findLastIndex(({ at }) => at <= time + kLeast);
    return [this.told[k]?.velocity ?? kStill, this.told[k + 1]?.at ?? Infinity];
  }

  private fade(drawn: Place | null, now: number): void {
    this.faded = now;
    const { body } = this;
    if (!body || !drawn) return;
    this.off = { x: drawn.x - body.x, y: drawn.y - body.y, a: turn(body.a, drawn.a) };
    if (Math.hypot(this.off.x, this.off.y) > kSnap) this.off = { x: 0, y: 0, a: 0 };
  }

  /** Time went back: nothing that was told counts any more. */
  private forget(): void {
    this.told = [];
    this.trace = [];
    this.anchor = null;
    this.before = null;
  }
}
