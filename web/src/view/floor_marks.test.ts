import { expect, test } from 'vitest';
import { gridOf, markHeight, outlineOf } from './floor_marks';

test('an outline has the four edges of the box', () => {
  expect(outlineOf({ size: [4, 2, 1] })).toEqual([[-2, -1, 2, -1], [2, -1, 2, 1], [2, 1, -2, 1], [-2, 1, -2, -1]]);
});

test('marks lie on what is flat and at the foot of what is high', () => {
  expect(markHeight({ size: [1, 1, 0.02] })).toBeGreaterThan(0.02);
  expect(markHeight({ size: [1, 1, 0.5] })).toBeLessThan(0.01);
});

test('a grid has a line per metre, and fewer in a large box', () => {
  expect(gridOf({ size: [2.5, 1, 1] })).toEqual([[-1, -0.5, -1, 0.5], [0, -0.5, 0, 0.5], [1, -0.5, 1, 0.5], [-1.25, 0, 1.25, 0]]);
  expect(gridOf({ size: [1e6, 1e6, 1] }).length).toBeLessThan(500);
});
