import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { ByteReader } from './byte_reader';
import { radiansOf, Replica, type Hit } from './replica';
import { parseText, rootsOf, type Scene } from './scene';

interface Held {
  tick: number;
  paused: boolean;
  speed: number;
  models: number[][];
  positions: number[][];
  scans: Record<string, number[]>;
  findings: Record<string, number[][]>;
}

// Made by the program's own tests (playhouse/replicate/golden_test.cc).
const golden = JSON.parse(readFileSync(new URL('golden.json', import.meta.url), 'utf8')) as {
  scene: Scene;
  frames: { packet: string; after: Held }[];
};

function bytesOf(hex: string): ArrayBuffer {
  return Uint8Array.from(hex.match(/../g) ?? [], (pair) => parseInt(pair, 16)).buffer;
}

function turnOf(radians: number): number {
  return Math.round((radians / (2 * Math.PI)) * 65536) & 0xffff;
}

function held(replica: Replica): Held {
  const rows = [...replica.x.keys()];
  const hit = (h: Hit) => [h.target, h.id, Math.round(h.range * 1000), turnOf(h.bearing), turnOf(h.heading)];
  return {
    tick: replica.tick,
    paused: replica.paused,
    speed: replica.speed,
    models: rows.map((r) => [replica.x[r], replica.y[r], replica.z[r], replica.a[r], replica.state[r], replica.color[r]]),
    positions: [...Array(replica.positions.length / 6).keys()].map((p) => [...replica.positions.slice(p * 6, p * 6 + 6)]),
    scans: Object.fromEntries([...replica.scans].map(([row, beams]) => [row, [...beams]])),
    findings: Object.fromEntries([...replica.findings].map(([row, hits]) => [row, hits.map(hit)])),
  };
}

describe('Replica', () => {
  it("follows the program's packets to the number", () => {
    const replica = new Replica(golden.scene);
    golden.frames.forEach(({ packet, after }, k) => {
      replica.apply(bytesOf(packet));
      expect(replica.frame).toBe(k + 1);
      expect(held(replica)).toEqual(after);
    });
  });

  it('refuses a packet that is cut short anywhere', () => {
    const whole = golden.frames[0].packet;
    for (let length = 0; length < whole.length; length += 2) {
      expect(() => new Replica(golden.scene).apply(bytesOf(whole.slice(0, length)))).toThrow();
    }
  });

  it('refuses rows that the scene has not, and bytes after the end', () => {
    const head = golden.frames[0].packet.slice(0, 24);
    expect(() => new Replica(golden.scene).apply(bytesOf(`${head}01feff0302`))).toThrow('names what the scene has not');
    expect(() => new Replica(golden.scene).apply(bytesOf(`${head}0000000000`))).toThrow('bytes follow');
  });
});

describe('ByteReader', () => {
  it('reads numbers beyond 32 bits', () => {
    expect(new ByteReader(bytesOf('ffffffff1f')).varint()).toBe(8589934591);
    expect(new ByteReader(bytesOf('ffffffff1f')).zigzag()).toBe(-4294967296);
    expect(() => new ByteReader(bytesOf('ffffffffffffffffffff01')).varint()).toThrow();
  });
});

describe('scene', () => {
  it('knows the robot above every part', () => {
    expect([...rootsOf(golden.scene)].slice(0, 6)).toEqual([0, 1, 1, 1, 1, 5]);
  });

  it('takes scenes and notices and nothing else', () => {
    expect(parseText('{"notice":"hello"}')).toEqual({ notice: 'hello' });
    expect(parseText(JSON.stringify(golden.scene))).toHaveProperty('scene');
    expect(() => parseText('{"protocol":2}')).toThrow('reload');
  });

  it('turns wrap at half a turn', () => {
    expect(radiansOf(16384)).toBeCloseTo(Math.PI / 2);
    expect(radiansOf(49152)).toBeCloseTo(-Math.PI / 2);
  });
});
