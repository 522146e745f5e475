import { describe, expect, it } from 'vitest';
import { freeName, quantity } from './texts';

describe('quantity', () => {
  it('has the digits that travel, at most two, and its unit', () => {
    expect(quantity(21.5049, 0.001, 'degC')).toBe('21.50 °C');
    expect(quantity(-0.5, 0.001, '')).toBe('-0.50');
    expect(quantity(120, 1, 'J')).toBe('120 J');
    expect(quantity(Math.PI / 2, 1, 'rad')).toBe('90.0°');
  });

  it('is not there before the first measurement', () => {
    expect(quantity(undefined, 0.001, 'degC')).toBe('no data yet');
  });
});

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
