import { ByteReader } from './byte_reader';
import { kBits, kViews, type Code, type ViewFormat, type Views } from './generated/views';
import { rowsOf, type Scene, type Sensor } from './scene';

export const kSubscribed = kBits.subscribed;
export const kStalled = kBits.position.stalled;
export const kMotorOn = kBits.position.motor_on;

export interface SensorPlace {
  model: number; // row
  sensor: Sensor;
}

/** Points, lines or triangles of one color that somebody has drawn, in the frame of their model. */
export interface DrawnRun {
  corners: 1 | 2 | 3; // of each shape
  flat: boolean; // on the floor of the frame, where the newest shape covers older ones
  color: number; // 0xRRGGBBAA
  points: Float32Array; // m: x, y, z of each corner
}

const kColumns = ['x', 'y', 'z', 'a', 'state', 'color', 'flags', 'tiltX', 'tiltY'] as const;
const kEnd = 0;
const kFresh = 1;
const kGone = 2;

/** [1/65536 turn] to [rad] in (-pi, pi]. */
export function radiansOf(turn: number): number {
  return ((turn > 32768 ? turn - 65536 : turn) / 65536) * 2 * Math.PI;
}

/** This viewer's replica of the world: the baseline that delta packets update. Mirrors delta.h. */
export class Replica {
  tick = 0;
  frame = 0;
  paused = false;
  rowsWait = false;
  beamsFull = false;
  speed = 1;
  realTimeFactor = 0;

  // Per model, in the parent's frame: mm, mm, mm, 1/65536 turn; state bits; 0xRRGGBBAA; flags carried; tilt in 1/65536 turn.
  readonly x: Int32Array;
  readonly y: Int32Array;
  readonly z: Int32Array;
  readonly a: Uint16Array;
  readonly state: Uint8Array;
  readonly color: Uint32Array;
  readonly flags: Uint32Array;
  readonly tiltX: Uint16Array;
  readonly tiltY: Uint16Array;

  /** By model row: its current text; silent models are absent. */
  readonly says = new Map<number, string>();
  /** By model row: what clients have drawn in its frame; a new object whenever it differs. */
  readonly drawings = new Map<number, DrawnRun[]>();
  /** By sensor row: ranges as fractions of the sensor's range_max, times 65535. */
  readonly scans = new Map<number, Uint16Array>();
  /** Pose of each sensor row. */
  readonly sensors: SensorPlace[] = [];
  /** First sensor row of each model with sensors. */
  readonly firstSensor = new Map<number, number>();
  /** Model rows by id. */
  readonly rows: Map<number, number>;

  /** View data per kind, by model row. */
  private readonly viewed = kViews.map(() => new Map<number, unknown>());

  constructor(readonly scene: Scene) {
    const count = scene.models.length;
    this.x = new Int32Array(count);
    this.y = new Int32Array(count);
    this.z = new Int32Array(count);
    this.a = new Uint16Array(count);
    this.state = new Uint8Array(count);
    this.color = new Uint32Array(count);
    this.flags = new Uint32Array(count);
    this.tiltX = new Uint16Array(count);
    this.tiltY = new Uint16Array(count);
    this.rows = rowsOf(scene.models);
    scene.models.forEach((model, row) => {
      [this.x[row], this.y[row], this.z[row], this.a[row], this.state[row], this.color[row], this.flags[row]] = model.start;
      [this.tiltX[row], this.tiltY[row]] = model.tilt ?? [0, 0];
      if (!model.sensors) return;
      this.firstSensor.set(row, this.sensors.length);
      for (const sensor of model.sensors) this.sensors.push({ model: row, sensor });
    });
  }

  /** Carries the replica over to another population: models in `came` start from the scene's initial state. */
  followedBy(scene: Scene, came: Set<number>): Replica {
    const next = new Replica(scene);
    const { tick, frame, paused, rowsWait, beamsFull, speed, realTimeFactor } = this;
    Object.assign(next, { tick, frame, paused, rowsWait, beamsFull, speed, realTimeFactor });
    this.scene.models.forEach(({ id }, before) => {
      const row = next.rows.get(id);
      if (row === undefined || came.has(id)) return;
      for (const column of kColumns) next[column][row] = this[column][before];
      if (this.says.has(before)) next.says.set(row, this.says.get(before)!);
      if (this.drawings.has(before)) next.drawings.set(row, this.drawings.get(before)!);
      this.viewed.forEach((held, view) => held.has(before) && next.viewed[view].set(row, held.get(before)));
      const first = this.firstSensor.get(before);
      if (first === undefined) return;
      for (let nth = 0; nth < this.scene.models[before].sensors!.length; ++nth) {
        const beams = this.scans.get(first + nth);
        if (beams) next.scans.set(next.firstSensor.get(row)! + nth, beams);
      }
    });
    return next;
  }

  /** View data of one kind, by model row. */
  views<K extends keyof Views>(kind: K): ReadonlyMap<number, Views[K]> {
    return this.viewed[kViews.findIndex((view) => view.kind === kind)] as Map<number, Views[K]>;
  }

  /** Applies a packet. Throws if it is malformed; the replica is then invalid. */
  apply(packet: ArrayBuffer): void {
    const bytes = new ByteReader(packet);
    if (bytes.u8() !== 4) throw new Error('not a packet of this program');
    const flags = bytes.u8();
    this.paused = (flags & 1) !== 0;
    this.rowsWait = (flags & 2) !== 0;
    this.beamsFull = (flags & 4) !== 0;
    this.frame = bytes.varint();
    this.tick = bytes.varint();
    this.speed = bytes.f32();
    this.realTimeFactor = bytes.f32();
    this.section(bytes, (mask, row) => this.readModel(bytes, mask, row));
    this.section(bytes, (tag, row) => this.readText(bytes, tag, row));
    this.section(bytes, (tag, row) => this.readScan(bytes, tag, row));
    this.section(bytes, (tag, row) => this.readView(bytes, tag, row));
    this.section(bytes, (tag, row) => this.readDrawing(bytes, tag, row));
    if (!bytes.atEnd) throw new Error('bytes follow a packet');
  }

  private section(bytes: ByteReader, read: (tag: number, row: number) => void): void {
    let id = 0;
    for (let tag = bytes.u8(); tag !== kEnd; tag = bytes.u8()) {
      id += bytes.zigzag();
      read(tag, this.rows.get(id) ?? nobody());
    }
  }

  private readModel(bytes: ByteReader, mask: number, row: number): void {
    if (mask & 1) this.x[row] += bytes.zigzag();
    if (mask & 2) this.y[row] += bytes.zigzag();
    if (mask & 4) this.z[row] += bytes.zigzag();
    if (mask & 8) this.a[row] += bytes.zigzag();
    if (mask & 16) this.state[row] = bytes.u8();
    if (mask & 32) this.color[row] = bytes.u32();
    if (mask & 64) this.flags[row] = bytes.varint();
    if (mask & 128) [this.tiltX[row], this.tiltY[row]] = [bytes.u16(), bytes.u16()];
  }

  private readText(bytes: ByteReader, tag: number, row: number): void {
    if (tag !== kFresh) nobody();
    const text = bytes.text();
    if (text === '') this.says.delete(row);
    else this.says.set(row, text);
  }

  private readScan(bytes: ByteReader, tag: number, model: number): void {
    const nth = bytes.varint();
    const row = nth < (this.scene.models[model].sensors?.length ?? 0) ? this.firstSensor.get(model)! + nth : nobody();
    if (tag !== kFresh) {
      this.scans.delete(row);
      return;
    }
    const beams = new Uint16Array(this.sensors[row].sensor.samples);
    for (let k = 0; k < beams.length; ++k) beams[k] = bytes.u16();
    this.scans.set(row, beams);
  }

  private readDrawing(bytes: ByteReader, tag: number, row: number): void {
    if (tag === kGone) this.drawings.delete(row);
    else if (tag === kFresh) this.drawings.set(row, readRuns(bytes));
    else nobody();
  }

  private readView(bytes: ByteReader, tag: number, row: number): void {
    const number = (tag - 1) >> 1;
    const format = kViews[number] ?? nobody();
    if (tag % 2 === 0) {
      this.viewed[number].delete(row);
      return;
    }
    if (!format.list) {
      this.viewed[number].set(row, readRecord(bytes, format));
      return;
    }
    const records: unknown[] = [];
    for (let left = bytes.varint(); left > 0; --left) records.push(readRecord(bytes, format));
    this.viewed[number].set(row, records);
  }
}

/** All runs of a drawing; each corner is a difference to the one before. */
function readRuns(bytes: ByteReader): DrawnRun[] {
  const runs: DrawnRun[] = [];
  const at = [0, 0, 0]; // mm
  for (let left = bytes.varint(); left > 0; --left) {
    const form = bytes.u8();
    const [corners, flat] = [form & 3, form >= 4];
    if ((corners !== 1 && corners !== 2 && corners !== 3) || form > 7) nobody();
    const color = bytes.u32();
    const count = 3 * corners * bytes.varint();
    if (count > bytes.left) nobody(); // a number has at least one byte
    const points = new Float32Array(count);
    for (let k = 0; k < count; ++k) {
      at[k % 3] = (at[k % 3] + bytes.zigzag()) | 0;
      points[k] = at[k % 3] / 1000;
    }
    runs.push({ corners, flat, color, points });
  }
  return runs;
}

function readRecord(bytes: ByteReader, format: ViewFormat): Record<string, number> {
  const record: Record<string, number> = {};
  for (const [name, code, worth] of format.fields) record[name] = kReaders[code](bytes) * worth;
  return record;
}

const kReaders: Record<Code, (bytes: ByteReader) => number> = {
  varint: (bytes) => bytes.varint(),
  zigzag: (bytes) => bytes.zigzag(),
  turn: (bytes) => radiansOf(bytes.u16()),
  rgba: (bytes) => bytes.u32(),
};

function nobody(): never {
  throw new Error('a packet names what the scene has not');
}
