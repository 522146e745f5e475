import { kMotorOn, kStalled } from '../protocol/replica';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import { degrees, metres } from '../ui/texts';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'position', panel } satisfies KindPage;

function panel(wheels: Model, { replica, row, line, detail, codes }: PanelTools): Node[] {
  const view = () => replica().views('position').get(row(wheels.id));
  const told = (text: (now: NonNullable<ReturnType<typeof view>>) => string) => () => {
    const now = view();
    return now ? text(now) : '–';
  };
  const state = () => replica().state[row(wheels.id)];
  const walks = wheels.drive === 'walk';
  const off = walks ? 'switched off' : 'motor off';
  return [
    el('h3', {}, walks ? 'Walking' : 'Wheels', ...codes(wheels), detail(() => (state() & kMotorOn ? '' : off))),
    el('table', {},
      line('speed', told(({ vx }) => `${vx.toFixed(3)} m/s`), 'speed-x'),
      line('sideways', told(({ vy }) => `${vy.toFixed(3)} m/s`), 'speed-y'),
      line('turn rate', told(({ va }) => `${(va * (180 / Math.PI)).toFixed(1)} °/s`), 'speed-a'),
      line('odometry', told(({ ox, oy, oa }) => `${ox.toFixed(2)}, ${metres(oy)}, ${degrees(oa)}`), 'odometry'),
      line(walks ? 'blocked' : 'stall', () => (state() & kStalled ? 'yes' : 'no'), 'stall'),
    ),
  ];
}
