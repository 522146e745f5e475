import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { makeFigure } from './figure_body';
import { pose } from './figure_pose';
import { Gait, gaitOf } from './gait';
import { kBoneIndex, kSole, makeBones, type BoneName } from './skeleton';

const kStep = 1 / 120; // s

/** Bones of somebody who stands at the origin, posed. */
class Body {
  readonly bones = makeBones();
  pose(gait: Gait, wave = 0): void {
    pose(this.bones, gait, wave);
    this.bones[0].updateMatrixWorld(true);
  }
  at(name: BoneName): Vector3 {
    return new Vector3().setFromMatrixPosition(this.bones[kBoneIndex.get(name)!].matrixWorld);
  }
}

/** Feet of somebody who walks so fast, in the world, one by one picture. */
function walk(vx: number, vy: number, seconds: number): { left: Vector3; right: Vector3 }[] {
  const gait = gaitOf(0, 0);
  const body = new Body();
  return Array.from({ length: Math.round(seconds / kStep) }, (_, k) => {
    const t = (k + 1) * kStep;
    gait.walk(vx * t, vy * t, 0, kStep);
    body.pose(gait);
    const moved = new Vector3(vx * t, vy * t, 0);
    return { left: body.at('footLeft').add(moved), right: body.at('footRight').add(moved) };
  });
}

describe('pose', () => {
  it('stands with both feet on the ground and the eyes at the height of a person', () => {
    const body = new Body();
    body.pose(gaitOf(0, 0));
    for (const foot of ['footLeft', 'footRight'] as const) expect(body.at(foot).z).toBeCloseTo(kSole, 3);
    expect(body.at('head').z).toBeGreaterThan(1.5);
    expect(body.at('head').z).toBeLessThan(1.6);
  });

  it('does not let a foot slide that stands', () => {
    for (const speed of [0.6, 1, 1.4, -0.7]) {
      const steps = walk(speed, 0, 4).slice(-240);
      let [slid, stood] = [0, 0];
      for (const side of ['left', 'right'] as const) {
        for (let k = 1; k < steps.length; ++k) {
          const [before, now] = [steps[k - 1][side], steps[k][side]];
          if (before.z > kSole + 0.004 || now.z > kSole + 0.004) continue;
          slid += Math.abs(now.x - before.x);
          stood += kStep;
        }
      }
      expect(stood).toBeGreaterThan(1); // of four seconds of two feet
      expect(slid / stood, `at ${speed} m/s`).toBeLessThan(0.15 * Math.abs(speed));
    }
  });

  it('always has a foot on the ground, and none below it, but in a run', () => {
    for (const [vx, vy] of [[0.8, 0], [1.4, 0], [0, 0.7], [-0.8, 0.3]]) {
      for (const { left, right } of walk(vx, vy, 3)) {
        expect(Math.min(left.z, right.z)).toBeGreaterThan(kSole - 0.01);
        expect(Math.min(left.z, right.z)).toBeLessThan(kSole + 0.03);
      }
    }
  });

  it('raises the right hand above the head to wave, and to and fro', () => {
    const body = new Body();
    const gait = gaitOf(0, 0);
    const hands: number[] = [];
    for (let k = 0; k < 120; ++k) {
      gait.walk(0, 0, 0, 1 / 60);
      body.pose(gait, 1);
      expect(body.at('handRight').z).toBeGreaterThan(body.at('head').z - 0.05);
      expect(body.at('handLeft').z).toBeLessThan(1);
      hands.push(body.at('handRight').y);
    }
    expect(Math.max(...hands) - Math.min(...hands)).toBeGreaterThan(0.12);
  });
});

describe('makeFigure', () => {
  it('is a person of 1.75 m on two soles, whose corners hang on bones', () => {
    for (const [corners, full, least, most] of [[18, true, 3000, 8000], [7, false, 300, 1500]] as const) {
      const geometry = makeFigure({ corners, full });
      geometry.computeBoundingBox();
      const { min, max } = geometry.boundingBox!;
      expect(min.z).toBeCloseTo(0, 2);
      expect(max.z).toBeGreaterThan(1.74);
      expect(max.z).toBeLessThan(1.78);
      const triangles = geometry.index!.count / 3;
      expect(triangles).toBeGreaterThan(least);
      expect(triangles).toBeLessThan(most);
      const { skinWeight, position } = geometry.attributes;
      for (let k = 0; k < position.count; ++k) {
        const sum = skinWeight.getX(k) + skinWeight.getY(k) + skinWeight.getZ(k) + skinWeight.getW(k);
        expect(sum).toBeCloseTo(1, 5);
      }
    }
  });
});
