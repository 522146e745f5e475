import { describe, expect, it } from 'vitest';
import { Eyes } from './eyes';
import { kStill } from './hands';

const kNoHands = { forward: 0, sideways: 0, turn: 0 };

describe('Eyes', () => {
  it('look where the mouse goes, and the body turns after them the short way round', () => {
    const eyes = new Eyes(3);
    eyes.look(-200, 0);
    expect(eyes.yaw).toBeCloseTo(3.5);
    expect(eyes.walk(kNoHands, 3).turn).toBeCloseTo(3);
    expect(eyes.walk(kNoHands, 3.45).turn).toBeCloseTo(0.3);
    expect(eyes.walk(kNoHands, 3.5 - 2 * Math.PI)).toEqual(kStill);
  });

  it('do not look over their own back', () => {
    const eyes = new Eyes(0);
    eyes.look(0, -1e4);
    expect(eyes.pitch).toBeCloseTo(1.4);
  });

  it('walk ahead and aside by W A S D, and turn by Q and E', () => {
    const eyes = new Eyes(0);
    expect(eyes.walk({ forward: 0.5, sideways: 0, turn: 1 }, 0)).toEqual({ forward: 1, sideways: 0.8, turn: 0 });
    expect(eyes.walk({ forward: 0, sideways: 1, turn: 0 }, 0).turn).toBeCloseTo(1.8);
  });
});
