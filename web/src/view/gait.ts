import { Vector3 } from 'three';

/** Joints of a figure of 1.75 m in its own frame: x ahead, y left, z up, the ground at 0. [m] */
export type Joints = Record<
  'pelvis' | 'chest' | 'head' | `${'hip' | 'knee' | 'ankle' | 'toe' | 'shoulder' | 'elbow' | 'hand'}${'Left' | 'Right'}`,
  Vector3
>;

const kStride = 1.35; // m, two steps
const kFullSwing = 1.3; // m/s, from which on legs swing as far as they do
const kSwing = 0.5; // rad, of a thigh to each side
const kSettle = 6; // 1/s
const kJump = 0.5; // m between two pictures: that is no step
const kStill = 0.02; // m/s
const [kThigh, kShin, kSole, kFoot] = [0.44, 0.44, 0.07, 0.17]; // m
const [kUpperArm, kForearm] = [0.28, 0.26]; // m

/** How somebody walks: where in a stride, and how far limbs swing. */
export class Gait {
  phase = 0; // rad; a stride is a turn
  speed = 0; // m/s ahead, smoothed
  aside = 0; // m/s to the left, smoothed

  constructor(
    private x: number,
    private y: number,
  ) {}

  /** Has come to x, y, heading a, after so many seconds. False when it stands still. */
  walk(x: number, y: number, a: number, seconds: number): boolean {
    const [dx, dy] = [x - this.x, y - this.y];
    [this.x, this.y] = [x, y];
    if (seconds <= 0) return false;
    const near = Math.hypot(dx, dy) < kJump;
    const ahead = near ? Math.cos(a) * dx + Math.sin(a) * dy : 0;
    const left = near ? Math.cos(a) * dy - Math.sin(a) * dx : 0;
    const t = 1 - Math.exp(-kSettle * seconds);
    this.speed += t * (ahead / seconds - this.speed);
    this.aside += t * (left / seconds - this.aside);
    this.phase += (2 * Math.PI * (Math.abs(ahead) > Math.abs(left) ? ahead : Math.abs(left))) / kStride;
    return Math.hypot(this.speed, this.aside) > kStill;
  }

  /** How far limbs swing, 0 to 1. */
  get swing(): number {
    return Math.min(Math.hypot(this.speed, this.aside) / kFullSwing, 1);
  }
}

export function gaitOf(x: number, y: number): Gait {
  return new Gait(x, y);
}

/** The joints at this moment of a stride. The lower foot stands on the ground, so that hips rise and sink. */
export function poseOf(gait: Gait): Joints {
  const swing = gait.swing;
  const left = legOf(gait.phase, swing);
  const right = legOf(gait.phase + Math.PI, swing);
  const hips = Math.max(left.reach, right.reach);
  const at = (x: number, y: number, z: number) => new Vector3(x, y, z);
  const lean = 0.06 * swing;
  const joints: Partial<Joints> = {
    pelvis: at(0, 0, hips + 0.06),
    chest: at(lean, 0, hips + 0.48),
    head: at(lean + 0.02, 0, hips + 0.72),
  };
  for (const [side, y, leg, arm] of [['Left', 1, left, right], ['Right', -1, right, left]] as const) {
    const hip = at(0, 0.1 * y, hips);
    const knee = hip.clone().add(at(kThigh * Math.sin(leg.thigh), 0, -kThigh * Math.cos(leg.thigh)));
    const ankle = knee.clone().add(at(kShin * Math.sin(leg.shin), 0, -kShin * Math.cos(leg.shin)));
    const shoulder = at(lean, 0.2 * y, hips + 0.5);
    const forearm = 0.8 * arm.thigh + 0.25 + 0.3 * swing;
    const elbow = shoulder.clone().add(at(kUpperArm * Math.sin(0.8 * arm.thigh), 0.03 * y, -kUpperArm * Math.cos(0.8 * arm.thigh)));
    const hand = elbow.clone().add(at(kForearm * Math.sin(forearm), 0, -kForearm * Math.cos(forearm)));
    const toe = ankle.clone().add(at(kFoot * Math.cos(leg.shin), 0, kFoot * Math.sin(leg.shin) - 0.03));
    Object.assign(joints, {
      [`hip${side}`]: hip, [`knee${side}`]: knee, [`ankle${side}`]: ankle, [`toe${side}`]: toe,
      [`shoulder${side}`]: shoulder, [`elbow${side}`]: elbow, [`hand${side}`]: hand,
    });
  }
  return joints as Joints;
}

interface Leg {
  thigh: number; // rad from straight down, ahead
  shin: number; // the same
  reach: number; // m from the hip down to the sole
}

/** A leg swings ahead with its knee bent, and back straight. */
function legOf(phase: number, swing: number): Leg {
  const thigh = kSwing * swing * Math.sin(phase);
  const shin = thigh - swing * (0.1 + 0.9 * Math.max(0, Math.cos(phase)));
  return { thigh, shin, reach: kThigh * Math.cos(thigh) + kShin * Math.cos(shin) + kSole };
}
