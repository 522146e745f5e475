import { Color, Group } from 'three';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'wifi', panel, drawings: (stage) => [new Links(stage)] } satisfies KindPage;

const kListed = 12; // in the panel
const kWeak = new Color(0xe03131);
const kStrong = new Color(0x2f9e44);

/** Radio links: a line to each radio in range, green for a strong signal. */
class Links implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly lines = new Painted('lines', 4);
  private readonly color = new Color();

  constructor(private readonly stage: Stage) {
    this.object.add(this.lines.object);
  }

  draw(): void {
    const { replica, motion } = this.stage;
    this.lines.begin();
    for (const [row, links] of replica.views('wifi')) {
      for (const { station, quality } of links) {
        const other = replica.rows.get(station);
        if (other === undefined) continue;
        this.color.lerpColors(kWeak, kStrong, quality / 100);
        const paint = [this.color.r, this.color.g, this.color.b];
        for (const end of [row, other]) this.lines.corner(motion.x[end], motion.y[end], motion.z[end] + 0.1, paint, 0.6);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }
}

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'radio' });
  const nameOf = (station: number) => replica().scene.models[replica().rows.get(station) ?? -1]?.name ?? 'one that went';
  refresh(() => {
    const links = replica().views('wifi').get(row(model.id));
    const lines = !links
      ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
      : links.length === 0
        ? [el('tr', {}, el('td', { class: 'empty' }, 'hears nobody'))]
        : links.slice(0, kListed).map(({ station, level, quality }) => el('tr', {}, el('th', {}, nameOf(station)), el('td', {}, `${level} dBm`), el('td', {}, `${quality} %`)));
    const text = lines.map((line) => line.textContent).join('|');
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  return [el('h3', {}, 'Radio', ...codes(model)), table];
}
