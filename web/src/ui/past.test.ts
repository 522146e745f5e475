import { expect, test } from 'vitest';
import { nearest, neighbour } from './past';

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
});
