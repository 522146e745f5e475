import { Color, Group } from 'three';
import type { Motion } from '../motion';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees, metres } from '../ui/texts';
import { frameOf } from '../view/frames';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'detector', panel, drawings: (stage) => [new Fields(stage)] } satisfies KindPage;

const kSteps = 24; // of a circle
const kListed = 12; // in the panel
const kInk = new Color(0x9c36b5);

/** Field of view of each detector, and a line to each detection, broken where bodies occlude it. */
class Fields implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly fill = new Painted('triangles', 2);
  private readonly lines = new Painted('lines', 4);

  constructor(private readonly stage: Stage) {
    this.object.add(this.fill.object, this.lines.object);
  }

  draw(): void {
    const { scene, replica, motion } = this.stage;
    this.fill.begin();
    this.lines.begin();
    for (const [row, finds] of replica.views('detector')) {
      const at = eyeOf(motion, row, scene.models[row]);
      this.field(at, scene.models[row]);
      for (const { range, bearing, bodies } of finds) {
        const x = at.x + Math.cos(at.a + bearing) * range;
        const y = at.y + Math.sin(at.a + bearing) * range;
        this.line(at.x, at.y, x, y, at.z, bodies === 0 ? 1 : 0.45);
        this.cross(x, y, at.z);
      }
    }
    this.fill.end();
    this.lines.end();
  }

  dispose(): void {
    this.fill.dispose();
    this.lines.dispose();
  }

  private field(at: Eye, { fov = 0, reach = [0, 0] }: Model): void {
    const steps = Math.max(1, Math.ceil((fov / (2 * Math.PI)) * kSteps));
    const paint = [kInk.r, kInk.g, kInk.b];
    for (let k = 0; k < steps; ++k) {
      this.fill.corner(at.x, at.y, at.z, paint, 0.12);
      for (const end of [k, k + 1]) {
        const bearing = at.a + fov * (end / steps - 0.5);
        this.fill.corner(at.x + Math.cos(bearing) * reach[1], at.y + Math.sin(bearing) * reach[1], at.z, paint, 0.05);
      }
    }
  }

  private cross(x: number, y: number, z: number): void {
    const arm = 0.12;
    this.line(x - arm, y - arm, x + arm, y + arm, z, 1);
    this.line(x - arm, y + arm, x + arm, y - arm, z, 1);
  }

  private line(ax: number, ay: number, bx: number, by: number, z: number, alpha: number): void {
    const paint = [kInk.r, kInk.g, kInk.b];
    this.lines.corner(ax, ay, z, paint, alpha);
    this.lines.corner(bx, by, z, paint, alpha);
  }
}

type Eye = ReturnType<typeof frameOf>;

/** Origin of a detector's rays: half its height above its pose. */
function eyeOf(motion: Motion, row: number, model: Model): Eye {
  const at = frameOf(motion, row, model.origin);
  at.z += (model.size?.[2] ?? 0) / 2;
  return at;
}

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'detections' });
  const nameOf = (target: number) => replica().scene.models[replica().rows.get(target) ?? -1]?.name ?? 'one that went';
  refresh(() => {
    const finds = replica().views('detector').get(row(model.id));
    const lines = !finds
      ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
      : finds.length === 0
        ? [el('tr', {}, el('td', { class: 'empty' }, 'finds nothing'))]
        : finds.slice(0, kListed).map(({ target, range, bearing, level }) =>
            el('tr', {}, el('th', {}, nameOf(target)), el('td', {}, metres(range)), el('td', {}, degrees(bearing)), el('td', {}, `${Math.round(level)} dB`)));
    const text = lines.map((line) => line.textContent).join('|');
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  const { fov = 0, reach } = model;
  const detail = `to ${reach?.[1] ?? '?'} m, ${Math.round((fov * 180) / Math.PI)}°`;
  return [el('h3', {}, 'Detector', ...codes(model), el('span', { class: 'detail' }, detail)), table];
}
