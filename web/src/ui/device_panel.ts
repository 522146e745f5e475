import { kMotorOn, kStalled, kSubscribed, radiansOf, type Replica } from '../protocol/replica';
import { devicesOf, type Model, type Scene, type Sensor } from '../protocol/scene';
import { bearingOf } from '../view/fans';
import { css, el, icon, setText } from './dom';
import { PolarPlot } from './polar_plot';

export interface PanelEvents {
  close(): void;
  follow(row: number): void;
  copy(): void;
  remove(): void;
}

type Refresh = () => void;

const kSonarValuesMost = 64;

/** The devices of the selected robot, live. */
export class DevicePanel {
  private refreshers: Refresh[] = [];
  private followButton: HTMLElement | null = null;
  private row: number | null = null;
  private replica!: Replica; // set before anything is shown
  private parts: number[] = []; // ids of the robot and all that is shown of it

  constructor(
    private readonly box: HTMLElement,
    private readonly events: PanelEvents,
  ) {}

  show(scene: Scene, replica: Replica, roots: Int32Array, row: number): void {
    this.replica = replica;
    this.row = row;
    const rows = [...scene.models.keys()].filter((part) => roots[part] === row);
    const parts = [scene.models[row].id, ...rows.map((part) => scene.models[part].id)];
    // The same robot in another population: its nodes stay, one may be about to be clicked.
    const same = !this.box.hidden && parts.length === this.parts.length && parts.every((id, k) => id === this.parts[k]);
    this.parts = parts;
    if (same) return this.update();
    this.refreshers = [];
    this.box.replaceChildren(this.head(scene, roots, row), ...this.place(scene.models[row].id));
    for (const part of rows) this.box.append(...this.part(scene.models[part]));
    this.box.hidden = false;
    this.box.dataset.robot = scene.models[row].name;
    this.update();
  }

  private part(model: Model): Node[] {
    if (model.kind === 'position') return this.wheels(model);
    if (model.kind === 'ranger') return this.ranger(model);
    if (model.kind === 'fiducial') return this.finder(model);
    return model.devices ? [el('h3', {}, shortName(model.name), ...codes(model))] : [];
  }

  /** Row of a model now. */
  private at(id: number): number {
    return this.replica.rows.get(id)!;
  }

  hide(): void {
    this.row = null;
    this.refreshers = [];
    this.parts = [];
    this.box.hidden = true;
    delete this.box.dataset.robot;
    this.box.replaceChildren();
  }

  showFollowed(followed: number | null): void {
    this.followButton?.setAttribute('aria-pressed', String(followed !== null && followed === this.row));
  }

  update(): void {
    for (const refresh of this.refreshers) refresh();
  }

  private head(scene: Scene, roots: Int32Array, row: number): HTMLElement {
    const model = scene.models[row];
    const state = () => this.replica.state[this.at(model.id)];
    const swatch = el('span', { class: 'swatch' });
    const stalled = el('span', { class: 'tag bad', 'data-testid': 'stalled' }, 'stalled');
    const used = el('span', { class: 'tag', title: 'a client or a controller uses it' }, 'in use');
    const follow = el('button', { title: 'Keep it in the middle (L)', 'data-testid': 'follow' }, 'Follow');
    const copy = el('button', { title: 'Another one like it, beside it (C)', 'data-testid': 'copy' }, 'Copy');
    const remove = el('button', { title: 'Take it out of the world (Delete)', 'data-testid': 'remove' }, 'Remove');
    const close = el('button', { title: 'Close (Esc)', 'aria-label': 'Close' }, icon('close'));
    follow.onclick = () => this.events.follow(this.at(model.id));
    copy.onclick = this.events.copy;
    remove.onclick = this.events.remove;
    close.onclick = this.events.close;
    this.followButton = follow;
    this.refreshers.push(() => {
      swatch.style.background = css(this.replica.color[this.at(model.id)]);
      stalled.hidden = model.kind !== 'position' || (state() & kStalled) === 0;
      used.hidden = (state() & kSubscribed) === 0;
    });
    const name = el('h2', { 'data-testid': 'selected', title: `${model.name}, a ${model.type}` }, model.name);
    const devices = devicesOf(scene, roots, row);
    const what = [model.type, ...(model.fiducial ? [`marker ${model.fiducial}`] : []), ...(devices.length === 0 ? ['no devices'] : [])].join(', ');
    const tags = el('p', { class: 'tags' }, el('span', { 'data-testid': 'type' }, what), stalled, used);
    const edits = el('p', { class: 'edits' }, follow, ...(model.movable ? [copy, remove] : []));
    return el('header', {}, swatch, name, close, tags, edits);
  }

  private place(id: number): Node[] {
    const value = (name: string, text: () => string) => this.line(name, text, `place-${name}`);
    return [
      el('h3', {}, 'Place', el('span', { class: 'detail' }, 'in the world')),
      el('table', {},
        value('x', () => metres(this.replica.x[this.at(id)] / 1000)),
        value('y', () => metres(this.replica.y[this.at(id)] / 1000)),
        value('heading', () => degrees(radiansOf(this.replica.a[this.at(id)]))),
      ),
    ];
  }

  private wheels(wheels: Model): Node[] {
    const view = () => this.replica.views('position').get(this.at(wheels.id));
    const told = (text: (now: NonNullable<ReturnType<typeof view>>) => string) => () => {
      const now = view();
      return now ? text(now) : '–';
    };
    const state = () => this.replica.state[this.at(wheels.id)];
    return [
      el('h3', {}, 'Wheels', ...codes(wheels), this.detail(() => (state() & kMotorOn ? '' : 'motor off'))),
      el('table', {},
        this.line('speed', told(({ vx }) => `${vx.toFixed(3)} m/s`), 'speed-x'),
        this.line('sideways', told(({ vy }) => `${vy.toFixed(3)} m/s`), 'speed-y'),
        this.line('turn rate', told(({ va }) => `${(va * (180 / Math.PI)).toFixed(1)} °/s`), 'speed-a'),
        this.line('odometry', told(({ ox, oy, oa }) => `${ox.toFixed(2)}, ${metres(oy)}, ${degrees(oa)}`), 'odometry'),
        this.line('stall', () => (state() & kStalled ? 'yes' : 'no'), 'stall'),
      ),
    ];
  }

  private ranger(model: Model): Node[] {
    const sensors = model.sensors ?? [];
    const scansNow = () => {
      const first = this.replica.firstSensor.get(this.at(model.id)) ?? 0;
      return sensors.map((_, nth) => this.replica.scans.get(first + nth));
    };
    const laser = sensors.some(({ samples }) => samples > 1);
    const canvas = el('canvas', { class: 'polar' });
    const plot = new PolarPlot(canvas);
    const nodes: Node[] = [
      el('h3', {}, laser ? 'Laser' : 'Sonar', ...codes(model), this.detail(() => rangerText(sensors, scansNow()), `ranger-${shortName(model.name)}`)),
      canvas,
    ];
    const drawn: (Uint16Array | undefined)[] = [];
    let drawnOnce = false;
    this.refreshers.push(() => {
      const scans = scansNow();
      if (drawnOnce && scans.every((scan, k) => scan === drawn[k])) return;
      drawnOnce = canvas.clientWidth > 0;
      scans.forEach((scan, k) => (drawn[k] = scan));
      plot.draw(sensors, scans);
    });
    nodes.push(laser ? this.laserTable(sensors[0], () => scansNow()[0]) : this.values(sensors, scansNow));
    return nodes;
  }

  private laserTable(sensor: Sensor, scan: () => Uint16Array | undefined): HTMLElement {
    const metresOf = (beam: number | undefined) => (beam === undefined ? '–' : metres((beam / 65535) * sensor.range[1]));
    const nearest = () => {
      const beams = scan();
      if (!beams) return '–';
      const k = beams.reduce((best, beam, i) => (beam < beams[best] ? i : best), 0);
      return `${metresOf(beams[k])} at ${degrees(bearingOf(sensor, k))}`;
    };
    return el('table', {},
      this.line('nearest', nearest, 'laser-nearest'),
      this.line('right, ahead, left', () => {
        const beams = scan();
        return [0, Math.floor((sensor.samples - 1) / 2), sensor.samples - 1].map((k) => metresOf(beams?.[k])).join('  ').replaceAll(' m', '');
      }),
      this.line('beams', () => `${sensor.samples}, ${Math.round((sensor.fov * 180) / Math.PI)}°, to ${Number(sensor.range[1].toFixed(1))} m`),
    );
  }

  private values(sensors: Sensor[], scans: () => (Uint16Array | undefined)[]): HTMLElement {
    const cells = sensors.slice(0, kSonarValuesMost).map(() => el('b', {}, '–'));
    this.refreshers.push(() => {
      const now = scans();
      cells.forEach((cell, k) => {
        const beam = now[k]?.[0];
        setText(cell, beam === undefined ? '–' : ((beam / 65535) * sensors[k].range[1]).toFixed(2));
      });
    });
    return el('div', { class: 'values' }, ...cells);
  }

  private finder(model: Model): Node[] {
    const table = el('table', { 'data-testid': 'fiducials' });
    this.refreshers.push(() => {
      const hits = this.replica.views('fiducial').get(this.at(model.id));
      const lines = !hits
        ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
        : hits.length === 0
          ? [el('tr', {}, el('td', { class: 'empty' }, 'sees no marker'))]
          : hits.slice(0, 12).map((hit) =>
              el('tr', {}, el('th', {}, hit.id ? `${this.replica.scene.models[this.replica.rows.get(hit.target) ?? -1]?.name ?? 'one that went'} (${hit.id})` : 'too far to read'), el('td', {}, metres(hit.range)), el('td', {}, degrees(hit.bearing))),
            );
      const text = lines.map((line) => line.textContent).join('|');
      if (table.dataset.shown === text) return;
      table.dataset.shown = text;
      table.replaceChildren(...lines);
    });
    const { range, fov } = model;
    const reach = `to ${range ?? '?'} m, ${Math.round(((fov ?? 0) * 180) / Math.PI)}°`;
    return [el('h3', {}, 'Fiducial finder', ...codes(model), el('span', { class: 'detail' }, reach)), table];
  }

  private line(name: string, text: () => string, id?: string): HTMLElement {
    const cell = el('td', id ? { 'data-testid': id } : {});
    this.refreshers.push(() => setText(cell, text()));
    return el('tr', {}, el('th', {}, name), cell);
  }

  private detail(text: () => string, id?: string): HTMLElement {
    const node = el('span', { class: 'detail', ...(id ? { 'data-testid': id } : {}) });
    this.refreshers.push(() => setText(node, text()));
    return node;
  }
}

/** The devices of a part, as a client opens them. */
function codes(model: Model): HTMLElement[] {
  return (model.devices ?? []).map((device) => el('code', { 'data-device': device }, device));
}

function rangerText(sensors: Sensor[], scans: (Uint16Array | undefined)[]): string {
  let nearest = Infinity;
  scans.forEach((scan, k) => {
    if (scan) for (const beam of scan) nearest = Math.min(nearest, (beam / 65535) * sensors[k].range[1]);
  });
  return nearest === Infinity ? 'no data yet' : `nearest ${metres(nearest)}`;
}

/** "r0.ranger:1" to "ranger:1". */
function shortName(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1);
}

function metres(value: number): string {
  return `${value.toFixed(2)} m`;
}

function degrees(radians: number): string {
  return `${((radians * 180) / Math.PI).toFixed(1)}°`;
}
