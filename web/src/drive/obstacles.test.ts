import { describe, expect, it } from 'vitest';
import { Obstacles, hullOf, isConvex } from './obstacles';

const kBox = [0, 0, 2, 0, 2, 1, 0, 1];
const square = (x: number, y: number, half: number) => [x - half, y - half, x + half, y - half, x + half, y + half, x - half, y + half];

describe('Obstacles', () => {
  it('push out of a solid by the shortest way', () => {
    const obstacles = new Obstacles([{ z: [0, 1], loop: kBox }]);
    const push = obstacles.push(square(-0.05, 0.5, 0.1), [0, 2])!;
    expect([push.x, push.y]).toEqual([-1, 0]);
    expect(push.depth).toBeCloseTo(0.045);
    expect(obstacles.push(square(-0.2, 0.5, 0.1), [0, 2])).toBe(null);
  });

  it('let pass who is above or below', () => {
    const obstacles = new Obstacles([{ z: [0, 0.25], loop: kBox }]);
    expect(obstacles.push(square(1, 0.5, 0.1), [0.3, 1.7])).toBe(null);
    expect(obstacles.push(square(1, 0.5, 0.1), [0.2, 1.7])).not.toBe(null);
  });

  it('of an outline that is not convex, only the edges are in the way', () => {
    const angle = [0, 0, 4, 0, 4, 4, 3, 4, 3, 1, 0, 1];
    expect(isConvex(angle)).toBe(false);
    const obstacles = new Obstacles([{ z: [0, 1], loop: angle }]);
    expect(obstacles.push(square(1, 3, 0.5), [0, 1])).toBe(null);
    expect(obstacles.push(square(1, 1.05, 0.1), [0, 1])!.y).toBeCloseTo(1);
  });

  it('take the corners of another solid for what they enclose', () => {
    const obstacles = new Obstacles([{ corners: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.2, 3] }]);
    expect(obstacles.push(square(0.3, 0.3, 0.1), [2, 2.5])).not.toBe(null);
    expect(obstacles.push(square(0.9, 0.9, 0.1), [2, 2.5])).toBe(null);
  });

  it('tell that nothing of many is met as trying each one does', () => {
    let seed = 3;
    const random = () => ((seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648);
    const solids = Array.from({ length: 60 }, () => ({ z: [0, 1] as [number, number], loop: square(20 * random(), 20 * random(), 0.2 + random()) }));
    const all = new Obstacles(solids);
    const each = solids.map((solid) => new Obstacles([solid]));
    let met = 0;
    for (let k = 0; k < 500; ++k) {
      const body = square(20 * random(), 20 * random(), 0.3);
      const deepest = Math.max(0, ...each.map((one) => one.push(body, [0, 1])?.depth ?? 0));
      expect(all.push(body, [0, 1])?.depth ?? 0).toBeCloseTo(deepest, 9);
      met += deepest > 0 ? 1 : 0;
    }
    expect(met).toBeGreaterThan(50);
  });
});

describe('hullOf', () => {
  it('leaves out what is inside or on an edge', () => {
    expect(hullOf([0, 0, 2, 0, 1, 0, 2, 2, 0, 2, 1, 1])).toEqual([0, 0, 2, 0, 2, 2, 0, 2]);
  });
});
