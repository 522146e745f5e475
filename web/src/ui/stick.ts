import { handsOfAxes, type Hands } from '../drive/hands';
import { el } from './dom';

/** Touch joystick for devices without a keyboard. */
export class Stick {
  private readonly knob = el('span', { class: 'knob' });
  private axes: [number, number] = [0, 0];
  private finger: number | null = null;

  constructor(
    private readonly box: HTMLElement,
    private readonly changed: () => void,
  ) {
    box.append(this.knob);
    box.addEventListener('pointerdown', (event) => {
      this.finger = event.pointerId;
      box.setPointerCapture(event.pointerId);
      this.follow(event);
    });
    box.addEventListener('pointermove', (event) => event.pointerId === this.finger && this.follow(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) box.addEventListener(end, () => this.release());
    box.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  hands(): Hands {
    return handsOfAxes(this.axes);
  }

  show(visible: boolean): void {
    if (!visible) this.release();
    this.box.hidden = !visible;
  }

  release(): void {
    this.finger = null;
    this.put(0, 0);
  }

  private follow(event: PointerEvent): void {
    const { left, top, width, height } = this.box.getBoundingClientRect();
    const [x, y] = [((event.clientX - left) / width) * 2 - 1, ((event.clientY - top) / height) * 2 - 1];
    const way = Math.max(Math.hypot(x, y), 1);
    this.put(x / way, y / way);
  }

  private put(x: number, y: number): void {
    this.axes = [x, y];
    this.knob.style.translate = `${x * 36}px ${y * 36}px`;
    this.changed();
  }
}
