import { ByteReader } from './byte_reader';
import type { Scene, Sensor } from './scene';

export const kStalled = 1;
export const kSubscribed = 2;
export const kMotorOff = 4;

export interface Hit {
  target: number; // model row
  id: number;
  range: number; // m
  bearing: number; // rad, in (-pi, pi]
  heading: number; // rad, in (-pi, pi]
}

export interface SensorPlace {
  model: number;
  sensor: Sensor;
}

const kEnd = 0;
const kFresh = 1;

/** [1/65536 turn] to [rad] in (-pi, pi]. */
export function radiansOf(turn: number): number {
  return ((turn > 32768 ? turn - 65536 : turn) / 65536) * 2 * Math.PI;
}

/** What this viewer holds of the world: the baseline that the program's packets change. Mirrors delta.h. */
export class Replica {
  tick = 0;
  frame = 0;
  paused = false;
  rowsWait = false;
  beamsFull = false;
  speed = 1;
  realTimeFactor = 0;

  // Per model, in the parent's frame: mm, mm, mm, 1/65536 turn; bits; 0xRRGGBBAA.
  readonly x: Int32Array;
  readonly y: Int32Array;
  readonly z: Int32Array;
  readonly a: Uint16Array;
  readonly state: Uint8Array;
  readonly color: Uint32Array;

  /** Per position, 6 numbers: vx, vy [mm/s], va [mrad/s], odometry x, y [mm], heading [1/65536 turn]. */
  readonly positions: Int32Array;

  /** By sensor row: ranges as fractions of the sensor's range_max, times 65535. */
  readonly scans = new Map<number, Uint16Array>();
  /** By finder row. */
  readonly findings = new Map<number, Hit[]>();
  /** Where each sensor row is. */
  readonly sensors: SensorPlace[] = [];

  constructor(scene: Scene) {
    const count = scene.models.length;
    this.x = new Int32Array(count);
    this.y = new Int32Array(count);
    this.z = new Int32Array(count);
    this.a = new Uint16Array(count);
    this.state = new Uint8Array(count);
    this.color = new Uint32Array(count);
    let positions = 0;
    scene.models.forEach((model, row) => {
      [this.x[row], this.y[row], this.z[row], this.a[row], this.state[row], this.color[row]] = model.start;
      if (model.position !== undefined) positions = Math.max(positions, model.position + 1);
      if (model.first_sensor === undefined || model.sensors === undefined) return;
      scene.sensors[model.sensors].forEach((sensor, nth) => {
        this.sensors[model.first_sensor! + nth] = { model: row, sensor };
      });
    });
    this.positions = new Int32Array(positions * 6);
  }

  /** Applies one packet. Throws when the bytes are none; the replica is then of no use any more. */
  apply(packet: ArrayBuffer): void {
    const bytes = new ByteReader(packet);
    if (bytes.u8() !== 1) throw new Error('not a packet of this program');
    const flags = bytes.u8();
    this.paused = (flags & 1) !== 0;
    this.rowsWait = (flags & 2) !== 0;
    this.beamsFull = (flags & 4) !== 0;
    this.frame = bytes.varint();
    this.tick = bytes.varint();
    this.speed = bytes.f32();
    this.realTimeFactor = bytes.f32();
    this.readModels(bytes);
    this.readPositions(bytes);
    this.readScans(bytes);
    this.readFindings(bytes);
    if (!bytes.atEnd) throw new Error('bytes follow a packet');
  }

  private readModels(bytes: ByteReader): void {
    let row = 0;
    for (let mask = bytes.u8(); mask !== kEnd; mask = bytes.u8()) {
      row = step(row, bytes, this.x.length);
      if (mask & 1) this.x[row] += bytes.zigzag();
      if (mask & 2) this.y[row] += bytes.zigzag();
      if (mask & 4) this.z[row] += bytes.zigzag();
      if (mask & 8) this.a[row] += bytes.zigzag();
      if (mask & 16) this.state[row] = bytes.u8();
      if (mask & 32) this.color[row] = bytes.u32();
    }
  }

  private readPositions(bytes: ByteReader): void {
    let row = 0;
    for (let mask = bytes.u8(); mask !== kEnd; mask = bytes.u8()) {
      row = step(row, bytes, this.positions.length / 6);
      for (let field = 0; field < 6; ++field) {
        if (mask & (1 << field)) this.positions[row * 6 + field] += bytes.zigzag();
      }
      this.positions[row * 6 + 5] &= 0xffff;
    }
  }

  private readScans(bytes: ByteReader): void {
    let row = 0;
    for (let tag = bytes.u8(); tag !== kEnd; tag = bytes.u8()) {
      row = step(row, bytes, this.sensors.length);
      if (tag !== kFresh) {
        this.scans.delete(row);
        continue;
      }
      const beams = new Uint16Array(this.sensors[row].sensor.samples);
      for (let k = 0; k < beams.length; ++k) beams[k] = bytes.u16();
      this.scans.set(row, beams);
    }
  }

  private readFindings(bytes: ByteReader): void {
    let row = 0;
    for (let tag = bytes.u8(); tag !== kEnd; tag = bytes.u8()) {
      row = step(row, bytes, Number.MAX_SAFE_INTEGER);
      if (tag !== kFresh) {
        this.findings.delete(row);
        continue;
      }
      const hits: Hit[] = [];
      for (let left = bytes.varint(); left > 0; --left) {
        hits.push({
          target: bytes.varint(),
          id: bytes.zigzag(),
          range: bytes.varint() / 1000,
          bearing: radiansOf(bytes.u16()),
          heading: radiansOf(bytes.u16()),
        });
      }
      this.findings.set(row, hits);
    }
  }
}

function step(row: number, bytes: ByteReader, rows: number): number {
  const next = row + bytes.zigzag();
  if (next < 0 || next >= rows) throw new Error('a packet names what the scene has not');
  return next;
}
