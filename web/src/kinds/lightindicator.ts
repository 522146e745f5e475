import { kBits } from '../protocol/generated/views';
import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import type { KindPage, PanelTools } from './kind_page';

export default { kind: 'lightindicator', panel, shade } satisfies KindPage;

const kDark = 0.8; // of its colour, as in Stage

function isLit(state: number): boolean {
  return (state & kBits.lightindicator.lit) !== 0;
}

function shade(state: number): number {
  return isLit(state) ? 1 : kDark;
}

function panel(model: Model, { replica, row, detail, codes }: PanelTools): Node[] {
  return [el('h3', {}, 'Light', ...codes(model), detail(() => (isLit(replica().state[row(model.id)]) ? 'lit' : 'dark'), 'light'))];
}
