import type { Bone } from 'three';
import { smooth, strideOf, type Gait } from './gait';
import { kBoneIndex, kHip, kJoints, kShin, kSides, kSole, kThigh, type BoneName } from './skeleton';

const kLeg = 0.8185; // m, length of the slightly bent standing leg
const kLegRun = 0.79;
const kLift = 0.09; // m, foot clearance when walking
const kLiftRun = 0.2;
const kWaveRate = 1.7; // 1/s

interface Foot {
  x: number; // m, of the ankle relative to the hip
  y: number;
  z: number; // m above its position at rest
  pitch: number; // rad, toes up
}

/** Foot trajectory: stance at ground speed backwards, then swing ahead. */
function footOf(gait: Gait, phase: number, y: number): Foot {
  const { walking, running, stepping } = gait;
  const turns = phase / (2 * Math.PI);
  const u = turns - Math.floor(turns);
  const reach = strideOf(gait.pace) / 4; // a standing foot travels half a stride relative to the body
  const swings = u >= 0.5;
  const t = (u - 0.5) * 2;
  const along = walking * reach * (swings ? -1 + 2 * smooth(t) : 1 - 4 * u);
  const lift = (walking * (kLift + running * (kLiftRun - kLift)) + 0.06 * stepping) * (swings ? Math.sin(Math.PI * t) ** 2 : 0);
  const pace = Math.max(gait.pace, 1e-6);
  // Toes point down at lift-off and up at landing.
  const tip = walking * (gait.speed / pace) * (swings ? -0.55 * Math.sin(Math.PI * Math.min(2 * t, 1)) * (1 - t) + 0.25 * Math.sin(Math.PI * t) * t : 0);
  return { x: (along * gait.speed) / pace, y: y + (0.45 * along * gait.aside) / pace, z: lift, pitch: tip };
}

/**
 * Poses the bones by gait (standing, breathing, walking, running, turning in
 * place) and `wave` (0 to 1). The pelvis height follows from the standing leg.
 */
export function pose(bones: Bone[], gait: Gait, wave: number): void {
  const { walking, running, stepping, age, phase } = gait;
  const still = 1 - Math.max(walking, stepping);
  const bone = (name: BoneName) => bones[kBoneIndex.get(name)!];
  const rest = (name: BoneName) => kJoints[kBoneIndex.get(name)!];
  const backwards = gait.speed < 0 ? -1 : 1;
  const breath = Math.sin(1.5 * age);
  const feet = { Left: footOf(gait, phase, 0), Right: footOf(gait, phase + Math.PI, 0) };
  const stands = feet.Left.z <= feet.Right.z ? feet.Left : feet.Right;
  const leg = kLeg + Math.max(running, 0) * (kLegRun - kLeg);
  const hips = kSole + Math.sqrt(Math.max(leg ** 2 - stands.x ** 2 - stands.y ** 2, 0.3)) + running * 0.035 * (1 - Math.cos(2 * phase));
  const sway = still * 0.008 * Math.sin(0.8 * age) + walking * 0.018 * Math.sin(phase);
  const lean = walking * 0.04 * backwards + running * 0.12;
  const twist = (walking * 0.1 + running * 0.08) * Math.cos(phase) * backwards;

  const pelvis = bone('pelvis');
  pelvis.position.set(-lean * 0.1, sway, hips + rest('pelvis')[4] - kHip);
  pelvis.rotation.set(0, lean * 0.4, twist);
  bone('spine').rotation.set(-sway * 0.8, lean * 0.4 + 0.012 * breath * still, -twist * 0.9);
  bone('chest').rotation.set(0, lean * 0.2 - 0.018 * breath * still, -twist * 0.9);
  const glance = Math.min(Math.max(0.2 * gait.turning, -0.5), 0.5) + still * 0.1 * Math.sin(0.31 * age);
  bone('neck').rotation.set(0, -lean * 0.5, (glance + twist * 0.8) / 2);
  bone('head').rotation.set(wave * 0.05, -lean * 0.5 - 0.01 * breath * still, (glance + twist * 0.8) / 2);

  for (const [side, y] of kSides) {
    bendLeg(bone(`thigh${side}`), bone(`shin${side}`), bone(`foot${side}`), feet[side], { x: pelvis.position.x, y: sway, z: hips, lean: lean * 0.4, twist });
    const swing = Math.sin(2 * Math.PI * (phase / (2 * Math.PI) + (side === 'Left' ? 0.75 : 0.25))) * backwards;
    const amount = walking * (0.42 + 0.4 * running);
    const out = 0.06 + 0.03 * running + 0.01 * breath * still;
    bone(`arm${side}`).rotation.set(y * out, -amount * swing + 0.03 * still + running * 0.25, 0);
    bone(`forearm${side}`).rotation.set(0, -(0.16 + 0.2 * walking + 1.3 * running + 0.1 * amount * swing), 0);
    bone(`hand${side}`).rotation.set(0, -0.1, 0);
  }
  if (wave > 0) waveRight(bone, wave, age);
}

/** Raises the right arm and waves the forearm. */
function waveRight(bone: (name: BoneName) => Bone, wave: number, age: number): void {
  const blend = (name: BoneName, x: number, y: number, z: number) => {
    const { rotation } = bone(name);
    rotation.set(rotation.x + wave * (x - rotation.x), rotation.y + wave * (y - rotation.y), rotation.z + wave * (z - rotation.z));
  };
  const beat = Math.sin(2 * Math.PI * kWaveRate * age);
  blend('armRight', -1.75, -0.35, 0);
  blend('forearmRight', -1.15 + 0.42 * beat, 0, 0);
  blend('handRight', 0.18 * beat, 0, 0);
}

interface Hips {
  x: number;
  y: number;
  z: number;
  lean: number;
  twist: number;
}

/** Two-bone inverse kinematics of hip and ankle (law of cosines); the knee bends ahead. */
function bendLeg(thigh: Bone, shin: Bone, foot: Bone, to: Foot, hips: Hips): void {
  const [dx, dy, dz] = [to.x - hips.x, to.y - hips.y, to.z + kSole - hips.z];
  const far = Math.min(Math.hypot(dx, dy, dz), kThigh + kShin - 1e-4);
  const roll = Math.atan2(dy, -dz);
  const pitch = Math.atan2(dx, Math.hypot(dy, dz));
  const atHip = Math.acos(Math.min((kThigh ** 2 + far ** 2 - kShin ** 2) / (2 * kThigh * far), 1));
  const atKnee = Math.PI - Math.acos(Math.max(-1, Math.min((kThigh ** 2 + kShin ** 2 - far ** 2) / (2 * kThigh * kShin), 1)));
  thigh.rotation.set(roll, -(pitch + atHip) - hips.lean, -hips.twist);
  shin.rotation.set(0, atKnee, 0);
  foot.rotation.set(-roll, pitch + atHip - atKnee - to.pitch, 0);
}
