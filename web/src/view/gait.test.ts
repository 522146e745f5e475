import { describe, expect, it } from 'vitest';
import { gaitOf, strideOf } from './gait';

/** Walks at a speed for a while, in steps of a picture. */
function walked(speed: number, seconds: number) {
  const gait = gaitOf(0, 0);
  const step = 1 / 60;
  for (let t = step; t <= seconds; t += step) gait.walk(speed * t, 0, 0, step);
  return gait;
}

describe('Gait', () => {
  it('makes as many strides as the way has, and none while it stands', () => {
    const seconds = 20;
    for (const speed of [0.5, 1, 2]) expect(walked(speed, seconds).phase / (2 * Math.PI) / ((seconds * speed) / strideOf(speed))).toBeCloseTo(1, 1);
    const gait = walked(1, 1);
    const { phase } = gait;
    for (let k = 0; k < 120; ++k) gait.walk(1, 0, 0, 1 / 60);
    expect(gait.phase - phase).toBeLessThan(0.2);
    expect(gait.walking).toBeLessThan(0.01);
    expect(gait.walk(1, 0, 0, 1 / 60)).toBe(false);
  });

  it('takes no step for a jump to elsewhere', () => {
    const gait = gaitOf(0, 0);
    gait.walk(5, 5, 0, 1 / 60);
    expect(gait.phase).toBe(0);
  });

  it('steps in place as somebody turns', () => {
    const gait = gaitOf(0, 0);
    for (let k = 1; k <= 120; ++k) gait.walk(0, 0, k / 60, 1 / 60);
    expect(gait.phase).toBeGreaterThan(2);
    expect(gait.stepping).toBe(1);
    expect(gait.walking).toBe(0);
  });

  it('is a run only from the pace of one on', () => {
    expect(walked(1.2, 3).running).toBe(0);
    expect(walked(2, 3).running).toBeGreaterThan(0.8);
  });
});
