/** Laws of the encoding: round trips, and hostile bytes that throw WireError and nothing else. */

import assert from 'node:assert/strict';
import test from 'node:test';
import * as generated from '../src/generated/index.js';
import { common, findMessage, map, player, position2d } from '../src/generated/index.js';
import { cString, Codec, Kind, text, WireError } from '../src/index.js';
import { didYouMean } from '../src/text.js';
import { decodeHeader, encodeHeader, Reader, Writer } from '../src/wire.js';

function payloads(): Codec<object>[] {
  const modules = Object.values(generated).filter((each) => typeof each === 'object' && !(each instanceof Map));
  return modules.flatMap((module) => Object.values(module)).filter((each) => each instanceof Codec);
}

/** Numbers from a seed, below `limit`. */
function random(seed: number): (limit: number) => number {
  let state = seed;
  return (limit) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * limit);
  };
}

/** Words as bodies have them: mostly small numbers, so that lengths are often believable. */
function words(next: (limit: number) => number): Buffer {
  const body = Buffer.alloc(4 * (1 + next(60)));
  for (let at = 0; at < body.length; at += 4) body.writeUInt32BE([0, 1, 2, 3, next(2 ** 32)][next(5)]!, at);
  return body;
}

function hex(bytes: Uint8Array): string {
  return Buffer.from(bytes).toString('hex');
}

function bytes(text: string): Buffer {
  return Buffer.from(text.replaceAll(' ', ''), 'hex');
}

test('all structs of the definitions are there', () => {
  assert.equal(payloads().length, 223);
});

test('what decodes encodes to bytes that mean the same, and hostile bytes are a WireError', () => {
  const next = random(1);
  for (const codec of payloads()) {
    let decoded = 0;
    for (let i = 0; i < 200; ++i) {
      let value: object;
      try {
        value = codec.decode(words(next));
      } catch (error) {
        assert.ok(error instanceof WireError, codec.name);
        continue;
      }
      decoded += 1;
      const body = codec.encode(value);
      assert.equal(hex(codec.encode(codec.decode(body))), hex(body), codec.name);
    }
    assert.ok(decoded > 0, codec.name);
  }
});

test('a body that is cut short is an error', () => {
  for (const codec of payloads()) {
    const body = codec.encode({});
    for (let size = 0; size < body.length; ++size) {
      assert.throws(() => codec.decode(body.subarray(0, size)), WireError, `${codec.name} cut to ${size} bytes`);
    }
  }
});

test('bytes after the end are ignored', () => {
  const body = position2d.CmdCar.encode({ velocity: 1, angle: 2 });
  assert.deepEqual(position2d.CmdCar.decode(Buffer.concat([body, Buffer.from('more')])), { velocity: 1, angle: 2 });
});

test('a huge length is an error before anything is allocated', () => {
  const body = bytes('ffffffff ffffffff');
  assert.throws(() => player.DeviceDevlist.decode(body), /devices has a length of 4294967295, over its limit of 4096/);
  assert.throws(() => common.IntpropReq.decode(body), /key claims 4294967295 elements, but 0 bytes are left/);
});

test('the second length counts and may not exceed the first', () => {
  assert.equal(text(common.IntpropReq.decode(bytes('00000008 00000004 61626364 00000005')).key), 'abcd');
  assert.throws(() => common.IntpropReq.decode(bytes('00000003 00000004 61626364 00000005')), {
    name: 'WireError', message: 'common.IntpropReq: byte 8: key has a length of 4, over its limit of 3',
  });
});

test('a count may travel apart from its list', () => {
  const value = { col: 1, row: 2, width: 3, height: 4, dataRange: -1, data: Uint8Array.of(1, 255) };
  const body = map.Data.encode(value);
  assert.equal(hex(body), '0000000100000002000000030000000400000002ffffffff0000000201ff0000');
  assert.deepEqual(map.Data.decode(body), value);
});

test('lists of numbers come and go in the order of bytes of the wire', () => {
  const to = new Writer();
  to.float32s(Float32Array.of(1, -2));
  to.float64s([0.5]);
  assert.equal(hex(to.bytes()), '3f800000c00000003fe0000000000000');
  const from = new Reader(to.bytes());
  assert.deepEqual(from.float32s(2), Float32Array.of(1, -2));
  assert.deepEqual(from.float64s(1), Float64Array.of(0.5));
  assert.throws(() => from.float64s(1), /byte 16: 8 bytes expected, 0 are left/);
});

test('a list that is encoded keeps its numbers', () => {
  const ranges = Float32Array.of(1, 2);
  generated.laser.Data.encode({ ranges });
  assert.deepEqual(ranges, Float32Array.of(1, 2));
});

test('a number that does not fit its field is an error', () => {
  const wrong: [() => unknown, RegExp][] = [
    [() => player.DeviceDatamodeReq.encode({ mode: 256 }), /256 is outside \[0, 255\]/],
    [() => common.IntpropReq.encode({ value: 2 ** 31 }), /2147483648 is outside/],
    [() => common.IntpropReq.encode({ value: 1.5 }), /1.5 is not a whole number/],
    [() => common.IntpropReq.encode({ value: '1' as never }), /"1" is not a whole number/],
    [() => position2d.CmdCar.encode({ angle: undefined as never }), /undefined is not a number/],
    [() => player.DeviceReq.encode({ driverName: new Uint8Array(65) }), /driver_name has 65 elements, over its limit of 64/],
    [() => generated.laser.Data.encode({ minAngle: 1e39 }), /1e\+39 is too large for 32 bits/],
    [() => generated.laser.Data.encode({ ranges: [1e39] as never }), /1e\+39 is too large for 32 bits/],
    [() => generated.localize.SetPose.encode({ cov: new Float64Array(5) }), /cov has 5 elements instead of 6/],
    [() => generated.health.Memory.encode({ total: 2n ** 63n }), /9223372036854775808 is outside the range of 64 bits/],
    [() => generated.health.Memory.encode({ total: 1 as never }), /1 is not a bigint/],
  ];
  for (const [encode, line] of wrong) {
    assert.throws(encode, (error: Error) => error instanceof WireError && line.test(error.message), String(line));
  }
  const large = { total: 2n ** 62n + 1n, used: -1n, free: 0n };
  assert.deepEqual(generated.health.Memory.decode(generated.health.Memory.encode(large)), large);
});

test('narrow numbers keep their low bits', () => {
  const from = new Reader(bytes('00000101 00012345 000000c8 ffffff38 0001ffff'));
  const read = [from.uint8(), from.uint16(), from.int8(), from.int8(), from.int16()];
  assert.deepEqual(read, [1, 0x2345, -56, 56, -1]);
});

test('headers come out as they went in, with the low bits of narrow fields', () => {
  const header = {
    interface: 4, index: 1, kind: 1, subtype: 2, timestamp: 7.5, sequence: 2 ** 32 - 1, size: 3, host: 0x100007f, robot: 6665,
  };
  assert.deepEqual(decodeHeader(encodeHeader(header)), header);
  const wide = encodeHeader({ ...header, interface: 0x10004, index: 0x10001, kind: 0x101, subtype: 0x102 });
  assert.deepEqual(decodeHeader(wide), header);
});

test('strings carry their NUL', () => {
  assert.equal(hex(cString('r0')), '723000');
  assert.equal(text(Buffer.from('r0\0junk')), 'r0');
  assert.equal(text(Buffer.from('r0')), 'r0');
  assert.equal(text(Buffer.from('\ufeffschön')), '\ufeffschön');
  assert.equal(text(Uint8Array.of(0x61, 0xff)), 'a\ufffd');
  assert.throws(() => cString('r0\0'), /has a NUL in it/);
  assert.throws(() => cString('r\udcff'), /cannot be sent as UTF-8/);
});

test('answers share the row of their request', () => {
  assert.equal(findMessage(4, Kind.ACK, 1), position2d.REQ_GET_GEOM);
  assert.equal(findMessage(999, Kind.NACK, 255), common.REQ_CAPABILITIES);
  assert.equal(findMessage(4, Kind.DATA, 99), undefined);
});

test('the nearest word is meant if it is near', () => {
  assert.equal(didYouMean('lazer', ['sonar', 'laser', 'ranger']), ' (did you mean "laser"?)');
  assert.equal(didYouMean('xyzzy', ['sonar', 'laser']), '');
  assert.equal(didYouMean('', []), '');
});
