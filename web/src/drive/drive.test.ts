import { describe, expect, it } from 'vitest';
import { Driver } from './driver';
import { HeldKeys, handsOfAxes, kStill, velocityOf } from './hands';

const kAhead = { forward: 0.5, sideways: 0, turn: 0 };

describe('HeldKeys', () => {
  it('adds what is held, and opposite keys cancel', () => {
    const keys = new HeldKeys();
    keys.press('KeyW', 'w');
    keys.press('ArrowLeft', 'ArrowLeft');
    expect(keys.hands(true)).toEqual({ forward: 1, sideways: 0, turn: 1 });
    keys.press('KeyS', 's');
    expect(keys.hands(true).forward).toBe(0);
    keys.release('KeyW');
    expect(keys.hands(true).forward).toBe(-1);
    keys.press('KeyX', 'x');
    expect(keys.hands(true)).toEqual({ forward: -1, sideways: 0, turn: 1 });
  });

  it('is no faster by two keys of one meaning', () => {
    const keys = new HeldKeys();
    keys.press('KeyW', 'w');
    keys.press('ArrowUp', 'ArrowUp');
    expect(keys.hands(true).forward).toBe(1);
  });

  it('finds a key again whose letter Shift changed', () => {
    const keys = new HeldKeys();
    keys.press('KeyW', 'W');
    keys.release('KeyW');
    expect(keys.hands(true)).toEqual({ forward: 0, sideways: 0, turn: 0 });
  });
});

describe('handsOfAxes', () => {
  it('is still within the dead zone and continuous at its edge', () => {
    expect(handsOfAxes([0.1, -0.1, 0.14, 0])).toEqual({ forward: 0, sideways: 0, turn: 0 });
    expect(handsOfAxes([0, -0.16]).forward).toBeCloseTo(0.0118, 3);
    expect(handsOfAxes([0, -1])).toEqual({ forward: 1, sideways: 0, turn: 0 });
    expect(handsOfAxes([1, 0]).turn).toBe(-1);
    expect(handsOfAxes([0, 0, -1]).sideways).toBe(1);
  });

  it('takes what is no number, or missing, for stillness', () => {
    expect(handsOfAxes([])).toEqual({ forward: 0, sideways: 0, turn: 0 });
    expect(handsOfAxes([NaN, 1])).toEqual({ forward: 0, sideways: 0, turn: 0 });
  });
});

describe('velocityOf', () => {
  it('is half of full speed by keys, and all of it with Shift', () => {
    const keys = new HeldKeys();
    keys.press('KeyS', 's');
    keys.press('KeyA', 'a');
    expect(velocityOf(keys.hands(false))).toEqual({ forward: -0.3, sideways: 0, turn: 0.8 });
    expect(velocityOf(keys.hands(true))).toEqual({ forward: -0.6, sideways: 0, turn: 1.6 });
  });
});

describe('Driver', () => {
  it('says nothing while nobody drives', () => {
    const driver = new Driver();
    expect(driver.next(null, kStill, 0)).toEqual([]);
    expect(driver.next(3, kStill, 10)).toEqual([]);
    expect(driver.driven).toBe(null);
  });

  it('sends a velocity at once, renews it well within half a second, and stops once', () => {
    const driver = new Driver();
    expect(driver.next(3, kAhead, 0)).toEqual([{ model: 3, ...kAhead }]);
    const times = [];
    for (let now = 50; now <= 1000; now += 50) if (driver.next(3, kAhead, now).length > 0) times.push(now);
    expect(times).toEqual([150, 300, 450, 600, 750, 900]);
    expect(driver.next(3, kStill, 1001)).toEqual([{ model: 3, ...kStill }]);
    expect(driver.next(3, kStill, 1050)).toEqual([]);
  });

  it('does not send every step of a stick', () => {
    const driver = new Driver();
    let sent = 0;
    for (let now = 0; now < 400; now += 4) sent += driver.next(3, { ...kAhead, turn: now / 1000 + 0.1 }, now).length;
    expect(sent).toBe(10);
  });

  it('stops one robot before it drives another, or none', () => {
    const driver = new Driver();
    driver.next(3, kAhead, 0);
    expect(driver.next(7, kAhead, 1)).toEqual([{ model: 3, ...kStill }, { model: 7, ...kAhead }]);
    expect(driver.next(null, kAhead, 2)).toEqual([{ model: 7, ...kStill }]);
    driver.next(3, kAhead, 3);
    driver.forget();
    expect(driver.next(null, kStill, 4)).toEqual([]);
  });
});
