import type { position2d } from '../src/generated/index.js';

/** The data of a base at this x (m). */
export function at(x: number): Partial<position2d.Data> {
  return { pos: { px: x, py: 0, pa: 0 } };
}
