import { Color, Group } from 'three';
import { kBits } from '../protocol/generated/views';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'blinkenlight', panel, shade, drawings: (stage) => [new Glows(stage)] } satisfies KindPage;

const kDark = 0.35; // of its colour
const kRays = 16; // corners of a glow

function isLit(state: number): boolean {
  return (state & kBits.blinkenlight.lit) !== 0;
}

function shade(state: number): number {
  return isLit(state) ? 1 : kDark;
}

/** A glow around each lit lamp: the lamps themselves are small. */
class Glows implements Drawing {
  readonly object = new Group();
  private readonly fill = new Painted('triangles', 2);
  private readonly color = new Color();
  private readonly lamps: number[]; // rows

  constructor(private readonly stage: Stage) {
    this.object.add(this.fill.object);
    this.lamps = [...stage.scene.models.keys()].filter((row) => stage.scene.models[row].kind === 'blinkenlight');
  }

  draw(): void {
    const { scene, replica, motion } = this.stage;
    this.fill.begin();
    for (const row of this.lamps) {
      if (!isLit(replica.state[row])) continue;
      const { size } = scene.models[row];
      const [x, y, z] = [motion.x[row], motion.y[row], motion.z[row] + size[2]];
      const radius = 0.06 + Math.max(size[0], size[1]);
      this.color.setHex(replica.color[row] >>> 8);
      const paint = [this.color.r, this.color.g, this.color.b];
      for (let k = 0; k < kRays; ++k) {
        this.fill.corner(x, y, z, paint, 0.7);
        for (const corner of [k, k + 1]) {
          const bearing = (corner / kRays) * 2 * Math.PI;
          this.fill.corner(x + Math.cos(bearing) * radius, y + Math.sin(bearing) * radius, z, paint, 0);
        }
      }
    }
    this.fill.end();
  }

  dispose(): void {
    this.fill.dispose();
  }
}

function panel(model: Model, { replica, row, line, detail, codes }: PanelTools): Node[] {
  const state = () => replica().state[row(model.id)];
  const flash = () => {
    const now = replica().views('blinkenlight').get(row(model.id));
    if (!now) return '–';
    const steady = now.period === 0 || now.dutycycle >= 1;
    return steady ? 'burns steadily' : `${(now.period * now.dutycycle).toFixed(2)} s of ${now.period.toFixed(2)} s`;
  };
  return [
    el('h3', {}, 'Lamp', ...codes(model), detail(() => (isLit(state()) ? 'lit' : 'dark'), 'lamp')),
    el('table', {},
      line('switch', () => (state() & kBits.blinkenlight.enabled ? 'on' : 'off'), 'lamp-switch'),
      line('flash', flash, 'lamp-flash'),
    ),
  ];
}
