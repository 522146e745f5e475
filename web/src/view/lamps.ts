import { Color, Group, Matrix4, PointLight, Vector3 } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Pose, Scene } from '../protocol/scene';
import { bodyMatrix } from './frames';
import { isLit } from './surfaces';

const kMost = 16; // as cameras have them
const kMid: Pose = [0, 0, 0, 0];

/** A lamp that is lit: where it is, its color times its candela. */
export interface Shining {
  at: Vector3;
  light: Color;
}

/** The lamps of a scene that are brightest where the eye is, as point lights. */
export class Lamps {
  readonly group = new Group();
  private lights: PointLight[] = [];

  /** As many lights as the scene may need: another number of them has every shader compiled again. */
  prepare(scene: Scene): void {
    const count = Math.min(scene.models.filter(({ lamp }) => lamp !== undefined).length, kMost);
    if (count === this.lights.length) return;
    for (const light of this.lights) light.dispose();
    this.lights = Array.from({ length: count }, () => new PointLight(0xffffff, 0, 0, 2));
    this.group.clear();
    if (count > 0) this.group.add(...this.lights);
  }

  /** Puts the lights where the lamps are that are lit now. */
  place(scene: Scene, replica: Replica, motion: Motion, eye: { x: number; y: number; z: number }): void {
    if (!scene.light) return;
    const intensity = Math.PI / scene.light.white_lux; // a white face returns 1 / pi of it
    const shining = brightest(shiningIn(scene, replica, motion), new Vector3(eye.x, eye.y, eye.z), this.lights.length);
    this.lights.forEach((light, k) => {
      const lamp = shining[k];
      light.intensity = lamp ? intensity : 0;
      if (!lamp) return;
      light.position.copy(lamp.at);
      light.color.copy(lamp.light);
    });
  }
}

function shiningIn(scene: Scene, replica: Replica, motion: Motion): Shining[] {
  const matrix = new Matrix4();
  const shining: Shining[] = [];
  scene.models.forEach((model, row) => {
    if (model.lamp === undefined || !isLit(model, replica.state[row])) return;
    const at = new Vector3(0, 0, model.size[2] / 2).applyMatrix4(bodyMatrix(motion, row, model.origin ?? kMid, matrix));
    shining.push({ at, light: new Color(replica.color[row] >>> 8).multiplyScalar(model.lamp) });
  });
  return shining;
}

/** The first `most` by how bright they are at the eye. */
export function brightest(lamps: Shining[], eye: Vector3, most: number): Shining[] {
  if (lamps.length <= most) return lamps;
  const there = ({ at, light }: Shining) => (light.r + light.g + light.b) / Math.max(at.distanceToSquared(eye), 1e-4);
  return [...lamps].sort((a, b) => there(b) - there(a)).slice(0, most);
}
