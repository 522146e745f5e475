/**
 * Encoding and decoding of Player's variant of XDR and of its message header; base of the generated codecs.
 *
 * Everything is big-endian and a multiple of four bytes. A list is encoded as its count in the count field, and again
 * as a length before its elements; the rules are in docs/wire.md.
 */

import { WireError } from './errors.js';
import { shown } from './text.js';

export const HEADER_BYTES = 40;
export const MAX_BODY_BYTES = 33554432 - HEADER_BYTES;

/** Type of a message: the header's `type`. */
export const Kind = { DATA: 1, CMD: 2, REQ: 3, ACK: 4, SYNCH: 5, NACK: 6 } as const;

/** The 40 bytes before every body. */
export interface Header {
  /** Code of the interface. */
  interface: number;
  index: number;
  /** One of Kind, or another number. */
  kind: number;
  subtype: number;
  /** In s. */
  timestamp: number;
  sequence: number;
  /** Length of the body in bytes. */
  size: number;
  host: number;
  /** TCP port of a server. */
  robot: number;
}

export function encodeHeader(header: Header): Uint8Array {
  const bytes = new Uint8Array(HEADER_BYTES);
  const to = new DataView(bytes.buffer);
  to.setUint32(0, header.host);
  to.setUint32(4, header.robot);
  to.setUint32(8, header.interface);
  to.setUint32(12, header.index);
  to.setUint32(16, header.kind);
  to.setUint32(20, header.subtype);
  to.setFloat64(24, header.timestamp);
  to.setUint32(32, header.sequence);
  to.setUint32(36, header.size);
  return bytes;
}

/** Reads 40 bytes at `at`; narrow fields keep their low bits only, as in every Player receiver. */
export function decodeHeader(bytes: Uint8Array, at = 0): Header {
  const from = new DataView(bytes.buffer, bytes.byteOffset + at, HEADER_BYTES);
  return {
    interface: from.getUint32(8) & 0xffff,
    index: from.getUint32(12) & 0xffff,
    kind: from.getUint32(16) & 0xff,
    subtype: from.getUint32(20) & 0xff,
    timestamp: from.getFloat64(24),
    sequence: from.getUint32(32),
    size: from.getUint32(36),
    host: from.getUint32(0),
    robot: from.getUint32(4),
  };
}

/** Reads values from a body, front to back. Allocations are bounded by the size of the body. */
export class Reader {
  private at = 0;
  private readonly view: DataView;

  constructor(private readonly data: Uint8Array) {
    this.view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  }

  uint8(): number {
    return this.uint32() & 0xff;
  }

  int8(): number {
    return (this.uint32() << 24) >> 24;
  }

  uint16(): number {
    return this.uint32() & 0xffff;
  }

  int16(): number {
    return (this.uint32() << 16) >> 16;
  }

  uint32(): number {
    return this.view.getUint32(this.take(4));
  }

  int32(): number {
    return this.view.getInt32(this.take(4));
  }

  int64(): bigint {
    return this.view.getBigInt64(this.take(8));
  }

  float32(): number {
    return this.view.getFloat32(this.take(4));
  }

  float64(): number {
    return this.view.getFloat64(this.take(8));
  }

  float32s(count: number): Float32Array {
    return this.floats(Float32Array, count);
  }

  float64s(count: number): Float64Array {
    return this.floats(Float64Array, count);
  }

  /** `count` raw bytes and the zero padding of the last word. */
  opaque(count: number): Uint8Array {
    const at = this.take(count + padding(count));
    return this.data.slice(at, at + count);
  }

  /** As many values as `one` reads in `count` calls. */
  many<T>(count: number, one: () => T): T[] {
    const values: T[] = [];
    for (let i = 0; i < count; ++i) values.push(one());
    return values;
  }

  /** The length before the elements of a list: at most `limit`, each element at least `least` bytes. */
  length(name: string, limit: number, least: number): number {
    const count = this.uint32();
    const left = this.data.length - this.at;
    if (count > limit) {
      throw new WireError(`byte ${this.at}: ${name} has a length of ${count}, over its limit of ${limit}`);
    }
    if (count * least > left) {
      throw new WireError(`byte ${this.at}: ${name} claims ${count} elements, but ${left} bytes are left`);
    }
    return count;
  }

  private floats<T extends Float32Array | Float64Array>(
    list: { new (count: number): T; BYTES_PER_ELEMENT: number }, count: number,
  ): T {
    const size = list.BYTES_PER_ELEMENT;
    const at = this.take(count * size);
    const values = new list(count);
    for (let i = 0; i < count; ++i) values[i] = size === 4 ? this.view.getFloat32(at + 4 * i) : this.view.getFloat64(at + 8 * i);
    return values;
  }

  private take(size: number): number {
    const { at } = this;
    const left = this.data.length - at;
    if (size > left) throw new WireError(`byte ${at}: ${size} bytes expected, ${left} are left`);
    this.at = at + size;
    return at;
  }
}

/** Appends values to a body. A value outside the range of its field is a WireError. */
export class Writer {
  private data = new Uint8Array(256);
  private view = new DataView(this.data.buffer);
  private size = 0;

  uint8(value: number): void {
    this.whole(value, 0, 0xff);
  }

  int8(value: number): void {
    this.whole(value, -0x80, 0x7f);
  }

  uint16(value: number): void {
    this.whole(value, 0, 0xffff);
  }

  int16(value: number): void {
    this.whole(value, -0x8000, 0x7fff);
  }

  uint32(value: number): void {
    this.whole(value, 0, 0xffffffff);
  }

  int32(value: number): void {
    this.whole(value, -0x80000000, 0x7fffffff);
  }

  int64(value: bigint): void {
    if (typeof value !== 'bigint') throw new WireError(`${shown(value)} is not a bigint`);
    if (BigInt.asIntN(64, value) !== value) throw new WireError(`${value} is outside the range of 64 bits`);
    const at = this.grow(8);
    this.view.setBigInt64(at, value);
  }

  float32(value: number): void {
    const at = this.grow(4);
    this.view.setFloat32(at, single(value));
  }

  float64(value: number): void {
    const at = this.grow(8);
    this.view.setFloat64(at, double(value));
  }

  /** Any list of numbers; the generated types ask for a Float32Array. */
  float32s(values: ArrayLike<number>): void {
    const at = this.grow(4 * values.length);
    for (let i = 0; i < values.length; ++i) this.view.setFloat32(at + 4 * i, single(values[i]!));
  }

  float64s(values: ArrayLike<number>): void {
    const at = this.grow(8 * values.length);
    for (let i = 0; i < values.length; ++i) this.view.setFloat64(at + 8 * i, double(values[i]!));
  }

  /** A count or length word before a list of at most `limit` elements. */
  length(name: string, count: number, limit: number): void {
    if (count > limit) throw new WireError(`${name} has ${count} elements, over its limit of ${limit}`);
    this.uint32(count);
  }

  /** Checks a list of fixed length, which is encoded without a length word. */
  exactly(name: string, count: number, wanted: number): void {
    if (count !== wanted) throw new WireError(`${name} has ${count} elements instead of ${wanted}`);
  }

  /** Raw bytes, zero-padded to a multiple of four. */
  opaque(data: Uint8Array): void {
    this.padded(data, data.length + padding(data.length));
  }

  /** Exactly `size` bytes: `data`, zero-padded. */
  fixed(name: string, data: Uint8Array, size: number): void {
    if (data.length > size) throw new WireError(`${name} has ${data.length} bytes, over its ${size}`);
    this.padded(data, size + padding(size));
  }

  bytes(): Uint8Array {
    return this.data.slice(0, this.size);
  }

  private whole(value: number, low: number, high: number): void {
    if (!Number.isInteger(value)) throw new WireError(`${shown(value)} is not a whole number`);
    if (value < low || value > high) throw new WireError(`${value} is outside [${low}, ${high}]`);
    const at = this.grow(4);
    this.view.setInt32(at, value | 0);
  }

  private padded(data: Uint8Array, size: number): void {
    const at = this.grow(size);
    this.data.set(data, at);
    this.data.fill(0, at + data.length, at + size);
  }

  /** Makes room for `size` bytes more; returns where they begin. */
  private grow(size: number): number {
    const at = this.size;
    this.size = at + size;
    if (this.size > this.data.length) {
      const larger = new Uint8Array(Math.max(2 * this.data.length, this.size));
      larger.set(this.data.subarray(0, at));
      this.data = larger;
      this.view = new DataView(larger.buffer);
    }
    return at;
  }
}

function padding(count: number): number {
  return -count & 3;
}

function double(value: number): number {
  if (typeof value !== 'number') throw new WireError(`${shown(value)} is not a number`);
  return value;
}

function single(value: number): number {
  const rounded = Math.fround(double(value));
  if (!Number.isFinite(rounded) && Number.isFinite(value)) throw new WireError(`${value} is too large for 32 bits`);
  return rounded;
}

/** How a struct is written and read; made by the generated code. */
interface Layout<T> {
  zero(): T;
  write(to: Writer, value: T): void;
  read(from: Reader): T;
}

/** Encodes and decodes one struct. Values are plain objects with the fields of the interface of the same name. */
export class Codec<T> {
  /** Writes and reads a value inside another one. */
  readonly write: (to: Writer, value: T) => void;
  readonly read: (from: Reader) => T;
  private readonly zero: () => T;

  /** `name` is that of the struct, for instance "position2d.CmdVel". */
  constructor(readonly name: string, layout: Layout<T>) {
    this.write = layout.write;
    this.read = layout.read;
    this.zero = layout.zero;
  }

  /** A value with these fields; the others are zero or empty. */
  make(fields: Partial<T> = {}): T {
    return { ...this.zero(), ...fields };
  }

  /** The body of a value; fields that it lacks are zero or empty. Throws WireError for values outside the range of
   * their fields. */
  encode(value: Partial<T>): Uint8Array {
    const to = new Writer();
    this.write(to, this.make(value));
    return to.bytes();
  }

  /** Decodes `data`; bytes after the last field are ignored. Throws WireError. */
  decode(data: Uint8Array): T {
    try {
      return this.read(new Reader(data));
    } catch (error) {
      throw error instanceof WireError ? new WireError(`${this.name}: ${error.message}`) : error;
    }
  }
}

/** One message type of one interface, as PLAYER_POSITION2D_CMD_VEL; without `payload` it has no body. */
export class MessageType<T> {
  /** Code of the interface; 0: the message is shared by all. */
  readonly interface: number;

  /** `name` is for instance "position2d.cmd.vel". */
  constructor(
    code: number, readonly kind: number, readonly subtype: number, readonly name: string, readonly payload?: Codec<T>,
  ) {
    this.interface = code;
  }
}

/** A message type of whatever payload. */
export type AnyMessage = MessageType<any>;
