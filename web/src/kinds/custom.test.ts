import { expect, it } from 'vitest';
import { readingText } from './custom';

it('a reading is shown in thousandths at most', () => {
  expect(readingText(3 * 0.001)).toBe('0.003');
  expect(readingText(2100 * 0.001)).toBe('2.1');
  expect(readingText(-4000 * 0.001)).toBe('-4');
});
