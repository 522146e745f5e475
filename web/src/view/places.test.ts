import { describe, expect, it } from 'vitest';
import { Places } from './places';

describe('Places', () => {
  it('gives no two texts the same room', () => {
    const places = new Places();
    const given: [number, number][] = [];
    for (let k = 0; k < 1000; ++k) {
      const [x, y] = [(k * 7919) % 1280, (k * 104729) % 800];
      if (places.take(x, y, 60, 14)) given.push([x, y]);
    }
    const near = given.some(([ax, ay], i) => given.some(([bx, by], k) => i < k && Math.abs(ax - bx) < 70 && Math.abs(ay - by) < 20));
    expect(near).toBe(false);
    expect(given.length).toBeGreaterThan(100);
    expect(given.length).toBeLessThan(750); // as many as fit on 1280 x 800
  });

  it('forgets everything for the next picture', () => {
    const places = new Places();
    expect(places.take(10, 10, 50, 14)).toBe(true);
    expect(places.take(30, 10, 50, 14)).toBe(false);
    places.clear();
    expect(places.take(30, 10, 50, 14)).toBe(true);
  });
});
