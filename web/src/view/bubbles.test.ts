import { describe, expect, it } from 'vitest';
import { linesOf } from './bubbles';

const kTenEach = (line: string) => [...line].length * 10; // px: 22 letters have room

describe('linesOf', () => {
  it('leaves a short text as it is', () => {
    expect(linesOf('on my way', kTenEach)).toEqual(['on my way']);
    expect(linesOf('  ', kTenEach)).toEqual(['']);
  });

  it('breaks between words', () => {
    expect(linesOf('the quick brown fox jumps over', kTenEach)).toEqual(['the quick brown fox', 'jumps over']);
    expect(linesOf('twenty-two letters: ab next', kTenEach)).toEqual(['twenty-two letters: ab', 'next']);
  });

  it('breaks words that are too long for a line, between letters', () => {
    expect(linesOf('😀'.repeat(30), kTenEach)).toEqual(['😀'.repeat(22), '😀'.repeat(8)]);
  });

  it('ends what is too much with dots', () => {
    const lines = linesOf('a'.repeat(1024), kTenEach);
    expect(lines).toHaveLength(4);
    expect(lines[3]).toBe(`${'a'.repeat(21)}…`);
  });
});
