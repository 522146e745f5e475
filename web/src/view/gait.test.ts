import { describe, expect, it } from 'vitest';
import { gaitOf, poseOf } from './gait';

/** Walks at a speed for a while, in steps of a picture. */
function walked(speed: number, seconds: number) {
  const gait = gaitOf(0, 0);
  const step = 1 / 60;
  for (let t = step; t <= seconds; t += step) gait.walk(speed * t, 0, 0, step);
  return gait;
}

describe('Gait', () => {
  it('makes as many strides as the way has, and none while it stands', () => {
    expect(walked(1.35, 4).phase / (2 * Math.PI)).toBeCloseTo(4, 1);
    const gait = walked(1, 1);
    const { phase } = gait;
    for (let k = 0; k < 120; ++k) gait.walk(1, 0, 0, 1 / 60);
    expect(gait.phase - phase).toBeLessThan(0.2);
    expect(gait.swing).toBeLessThan(0.01);
    expect(gait.walk(1, 0, 0, 1 / 60)).toBe(false);
  });

  it('takes no step for a jump to elsewhere', () => {
    const gait = gaitOf(0, 0);
    gait.walk(5, 5, 0, 1 / 60);
    expect(gait.phase).toBe(0);
  });

  it('goes backwards as it walks backwards', () => {
    expect(walked(-1, 1).phase).toBeLessThan(0);
  });
});

describe('poseOf', () => {
  it('keeps bones as long as they are and one sole on the ground', () => {
    for (const speed of [0, 0.5, 2]) {
      for (const seconds of [1, 1.2, 1.35]) {
        const joints = poseOf(walked(speed, seconds));
        expect(joints.hipLeft.distanceTo(joints.kneeLeft)).toBeCloseTo(0.44, 9);
        expect(joints.kneeRight.distanceTo(joints.ankleRight)).toBeCloseTo(0.44, 9);
        expect(Math.min(joints.ankleLeft.z, joints.ankleRight.z)).toBeCloseTo(0.07, 9);
      }
    }
  });

  it('stands upright with its eyes at the height of a person', () => {
    const { head, ankleLeft, ankleRight } = poseOf(gaitOf(0, 0));
    expect(head.z).toBeCloseTo(1.67, 2);
    expect(ankleLeft.x).toBeCloseTo(ankleRight.x, 9);
  });
});
