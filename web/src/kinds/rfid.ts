import { Color, Group } from 'three';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { metres } from '../ui/texts';
import { Painted } from '../view/painted';
import type { Drawing, KindPage, PanelTools, Stage } from './kind_page';

export default { kind: 'rfid', panel, drawings: (stage) => [new TagLines(stage)] } satisfies KindPage;

const kListed = 12; // in the panel
const kInk = new Color(0x7048e8);
const kRaised = 0.1; // m, above the floor of either model

/** Radio tags: a line to each model whose tag is read. */
class TagLines implements Drawing {
  readonly layer = 'sensors';
  readonly object = new Group();
  private readonly lines = new Painted('lines', 4);

  constructor(private readonly stage: Stage) {
    this.object.add(this.lines.object);
  }

  draw(): void {
    const { replica, motion } = this.stage;
    const paint = [kInk.r, kInk.g, kInk.b];
    this.lines.begin();
    for (const [row, tags] of replica.views('rfid')) {
      for (const { target } of tags) {
        const other = replica.rows.get(target);
        if (other === undefined) continue;
        for (const end of [row, other]) this.lines.corner(motion.x[end], motion.y[end], motion.z[end] + kRaised, paint, 0.7);
      }
    }
    this.lines.end();
  }

  dispose(): void {
    this.lines.dispose();
  }
}

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'tags' });
  const nameOf = (target: number) => replica().scene.models[replica().rows.get(target) ?? -1]?.name ?? 'one that went';
  refresh(() => {
    const tags = replica().views('rfid').get(row(model.id));
    const lines = !tags
      ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
      : tags.length === 0
        ? [el('tr', {}, el('td', { class: 'empty' }, 'reads no tag'))]
        : tags.slice(0, kListed).map(({ target, range }) => el('tr', {}, el('th', {}, nameOf(target)), el('td', {}, metres(range))));
    const text = lines.map((line) => line.textContent).join('|');
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  const reach = `to ${model.range ?? '?'} m, ${Math.round(((model.fov ?? 0) * 180) / Math.PI)}°`;
  return [el('h3', {}, 'Tag reader', ...codes(model), el('span', { class: 'detail' }, reach)), table];
}
