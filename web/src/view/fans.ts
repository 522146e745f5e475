import { Color, Group } from 'three';
import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Pose, Rgba, Scene, Sensor } from '../protocol/scene';
import { Painted } from './painted';
import type { Theme } from './theme';

const kConeSteps = 6;
const kSensorsManyMost = 1500; // beyond, cones are plain triangles
const kLayersMost = 1; // scans on top of each other; beyond, they get fainter, so that robots stay visible
const kRoom = 8; // m, of floor around them
const kGap = 0.4; // m: a longer step between two beams is no surface

/** A sensor's place in the world at this moment. */
export interface SensorPose {
  x: number;
  y: number;
  z: number;
  a: number;
}

export function sensorPose(motion: Motion, model: number, origin: Pose | undefined, sensor: Sensor): SensorPose {
  let { x, y, z, a } = { x: motion.x[model], y: motion.y[model], z: motion.z[model], a: motion.a[model] };
  for (const pose of [origin, sensor.pose]) {
    if (!pose) continue;
    const c = Math.cos(a);
    const s = Math.sin(a);
    [x, y] = [x + c * pose[0] - s * pose[1], y + s * pose[0] + c * pose[1]];
    z += pose[2];
    a += pose[3];
  }
  return { x, y, z: z + sensor.size[2] / 2, a };
}

/** Bearing of beam k of a sensor: the first is rightmost, a single one looks ahead. */
export function bearingOf(sensor: Sensor, k: number): number {
  return sensor.samples < 2 ? 0 : -sensor.fov / 2 + (k * sensor.fov) / (sensor.samples - 1);
}

/** How much floor scans cover, and how often. */
class Cover {
  private area = 0; // m^2, of all scans
  private left = Infinity;
  private right = -Infinity;
  private low = Infinity;
  private high = -Infinity;

  add(at: SensorPose, sensor: Sensor, beams: Uint16Array): void {
    const unit = sensor.range[1] / 65535;
    let squares = 0;
    for (const beam of beams) squares += beam * beam;
    this.area += ((squares / beams.length) * unit * unit * sensor.fov) / 2;
    this.left = Math.min(this.left, at.x);
    this.right = Math.max(this.right, at.x);
    this.low = Math.min(this.low, at.y);
    this.high = Math.max(this.high, at.y);
  }

  /** On average, between the outermost sensors; a few robots close together are not a crowd. */
  layers(): number {
    const floor = (this.right - this.left + kRoom) * (this.high - this.low + kRoom);
    return this.area > 0 ? this.area / floor : 0;
  }
}

/** Laser scans as filled fans, outlined where they met something; sonar pings as cones. */
export class Fans {
  readonly group = new Group();
  private readonly fill = new Painted('triangles', 2);
  private readonly outline = new Painted('lines', 3);
  private readonly colors: Float32Array[] = [];
  private fade = 1; // of this frame's paint; from how much floor the last frame's scans covered

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
    theme: Theme,
  ) {
    this.group.add(this.fill.object, this.outline.object);
    for (const place of replica.sensors) this.colors.push(paintOf(place.sensor.color, theme));
  }

  draw(): void {
    this.fill.begin();
    this.outline.begin();
    const cover = new Cover();
    const steps = this.replica.scans.size > kSensorsManyMost ? 1 : kConeSteps;
    for (const [row, beams] of this.replica.scans) {
      const { model, sensor } = this.replica.sensors[row];
      const at = sensorPose(this.motion, model, this.scene.models[model].origin, sensor);
      if (sensor.samples < 2) this.cone(at, sensor, beams[0], this.colors[row], steps);
      else this.fan(at, sensor, beams, this.colors[row]);
      cover.add(at, sensor, beams);
    }
    this.fade = Math.min(1, kLayersMost / cover.layers());
    this.fill.end();
    this.outline.end();
  }

  dispose(): void {
    this.fill.dispose();
    this.outline.dispose();
  }

  private fan(at: SensorPose, sensor: Sensor, beams: Uint16Array, color: Float32Array): void {
    const unit = sensor.range[1] / 65535;
    const alpha = color[3] * this.fade;
    let px = at.x;
    let py = at.y;
    for (let k = 0; k < beams.length; ++k) {
      const bearing = at.a + bearingOf(sensor, k);
      const x = at.x + Math.cos(bearing) * beams[k] * unit;
      const y = at.y + Math.sin(bearing) * beams[k] * unit;
      if (k > 0) {
        this.fill.corner(at.x, at.y, at.z, color, alpha * 1.2);
        this.fill.corner(px, py, at.z, color, alpha);
        this.fill.corner(x, y, at.z, color, alpha);
        if (Math.max(beams[k], beams[k - 1]) < 65535 && Math.abs(beams[k] - beams[k - 1]) * unit < kGap) {
          this.line(px, py, x, y, at.z, color, 0.75 * this.fade);
        }
      }
      px = x;
      py = y;
    }
  }

  private cone(at: SensorPose, sensor: Sensor, beam: number, color: Float32Array, steps: number): void {
    const range = (beam * sensor.range[1]) / 65535;
    // A ping that heard nothing says little; it is drawn fainter.
    const alpha = (beam === 65535 ? color[3] * 0.45 : color[3]) * this.fade;
    let px = 0;
    let py = 0;
    for (let k = 0; k <= steps; ++k) {
      const bearing = at.a + sensor.fov * (k / steps - 0.5);
      const x = at.x + Math.cos(bearing) * range;
      const y = at.y + Math.sin(bearing) * range;
      if (k > 0) {
        this.fill.corner(at.x, at.y, at.z, color, alpha);
        this.fill.corner(px, py, at.z, color, alpha);
        this.fill.corner(x, y, at.z, color, alpha);
        if (beam !== 65535 && steps > 1) this.line(px, py, x, y, at.z, color, 0.55 * this.fade);
      }
      px = x;
      py = y;
    }
  }

  private line(ax: number, ay: number, bx: number, by: number, z: number, color: Float32Array, alpha: number): void {
    this.outline.corner(ax, ay, z, color, alpha);
    this.outline.corner(bx, by, z, color, alpha);
  }
}

/** The sensor's own colour, lifted where the page is dark; alpha within what lets the world shine through. */
function paintOf(rgba: Rgba, theme: Theme): Float32Array {
  const color = new Color().setRGB(rgba[0], rgba[1], rgba[2], 'srgb');
  if (theme.dark) color.lerp(new Color(0xffffff), 0.35);
  return Float32Array.of(color.r, color.g, color.b, Math.min(Math.max(rgba[3], 0.06), 0.3));
}
