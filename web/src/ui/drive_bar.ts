import { isStill, type Velocity } from '../drive/hands';
import type { Model } from '../protocol/scene';
import { el, setText } from './dom';

const kHint = ['W', 'A', 'S', 'D'];

/** Shows the keys for driving the selected robot, and the commanded velocity. */
export class DriveBar {
  private readonly verb = el('span');
  private readonly who = el('b', { 'data-testid': 'drives' });
  private readonly speed = el('span', { class: 'speed', 'data-testid': 'wanted' });
  private readonly controller = el('span', { class: 'soft' });

  constructor(private readonly box: HTMLElement) {
    box.append(
      el('span', { class: 'keys' }, ...kHint.map((key) => el('kbd', {}, key)), ' or arrows ', this.verb, ' ', this.who, ', ', el('kbd', {}, 'Shift'), ' faster'),
      this.speed,
      this.controller,
    );
  }

  show(model: Model | null): void {
    this.box.hidden = model === null;
    if (!model) return;
    setText(this.verb, model.drive === 'walk' ? 'walk' : 'drive');
    setText(this.who, model.name);
    const controllers = model.controllers?.join(', ');
    setText(this.controller, controllers ? `its controller ${controllers} steers, too` : '');
    this.controller.hidden = !controllers;
  }

  showVelocity(velocity: Velocity): void {
    this.speed.hidden = isStill(velocity);
    setText(this.speed, `${velocity.forward.toFixed(2)} m/s, ${Math.round((velocity.turn * 180) / Math.PI)}°/s`);
  }
}
