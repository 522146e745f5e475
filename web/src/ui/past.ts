import type { Replica } from '../protocol/replica';
import type { History } from '../protocol/scene';
import { el } from './dom';
import { clockText } from './texts';

export interface PastEvents {
  /** Rewinds the run to this tick. */
  rewind(tick: number): void;
  pause(): void;
  goOn(): void;
}

const kPeriodMs = 100; // minimum interval between rewind requests
const kKeysMs = 700; // the run resumes this long after the last key
const kPage = 10; // keyframes per page key
const kNoPast = 'There is no way back in this run: ';

/** Rewind slider over the keyframes of the last minutes. */
export class Past {
  readonly slider = el('input', { type: 'range', class: 'past', 'data-testid': 'past', 'aria-label': 'Time', title: 'Drag to go back, and on from there', hidden: true });
  private ticks: number[] = [];
  /** Ticks left by rewinding a paused run: kept by the server, which lists them within 1 to 2 s. */
  private left: number[] = [];
  private replica: Replica | null = null;
  private interval = 1;
  private live = false;
  private held = false; // paused while the slider is in use
  private resumes = false; // was running before
  private asked: number | null = null; // the newest tick requested by the user
  private sent: number | null = null; // the newest tick sent to the server
  private waiting = false; // for the minimum interval
  private keysTimer = 0;

  /** `whyNot`: element for the reason why there is no rewind. */
  constructor(
    private readonly events: PastEvents,
    private readonly whyNot: HTMLElement,
  ) {
    const { slider } = this;
    slider.onpointerdown = () => this.hold();
    slider.oninput = () => this.seek(nearest(this.ticks, Number(slider.value)));
    // The focused slider handles the arrow keys: after use by mouse it loses the focus, so that they drive again.
    slider.onpointerup = slider.onpointercancel = () => {
      this.release();
      slider.blur();
    };
    slider.onkeydown = (event) => this.key(event);
  }

  follow(history: History): void {
    const told = 'ticks' in history ? history.ticks : [];
    this.left = untold(this.left, told);
    this.ticks = merged(told, this.left);
    this.whyNot.title = 'none' in history ? kNoPast + history.none : '';
    this.whyNot.classList.toggle('says', 'none' in history);
    this.update();
  }

  show(replica: Replica, interval: number): void {
    this.replica = replica;
    this.interval = interval;
    this.update();
  }

  showLink(live: boolean): void {
    this.live = live;
    if (!live) this.held = false;
    this.slider.disabled = !live;
  }

  private update(): void {
    const { slider, ticks, replica } = this;
    slider.hidden = ticks.length === 0 || !replica;
    if (slider.hidden || !replica) return;
    slider.min = String(ticks[0]);
    slider.max = String(Math.max(ticks[ticks.length - 1], replica.tick));
    this.place(this.held && this.asked !== null ? this.asked : replica.tick);
  }

  private place(tick: number): void {
    const { slider } = this;
    slider.value = String(tick);
    slider.setAttribute('aria-valuetext', clockText(tick * this.interval));
    const [min, max] = [Number(slider.min), Number(slider.max)];
    slider.style.setProperty('--gone', `${max > min ? ((100 * (tick - min)) / (max - min)).toFixed(2) : 100}%`);
  }

  private hold(): void {
    if (this.held || !this.live || !this.replica) return;
    this.held = true;
    this.asked = this.sent = null;
    this.resumes = !this.replica.paused;
    if (this.resumes) return this.events.pause();
    this.left = untold([...this.left, this.replica.tick], this.ticks);
    this.ticks = merged(this.ticks, this.left);
  }

  private release(): void {
    if (!this.held) return;
    this.held = false;
    if (this.asked !== null && this.asked !== this.sent) this.events.rewind(this.asked);
    if (this.resumes) this.events.goOn();
  }

  private seek(tick: number): void {
    this.hold();
    if (!this.held) return;
    this.asked = tick;
    this.place(tick);
    this.send();
  }

  /** Sends the newest requested tick, rate-limited. */
  private send(): void {
    if (this.waiting || !this.held || this.asked === null || this.asked === this.sent) return;
    this.sent = this.asked;
    this.events.rewind(this.asked);
    this.waiting = true;
    window.setTimeout(() => {
      this.waiting = false;
      this.send();
    }, kPeriodMs);
  }

  private key(event: KeyboardEvent): void {
    const at = this.held && this.asked !== null ? this.asked : (this.replica?.tick ?? 0);
    const tick = event.ctrlKey || event.metaKey || event.altKey ? null : neighbour(this.ticks, at, event.key);
    if (tick === null) return;
    event.preventDefault();
    if (tick === at) return;
    this.seek(tick);
    window.clearTimeout(this.keysTimer);
    this.keysTimer = window.setTimeout(() => this.release(), kKeysMs);
  }
}

/** Ticks missing from a list, among those it could contain. */
export function untold(instants: number[], told: number[]): number[] {
  return instants.filter((each) => told.length > 0 && each > told[0] && !told.includes(each));
}

export function merged(ticks: number[], others: number[]): number[] {
  return [...new Set([...ticks, ...others])].sort((a, b) => a - b);
}

export function nearest(ticks: number[], tick: number): number {
  return ticks.reduce((best, each) => (Math.abs(each - tick) < Math.abs(best - tick) ? each : best));
}

/** The tick a key leads to (unchanged at an end); null for other keys. */
export function neighbour(ticks: number[], tick: number, key: string): number | null {
  const earlier = ticks.filter((each) => each < tick);
  const later = ticks.filter((each) => each > tick);
  const steps: Record<string, number[]> = {
    ArrowLeft: earlier.slice(-1), ArrowDown: earlier.slice(-1), PageDown: earlier.slice(-kPage), Home: earlier,
    ArrowRight: later, ArrowUp: later, PageUp: later.slice(0, kPage).slice(-1), End: later.slice(-1),
  };
  if (!(key in steps)) return null;
  return steps[key][0] ?? tick;
}
