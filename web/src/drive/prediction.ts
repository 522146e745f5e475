import { turn } from '../motion';
import { isStill, kStill, type Velocity } from './hands';
import type { Walker, Walking } from './walker';

const kStep = 0.01; // s, maximum integration step
const kSmooth = 0.12; // s: time constant of the decay of prediction errors
const kSnap = 1; // m: a larger error is a teleport, which is not smoothed
const kHorizonMost = 1; // s, maximum prediction ahead of the server
const kDrift = 0.1; // gain of the delay estimate per command
const kAgrees = 0.03; // m: below this distance the body moved as predicted
const kTraceMost = 300; // steps
const kToldMost = 200; // maximum of unacknowledged commands
const kLeast = 1e-9; // s

/** A pose in the plane. */
export interface Place {
  x: number;
  y: number;
  a: number;
}

/** The own body in a server update. */
export interface Shown extends Place {
  tick: number;
  z: number;
  /** Wall-clock seconds per tick; 0: time stands still. */
  tickSeconds: number;
}

/** A command: its local time, and the server tick it took effect in, once acknowledged. */
interface Told {
  input: number;
  velocity: Velocity;
  at: number; // s, local
  tick: number | null; // takes effect in the ticks after this one
}

/**
 * Client-side prediction with server reconciliation: commands move the body at once by the server's
 * kinematics. Each update includes the commands up to some number (acknowledged by the server);
 * later commands are replayed from there. The remaining difference to the drawn pose decays.
 */
export class Prediction {
  private told: Told[] = []; // the first is the newest command included in the last update
  private given = 0;
  private body: Walking | null = null;
  private time = 0; // s, local: of the body
  private z = 0;
  private before: Shown | null = null;
  private trace: (Walking & { time: number })[] = []; // where the body was, ascending
  private off: Place = { x: 0, y: 0, a: 0 }; // offset of the drawn pose from the body
  private faded = 0; // s, local: time of the last decay
  private anchor: { at: number; tick: number } | null = null; // a server tick and the local time of the command applied in it

  constructor(
    private readonly walker: Walker,
    private readonly interval: number, // s of simulated time per tick
  ) {}

  /** Applies a velocity command from now on. Returns its input number. */
  command(velocity: Velocity, now: number): number {
    this.advance(now);
    this.told.push({ input: ++this.given, velocity, at: now, tick: null });
    if (this.told.length > kToldMost) this.told.shift();
    return this.given;
  }

  /** Acknowledgement: a command takes effect in the ticks after this one. */
  counts(input: number, tick: number): void {
    for (const told of this.told) if (told.input <= input && told.tick === null) this.date(told, tick);
  }

  private date(told: Told, tick: number): void {
    told.tick = tick;
    const before = this.told[this.told.indexOf(told) - 1];
    const period = this.before?.tickSeconds ?? 0;
    const known = this.anchor ? this.anchor.at + (tick - this.anchor.tick) * period : told.at;
    // From standstill, take over the delay of this command; while walking, filter it, as jumps would be visible.
    const at = !before || isStill(before.velocity) ? told.at : known + kDrift * (told.at - known);
    this.anchor = { at, tick };
  }

  /** Reconciles with a server update. */
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

  /** Pose to draw now; null before the first update. */
  at(now: number): Place | null {
    if (!this.body) return null;
    this.advance(now);
    const left = Math.exp(-(now - this.faded) / kSmooth);
    this.off = { x: this.off.x * left, y: this.off.y * left, a: this.off.a * left };
    this.faded = now;
    const { x, y, a } = this.body;
    return { x: x + this.off.x, y: y + this.off.y, a: a + this.off.a };
  }

  /** Local time of the commands in a server update: between the newest one included and the next one. */
  private timeOf({ tick, tickSeconds }: Shown, now: number): number {
    if (tickSeconds <= 0) return now;
    const counts = this.told.length > 0 && this.told[0].tick !== null && this.told[0].tick < tick;
    const [counted, next] = counts ? this.told : [undefined, this.told[0]];
    const known = this.anchor ? this.anchor.at + (tick - this.anchor.tick) * tickSeconds : now;
    return Math.min(Math.max(known, counted?.at ?? -Infinity, now - kHorizonMost), next?.at ?? now, now);
  }

  /** World velocity [m/s]: the predicted one if the prediction agrees, else by difference to the previous update. */
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
    const rate = this.interval / before.tickSeconds; // simulated seconds per wall-clock second
    while (this.time < now - kLeast) {
      const [velocity, until] = this.wanted(this.time);
      const seconds = Math.min(kStep, now - this.time, until - this.time);
      this.walker.step(body, velocity, this.z, seconds * rate);
      this.time += seconds;
      this.trace.push({ ...body, time: this.time });
      if (this.trace.length > kTraceMost) this.trace.shift();
    }
  }

  /** The velocity command in effect at a time, and the time of the next command. */
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

  /** Time went backwards: discards all commands and the trace. */
  private forget(): void {
    this.told = [];
    this.trace = [];
    this.anchor = null;
    this.before = null;
  }
}
