import { describe, expect, it } from 'vitest';
import { CameraRig, kTilted } from './camera_rig';

const kMargins = { left: 250, right: 20, top: 80, bottom: 60 };

describe('CameraRig.fit', () => {
  for (const pitch of [0, 0.4, kTilted, 1.2]) {
    for (const yaw of [0, 0.7]) {
      it(`shows all of a box within the margins and wastes little, pitch ${pitch}, yaw ${yaw}`, () => {
        const rig = new CameraRig();
        rig.resize(1280, 800);
        Object.assign(rig, { pitch, yaw });
        rig.fit({ x_min: -6, x_max: 10, y_min: 1, y_max: 9 }, kMargins, 'jump');
        rig.update(0);
        const corners = [[-6, 1], [10, 1], [10, 9], [-6, 9]].map(([x, y]) => rig.pixelOf(x, y, 0)!);
        const xs = corners.map(({ x }) => x);
        const ys = corners.map(({ y }) => y);
        const slack = 6;
        expect(Math.min(...xs)).toBeGreaterThan(kMargins.left - slack);
        expect(Math.max(...xs)).toBeLessThan(1280 - kMargins.right + slack);
        expect(Math.min(...ys)).toBeGreaterThan(kMargins.top - slack);
        expect(Math.max(...ys)).toBeLessThan(800 - kMargins.bottom + slack);
        const used = Math.max((Math.max(...xs) - Math.min(...xs)) / 1010, (Math.max(...ys) - Math.min(...ys)) / 660);
        expect(used).toBeGreaterThan(0.9);
      });
    }
  }

  it('shows a metre around a point', () => {
    const rig = new CameraRig();
    rig.resize(1280, 800);
    rig.fit({ x_min: 3, x_max: 3, y_min: 3, y_max: 3 }, kMargins, 'jump');
    expect(rig.scale).toBeCloseTo(660, 0);
  });
});

describe('CameraRig.tilt', () => {
  for (const yaw of [0.35, 3, 6.5, -2]) {
    it(`shows what is from above with +y up and +x right, after a view turned by ${yaw}`, () => {
      const rig = new CameraRig();
      rig.resize(1280, 800);
      Object.assign(rig, { pitch: 0.6, yaw, x: 2, y: 1 });
      rig.tilt();
      for (let k = 0; k < 100 && rig.update(0.1); ++k);
      const [middle, north, east] = [rig.pixelOf(2, 1, 0)!, rig.pixelOf(2, 2, 0)!, rig.pixelOf(3, 1, 0)!];
      expect([north.x - middle.x, north.y - middle.y]).toEqual([expect.closeTo(0, 6), expect.closeTo(-rig.scale, 6)]);
      expect([east.x - middle.x, east.y - middle.y]).toEqual([expect.closeTo(rig.scale, 6), expect.closeTo(0, 6)]);
      rig.tilt();
      for (let k = 0; k < 100 && rig.update(0.1); ++k);
      expect(rig.pitch).toBe(kTilted);
    });
  }
});

describe('CameraRig.showFrom', () => {
  const rig = new CameraRig();
  rig.resize(200, 100);
  Object.assign(rig, { pitch: 1, yaw: 2 });
  rig.glideTo({ x: 50 });
  rig.showFrom(-3, 7, 20);

  it('has the corner at the top left, north up and so many pixels to a metre, and stays there', () => {
    expect(rig.update(1)).toBe(false);
    for (const z of [-1, 0, 5]) {
      const [corner, inside] = [rig.pixelOf(-3, 7, z)!, rig.pixelOf(-2, 4, z)!];
      expect([corner.x, corner.y]).toEqual([expect.closeTo(0, 6), expect.closeTo(0, 6)]);
      expect([inside.x, inside.y]).toEqual([expect.closeTo(20, 6), expect.closeTo(60, 6)]);
    }
  });

  it('shows what is higher than the picture is wide', () => {
    expect(rig.pixelOf(0, 5, 900)).not.toBeNull();
  });
});
