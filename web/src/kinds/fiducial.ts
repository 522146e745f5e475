import { Color, Group } from 'three';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees, metres } from '../ui/texts';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'fiducial', panel, drawings: (stage) => [new Sightings(stage)] } satisfies KindPage;

const kRing = 20; // corners
const kInk = new Color(0xe08a00);

/** Fiducial detections: a line to each marker, a ring at its position and a tick for its heading. */
class Sightings implements Drawing {
  readonly layer = 'fiducials';
  readonly object = new Group();
  private readonly lines = new Painted('lines', 4);

  constructor(private readonly stage: Stage) {
    this.object.add(this.lines.object);
  }

  draw(): void {
    const { scene, replica, motion } = this.stage;
    this.lines.begin();
    const color = [kInk.r, kInk.g, kInk.b];
    for (const [row, hits] of replica.views('fiducial')) {
      const [x, y, a] = [motion.x[row], motion.y[row], motion.a[row]];
      for (const hit of hits) {
        const tx = x + Math.cos(a + hit.bearing) * hit.range;
        const ty = y + Math.sin(a + hit.bearing) * hit.range;
        const size = scene.models[replica.rows.get(hit.target) ?? -1]?.size ?? [0.2, 0.2, 0.2];
        const radius = Math.max(Math.hypot(size[0], size[1]) * 0.6, 0.12);
        const z = Math.max(motion.z[row], 0.02);
        this.line(x, y, tx, ty, z, color, 0.55);
        this.ring(tx, ty, z, radius, color);
        const heading = a + hit.heading;
        this.line(tx, ty, tx + Math.cos(heading) * radius * 1.5, ty + Math.sin(heading) * radius * 1.5, z, color, 1);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }

  private ring(x: number, y: number, z: number, radius: number, color: number[]): void {
    for (let k = 0; k < kRing; ++k) {
      const a = (k / kRing) * 2 * Math.PI;
      const b = ((k + 1) / kRing) * 2 * Math.PI;
      this.line(x + Math.cos(a) * radius, y + Math.sin(a) * radius, x + Math.cos(b) * radius, y + Math.sin(b) * radius, z, color, 0.9);
    }
  }

  private line(ax: number, ay: number, bx: number, by: number, z: number, color: number[], alpha: number): void {
    this.lines.corner(ax, ay, z, color, alpha);
    this.lines.corner(bx, by, z, color, alpha);
  }
}

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'fiducials' });
  refresh(() => {
    const hits = replica().views('fiducial').get(row(model.id));
    const lines = !hits
      ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
      : hits.length === 0
        ? [el('tr', {}, el('td', { class: 'empty' }, 'sees no marker'))]
        : hits.slice(0, 12).map((hit) =>
            el('tr', {}, el('th', {}, hit.id ? `${replica().scene.models[replica().rows.get(hit.target) ?? -1]?.name ?? 'one that went'} (${hit.id})` : 'too far to read'), el('td', {}, metres(hit.range)), el('td', {}, degrees(hit.bearing))),
          );
    const text = lines.map((line) => line.textContent).join('|');
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  const { range, fov } = model;
  const reach = `to ${range ?? '?'} m, ${Math.round(((fov ?? 0) * 180) / Math.PI)}°`;
  return [el('h3', {}, 'Fiducial finder', ...codes(model), el('span', { class: 'detail' }, reach)), table];
}
