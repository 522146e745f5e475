import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees } from '../ui/texts';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'imu', panel } satisfies KindPage;

const three = (x: number, y: number, z: number) => [x, y, z].map((each) => each.toFixed(2)).join('  ');

/** Measurements of an inertial unit, in its own frame. */
function panel(model: Model, { replica, row, line, codes }: PanelTools): Node[] {
  const now = () => replica().views('imu').get(row(model.id));
  return [
    el('h3', {}, 'Inertial unit', ...codes(model)),
    el(
      'table',
      { 'data-testid': 'imu' },
      line('acceleration', () => { const one = now(); return one ? `${three(one.ax, one.ay, one.az)} m/s²` : 'no data yet'; }),
      line('turn rate', () => { const one = now(); return one ? `${three(one.wx, one.wy, one.wz)} rad/s` : ''; }),
      line('heading', () => { const one = now(); return one ? degrees(one.heading) : ''; }),
    ),
  ];
}
