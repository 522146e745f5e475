import { Color, Group } from 'three';
import type { Model } from '../protocol/scene';
import { css, el } from '../ui/dom';
import { degrees, metres } from '../ui/texts';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'blobfinder', panel, drawings: (stage) => [new Wedges(stage)] } satisfies KindPage;

const kListed = 12; // in the panel

/** Bearing of a column of the image from the camera, the leftmost first. */
function bearingOf({ fov = 0, pan = 0, image: [width] = [1, 1] }: Model, column: number): number {
  return pan + (width > 1 ? fov * (0.5 - column / (width - 1)) : 0);
}

/** Colour blobs: a wedge per blob, in its colour. */
class Wedges implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly fill = new Painted('triangles', 2);
  private readonly color = new Color();

  constructor(private readonly stage: Stage) {
    this.object.add(this.fill.object);
  }

  draw(): void {
    const { scene, replica, motion } = this.stage;
    this.fill.begin();
    for (const [row, blobs] of replica.views('blobfinder')) {
      const [x, y, a] = [motion.x[row], motion.y[row], motion.a[row]];
      const z = motion.z[row] + 0.05;
      for (const { color, left, right, range } of blobs) {
        this.color.setHex(color >>> 8);
        const paint = [this.color.r, this.color.g, this.color.b];
        this.fill.corner(x, y, z, paint, 0.1);
        for (const column of [right + 0.5, left - 0.5]) {
          const bearing = a + bearingOf(scene.models[row], column);
          this.fill.corner(x + Math.cos(bearing) * range, y + Math.sin(bearing) * range, z, paint, 0.5);
        }
      }
    }
    this.fill.end();
  }

  dispose(): void {
    this.fill.dispose();
  }
}

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'blobs' });
  refresh(() => {
    const blobs = replica().views('blobfinder').get(row(model.id));
    const lines = !blobs
      ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
      : blobs.length === 0
        ? [el('tr', {}, el('td', { class: 'empty' }, 'sees no color'))]
        : blobs.slice(0, kListed).map(({ color, left, right, range }) => {
            const swatch = el('span', { class: 'swatch' });
            swatch.style.background = css(color);
            return el('tr', {}, el('th', {}, swatch, ` ${right - left + 1} px`), el('td', {}, metres(range)), el('td', {}, degrees(bearingOf(model, (left + right) / 2))));
          });
    const text = lines.map((line) => line.textContent).join('|') + (blobs ?? []).map(({ color }) => color).join();
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  const { fov = 0, image: [width, height] = [0, 0] } = model;
  const detail = el('span', { class: 'detail' }, `${width} × ${height}, ${Math.round((fov * 180) / Math.PI)}°`);
  return [el('h3', {}, 'Blobfinder', ...codes(model), detail), table];
}
