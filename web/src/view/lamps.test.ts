import { Color, Matrix4, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { kBits } from '../protocol/generated/views';
import type { Light, Model } from '../protocol/scene';
import { brightest, ofMesh } from './lamps';
import { darkOf, isLamp, isLit } from './surfaces';

const model = (words: Partial<Model>) => ({ kind: 'plain', size: [1, 1, 1], ...words }) as Model;
const light = (words: Partial<Light>) => ({ to_sun: [0, 0, 1], sun: 0.72, ambient: 0.42, ...words }) as Light;
const at = (x: number, candela: number) => ({ at: new Vector3(x, 0, 0), light: new Color(candela, candela, candela) });

describe('lamps', () => {
  it('are chosen by how bright they are where the eye is', () => {
    const lamps = [at(1, 1), at(10, 400), at(3, 1), at(-1, 2)];
    const chosen = brightest(lamps, new Vector3(), 2);
    expect(chosen).toEqual([lamps[1], lamps[3]]);
    expect(brightest(lamps, new Vector3(), 4)).toEqual(lamps);
  });

  it('of a mesh are where its body is and shine where that has turned', () => {
    const body = new Matrix4().makeRotationZ(Math.PI / 2).setPosition(5, 0, 0);
    const bulb = ofMesh({ p: [1, 0, 2], candela: [30, 20, 10] }, body);
    expect(bulb.at.distanceTo(new Vector3(5, 1, 2))).toBeLessThan(1e-9);
    expect(bulb.light).toEqual(new Color(30, 20, 10));
    expect(bulb.spot).toBeUndefined();
    const spot = ofMesh({ p: [0, 0, 0], candela: [1, 1, 1], way: [1, 0, 0], inner: 0.2, outer: 0.4 }, body).spot!;
    expect(spot.way.distanceTo(new Vector3(0, 1, 0))).toBeLessThan(1e-9);
    expect(spot.outer).toBe(0.4);
  });

  it('without a switch are lit always, those with one by their state', () => {
    expect(isLit(model({ lamp: 30 }), 0)).toBe(true);
    expect(isLit(model({}), 0)).toBe(false);
    const signal = model({ kind: 'blinkenlight', lamp: 30 });
    expect(isLit(signal, kBits.blinkenlight.enabled)).toBe(false);
    expect(isLit(signal, kBits.blinkenlight.enabled | kBits.blinkenlight.lit)).toBe(true);
    expect(isLamp(model({ kind: 'lightindicator' }))).toBe(true);
    expect(isLamp(model({ kind: 'position' }))).toBe(false);
  });

  it('that are dark show what falls on them', () => {
    const night = light({ to_sun: [0, 0, -1], ambient: 0.05 });
    expect(darkOf(light({}))).toBeGreaterThan(0.85);
    expect(darkOf(night)).toBeLessThan(0.3);
  });
});
