import { kStalled, type Replica } from '../protocol/replica';
import { rootsOf, type Scene } from '../protocol/scene';
import { css, el, setText } from './dom';

const kRowsMost = 300; // rows shown at once; the search finds the rest

interface Robot {
  id: number;
  row: number;
  name: string;
  devices: string[]; // of all its parts, the base's first
}

interface Entry {
  id: number;
  row: number;
  item: HTMLElement;
  button: HTMLElement;
  swatch: HTMLElement;
  tag: HTMLElement;
  shown: number; // state and colour on the screen
}

function robotsOf(scene: Scene): Robot[] {
  const roots = rootsOf(scene);
  const devices: string[][] = scene.models.map(() => []);
  scene.models.forEach((model, part) => devices[roots[part]].push(...(model.devices ?? [])));
  return scene.models.flatMap((model, row) => (model.parent < 0 && model.kind === 'position' ? [{ id: model.id, row, name: model.name, devices: devices[row] }] : []));
}

/** List of robots by name, with search. */
export class RobotList {
  private readonly search = el('input', { type: 'search', placeholder: 'Find a robot or device', 'aria-label': 'Find a robot', 'data-testid': 'search' });
  private readonly count = el('div', { class: 'count', 'data-testid': 'count' });
  private readonly list = el('ul', { 'data-testid': 'robots' });
  private robots: Robot[] = [];
  private entries: Entry[] = [];
  private replica: Replica | null = null;
  private selected: number | null = null;

  constructor(
    private readonly box: HTMLElement,
    private readonly select: (row: number) => void,
  ) {
    box.append(el('div', { class: 'search' }, this.search), this.count, this.list);
    this.search.oninput = () => this.fill();
    this.search.onkeydown = (event) => {
      if (event.key === 'Enter' && this.entries[0]) this.select(this.entries[0].row);
      if (event.key === 'Escape') this.search.blur();
    };
  }

  focus(): void {
    this.box.classList.remove('desk');
    this.search.focus();
    this.search.select();
  }

  /** Sets another scene or population. */
  show(scene: Scene, replica: Replica): void {
    if (this.replica?.scene.name !== scene.name) this.entries = [];
    this.replica = replica;
    this.robots = robotsOf(scene);
    this.fill();
  }

  showSelected(row: number | null): void {
    this.selected = row;
    for (const entry of this.entries) entry.button.setAttribute('aria-current', String(entry.row === row));
  }

  /** Updates state and colour of the listed robots. */
  update(): void {
    const { replica } = this;
    if (!replica) return;
    for (const entry of this.entries) {
      const state = replica.state[entry.row] & kStalled;
      const now = (replica.color[entry.row] >>> 8) * 2 + state;
      if (now === entry.shown) continue;
      entry.shown = now;
      entry.swatch.style.background = css(replica.color[entry.row]);
      entry.tag.hidden = state === 0;
    }
  }

  private fill(): void {
    const wanted = this.search.value.trim().toLowerCase();
    const found = this.robots.filter(({ name, devices }) => [name, ...devices].some((text) => text.toLowerCase().includes(wanted)));
    // Reuses the entries of robots that stay: one may be about to be clicked.
    const known = new Map(this.entries.map((entry) => [entry.id, entry]));
    this.entries = found.slice(0, kRowsMost).map((robot) => this.entry(robot, known.get(robot.id)));
    const items = this.entries.map((entry) => entry.item);
    if (items.length !== this.list.children.length || items.some((item, k) => item !== this.list.children[k])) this.list.replaceChildren(...items);
    const more = found.length > kRowsMost ? `, the first ${kRowsMost} shown` : '';
    const all = `${this.robots.length} robot${this.robots.length === 1 ? '' : 's'}`;
    setText(this.count, wanted ? `${found.length} of ${all}${more}` : all + more);
    this.showSelected(this.selected);
    this.update();
  }

  private entry({ id, row, name, devices }: Robot, known: Entry | undefined): Entry {
    if (known) {
      known.row = row;
      return known;
    }
    const swatch = el('span', { class: 'swatch' });
    const tag = el('span', { class: 'tag bad', hidden: true }, 'stalled');
    const wheels = devices[0] ? el('code', {}, devices[0]) : null;
    const button = el('button', { 'data-robot': name, title: [name, ...devices].join('\n') }, swatch, el('span', { class: 'name' }, name), tag, wheels);
    const entry: Entry = { id, row, item: el('li', {}, button), button, swatch, tag, shown: -1 };
    button.onclick = () => this.select(entry.row);
    return entry;
  }
}
