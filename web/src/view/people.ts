import { CapsuleGeometry, Color, DynamicDrawUsage, Group, InstancedMesh, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3, type BufferGeometry } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import { gaitOf, poseOf, type Gait, type Joints } from './gait';

const kSkin = 0xe0b394;
const kTrousers = 0x2f3a4a;
const kHair = 0x3b2a20;
const kShoes = 0x20242b;
const kHeight = 1.75; // m, that the figure is drawn at; others are scaled
const kUp = new Vector3(0, 1, 0); // along a capsule

/** A part of the figure, between two joints; those with the model's colour wear it as a shirt. */
interface Limb {
  from: keyof Joints;
  to: keyof Joints;
  radius: number; // m
  length: number; // m
  color: number | 'own';
}

const kLimbs: Limb[] = [
  { from: 'pelvis', to: 'chest', radius: 0.13, length: 0.4, color: 'own' },
  { from: 'shoulderLeft', to: 'shoulderRight', radius: 0.07, length: 0.34, color: 'own' },
  { from: 'chest', to: 'head', radius: 0.05, length: 0.2, color: kSkin },
  ...(['Left', 'Right'] as const).flatMap((side): Limb[] => [
    { from: `shoulder${side}`, to: `elbow${side}`, radius: 0.05, length: 0.28, color: 'own' },
    { from: `elbow${side}`, to: `hand${side}`, radius: 0.04, length: 0.26, color: kSkin },
    { from: `hip${side}`, to: `knee${side}`, radius: 0.075, length: 0.44, color: kTrousers },
    { from: `knee${side}`, to: `ankle${side}`, radius: 0.055, length: 0.44, color: kTrousers },
    { from: `ankle${side}`, to: `toe${side}`, radius: 0.045, length: 0.17, color: kShoes },
  ]),
];

/** Everybody who walks, as a figure of capsules that steps as fast as it moves. */
export class People {
  readonly group = new Group();
  /** Who is not drawn: the one through whose eyes one looks. */
  hidden: number | null = null;

  private readonly rows: number[];
  private readonly gaits = new Map<number, Gait>();
  private readonly limbs: InstancedMesh[];
  private readonly heads: InstancedMesh;
  private readonly hairs: InstancedMesh;
  private readonly color = new Color();

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
    before: People | null = null,
  ) {
    this.rows = [...scene.models.keys()].filter((row) => isPerson(scene, row));
    for (const row of this.rows) {
      const was = before?.replica.rows.get(scene.models[row].id);
      this.gaits.set(row, (was === undefined ? undefined : before?.gaits.get(was)) ?? gaitOf(motion.x[row], motion.y[row]));
    }
    this.limbs = kLimbs.map(({ radius, length, color }) => this.instances(new CapsuleGeometry(radius, length, 4, 10), color));
    this.heads = this.instances(new SphereGeometry(0.11, 16, 12), kSkin);
    this.hairs = this.instances(new SphereGeometry(0.115, 16, 8, 0, 2 * Math.PI, 0, 1.5).rotateX(Math.PI / 2), kHair);
    this.paint();
    this.move(0);
  }

  /** Figures where the motion says, after so much time; false when nobody's limbs move. */
  move(seconds: number): boolean {
    let moves = false;
    this.rows.forEach((row, k) => {
      const gait = this.gaits.get(row)!;
      moves = gait.walk(this.motion.x[row], this.motion.y[row], this.motion.a[row], seconds) || moves;
      this.place(row, k, poseOf(gait));
    });
    for (const mesh of this.meshes()) mesh.instanceMatrix.needsUpdate = true;
    return moves;
  }

  /** Takes over the colours that changed. */
  paint(): void {
    kLimbs.forEach(({ color }, limb) => {
      if (color !== 'own' || this.rows.length === 0) return;
      this.rows.forEach((row, k) => this.limbs[limb].setColorAt(k, this.color.setHex(this.replica.color[row] >>> 8)));
      this.limbs[limb].instanceColor!.needsUpdate = true;
    });
  }

  dispose(): void {
    for (const mesh of this.meshes()) {
      mesh.geometry.dispose();
      (mesh.material as MeshLambertMaterial).dispose();
      mesh.dispose();
    }
  }

  private meshes(): InstancedMesh[] {
    return [...this.limbs, this.heads, this.hairs];
  }

  private instances(geometry: BufferGeometry, color: number | 'own'): InstancedMesh {
    const mesh = new InstancedMesh(geometry, new MeshLambertMaterial({ color: color === 'own' ? 0xffffff : color }), this.rows.length);
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    this.group.add(mesh);
    return mesh;
  }

  private place(row: number, k: number, joints: Joints): void {
    const { motion } = this;
    const size = row === this.hidden ? 0 : this.scene.models[row].size[2] / kHeight;
    const body = new Matrix4().makeRotationZ(motion.a[row]).scale(new Vector3(size, size, size));
    body.setPosition(motion.x[row], motion.y[row], motion.z[row]);
    kLimbs.forEach(({ from, to }, limb) => this.limbs[limb].setMatrixAt(k, body.clone().multiply(between(joints[from], joints[to]))));
    const head = body.clone().multiply(new Matrix4().setPosition(joints.head));
    this.heads.setMatrixAt(k, head);
    this.hairs.setMatrixAt(k, head);
  }
}

export function isPerson(scene: Scene, row: number): boolean {
  return scene.models[row].drive === 'walk';
}

/** A capsule from one joint to another. */
function between(from: Vector3, to: Vector3): Matrix4 {
  const along = to.clone().sub(from).normalize();
  return new Matrix4().makeRotationFromQuaternion(new Quaternion().setFromUnitVectors(kUp, along)).setPosition(from.clone().add(to).multiplyScalar(0.5));
}
