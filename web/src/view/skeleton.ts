import { Bone } from 'three';

export type Side = 'Left' | 'Right';
export const kSides: [Side, 1 | -1][] = [['Left', 1], ['Right', -1]];
export type BoneName = 'pelvis' | 'spine' | 'chest' | 'neck' | 'head' | `${'arm' | 'forearm' | 'hand' | 'thigh' | 'shin' | 'foot'}${Side}`;

export const kHeight = 1.75; // m, of the reference figure; others are scaled
export const kHip = 0.9; // m above the ground
export const kThigh = 0.42; // m
export const kShin = 0.4; // m
export const kSole = 0.08; // m from the ankle down

type Joint = [name: BoneName, parent: BoneName | null, x: number, y: number, z: number];

/** Joints of a standing person: x ahead, y left, z up, ground at 0. [m] */
export const kJoints: Joint[] = [
  ['pelvis', null, 0, 0, 0.96],
  ['spine', 'pelvis', 0, 0, 1.06],
  ['chest', 'spine', 0, 0, 1.22],
  ['neck', 'chest', -0.01, 0, 1.48],
  ['head', 'neck', 0, 0, 1.55],
  ...kSides.flatMap(([side, y]): Joint[] => [
    [`arm${side}`, 'chest', -0.005, 0.175 * y, 1.42],
    [`forearm${side}`, `arm${side}`, -0.005, 0.2 * y, 1.14],
    [`hand${side}`, `forearm${side}`, 0, 0.215 * y, 0.89],
    [`thigh${side}`, 'pelvis', 0, 0.09 * y, kHip],
    [`shin${side}`, `thigh${side}`, 0, 0.09 * y, kHip - kThigh],
    [`foot${side}`, `shin${side}`, 0, 0.09 * y, kSole],
  ]),
];

export const kBoneIndex = new Map(kJoints.map(([name], k) => [name, k]));

/** Bones in the order of kJoints; the first is the root. */
export function makeBones(): Bone[] {
  const bones: Bone[] = [];
  for (const [name, parent, x, y, z] of kJoints) {
    const bone = new Bone();
    bone.name = name;
    bone.rotation.order = 'ZXY'; // yaw, then roll, then pitch
    const above = parent === null ? null : kBoneIndex.get(parent)!;
    const [, , px, py, pz] = above === null ? [0, 0, 0, 0, 0] : kJoints[above];
    bone.position.set(x - px, y - py, z - pz);
    if (above !== null) bones[above].add(bone);
    bones.push(bone);
  }
  return bones;
}
