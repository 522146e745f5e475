import { describe, expect, it } from 'vitest';
import { CameraRig } from './camera_rig';
import { Flight } from './flight';

const kStill = { forward: 0, sideways: 0, turn: 0 };

describe('Flight', () => {
  it('goes where it looks, aside and up, and not below the ground', () => {
    const flight = new Flight({ x: 0, y: 0, z: 2, yaw: Math.PI / 2, pitch: -0.5 });
    expect(flight.move({ ...kStill, forward: 1 }, 0.25)).toBe(true);
    expect(flight.eye.x).toBeCloseTo(0);
    expect(flight.eye.y).toBeCloseTo(Math.cos(0.5));
    expect(flight.eye.z).toBeCloseTo(2 - Math.sin(0.5));
    flight.move({ ...kStill, turn: 1 }, 0.25);
    expect(flight.eye.x).toBeCloseTo(-1);
    flight.move({ ...kStill, sideways: 1 }, 1);
    expect(flight.eye.z).toBeGreaterThan(5);
    flight.move({ ...kStill, sideways: -1 }, 60);
    expect(flight.eye.z).toBe(0.05);
    expect(flight.move(kStill, 1)).toBe(false);
  });

  it('looks where the mouse goes, and never over its back; the wheel makes it faster within bounds', () => {
    const flight = new Flight({ x: 0, y: 0, z: 2, yaw: 0, pitch: 0 });
    flight.look(-400, 1e5);
    expect(flight.eye.yaw).toBeCloseTo(1);
    expect(flight.eye.pitch).toBeCloseTo(-1.5);
    flight.faster(1e9);
    expect(flight.speed).toBe(200);
  });

  it('begins where the world is looked at from, whatever the tilt', () => {
    for (const pitch of [0, 0.8]) {
      const rig = new CameraRig();
      rig.resize(1200, 800);
      Object.assign(rig, { x: 3, y: -2, scale: 80, yaw: 0.7, pitch });
      rig.update(0);
      const eye = rig.eyeHere();
      rig.eye = eye;
      rig.update(0);
      const seen = rig.pixelOf(3, -2, 0)!;
      expect(seen.x).toBeCloseTo(600, 3);
      expect(seen.y).toBeCloseTo(400, 3);
    }
  });
});
