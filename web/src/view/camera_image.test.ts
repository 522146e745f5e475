import { expect, test } from 'vitest';
import { paint } from './camera_image';

function painted(samples: number[], image: string): number[] {
  const out = new Uint8ClampedArray(4 * samples.length);
  paint(samples, image, out);
  return [...out];
}

test('colours are what the camera saw', () => {
  expect(painted([0xff8001], 'color')).toEqual([255, 128, 1, 255]);
});

test('brightness is grey', () => {
  expect(painted([7, 255], 'gray')).toEqual([7, 7, 7, 255, 255, 255, 255, 255]);
});

test('what is near is brighter than what is far, and nothing is black', () => {
  const [near, , , , far, , , , nothing] = painted([500, 4000, 0], 'depth');
  expect(near).toBeGreaterThan(far!);
  expect(far).toBeGreaterThan(0);
  expect(nothing).toBe(0);
});

test('models have colours that differ, and nothing is black', () => {
  const [a, b, none] = [painted([1], 'segmentation'), painted([2], 'segmentation'), painted([0], 'segmentation')];
  expect(a).not.toEqual(b);
  expect(Math.max(...a.slice(0, 3))).toBeGreaterThan(63);
  expect(none).toEqual([0, 0, 0, 255]);
});
