import type { Mesh } from 'three';
import { describe, expect, it } from 'vitest';
import { Areas } from './areas';

describe('Areas', () => {
  it('lays a triangle for each side that the first corner is not on, and forgets those before', () => {
    const areas = new Areas();
    const { geometry } = areas.object as Mesh;
    areas.lay([[[1, 0, 0, 0.5], 2, [0, 0, 1, 0, 1, 1, 0, 1]], [[0, 0, 1, 1], 0, [0, 0, 1, 0, 0, 1]]]);
    expect(geometry.drawRange.count).toBe(9);
    const at = (corner: number) => [geometry.getAttribute('position').getX(corner), geometry.getAttribute('position').getY(corner)];
    expect([0, 1, 2, 3, 4, 5].map(at)).toEqual([[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]);
    expect([...Array(4).keys()].map((channel) => geometry.getAttribute('color').getComponent(0, channel))).toEqual([1, 0, 0, 0.5]);
    areas.lay([]);
    expect(geometry.drawRange.count).toBe(0);
  });
});
