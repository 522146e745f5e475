import { Color, Group, type Light, Matrix4, PointLight, SpotLight, Vector3 } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { MeshLight, Pose, Scene } from '../protocol/scene';
import { bodyMatrix } from './frames';
import { isLit } from './surfaces';

const kMost = 16; // maximum per type, as for camera images
const kMid: Pose = [0, 0, 0, 0];

/** A lit lamp: position, colour times candela, and the cone of a spot light. */
export interface Shining {
  at: Vector3;
  light: Color;
  spot?: { way: Vector3; inner: number; outer: number }; // unit vector; rad
}

/** The lamps of a scene that contribute most at the eye. */
export class Lamps {
  readonly group = new Group();
  private points: PointLight[] = [];
  private spots: SpotLight[] = [];

  /** Allocates lights for the scene up front: a change of their number recompiles all shaders. */
  prepare(scene: Scene): void {
    const { points, spots } = lightsOf(scene);
    if (points === this.points.length && spots === this.spots.length) return;
    for (const light of [...this.points, ...this.spots]) light.dispose();
    this.points = Array.from({ length: points }, () => new PointLight(0xffffff, 0, 0, 2));
    this.spots = Array.from({ length: spots }, () => new SpotLight(0xffffff, 0, 0, 0.5, 0, 2));
    this.group.clear();
    for (const light of this.points) this.group.add(light);
    for (const light of this.spots) this.group.add(light, light.target);
  }

  /** Assigns the lights to lit lamps. */
  place(scene: Scene, replica: Replica, motion: Motion, eye: { x: number; y: number; z: number }): void {
    if (!scene.light || this.points.length + this.spots.length === 0) return;
    const intensity = Math.PI / scene.light.white_lux; // Lambertian: radiance = irradiance / pi
    const from = new Vector3(eye.x, eye.y, eye.z);
    const shining = shiningIn(scene, replica, motion);
    const points = brightest(shining.filter(({ spot }) => !spot), from, this.points.length);
    this.points.forEach((light, k) => shine(light, points[k], intensity));
    const spots = brightest(shining.filter(({ spot }) => spot), from, this.spots.length);
    this.spots.forEach((light, k) => {
      shine(light, spots[k], intensity);
      if (spots[k]?.spot) aim(light, spots[k].spot);
    });
  }
}

function lightsOf(scene: Scene): { points: number; spots: number } {
  let points = 0;
  let spots = 0;
  for (const { lamp, lights } of scene.models) {
    if (lamp !== undefined) ++points;
    for (const { way } of lights ?? []) way ? ++spots : ++points;
  }
  return { points: Math.min(points, kMost), spots: Math.min(spots, kMost) };
}

function shine(light: Light, lamp: Shining | undefined, intensity: number): void {
  light.intensity = lamp ? intensity : 0;
  if (!lamp) return;
  light.position.copy(lamp.at);
  light.color.copy(lamp.light);
}

function aim(light: SpotLight, spot: NonNullable<Shining['spot']>): void {
  light.angle = spot.outer;
  light.penumbra = spot.outer > 0 ? 1 - spot.inner / spot.outer : 0;
  light.target.position.copy(light.position).add(spot.way);
}

function shiningIn(scene: Scene, replica: Replica, motion: Motion): Shining[] {
  const matrix = new Matrix4();
  const shining: Shining[] = [];
  scene.models.forEach((model, row) => {
    const isLamp = model.lamp !== undefined && isLit(model, replica.state[row]);
    if (!isLamp && !model.lights) return;
    bodyMatrix(motion, row, model.origin ?? kMid, matrix);
    if (isLamp) {
      const at = new Vector3(0, 0, model.size[2] / 2).applyMatrix4(matrix);
      shining.push({ at, light: new Color(replica.color[row] >>> 8).multiplyScalar(model.lamp!) });
    }
    for (const light of model.lights ?? []) shining.push(ofMesh(light, matrix));
  });
  return shining;
}

/** World position of a mesh's light, given its body's transform. */
export function ofMesh({ p, candela, way, inner, outer }: MeshLight, body: Matrix4): Shining {
  const shining: Shining = { at: new Vector3(...p).applyMatrix4(body), light: new Color(...candela) };
  if (way) shining.spot = { way: new Vector3(...way).transformDirection(body), inner: inner ?? 0, outer: outer ?? 0 };
  return shining;
}

/** The `most` lamps with the highest illuminance at the eye. */
export function brightest(lamps: Shining[], eye: Vector3, most: number): Shining[] {
  if (lamps.length <= most) return lamps;
  const there = ({ at, light }: Shining) => (light.r + light.g + light.b) / Math.max(at.distanceToSquared(eye), 1e-4);
  return [...lamps].sort((a, b) => there(b) - there(a)).slice(0, most);
}
