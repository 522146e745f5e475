import type { Replica } from '../protocol/replica';
import type { History } from '../protocol/scene';
import { el, setText } from './dom';
import { Past, type PastEvents } from './past';
import { clockText } from './texts';

/** Simulated time, real-time factor, and the rewind slider. */
export class Clock {
  private readonly time = el('span', { class: 'time', 'data-testid': 'time' });
  private readonly factor = el('span', { class: 'factor', 'data-testid': 'factor' });
  private readonly tick = el('span', { class: 'tick', 'data-testid': 'tick' });
  private readonly mode = el('span', { class: 'mode', 'data-testid': 'mode' });

  private readonly past: Past;

  constructor(bar: HTMLElement, events: PastEvents) {
    this.past = new Past(events, this.time);
    bar.append(this.time, this.past.slider, el('span', { class: 'pace' }, this.factor, this.mode), this.tick);
  }

  /** Sets the keyframes the run can be rewound to. */
  follow(history: History): void {
    this.past.follow(history);
  }

  showLink(live: boolean): void {
    this.past.showLink(live);
  }

  show(replica: Replica, interval: number): void {
    setText(this.time, clockText(replica.tick * interval));
    setText(this.factor, `${factorText(replica.realTimeFactor)}× real time`);
    setText(this.tick, `tick ${replica.tick}`);
    setText(this.mode, modeText(replica));
    this.factor.hidden = replica.paused;
    this.past.show(replica, interval);
  }
}

function modeText(replica: Replica): string {
  if (replica.paused) return 'paused';
  if (replica.rowsWait) return 'catching up';
  return replica.beamsFull ? 'some sensors not shown' : '';
}

export function factorText(factor: number): string {
  return factor >= 100 ? factor.toFixed(0) : factor >= 10 ? factor.toFixed(1) : factor.toFixed(2);
}
