import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'gps', panel } satisfies KindPage;

/** Estimated position of a satellite receiver, in the world frame. */
function panel(model: Model, { replica, row, line, codes }: PanelTools): Node[] {
  const now = () => replica().views('gps').get(row(model.id));
  return [
    el('h3', {}, 'Satellite receiver', ...codes(model)),
    el(
      'table',
      { 'data-testid': 'gps' },
      line('position', () => { const one = now(); return one ? `${[one.x, one.y, one.z].map((each) => each.toFixed(2)).join('  ')} m` : 'no data yet'; }),
      line('satellites', () => `${model.satellites ?? '?'}`),
    ),
  ];
}
