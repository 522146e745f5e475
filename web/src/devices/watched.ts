import { Access, type AnyMessage, type Client, type Device, type DeviceEntry } from '../../../clients/typescript/src/index';
import { el, icon, setText } from '../ui/dom';
import { Driving } from './driving';
import { type Panel, panelOf } from './panels';

const kRateSeconds = 2; // over which the rate of messages is measured

/** A device that the page has open for reading, and its card. */
export class Watched {
  readonly card = el('section', { class: 'card' });
  private readonly about = el('small');
  private readonly note = el('p', { class: 'bad', hidden: true });
  private device: Device | null = null;
  private panel: Panel | null = null;
  private driving: Driving | null = null;
  private readonly due = new Map<number, [AnyMessage, unknown]>(); // by subtype
  private arrivals: number[] = []; // ms

  constructor(
    private readonly entry: DeviceEntry,
    private readonly client: Client,
    private readonly drives: boolean, // whether the page may
    closed: () => void,
  ) {
    const close = el('button', { title: 'Stop watching', 'aria-label': 'Close' }, icon('close'));
    close.onclick = closed;
    this.card.dataset.device = entry.name;
    this.card.append(el('header', {}, el('h2', {}, entry.name), this.about, close), this.note);
  }

  async open(): Promise<void> {
    try {
      const device = await this.client.device(this.entry.interface, this.entry.index, Access.READ);
      this.device = device;
      this.panel = panelOf(device);
      this.card.append(...this.panel.nodes);
      if (this.entry.interface === 'position2d') this.offerDriving();
      device.onData((message, value) => {
        this.due.set(message.subtype, [message, value]);
        this.arrivals.push(performance.now());
      });
    } catch (error) {
      this.tell(error);
    }
  }

  private offerDriving(): void {
    if (!this.drives) {
      this.card.append(el('p', { class: 'soft', 'data-testid': 'observes' }, 'You observe: driving takes the link of a driver.'));
      return;
    }
    this.driving = new Driving(this.client, this.entry.index, (error) => this.tell(error));
    this.card.append(...this.driving.nodes);
  }

  /** Draws what has arrived; called for each picture of the page. */
  draw(): void {
    for (const [message, value] of this.due.values()) this.panel?.show(message, value);
    this.due.clear();
    const since = performance.now() - 1000 * kRateSeconds;
    this.arrivals = this.arrivals.filter((time) => time > since);
    const rate = (this.arrivals.length / kRateSeconds).toFixed(this.arrivals.length < 20 ? 1 : 0);
    const gone = this.device?.gone ? ', gone' : '';
    setText(this.about, `${this.entry.driver}, ${rate} messages/s${gone}`);
  }

  async close(): Promise<void> {
    this.card.remove();
    await this.driving?.end();
    await this.device?.close();
  }

  private tell(error: unknown): void {
    this.note.hidden = false;
    setText(this.note, error instanceof Error ? error.message : String(error));
  }
}
