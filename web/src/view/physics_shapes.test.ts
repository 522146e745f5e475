import { describe, expect, it } from 'vitest';
import { edgesOf } from './physics_shapes';

/** Edges as texts, in no order and direction. */
function named(points: number[]): Set<string> {
  const ends = Array.from({ length: points.length / 3 }, (_, k) => points.slice(3 * k, 3 * k + 3).join(' '));
  return new Set(Array.from({ length: ends.length / 2 }, (_, k) => [ends[2 * k], ends[2 * k + 1]].sort().join(' - ')));
}

describe('edgesOf', () => {
  it('are those of a box, however the box is told', () => {
    const prism = named(edgesOf({ z: [0, 2], loop: [0, 0, 1, 0, 1, 1, 0, 1] }));
    const corners = [0, 2].flatMap((z) => [[0, 0, z], [1, 0, z], [1, 1, z], [0, 1, z]].flat());
    expect(prism.size).toBe(12);
    expect(named(edgesOf({ corners }))).toEqual(prism);
  });

  it('are those of a tetrahedron', () => {
    expect(named(edgesOf({ corners: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] })).size).toBe(6);
  });
});
