import { kKindPages, type KindPage, type PanelTools } from '../kinds/kind_page';
import { kViews } from '../protocol/generated/views';
import { kStalled, kSubscribed, radiansOf, type Replica } from '../protocol/replica';
import { devicesOf, type Model, type Scene } from '../protocol/scene';
import { css, el, icon, setText } from './dom';
import { degrees, metres, quantity, shortName } from './texts';

export interface PanelEvents {
  close(): void;
  follow(row: number): void;
  copy(): void;
  remove(): void;
}

type Refresh = () => void;

/** Live values of the selected robot's devices. */
export class DevicePanel {
  private refreshers: Refresh[] = [];
  private followButton: HTMLElement | null = null;
  private row: number | null = null;
  private replica!: Replica; // set before the first use
  private parts: number[] = []; // ids of the robot and its parts in the panel
  private readonly tools: PanelTools = {
    replica: () => this.replica,
    row: (id) => this.at(id),
    refresh: (what) => this.refreshers.push(what),
    line: (...line) => this.line(...line),
    detail: (...detail) => this.detail(...detail),
    codes,
  };

  constructor(
    private readonly box: HTMLElement,
    private readonly events: PanelEvents,
  ) {}

  show(scene: Scene, replica: Replica, roots: Int32Array, row: number): void {
    this.replica = replica;
    this.row = row;
    const rows = [...scene.models.keys()].filter((part) => roots[part] === row);
    const parts = [scene.models[row].id, ...rows.map((part) => scene.models[part].id)];
    // The same robot in another population: keeps its nodes, as one may be about to be clicked.
    const same = !this.box.hidden && parts.length === this.parts.length && parts.every((id, k) => id === this.parts[k]);
    this.parts = parts;
    if (same) return this.update();
    this.refreshers = [];
    this.box.classList.remove('large');
    this.box.replaceChildren(this.head(scene, roots, row), ...this.place(scene.models[row].id));
    for (const part of rows) this.box.append(...this.part(scene.models[part]));
    this.box.hidden = false;
    this.box.dataset.robot = scene.models[row].name;
    this.update();
  }

  private part(model: Model): Node[] {
    const panelOf = (what: KindPage['kind']) => kKindPages.find(({ kind }) => kind === what)?.panel?.(model, this.tools);
    const plain = () => (model.devices ? [el('h3', {}, shortName(model.name), ...codes(model)), ...this.numbers(model)] : []);
    return [...(panelOf(model.kind) ?? plain()), ...(model.traits ?? []).flatMap((trait) => panelOf(trait) ?? [])];
  }

  /** What a kind without a panel of its own measures, by the names and units of its definition. */
  private numbers(model: Model): Node[] {
    const format = kViews.find(({ kind, list }) => kind === model.kind && !list);
    if (!format) return [];
    const now = () => this.replica.views(format.kind).get(this.at(model.id)) as unknown as Record<string, number> | undefined;
    const lines = format.fields.map(([name, , worth, unit]) => this.line(name, () => quantity(now()?.[name], worth, unit)));
    return [el('table', { 'data-testid': format.kind }, ...lines)];
  }

  /** Current row of a model. */
  private at(id: number): number {
    return this.replica.rows.get(id)!;
  }

  hide(): void {
    this.row = null;
    this.refreshers = [];
    this.parts = [];
    this.box.classList.remove('large');
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
    const tags = el('p', { class: 'tags' }, el('span', { 'data-testid': 'type' }, what), stalled, used, ...this.speech(model));
    const edits = el('p', { class: 'edits' }, follow, ...(model.movable ? [copy, remove] : []));
    return el('header', {}, swatch, name, close, tags, edits);
  }

  /** Flags carried by a model, and its current text. */
  private speech(model: Model): HTMLElement[] {
    const flags = el('span', { class: 'tag', 'data-testid': 'flags' });
    const says = el('q', { 'data-testid': 'says' });
    this.refreshers.push(() => {
      const count = this.replica.flags[this.at(model.id)];
      const text = this.replica.says.get(this.at(model.id)) ?? '';
      flags.hidden = count === 0;
      setText(flags, count === 1 ? '1 flag' : `${count} flags`);
      says.hidden = text === '';
      setText(says, text);
    });
    return [flags, says];
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

/** Devices of a part, in the notation of clients. */
function codes(model: Model): HTMLElement[] {
  return (model.devices ?? []).map((device) => el('code', { 'data-device': device }, device));
}
