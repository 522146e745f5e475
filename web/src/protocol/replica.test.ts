import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { ByteReader } from './byte_reader';
import { kViews } from './generated/views';
import { radiansOf, Replica } from './replica';
import { isOfAnother, parseText, rootsOf, sceneOf, withChanges, type Changes, type Scene } from './scene';

interface Held {
  tick: number;
  paused: boolean;
  speed: number;
  models: Record<string, number[]>; // by id
  says: Record<string, string>; // by id
  scans: Record<string, number[]>; // by id/nth
  views: Record<string, number[]>; // by id: the bare numbers
  drawings: Record<string, number[]>; // by id: x, y, z [mm], color, number of corners and 1 if it is flat, of each corner
}

// Made by the program's own tests (playhouse/replicate/golden_test.cc).
const golden = JSON.parse(readFileSync(new URL('golden.json', import.meta.url), 'utf8')) as {
  scene: Parameters<typeof sceneOf>[0];
  frames: { changes?: Changes; packet: string; after: Held }[];
};

const kScene: Scene = sceneOf(golden.scene);

function bytesOf(hex: string): ArrayBuffer {
  return Uint8Array.from(hex.match(/../g) ?? [], (pair) => parseInt(pair, 16)).buffer;
}

function turnOf(radians: number): number {
  return Math.round((radians / (2 * Math.PI)) * 65536) & 0xffff;
}

function held(replica: Replica): Held {
  const { models } = replica.scene;
  const scans = [...replica.scans].map(([row, beams]) => {
    const { model } = replica.sensors[row];
    return [`${models[model].id}/${row - replica.firstSensor.get(model)!}`, [...beams]];
  });
  const views = kViews.flatMap(({ kind, fields }) =>
    [...replica.views(kind)].map(([row, value]) => {
      const records = (Array.isArray(value) ? value : [value]) as unknown as Record<string, number>[];
      const numbers = records.flatMap((record) =>
        fields.map(([name, code, worth]) => (code === 'turn' ? turnOf(record[name]) : Math.round(record[name] / worth))));
      return [models[row].id, numbers];
    }));
  const drawings = [...replica.drawings].map(([row, runs]) => [models[row].id, runs.flatMap(({ corners, flat, color, points }) =>
    Array.from({ length: points.length / 3 }, (_, k) => [...points.slice(3 * k, 3 * k + 3)].map((m) => Math.round(m * 1000)).concat(color, corners, flat ? 1 : 0)).flat())]);
  return {
    tick: replica.tick,
    paused: replica.paused,
    speed: replica.speed,
    models: Object.fromEntries(models.map(({ id }, r) => [id, [replica.x[r], replica.y[r], replica.z[r], replica.a[r], replica.state[r], replica.color[r], replica.flags[r], replica.tiltX[r], replica.tiltY[r]]])),
    says: Object.fromEntries([...replica.says].map(([row, text]) => [models[row].id, text])),
    scans: Object.fromEntries(scans),
    views: Object.fromEntries(views),
    drawings: Object.fromEntries(drawings),
  };
}

describe('Replica', () => {
  it("follows the program's packets to the number, and who comes and goes", () => {
    let replica = new Replica(kScene);
    golden.frames.forEach(({ changes, packet, after }, k) => {
      if (changes) replica = replica.followedBy(withChanges(replica.scene, changes), new Set(changes.models.map(({ id }) => id)));
      replica.apply(bytesOf(packet));
      expect(replica.frame).toBe(k + 1);
      expect(held(replica)).toEqual(after);
    });
  });

  it('refuses a packet that is cut short anywhere', () => {
    const whole = golden.frames[0].packet;
    for (let length = 0; length < whole.length; length += 2) {
      expect(() => new Replica(kScene).apply(bytesOf(whole.slice(0, length)))).toThrow();
    }
  });

  it('refuses models that the scene has not, and bytes after the end', () => {
    const head = golden.frames[0].packet.slice(0, 24);
    expect(() => new Replica(kScene).apply(bytesOf(`${head}01feff0302`))).toThrow('names what the scene has not');
    expect(() => new Replica(kScene).apply(bytesOf(`${head}000001000100`))).toThrow('names what the scene has not');
    expect(() => new Replica(kScene).apply(bytesOf(`${head}000000000000`))).toThrow('bytes follow');
  });
});

describe('what models say', () => {
  const packet = (says: string) => bytesOf(`${golden.frames[0].packet.slice(0, 24)}00${says}00000000`);

  it('holds until another text or none comes', () => {
    const replica = new Replica(kScene);
    replica.apply(packet('010202c3b6')); // row 1
    expect([...replica.says]).toEqual([[1, 'ö']]);
    replica.apply(packet(''));
    expect([...replica.says]).toEqual([[1, 'ö']]);
    replica.apply(packet('010200'));
    expect(replica.says.size).toBe(0);
  });

  it('is refused where it is no text, is longer than the packet, or has another tag', () => {
    for (const says of ['010202c328', '0102ff7f41', '02020141']) expect(() => new Replica(kScene).apply(packet(says))).toThrow();
  });
});

describe('what clients draw', () => {
  const packet = (drawings: string) => bytesOf(`${golden.frames[0].packet.slice(0, 24)}00000000${drawings}00`);

  it('holds until another drawing or none comes', () => {
    const replica = new Replica(kScene);
    replica.apply(packet('0102' + '01' + '06ff0000ff01' + 'd00f0000' + '00cf0f02')); // row 1: a line
    expect([...replica.drawings]).toEqual([[1, [{ corners: 2, flat: true, color: 0xff0000ff, points: Float32Array.of(1, 0, 0, 1, -1, 0.001) }]]]);
    replica.apply(packet(''));
    expect(replica.drawings.size).toBe(1);
    replica.apply(packet('0202'));
    expect(replica.drawings.size).toBe(0);
  });

  it('is refused with a shape of no or four corners, or longer than the packet, or has another tag', () => {
    for (const drawing of ['01020100ff0000ff01', '01020104ff0000ff01', '01020109ff0000ff010000', '01020101ff0000ffffffffff0f', '0302']) {
      expect(() => new Replica(kScene).apply(packet(drawing))).toThrow();
    }
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
    expect([...rootsOf(kScene)].slice(0, 6)).toEqual([0, 1, 1, 1, 1, 5]);
  });

  it('keeps ids while rows move, and finds parents that come later', () => {
    const grown = withChanges(kScene, { gone: [0, 5], models: [{ id: 5, prototype: 0, parent: 9, name: 'load', start: [0, 0, 0, 0, 0, 0, 0] }] });
    expect(grown.models.map(({ id }) => id)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13]);
    expect(grown.models[4].parent).toBe(8);
    expect(grown.models[1].parent).toBe(0);
    expect(kScene.models[2].parent).toBe(1);
    expect([...rootsOf(grown)].slice(4, 7)).toEqual([8, 8, 8]);
  });

  it('takes scenes, changes and notices and nothing else', () => {
    expect(parseText('{"notice":"hello"}')).toEqual({ notice: 'hello' });
    expect(parseText(JSON.stringify(golden.scene))).toHaveProperty('scene');
    expect(parseText('{"world":{"file":"a.world","text":"x"}}')).toEqual({ world: { file: 'a.world', text: 'x' } });
    expect(parseText('{"gone":[1],"models":[]}')).toEqual({ changes: { gone: [1], models: [] } });
    expect(() => parseText('{"protocol":1}')).toThrow('reload');
  });

  it('turns wrap at half a turn', () => {
    expect(radiansOf(16384)).toBeCloseTo(Math.PI / 2);
    expect(radiansOf(49152)).toBeCloseTo(-Math.PI / 2);
  });
});

describe('bodies of people', () => {
  it('are of another where another viewer has joined as them', () => {
    const people = { you: 2, people: [{ viewer: 1, role: 'human', body: 7 }, { viewer: 2, role: 'human', body: 8 }, { viewer: 3, role: 'observer' }] };
    expect([7, 8, 9].map((model) => isOfAnother(people, model))).toEqual([true, false, false]);
  });
});
