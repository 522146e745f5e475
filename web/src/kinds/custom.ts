import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'custom', panel } satisfies KindPage;

const kListed = 16; // in the panel

/** Readings come in thousandths; 0.001 times a whole number may show its rounding. */
export const readingText = (reading: number) => `${Number(reading.toFixed(3))}`;

/** Readings of a library's model, number by number: only the library knows their meaning. */
function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const table = el('table', { 'data-testid': 'readings' });
  refresh(() => {
    const readings = replica().views('custom').get(row(model.id));
    const lines =
      readings === undefined
        ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
        : readings.length === 0
          ? [el('tr', {}, el('td', { class: 'empty' }, 'measures nothing'))]
          : readings.slice(0, kListed).map(({ reading }, k) => el('tr', {}, el('th', {}, `reading ${k}`), el('td', {}, readingText(reading))));
    const text = lines.map((line) => line.textContent).join('|');
    if (table.dataset.shown === text) return;
    table.dataset.shown = text;
    table.replaceChildren(...lines);
  });
  return [el('h3', {}, model.library?.split(' ', 1)[0] ?? 'Custom', ...codes(model)), table];
}
