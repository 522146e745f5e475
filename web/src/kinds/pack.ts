import type { PackView } from '../protocol/generated/views';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'pack', panel } satisfies KindPage;

const isEndless = ({ stored }: PackView) => stored < 0;

/** 1234 J is "1.23 kJ". */
export function energy(joules: number): string {
  const [scaled, unit] = joules >= 1e6 ? [joules / 1e6, 'MJ'] : joules >= 1e3 ? [joules / 1e3, 'kJ'] : [joules, 'J'];
  return `${scaled.toFixed(unit === 'J' ? 0 : 2)} ${unit}`;
}

function panel(model: Model, { replica, row, refresh, line, detail }: PanelTools): Node[] {
  const view = () => replica().views('pack').get(row(model.id));
  const told = (text: (now: PackView) => string) => () => {
    const now = view();
    return now ? text(now) : '–';
  };
  const meter = el('meter', { min: '0', max: '1', low: '0.2', 'data-testid': 'battery' });
  refresh(() => {
    const now = view();
    meter.value = !now ? 0 : isEndless(now) ? 1 : now.capacity > 0 ? now.stored / now.capacity : 0;
  });
  return [
    el('h3', {}, 'Battery', detail(() => (view()?.charging ? 'charging' : ''), 'charging')),
    el('p', { class: 'battery' }, meter),
    el('table', {},
      line('holds', told((now) => (isEndless(now) ? 'without end' : `${energy(now.stored)} of ${energy(now.capacity)}`)), 'stored'),
      line('power', told(({ watts }) => `${watts.toFixed(1)} W`), 'watts'),
    ),
  ];
}
