import type { Replica } from '../protocol/replica';
import { el, setText } from './dom';

/** Simulated time, and how fast it passes. */
export class Clock {
  private readonly time = el('span', { class: 'time', 'data-testid': 'time' });
  private readonly factor = el('span', { class: 'factor', 'data-testid': 'factor' });
  private readonly tick = el('span', { class: 'tick', 'data-testid': 'tick' });
  private readonly mode = el('span', { class: 'mode', 'data-testid': 'mode' });

  constructor(bar: HTMLElement) {
    bar.append(this.time, this.factor, this.tick, this.mode);
  }

  show(replica: Replica, interval: number): void {
    setText(this.time, clockText(replica.tick * interval));
    setText(this.factor, `${factorText(replica.realTimeFactor)}× real time`);
    setText(this.tick, `tick ${replica.tick}`);
    setText(this.mode, modeText(replica));
    this.factor.hidden = replica.paused;
  }
}

function modeText(replica: Replica): string {
  if (replica.paused) return 'paused';
  if (replica.rowsWait) return 'catching up';
  return replica.beamsFull ? 'some sensors not shown' : '';
}

/** 3723.4 s as "1:02:03.4". */
export function clockText(seconds: number): string {
  const tenths = Math.round(seconds * 10);
  const h = Math.floor(tenths / 36000);
  const m = Math.floor((tenths / 600) % 60);
  const s = ((tenths % 600) / 10).toFixed(1).padStart(4, '0');
  return h > 0 ? `${h}:${String(m).padStart(2, '0')}:${s}` : `${m}:${s}`;
}

export function factorText(factor: number): string {
  return factor >= 100 ? factor.toFixed(0) : factor >= 10 ? factor.toFixed(1) : factor.toFixed(2);
}
