import { describe, expect, it } from 'vitest';
import type { GripperView } from '../protocol/generated/views';
import type { Model } from '../protocol/scene';
import { bitsText, faceOf, liftText, paddlesText } from './gripper';

const view = (changes: Partial<GripperView> = {}): GripperView => ({ paddles: 0, closing: 0, lift: 0, rising: 0, held: -1, beams: 0, contacts: 0, ...changes });

describe('a gripper', () => {
  it('has its paddles apart by what is left of its width, and together when closed', () => {
    const model = { size: [0.2, 0.3, 0.2], paddle: [0.66, 0.1, 0.4] } as Model;
    expect(faceOf(model, 0)).toBeCloseTo(0.12);
    expect(faceOf(model, 0.5)).toBeCloseTo(0.06);
    expect(faceOf(model, 1)).toBe(0);
    expect(faceOf({ ...model, paddle: [0.5, 0.8, 0.5] }, 0)).toBe(0);
  });

  it('says what its paddles do', () => {
    expect(paddlesText(view())).toBe('open');
    expect(paddlesText(view({ paddles: 0.25, closing: 1 }))).toBe('closing, 25 %');
    expect(paddlesText(view({ paddles: 0.25, closing: -1 }))).toBe('opening, 25 %');
    expect(paddlesText(view({ paddles: 0.25 }))).toBe('stopped, 25 %');
    expect(paddlesText(view({ paddles: 1 }))).toBe('closed');
    expect(paddlesText(view({ paddles: 0.68, held: 0 }))).toBe('closed, 68 %');
  });

  it('says where its lift is', () => {
    expect(liftText(view())).toBe('down');
    expect(liftText(view({ lift: 0.5, rising: 1 }))).toBe('rising, 50 %');
    expect(liftText(view({ lift: 0.5, rising: -1 }))).toBe('sinking, 50 %');
    expect(liftText(view({ lift: 0.5 }))).toBe('stopped, 50 %');
    expect(liftText(view({ lift: 1 }))).toBe('up');
  });

  it('names beams and paddles by their bits', () => {
    expect(bitsText(0, ['inner', 'outer'])).toBe('none');
    expect(bitsText(2, ['inner', 'outer'])).toBe('outer');
    expect(bitsText(3, ['left', 'right'])).toBe('left, right');
  });
});
