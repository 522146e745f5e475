import { kMotorOff, kStalled, kSubscribed, radiansOf, type Replica, type SensorPlace } from '../protocol/replica';
import { devicesOf, type Model, type Scene } from '../protocol/scene';
import { bearingOf } from '../view/fans';
import { css, el, icon, setText } from './dom';
import { PolarPlot } from './polar_plot';

export interface PanelEvents {
  close(): void;
  follow(row: number): void;
}

type Refresh = () => void;

const kSonarValuesMost = 64;

/** The devices of the selected robot, live. */
export class DevicePanel {
  private refreshers: Refresh[] = [];
  private followButton: HTMLElement | null = null;
  private row: number | null = null;

  constructor(
    private readonly box: HTMLElement,
    private readonly events: PanelEvents,
  ) {}

  show(scene: Scene, replica: Replica, roots: Int32Array, row: number): void {
    this.row = row;
    this.refreshers = [];
    this.box.replaceChildren(this.head(scene, replica, roots, row), ...this.place(replica, row));
    scene.models.forEach((model, part) => {
      if (roots[part] !== row) return;
      if (model.kind === 'position' && model.position !== undefined) this.box.append(...this.wheels(replica, model, part, model.position));
      if (model.kind === 'ranger') this.box.append(...this.ranger(scene, replica, part));
      if (model.kind === 'fiducial' && model.finder !== undefined) this.box.append(...this.finder(scene, replica, part, model.finder));
      if (model.kind === 'plain' && model.devices) this.box.append(el('h3', {}, shortName(model.name), ...codes(model)));
    });
    this.box.hidden = false;
    this.box.dataset.robot = scene.models[row].name;
    this.update();
  }

  hide(): void {
    this.row = null;
    this.refreshers = [];
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

  private head(scene: Scene, replica: Replica, roots: Int32Array, row: number): HTMLElement {
    const model = scene.models[row];
    const swatch = el('span', { class: 'swatch' });
    const stalled = el('span', { class: 'tag bad', 'data-testid': 'stalled' }, 'stalled');
    const used = el('span', { class: 'tag', title: 'a client or a controller uses it' }, 'in use');
    const follow = el('button', { title: 'Keep it in the middle (L)', 'data-testid': 'follow' }, 'Follow');
    const close = el('button', { title: 'Close (Esc)', 'aria-label': 'Close' }, icon('close'));
    follow.onclick = () => this.events.follow(row);
    close.onclick = this.events.close;
    this.followButton = follow;
    this.refreshers.push(() => {
      swatch.style.background = css(replica.color[row]);
      stalled.hidden = (replica.state[row] & kStalled) === 0;
      used.hidden = (replica.state[row] & kSubscribed) === 0;
    });
    const name = el('h2', { 'data-testid': 'selected', title: `${model.name}, a ${model.type}` }, model.name);
    const devices = devicesOf(scene, roots, row);
    const what = [model.type, ...(model.fiducial ? [`marker ${model.fiducial}`] : []), ...(devices.length === 0 ? ['no devices'] : [])].join(', ');
    const tags = el('p', { class: 'tags' }, el('span', { 'data-testid': 'type' }, what), stalled, used);
    return el('header', {}, swatch, name, follow, close, tags);
  }

  private place(replica: Replica, row: number): Node[] {
    const value = (name: string, text: () => string) => this.line(name, text, `place-${name}`);
    return [
      el('h3', {}, 'Place', el('span', { class: 'detail' }, 'in the world')),
      el('table', {},
        value('x', () => metres(replica.x[row] / 1000)),
        value('y', () => metres(replica.y[row] / 1000)),
        value('heading', () => degrees(radiansOf(replica.a[row]))),
      ),
    ];
  }

  private wheels(replica: Replica, wheels: Model, model: number, position: number): Node[] {
    const field = (k: number) => replica.positions[position * 6 + k];
    return [
      el('h3', {}, 'Wheels', ...codes(wheels), this.detail(() => (replica.state[model] & kMotorOff ? 'motor off' : ''))),
      el('table', {},
        this.line('speed', () => `${(field(0) / 1000).toFixed(3)} m/s`, 'speed-x'),
        this.line('sideways', () => `${(field(1) / 1000).toFixed(3)} m/s`, 'speed-y'),
        this.line('turn rate', () => `${((field(2) / 1000) * (180 / Math.PI)).toFixed(1)} °/s`, 'speed-a'),
        this.line('odometry', () => `${(field(3) / 1000).toFixed(2)}, ${metres(field(4) / 1000)}, ${degrees(radiansOf(field(5)))}`, 'odometry'),
        this.line('stall', () => (replica.state[model] & kStalled ? 'yes' : 'no'), 'stall'),
      ),
    ];
  }

  private ranger(scene: Scene, replica: Replica, row: number): Node[] {
    const model = scene.models[row];
    const rows = scene.sensors[model.sensors!].map((_, nth) => model.first_sensor! + nth);
    const sensors = rows.map((sensor) => replica.sensors[sensor]);
    const scansNow = () => rows.map((sensor) => replica.scans.get(sensor));
    const laser = sensors.some(({ sensor }) => sensor.samples > 1);
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
    nodes.push(laser ? this.laserTable(sensors[0], () => replica.scans.get(rows[0])) : this.values(sensors, scansNow));
    return nodes;
  }

  private laserTable(place: SensorPlace, scan: () => Uint16Array | undefined): HTMLElement {
    const { sensor } = place;
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

  private values(sensors: SensorPlace[], scans: () => (Uint16Array | undefined)[]): HTMLElement {
    const cells = sensors.slice(0, kSonarValuesMost).map(() => el('b', {}, '–'));
    this.refreshers.push(() => {
      const now = scans();
      cells.forEach((cell, k) => {
        const beam = now[k]?.[0];
        setText(cell, beam === undefined ? '–' : ((beam / 65535) * sensors[k].sensor.range[1]).toFixed(2));
      });
    });
    return el('div', { class: 'values' }, ...cells);
  }

  private finder(scene: Scene, replica: Replica, row: number, finder: number): Node[] {
    const table = el('table', { 'data-testid': 'fiducials' });
    this.refreshers.push(() => {
      const hits = replica.findings.get(finder);
      const lines = !hits
        ? [el('tr', {}, el('td', { class: 'empty' }, 'no data yet'))]
        : hits.length === 0
          ? [el('tr', {}, el('td', { class: 'empty' }, 'sees no marker'))]
          : hits.slice(0, 12).map((hit) =>
              el('tr', {}, el('th', {}, hit.id ? `${scene.models[hit.target].name} (${hit.id})` : 'too far to read'), el('td', {}, metres(hit.range)), el('td', {}, degrees(hit.bearing))),
            );
      const text = lines.map((line) => line.textContent).join('|');
      if (table.dataset.shown === text) return;
      table.dataset.shown = text;
      table.replaceChildren(...lines);
    });
    const { range, fov } = scene.models[row];
    const reach = `to ${range ?? '?'} m, ${Math.round(((fov ?? 0) * 180) / Math.PI)}°`;
    return [el('h3', {}, 'Fiducial finder', ...codes(scene.models[row]), el('span', { class: 'detail' }, reach)), table];
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

function rangerText(sensors: SensorPlace[], scans: (Uint16Array | undefined)[]): string {
  let nearest = Infinity;
  scans.forEach((scan, k) => {
    if (scan) for (const beam of scan) nearest = Math.min(nearest, (beam / 65535) * sensors[k].sensor.range[1]);
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
