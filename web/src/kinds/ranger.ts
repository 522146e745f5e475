import { Color, Group } from 'three';
import type { Motion } from '../motion';
import type { Model, Pose, Rgba, Sensor } from '../protocol/scene';
import { el, setText } from '../ui/dom';
import { type PolarScan, PolarPlot } from '../ui/polar_plot';
import { degrees, metres, shortName } from '../ui/texts';
import { bearingOf } from '../view/beams';
import { type Frame, frameOf } from '../view/frames';
import { Painted } from '../view/painted';
import type { Theme } from '../view/theme';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'ranger', panel, drawings: (stage) => [new Fans(stage)] } satisfies KindPage;

const kConeSteps = 6;
const kSensorsManyMost = 1500; // above this number, sonar cones are single triangles
const kLayersMost = 1; // scan overlap above which scans are faded, to keep robots visible
const kRoom = 8; // m, margin around the outermost sensors
const kSonarValuesMost = 64; // numbers in the panel
const kGap = 0.4; // m: a larger step between adjacent beams is a gap, not a surface

/** Current frame of a sensor's beams. */
function beamsFrame(motion: Motion, model: number, origin: Pose | undefined, sensor: Sensor): Frame {
  const frame = frameOf(motion, model, origin, sensor.pose);
  frame.z += sensor.size[2] / 2;
  return frame;
}

/** Overlap of scans on the floor: total area and bounding box. */
class Cover {
  private area = 0; // m^2, of all scans
  private left = Infinity;
  private right = -Infinity;
  private low = Infinity;
  private high = -Infinity;

  add(at: Frame, sensor: Sensor, beams: Uint16Array): void {
    const unit = sensor.range[1] / 65535;
    let squares = 0;
    for (const beam of beams) squares += beam * beam;
    this.area += ((squares / beams.length) * unit * unit * sensor.fov) / 2;
    this.left = Math.min(this.left, at.x);
    this.right = Math.max(this.right, at.x);
    this.low = Math.min(this.low, at.y);
    this.high = Math.max(this.high, at.y);
  }

  /** Average overlap within the bounding box; the margin keeps a few close robots from counting as a crowd. */
  layers(): number {
    const floor = (this.right - this.left + kRoom) * (this.high - this.low + kRoom);
    return this.area > 0 ? this.area / floor : 0;
  }
}

/** Laser scans as filled fans, outlined along surfaces hit; sonar pings as cones. */
class Fans implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly fill = new Painted('triangles', 2);
  private readonly outline = new Painted('lines', 3);
  private readonly colors: Float32Array[] = [];
  private fade = 1; // fade of this frame; from the overlap of the last frame

  constructor(private readonly stage: Stage) {
    this.object.add(this.fill.object, this.outline.object);
    for (const place of stage.replica.sensors) this.colors.push(paintOf(place.sensor.color, stage.theme));
  }

  draw(): void {
    this.fill.begin();
    this.outline.begin();
    const { scene, replica, motion } = this.stage;
    const cover = new Cover();
    const steps = replica.scans.size > kSensorsManyMost ? 1 : kConeSteps;
    for (const [row, beams] of replica.scans) {
      const { model, sensor } = replica.sensors[row];
      const at = beamsFrame(motion, model, scene.models[model].origin, sensor);
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

  private fan(at: Frame, sensor: Sensor, beams: Uint16Array, color: Float32Array): void {
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

  private cone(at: Frame, sensor: Sensor, beam: number, color: Float32Array, steps: number): void {
    const range = (beam * sensor.range[1]) / 65535;
    // A ping without an echo carries little information: drawn fainter.
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

/** The sensor's colour, lightened in the dark theme; alpha clamped so that the world shows through. */
function paintOf(rgba: Rgba, theme: Theme): Float32Array {
  const color = new Color().setRGB(rgba[0], rgba[1], rgba[2], 'srgb');
  if (theme.dark) color.lerp(new Color(0xffffff), 0.35);
  return Float32Array.of(color.r, color.g, color.b, Math.min(Math.max(rgba[3], 0.06), 0.3));
}

function panel(model: Model, tools: PanelTools): Node[] {
  const { replica, row, refresh, detail, codes } = tools;
  const sensors = model.sensors ?? [];
  const scansNow = () => {
    const first = replica().firstSensor.get(row(model.id)) ?? 0;
    return sensors.map((_, nth) => replica().scans.get(first + nth));
  };
  const laser = sensors.some(({ samples }) => samples > 1);
  const canvas = el('canvas', { class: 'polar' });
  const plot = new PolarPlot(canvas);
  const nodes: Node[] = [
    el('h3', {}, laser ? 'Laser' : 'Sonar', ...codes(model), detail(() => rangerText(sensors, scansNow()), `ranger-${shortName(model.name)}`)),
    canvas,
  ];
  const drawn: (Uint16Array | undefined)[] = [];
  let drawnOnce = false;
  refresh(() => {
    const scans = scansNow();
    if (drawnOnce && scans.every((scan, k) => scan === drawn[k])) return;
    drawnOnce = canvas.clientWidth > 0;
    scans.forEach((scan, k) => (drawn[k] = scan));
    plot.draw(sensors.map((sensor, k) => polarScan(sensor, scans[k])));
  });
  nodes.push(laser ? laserTable(tools, sensors[0], () => scansNow()[0]) : values(tools, sensors, scansNow));
  return nodes;
}

function polarScan(sensor: Sensor, beams: Uint16Array | undefined): PolarScan {
  const [x, y, , heading] = sensor.pose;
  const { fov, range: [, farthest] } = sensor;
  const ranges = Array.from(beams ?? [], (beam) => (beam / 65535) * farthest);
  return { x, y, heading, fov, farthest, ranges, bearings: ranges.map((_, k) => bearingOf(sensor, k)) };
}

function laserTable({ line }: PanelTools, sensor: Sensor, scan: () => Uint16Array | undefined): HTMLElement {
  const metresOf = (beam: number | undefined) => (beam === undefined ? '–' : metres((beam / 65535) * sensor.range[1]));
  const nearest = () => {
    const beams = scan();
    if (!beams) return '–';
    const k = beams.reduce((best, beam, i) => (beam < beams[best] ? i : best), 0);
    return `${metresOf(beams[k])} at ${degrees(bearingOf(sensor, k))}`;
  };
  return el('table', {},
    line('nearest', nearest, 'laser-nearest'),
    line('right, ahead, left', () => {
      const beams = scan();
      return [0, Math.floor((sensor.samples - 1) / 2), sensor.samples - 1].map((k) => metresOf(beams?.[k])).join('  ').replaceAll(' m', '');
    }),
    line('beams', () => `${sensor.samples}, ${Math.round((sensor.fov * 180) / Math.PI)}°, to ${Number(sensor.range[1].toFixed(1))} m`),
  );
}

function values({ refresh }: PanelTools, sensors: Sensor[], scans: () => (Uint16Array | undefined)[]): HTMLElement {
  const cells = sensors.slice(0, kSonarValuesMost).map(() => el('b', {}, '–'));
  refresh(() => {
    const now = scans();
    cells.forEach((cell, k) => {
      const beam = now[k]?.[0];
      setText(cell, beam === undefined ? '–' : ((beam / 65535) * sensors[k].range[1]).toFixed(2));
    });
  });
  return el('div', { class: 'values' }, ...cells);
}

function rangerText(sensors: Sensor[], scans: (Uint16Array | undefined)[]): string {
  let nearest = Infinity;
  scans.forEach((scan, k) => {
    if (scan) for (const beam of scan) nearest = Math.min(nearest, (beam / 65535) * sensors[k].range[1]);
  });
  return nearest === Infinity ? 'no data yet' : `nearest ${metres(nearest)}`;
}
