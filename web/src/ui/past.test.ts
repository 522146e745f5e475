import { expect, test } from 'vitest';
import { merged, nearest, neighbour, untold } from './past';

const ticks = [5, 10, 20, 30];

test('the instant nearest to where the slider is', () => {
  expect(nearest(ticks, 0)).toBe(5);
  expect(nearest(ticks, 14)).toBe(10);
  expect(nearest(ticks, 16)).toBe(20);
  expect(nearest(ticks, 99)).toBe(30);
});

test('keys go from instant to instant', () => {
  expect(neighbour(ticks, 34, 'ArrowLeft')).toBe(30);
  expect(neighbour(ticks, 30, 'ArrowLeft')).toBe(20);
  expect(neighbour(ticks, 5, 'ArrowLeft')).toBe(5);
  expect(neighbour(ticks, 5, 'ArrowRight')).toBe(10);
  expect(neighbour(ticks, 30, 'ArrowRight')).toBe(30);
  expect(neighbour(ticks, 30, 'Home')).toBe(5);
  expect(neighbour(ticks, 5, 'End')).toBe(30);
  expect(neighbour(ticks, 30, 'PageDown')).toBe(5);
  expect(neighbour(ticks, 30, 'a')).toBe(null);
  expect(neighbour(ticks, 34, 'Home')).toBe(5);
});

test('now is later than every instant: no key goes back to the last one by going on', () => {
  for (const key of ['ArrowRight', 'ArrowUp', 'PageUp', 'End']) expect(neighbour(ticks, 34, key)).toBe(34);
});

test('the instant that a run was taken back from is there before the program tells of it', () => {
  const left = untold([27], ticks);
  expect(merged(ticks, left)).toEqual([5, 10, 20, 27, 30]);
  expect(neighbour(merged([5, 10], untold([14], [5, 10])), 5, 'End')).toBe(14);
});

test('an instant that was told, or is older than what the program keeps, is forgotten', () => {
  expect(untold([20, 27], ticks)).toEqual([27]);
  expect(untold([3, 27], ticks)).toEqual([27]);
  expect(untold([27], [])).toEqual([]);
});
