import { Vector3, type Quaternion } from 'three';
import { orientationOf, standingOf, type Standing } from './orientation';
import { radiansOf, type Replica } from './protocol/replica';
import { parentsFirst, type Scene } from './protocol/scene';

const kJump = 1.0; // m: larger steps between two packets are teleports, not interpolated
const kParts = 6; // components per pose
const kPeriodMs = { least: 16, most: 250 };

/**
 * Interpolation of drawn poses between the last two packets, so that a world at 10 ticks/s moves
 * smoothly. World poses of all models, in metres and radians, and orientations of tilted ones.
 */
export class Motion {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly z: Float64Array;
  readonly a: Float64Array;
  /** By row, in the world frame; models not listed are upright. */
  readonly tilted = new Map<number, Quaternion>();

  // Poses in the parent's frame: start and end of the interpolation. Interleaved x, y, z, a, tilt x, tilt y.
  private readonly from: Float64Array;
  private readonly to: Float64Array;
  private readonly parent: Int32Array;
  private readonly order: Int32Array; // rows, parents first
  private since = 0;
  private periodMs = 100;
  private lastTick = -1;
  private settled = false;
  private led: { row: number; x: number; y: number; a: number } | null = null;
  private held: { row: number; x: number; y: number; a: number; until: number } | null = null;

  /** `before`: motion of the previous population of the same world; models in both keep their motion. */
  constructor(
    scene: Scene,
    private readonly replica: Replica,
    before: Motion | null = null,
  ) {
    const count = scene.models.length;
    this.x = new Float64Array(count);
    this.y = new Float64Array(count);
    this.z = new Float64Array(count);
    this.a = new Float64Array(count);
    this.from = new Float64Array(count * kParts);
    this.to = new Float64Array(count * kParts);
    this.parent = Int32Array.from(scene.models, (model) => model.parent);
    this.order = parentsFirst(scene);
    this.readTargets();
    this.from.set(this.to);
    if (before) this.goOnFrom(before);
    this.update(before ? performance.now() : 0);
  }

  private goOnFrom(before: Motion): void {
    const { since, periodMs, lastTick } = before;
    Object.assign(this, { since, periodMs, lastTick });
    for (const [id, row] of this.replica.rows) {
      const was = before.replica.rows.get(id);
      if (was === undefined || before.replica.scene.models[was].parentId !== this.replica.scene.models[row].parentId) continue;
      for (let k = 0; k < kParts; ++k) this.from[row * kParts + k] = before.from[was * kParts + k];
    }
    const held = before.held;
    const row = held && this.replica.rows.get(before.replica.scene.models[held.row].id);
    if (held && typeof row === 'number') this.held = { ...held, row };
  }

  /** A packet was applied to the replica. */
  aim(now: number): void {
    const drawn = this.fraction(now);
    for (let i = 0; i < this.from.length; i += kParts) this.advance(i, drawn);
    const wentBack = this.replica.tick < this.lastTick;
    if (this.replica.tick !== this.lastTick) {
      const passed = Math.min(Math.max(now - this.since, kPeriodMs.least), kPeriodMs.most);
      this.periodMs += 0.2 * (passed - this.periodMs);
      this.lastTick = this.replica.tick;
    }
    this.since = now;
    this.readTargets();
    if (wentBack) this.from.set(this.to);
    for (let i = 0; i < this.from.length; i += kParts) this.dropJump(i);
    this.settled = false;
  }

  /** Draws a dragged model at the pointer until the server's answer is due. */
  hold(row: number, x: number, y: number, a: number, now: number): void {
    this.held = { row, x, y, a, until: now + 400 };
    this.settled = false;
  }

  /** Overrides the drawn pose of one model; null: poses from packets only. */
  lead(led: { row: number; x: number; y: number; a: number } | null): void {
    const { led: before } = this;
    const same = led?.row === before?.row && led?.x === before?.x && led?.y === before?.y && led?.a === before?.a;
    this.led = led;
    if (!same) this.settled = false;
  }

  /** Poses at this time; false if nothing has moved since the last call. */
  update(now: number): boolean {
    if (this.settled) return false;
    const t = this.fraction(now);
    if (this.held && now > this.held.until) this.held = null;
    for (const row of this.order) {
      const { from, to } = this;
      const i = row * kParts;
      let [x, y] = [from[i] + t * (to[i] - from[i]), from[i + 1] + t * (to[i + 1] - from[i + 1])];
      const upright = this.isUpright(i) && !this.tilted.has(this.parent[row]);
      const standing = upright ? null : this.standing(i, t);
      let a = standing ? standing.a : from[i + 3] + t * turn(from[i + 3], to[i + 3]);
      if (this.led?.row === row) ({ x, y, a } = this.led);
      if (this.held?.row === row) ({ x, y, a } = this.held);
      if (standing) {
        this.placeTilted(row, x, y, to[i + 2], { ...standing, a });
      } else {
        if (this.tilted.size > 0) this.tilted.delete(row);
        this.place(row, x, y, to[i + 2], a);
      }
    }
    this.settled = t >= 1 && !this.held;
    return true;
  }

  private place(row: number, x: number, y: number, z: number, a: number): void {
    const parent = this.parent[row];
    if (parent < 0) {
      this.x[row] = x;
      this.y[row] = y;
      this.z[row] = z;
      this.a[row] = a;
      return;
    }
    const c = Math.cos(this.a[parent]);
    const s = Math.sin(this.a[parent]);
    this.x[row] = this.x[parent] + c * x - s * y;
    this.y[row] = this.y[parent] + s * x + c * y;
    this.z[row] = this.z[parent] + z;
    this.a[row] = this.a[parent] + a;
  }

  private placeTilted(row: number, x: number, y: number, z: number, standing: Standing): void {
    const parent = this.parent[row];
    const place = new Vector3(x, y, z);
    const turned = orientationOf(standing);
    if (parent >= 0) {
      const around = this.tilted.get(parent) ?? orientationOf({ a: this.a[parent], tiltX: 0, tiltY: 0 });
      place.applyQuaternion(around).add(new Vector3(this.x[parent], this.y[parent], this.z[parent]));
      turned.premultiply(around);
    }
    [this.x[row], this.y[row], this.z[row], this.a[row]] = [place.x, place.y, place.z, standingOf(turned).a];
    this.tilted.set(row, turned);
  }

  private isUpright(i: number): boolean {
    const { from, to } = this;
    return from[i + 4] === 0 && from[i + 5] === 0 && to[i + 4] === 0 && to[i + 5] === 0;
  }

  /** How a model stands in its parent after a part of its way. */
  private standing(i: number, t: number): Standing {
    const { from, to } = this;
    const at = (list: Float64Array): Standing => ({ a: list[i + 3], tiltX: list[i + 4], tiltY: list[i + 5] });
    return t >= 1 ? at(to) : standingOf(orientationOf(at(from)).slerp(orientationOf(at(to)), t));
  }

  private fraction(now: number): number {
    return Math.min(Math.max((now - this.since) / this.periodMs, 0), 1);
  }

  private advance(i: number, t: number): void {
    const { from, to } = this;
    from[i] += t * (to[i] - from[i]);
    from[i + 1] += t * (to[i + 1] - from[i + 1]);
    if (this.isUpright(i)) {
      from[i + 3] += t * turn(from[i + 3], to[i + 3]);
    } else {
      const { a, tiltX, tiltY } = this.standing(i, t);
      [from[i + 3], from[i + 4], from[i + 5]] = [a, tiltX, tiltY];
    }
  }

  private dropJump(i: number): void {
    const { from, to } = this;
    if (Math.abs(to[i] - from[i]) < kJump && Math.abs(to[i + 1] - from[i + 1]) < kJump) return;
    for (let k = 0; k < kParts; ++k) from[i + k] = to[i + k];
  }

  private readTargets(): void {
    const { replica, to } = this;
    for (let row = 0, i = 0; row < this.x.length; ++row, i += kParts) {
      to[i] = replica.x[row] / 1000;
      to[i + 1] = replica.y[row] / 1000;
      to[i + 2] = replica.z[row] / 1000;
      to[i + 3] = radiansOf(replica.a[row]);
      to[i + 4] = radiansOf(replica.tiltX[row]);
      to[i + 5] = radiansOf(replica.tiltY[row]);
    }
  }
}

/** Signed difference of two angles, in [-pi, pi]. */
export function turn(from: number, to: number): number {
  const turns = (to - from) / (2 * Math.PI);
  return (turns - Math.round(turns)) * 2 * Math.PI;
}
