import type { Client, Position2d } from '../../../clients/typescript/src/index';
import { HeldKeys, isStill, kStill, sum, type Velocity, velocityOf } from '../drive/hands';
import { el, setText } from '../ui/dom';
import { Stick } from '../ui/stick';

const kRenewMs = 200; // a device may stop a robot whose commander is silent

/** Driving a base by stick and keys; what is opened for it is closed when it ends. */
export class Driving {
  readonly nodes: Node[];
  private readonly button = el('button', { 'data-testid': 'drive', 'aria-pressed': 'false' }, 'Drive');
  private readonly pad = el('div', { class: 'pad', role: 'img', 'aria-label': 'Stick to drive with', hidden: true });
  private readonly keys = new HeldKeys();
  private readonly stick = new Stick(this.pad, () => this.send());
  private base: Position2d | null = null;
  private sent: Velocity = kStill;
  private timer = 0;
  private fast = false;

  constructor(
    private readonly client: Client,
    private readonly index: number,
    private readonly failed: (error: unknown) => void,
  ) {
    this.nodes = [this.button, this.pad];
    this.button.onclick = () => void this.toggle().catch(failed);
    window.addEventListener('keydown', this.pressed);
    window.addEventListener('keyup', this.released);
    window.addEventListener('blur', this.letGo);
  }

  async end(): Promise<void> {
    window.removeEventListener('keydown', this.pressed);
    window.removeEventListener('keyup', this.released);
    window.removeEventListener('blur', this.letGo);
    if (this.base) await this.toggle();
  }

  private async toggle(): Promise<void> {
    const { base } = this;
    this.base = null;
    window.clearInterval(this.timer);
    this.letGo();
    if (base) {
      await base.drive(0);
      await base.close();
    } else {
      const opened = await this.client.position2d(this.index);
      await opened.setMotorPower(true).catch(() => {}); // bases without a switch refuse
      this.base = opened;
      this.timer = window.setInterval(() => this.renew(), kRenewMs);
    }
    this.button.setAttribute('aria-pressed', String(this.base !== null));
    setText(this.button, this.base ? 'Stop driving' : 'Drive');
    this.stick.show(this.base !== null);
  }

  private readonly pressed = (event: KeyboardEvent) => {
    if (!this.base || event.ctrlKey || event.metaKey || event.altKey) return;
    this.fast = event.shiftKey;
    this.keys.press(event.code, event.key);
    this.send();
  };

  private readonly released = (event: KeyboardEvent) => {
    this.fast = event.shiftKey;
    this.keys.release(event.code);
    this.send();
  };

  private readonly letGo = () => {
    this.keys.clear();
    this.stick.release();
    this.send();
  };

  private wanted(): Velocity {
    return velocityOf(sum([this.keys.hands(this.fast), this.stick.hands()]));
  }

  private send(): void {
    const wanted = this.wanted();
    if (!this.base || (wanted.forward === this.sent.forward && wanted.sideways === this.sent.sideways && wanted.turn === this.sent.turn)) return;
    this.sent = wanted;
    void this.base.drive(wanted.forward, wanted.turn, wanted.sideways).catch(this.failed);
  }

  private renew(): void {
    if (!this.base || isStill(this.sent)) return;
    void this.base.drive(this.sent.forward, this.sent.turn, this.sent.sideways).catch(this.failed);
  }
}
