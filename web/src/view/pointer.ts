import type { StageView } from './stage_view';

export interface PointerEvents {
  select(row: number | null): void;
  /** The user drags a model to this pose. */
  carry(row: number, x: number, y: number, a: number): void;
  looked(): void;
  /** Sets the flight speed. [m/s] */
  flies(speed: number): void;
  /** Describes a clicked object that cannot be selected. */
  describe(what: string): void;
  mayCarry(row: number): boolean;
}

const kClickSlack = 4; // px
const kCarryPeriodMs = 33;
const kHoverPeriodMs = 80;
const kTurnStep = Math.PI / 18;
const kMouseReach = 5; // px
const kFingerReach = 18; // px: touch is less precise
const kFaster = 1.25; // speed factor per wheel notch, in flight
const kCloseScale = 140; // pixels per metre

interface Carried {
  row: number;
  dx: number; // offset of the model from the grab point
  dy: number;
  a: number;
}

/** Pointer input (mouse, pen, touch): pan, zoom, rotate, pick and drag. */
export class Pointer {
  private readonly down = new Map<number, { x: number; y: number }>();
  private start = { x: 0, y: 0 };
  private moved = false;
  private turning = false;
  private carried: Carried | null = null;
  private carriedAt = { x: 0, y: 0 };
  private lastCarry = 0;
  private lastHover = 0;
  private resting: { x: number; y: number } | null = null; // position of a mouse without a pressed button

  constructor(
    private readonly canvas: HTMLElement,
    private readonly view: StageView,
    private readonly events: PointerEvents,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.pressed(event));
    canvas.addEventListener('pointermove', (event) => this.dragged(event));
    canvas.addEventListener('pointerup', (event) => this.released(event));
    canvas.addEventListener('pointercancel', (event) => this.released(event));
    canvas.addEventListener('pointerleave', () => this.rest(null));
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('dblclick', (event) => {
      const row = this.pick(event);
      if (row !== null) this.view.goTo(row, kCloseScale);
    });
  }

  /** Repeats the hover test: models move under a resting mouse. */
  update(now: number): void {
    if (now - this.lastHover < kHoverPeriodMs) return;
    this.lastHover = now;
    const row = this.resting && this.view.pick(this.resting.x, this.resting.y, kMouseReach);
    if (row === this.view.hovered) return;
    this.view.hovered = row;
    this.canvas.style.cursor = row === null ? '' : this.events.mayCarry(row) ? 'grab' : 'pointer';
    this.view.redraw();
  }

  /** The population has changed: updates the dragged row, or drops it. */
  follow(rowNow: (row: number) => number | null): void {
    const row = this.carried && rowNow(this.carried.row);
    if (this.carried && row !== null) this.carried.row = row;
    else this.carried = null;
  }

  private pick(event: MouseEvent): number | null {
    const touch = event instanceof PointerEvent && event.pointerType === 'touch';
    return this.view.pick(event.offsetX, event.offsetY, touch ? kFingerReach : kMouseReach);
  }

  private pressed(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.resting = null;
    this.down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    this.start = { x: event.offsetX, y: event.offsetY };
    if (this.down.size > 1) {
      this.carried = null;
      this.moved = true;
      return;
    }
    this.moved = false;
    this.turning = event.button === 2 || event.button === 1 || event.shiftKey;
    if (!this.turning) this.grip(event);
  }

  private grip(event: PointerEvent): void {
    const { motion, rig } = this.view;
    const row = this.looks ? null : this.pick(event);
    const at = rig.floorAt(event.offsetX, event.offsetY);
    if (row === null || !motion || !at || !this.events.mayCarry(row)) return;
    this.carried = { row, dx: motion.x[row] - at.x, dy: motion.y[row] - at.y, a: motion.a[row] };
  }

  private dragged(event: PointerEvent): void {
    const before = this.down.get(event.pointerId);
    if (!before) return this.hover(event);
    const now = { x: event.offsetX, y: event.offsetY };
    if (!this.moved && Math.hypot(now.x - this.start.x, now.y - this.start.y) < kClickSlack) return;
    this.moved = true;
    if (this.looks) {
      if (!document.pointerLockElement) this.looks.look(now.x - before.x, now.y - before.y);
    } else if (this.down.size === 2) this.pinch(event.pointerId, before, now);
    else if (this.carried) this.carry(now);
    else if (this.turning) this.view.rig.turn((before.x - now.x) * 0.006, (before.y - now.y) * 0.006);
    else this.pan(before, now);
    this.down.set(event.pointerId, now);
    this.events.looked();
    this.view.redraw();
  }

  private released(event: PointerEvent): void {
    const wasDown = this.down.delete(event.pointerId);
    this.canvas.style.cursor = '';
    if (this.carried && this.moved) this.carryTo(this.carriedAt.x, this.carriedAt.y);
    else if (wasDown && !this.moved && !this.turning) this.click(event);
    this.carried = null;
  }

  /** The first-person or free camera, which dragging rotates; null: from above. */
  private get looks(): { look(dx: number, dy: number): void } | null {
    return this.view.flight ?? this.view.seenBy?.eyes ?? null;
  }

  private click(event: PointerEvent): void {
    if (this.looks) return; // a click captures the mouse
    const row = this.pick(event);
    this.events.select(row);
    const what = row === null ? this.view.describe(event.offsetX, event.offsetY) : null;
    if (what) this.events.describe(what);
  }

  private hover(event: PointerEvent): void {
    if (event.pointerType !== 'touch') this.rest({ x: event.offsetX, y: event.offsetY });
  }

  private rest(at: { x: number; y: number } | null): void {
    this.resting = at;
    this.update(performance.now());
  }

  private pan(before: { x: number; y: number }, now: { x: number; y: number }): void {
    const { rig } = this.view;
    const a = rig.floorAt(before.x, before.y);
    const b = rig.floorAt(now.x, now.y);
    this.view.followed = null;
    if (a && b) rig.lookAt(rig.x + a.x - b.x, rig.y + a.y - b.y);
  }

  private pinch(id: number, before: { x: number; y: number }, now: { x: number; y: number }): void {
    const other = [...this.down].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const apart = Math.hypot(before.x - other.x, before.y - other.y);
    const farther = Math.hypot(now.x - other.x, now.y - other.y);
    const { rig } = this.view;
    if (apart > 1) rig.zoom(farther / apart, (now.x + other.x) / 2, (now.y + other.y) / 2);
    const angle = Math.atan2(now.y - other.y, now.x - other.x) - Math.atan2(before.y - other.y, before.x - other.x);
    if (Math.abs(angle) < 0.5) rig.turn(angle, 0);
  }

  private carry(now: { x: number; y: number }): void {
    const at = this.view.rig.floorAt(now.x, now.y);
    if (!at || !this.carried) return;
    this.canvas.style.cursor = 'grabbing';
    this.carriedAt = { x: at.x + this.carried.dx, y: at.y + this.carried.dy };
    const time = performance.now();
    this.view.motion?.hold(this.carried.row, this.carriedAt.x, this.carriedAt.y, this.carried.a, time);
    if (time - this.lastCarry < kCarryPeriodMs) return;
    this.carryTo(this.carriedAt.x, this.carriedAt.y);
  }

  private carryTo(x: number, y: number): void {
    if (!this.carried) return;
    this.lastCarry = performance.now();
    this.view.motion?.hold(this.carried.row, x, y, this.carried.a, this.lastCarry);
    this.events.carry(this.carried.row, x, y, this.carried.a);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    if (this.carried && this.moved) {
      this.carried.a += Math.sign(event.deltaY) * kTurnStep;
      this.carryTo(this.carriedAt.x, this.carriedAt.y);
    } else if (this.view.flight) {
      this.view.flight.faster(event.deltaY < 0 ? kFaster : 1 / kFaster);
      this.events.flies(this.view.flight.speed);
    } else {
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      this.view.rig.zoom(Math.exp(-event.deltaY * lines * 0.0015), event.offsetX, event.offsetY);
      this.events.looked();
    }
    this.view.redraw();
  }
}
