import type { Replica } from '../protocol/replica';
import type { History } from '../protocol/scene';
import { el } from './dom';
import { clockText } from './texts';

export interface PastEvents {
  /** The world is to be as it was at this instant. */
  rewind(tick: number): void;
  pause(): void;
  goOn(): void;
}

const kPeriodMs = 100; // between two instants that are asked for
const kKeysMs = 700; // after the last key the run goes on
const kPage = 10; // instants
const kNoPast = 'There is no way back in this run: ';

/** The last minutes of the run: a slider over the instants that it can go back to. */
export class Past {
  readonly slider = el('input', { type: 'range', class: 'past', 'data-testid': 'past', 'aria-label': 'Time', title: 'Drag to go back, and on from there', hidden: true });
  private ticks: number[] = [];
  /** Where a run that stood was taken back from: the program keeps that, and tells so within a second or two. */
  private left: number[] = [];
  private replica: Replica | null = null;
  private interval = 1;
  private live = false;
  private held = false; // the run stands while somebody looks for an instant
  private resumes = false; // it went when that began
  private asked: number | null = null; // the newest instant that is wanted
  private sent: number | null = null; // the newest that the program was asked for
  private waiting = false; // for the time between two
  private keysTimer = 0;

  /** `whyNot`: where the page says that there is no way back. */
  constructor(
    private readonly events: PastEvents,
    private readonly whyNot: HTMLElement,
  ) {
    const { slider } = this;
    slider.onpointerdown = () => this.hold();
    slider.oninput = () => this.seek(nearest(this.ticks, Number(slider.value)));
    // Arrows belong to the slider while it has the focus: used with a mouse, it gives them back to who drives.
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

  /** Asks for the newest instant, now or when the last one had its time. */
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

/** Instants that a list does not have, of those that it could have. */
export function untold(instants: number[], told: number[]): number[] {
  return instants.filter((each) => told.length > 0 && each > told[0] && !told.includes(each));
}

export function merged(ticks: number[], others: number[]): number[] {
  return [...new Set([...ticks, ...others])].sort((a, b) => a - b);
}

export function nearest(ticks: number[], tick: number): number {
  return ticks.reduce((best, each) => (Math.abs(each - tick) < Math.abs(best - tick) ? each : best));
}

/** Where a key leads from a tick, the tick itself where nothing is that way; null for other keys. */
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
