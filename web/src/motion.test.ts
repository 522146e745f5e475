import { describe, expect, it, vi } from 'vitest';
import { Motion, turn } from './motion';
import { Replica } from './protocol/replica';
import type { Model, Scene } from './protocol/scene';
import { drawnLoops, outlinesOf, smoothed } from './view/shapes';

function model(id: number, name: string, parent: number, x_mm: number): Model {
  const parentId = parent < 0 ? null : parent;
  return { id, name, type: 'model', kind: 'plain', parent, parentId, start: [x_mm, 0, 0, 0, 0, 0, 0], size: [1, 1, 1] };
}

const scene: Scene = {
  protocol: 4, build: '', name: 'two', interval: 0.1, light: null, shapes: [], prototypes: [], addable: [],
  window: { center: [0, 0], scale: 0, pitch: 0, yaw: 0, sensors: false, follow: '' },
  models: [model(0, 'robot', -1, 0), model(1, 'hat', 0, 100)],
};

describe('Motion', () => {
  it('jumps when the run goes back', () => {
    const replica = new Replica(scene);
    const motion = new Motion(scene, replica);
    replica.tick = 9;
    motion.aim(1000);
    replica.tick = 2;
    replica.x[0] = 500;
    motion.aim(1100);
    motion.update(1100);
    expect(motion.x[0]).toBe(0.5);
  });

  it('draws between the last two known poses and arrives', () => {
    const replica = new Replica(scene);
    const motion = new Motion(scene, replica);
    replica.tick = 1;
    replica.x[0] = 500;
    motion.aim(1000);
    motion.update(1000);
    expect(motion.x[0]).toBe(0);
    motion.update(1050);
    expect(motion.x[0]).toBeGreaterThan(0.05);
    expect(motion.x[0]).toBeLessThan(0.45);
    motion.update(2000);
    expect(motion.x[0]).toBe(0.5);
    expect(motion.x[1]).toBeCloseTo(0.6);
    expect(motion.update(2016)).toBe(false);
  });

  it('takes parts along when their robot turns', () => {
    const replica = new Replica(scene);
    const motion = new Motion(scene, replica);
    replica.a[0] = 16384;
    motion.aim(0);
    motion.update(1000);
    expect(motion.x[1]).toBeCloseTo(0);
    expect(motion.y[1]).toBeCloseTo(0.1);
  });

  it('rolls the short way over its head, and takes parts along', () => {
    const replica = new Replica(scene);
    const motion = new Motion(scene, replica);
    const roll = (turns: number, now: number) => {
      replica.tiltY[0] = Math.round(turns * 65536) & 0xffff;
      replica.tick += 1;
      motion.aim(now);
    };
    roll(0.25, 1000);
    motion.update(2000);
    expect(motion.z[1]).toBeCloseTo(-0.1); // nose down
    expect(motion.x[1]).toBeCloseTo(0);
    roll(0.4, 3000);
    motion.update(4000);
    roll(0.6, 5000); // which is -0.4
    motion.update(5000);
    const before = motion.x[1];
    motion.update(5050);
    expect(motion.x[1]).toBeLessThan(before); // through upside down, where it is furthest back
    motion.update(6000);
    expect(motion.x[1]).toBeCloseTo(0.1 * Math.cos(0.6 * 2 * Math.PI));
    roll(0, 7000);
    motion.update(8000);
    motion.aim(8100);
    motion.update(9000);
    expect(motion.tilted.size).toBe(0);
    expect(motion.x[1]).toBeCloseTo(0.1);
  });

  it('does not glide across the world after a jump', () => {
    const replica = new Replica(scene);
    const motion = new Motion(scene, replica);
    replica.x[0] = 7000;
    motion.aim(1000);
    motion.update(1001);
    expect(motion.x[0]).toBe(7);
  });

  it('shows a carried model where the hand is', () => {
    const motion = new Motion(scene, new Replica(scene));
    motion.hold(0, 3, 4, 0, 1000);
    motion.update(1100);
    expect([motion.x[0], motion.y[0]]).toEqual([3, 4]);
    motion.update(1500);
    expect([motion.x[0], motion.y[0]]).toEqual([0, 0]);
  });

  it('goes on with who stays when others come and go', () => {
    const before = new Replica(scene);
    const moving = new Motion(scene, before);
    before.tick = 1;
    before.x[1] = 600;
    const clock = vi.spyOn(performance, 'now').mockReturnValue(1000);
    moving.aim(1000);
    const other: Scene = { ...scene, models: [{ ...model(1, 'hat', -1, 0), parentId: null }, model(7, 'new', -1, 3000)] };
    const grown: Scene = { ...scene, models: [...scene.models, model(7, 'new', -1, 3000)] };
    const gone = new Motion(other, before.followedBy(other, new Set([1, 7])), moving);
    expect([gone.x[0], gone.x[1]]).toEqual([0, 3]);
    const stays = new Motion(grown, before.followedBy(grown, new Set([7])), moving);
    expect(stays.x[2]).toBe(3);
    expect(stays.x[1]).toBeLessThan(0.6);
    stays.update(2000);
    clock.mockRestore();
    expect(stays.x[1]).toBeCloseTo(0.6);
  });

  it('takes along what came into the world before who carries it', () => {
    const carried: Scene = { ...scene, models: [model(0, 'puck', 1, 100), model(1, 'robot', -1, 2000)] };
    const motion = new Motion(carried, new Replica(carried));
    expect(motion.x[0]).toBeCloseTo(2.1);
  });
});

describe('turn', () => {
  it('takes the short way round', () => {
    expect(turn(3, -3)).toBeCloseTo(2 * Math.PI - 6);
    expect(turn(0, 1)).toBeCloseTo(1);
  });
});

describe('outlinesOf', () => {
  const square = (r: number) => [-r, -r, r, -r, r, r, -r, r];

  it('sorts loops into outlines with holes, and islands in holes into outlines again', () => {
    const shapes = outlinesOf([square(1), square(3), square(2)]);
    expect(shapes.length).toBe(2);
    expect(shapes.map((shape) => shape.holes.length).sort()).toEqual([0, 1]);
  });
});

describe('smoothed', () => {
  it('turns the stairs of a bitmap into the line that was meant and keeps corners of walls', () => {
    const stairs = [0, 0, 40, 0];
    for (let k = 0; k < 10; ++k) stairs.push(40 - k, k + 1, 39 - k, k + 1);
    stairs.push(30, 40, 0, 40);
    const drawn = smoothed(stairs);
    expect(drawn.length).toBeLessThan(stairs.length / 2);
    expect(drawn.slice(0, 2)).toEqual([0, 0]);
    for (let i = 0; i < drawn.length; i += 2) expect(Math.min(...stairs.map((_, j) => (j % 2 ? 99 : Math.hypot(stairs[j] - drawn[i], stairs[j + 1] - drawn[i + 1]))))).toBeLessThan(2);
  });

  it('leaves walls of a single pixel where they are: their two sides would cross', () => {
    // Up a stair of long steps, one pixel wide, and back down on its other side.
    const there: number[] = [];
    const back: number[] = [];
    for (let k = 0; k < 8; ++k) {
      there.push(k * 5, k, k * 5 + 5, k);
      back.unshift(k * 5 - 1, k + 1, k * 5 + 4, k + 1);
    }
    const thin = [...there, 40, 8, ...back];
    expect(drawnLoops({ z: [0, 1], loops: [thin] })).toEqual([thin]);
    const wide = [...there, 40, 40, 0, 40];
    expect(drawnLoops({ z: [0, 1], loops: [wide] })).not.toEqual([wide]);
  });

  it('leaves polygons alone', () => {
    const round = Array.from({ length: 60 }, (_, k) => (k % 2 ? Math.sin(k) : Math.cos(k)));
    expect(smoothed(round)).toBe(round);
  });
});
