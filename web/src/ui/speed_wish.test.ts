import { describe, expect, it } from 'vitest';
import { SpeedWish, fasterBy } from './speed_wish';

describe('SpeedWish', () => {
  it('counts keys that come before the program answered', () => {
    const wish = new SpeedWish();
    let speed = 50;
    for (let k = 0; k < 3; ++k) wish.ask((speed = fasterBy(-1, wish.over(50, 10 * k))), 10 * k);
    expect(speed).toBe(2);
    expect(wish.over(10, 40)).toBe(2); // the answer to the first of them
    expect(wish.over(2, 50)).toBe(2);
    expect(wish.over(5, 60)).toBe(5); // another viewer
  });

  it('knows its answer again in 32 bits', () => {
    const wish = new SpeedWish();
    wish.ask(0.1, 0);
    expect(wish.over(Math.fround(0.1), 10)).toBe(Math.fround(0.1));
    expect(wish.over(50, 20)).toBe(50);
  });

  it('gives way when the answer does not come', () => {
    const wish = new SpeedWish();
    wish.ask(2, 0);
    expect(wish.over(50, 1900)).toBe(2);
    expect(wish.over(50, 2100)).toBe(50);
  });
});

describe('fasterBy', () => {
  it('stops at the ends and starts from the nearest', () => {
    expect(fasterBy(1, 50)).toBe(50);
    expect(fasterBy(-1, 0.1)).toBe(0.1);
    expect(fasterBy(-1, 0)).toBe(10);
    expect(fasterBy(1, 3)).toBe(5);
  });
});
