import { describe, expect, it } from 'vitest';
import { freeName } from './texts';

describe('freeName', () => {
  it('is the name itself, or the first number behind it that nobody has', () => {
    expect(freeName('visitor', new Set(['guide']), 24)).toBe('visitor');
    expect(freeName('visitor', new Set(['visitor', 'visitor2', 'visitor4']), 24)).toBe('visitor3');
  });

  it('is no longer than names may be', () => {
    expect(freeName('abcd', new Set(['abcd']), 4)).toBe('abc2');
    expect(freeName('abcdef', new Set(), 4)).toBe('abcd');
  });
});
