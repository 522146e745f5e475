import { describe, expect, it } from 'vitest';
import { holds } from './things';

describe('holds', () => {
  const wall = { z: [0, 1] as [number, number], loops: [[0, 0, 4, 0, 4, 4, 0, 4], [1, 1, 1, 3, 3, 3, 3, 1]] };

  it('is solid in a wall and not in the room inside it', () => {
    expect(holds(wall, 0.5, 2)).toBe(true);
    expect(holds(wall, 2, 2)).toBe(false);
    expect(holds(wall, 5, 2)).toBe(false);
    expect(holds(wall, 3.5, 3.9)).toBe(true);
  });
});
