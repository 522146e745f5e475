import { type Client, connect, type DeviceEntry, Mode, Rule } from '../../../clients/typescript/src/index';
import { byId, el, setText } from '../ui/dom';
import { Watched } from './watched';

const kLookMs = 2000; // period of looking for clients, and for new devices
const kRetryMs = 1000;

interface ServerStatus {
  ports: number[];
  drives: boolean; // whether this page may
  clients: { peer: string; port: number; devices: string[] }[];
  recording?: { file: string; messages: number; bytes: number };
}

/** The page of a server without a world: a Player client over a WebSocket, like any other client. */
class DevicesPage {
  private readonly token = decodeURIComponent(location.hash.slice(1));
  private readonly state = el('span', { class: 'dot', 'data-state': 'connecting' });
  private readonly banner = el('span', { class: 'world' });
  private readonly portMenu = el('select', { title: 'Port of the server', hidden: true });
  private client: Client | null = null;
  private entries: DeviceEntry[] = [];
  private readonly watched = new Map<string, Watched>();
  private port = 0; // 0: the default one
  private ports: number[] = [];
  private drives = true; // of an observer's page: false

  constructor() {
    byId('bar').append(el('span', { class: 'brand' }, this.state, 'Playhouse', this.banner), this.portMenu);
    this.portMenu.onchange = () => {
      this.port = Number(this.portMenu.value);
      this.watched.clear();
      byId('cards').replaceChildren();
      void this.client?.close();
    };
  }

  /** For ever: connects, reads, and connects again. */
  async run(): Promise<never> {
    this.draw();
    window.setInterval(() => void this.lookAtServer(), kLookMs);
    for (;;) {
      try {
        await this.session();
      } catch (error) {
        this.lost(error instanceof Error ? error.message : String(error));
      }
      await new Promise((resolve) => window.setTimeout(resolve, kRetryMs));
    }
  }

  private async session(): Promise<void> {
    const client = await connect(this.address(), { mode: Mode.PUSH, token: this.token });
    this.client = client;
    try {
      await client.setReplaceRule(Rule.REPLACE); // a slow page sees the newest
      this.state.dataset.state = 'live';
      byId('notice').hidden = true;
      setText(this.banner, client.banner.replace(/^Player v\./, ''));
      await this.lookAtServer();
      await this.list();
      await this.reopen();
      for (;;) await client.read(Infinity);
    } finally {
      this.client = null;
      await client.close();
    }
  }

  private address(): string {
    const at = new URL(this.port === 0 ? 'player' : `player/${this.port}`, location.href.replace(/^http/, 'ws'));
    at.hash = '';
    return at.href;
  }

  private lost(why: string): void {
    this.state.dataset.state = 'lost';
    byId('notice').hidden = false;
    setText(byId('notice'), `${why}. Trying again …`);
  }

  private async list(): Promise<void> {
    if (!this.client) return;
    this.entries = await this.client.devices();
    const list = byId('list');
    list.replaceChildren(el('h2', {}, this.entries.length === 1 ? '1 device' : `${this.entries.length} devices`));
    for (const entry of this.entries) {
      const button = el('button', { 'data-device': entry.name, 'aria-pressed': String(this.watched.has(entry.name)) },
        entry.name, el('small', {}, entry.model === '' ? entry.driver : entry.model));
      button.onclick = () => void this.toggle(entry, button);
      list.append(button);
    }
  }

  private async toggle(entry: DeviceEntry, button: HTMLElement): Promise<void> {
    const watched = this.watched.get(entry.name);
    button.setAttribute('aria-pressed', String(!watched));
    if (watched) {
      this.watched.delete(entry.name);
      await watched.close();
    } else {
      await this.watch(entry);
    }
  }

  private async watch(entry: DeviceEntry): Promise<void> {
    if (!this.client) return;
    const watched = new Watched(entry, this.client, this.drives, () => {
      const button = byId('list').querySelector<HTMLElement>(`[data-device="${CSS.escape(entry.name)}"]`);
      if (button) void this.toggle(entry, button);
    });
    this.watched.set(entry.name, watched);
    byId('cards').append(watched.card);
    await watched.open();
  }

  /** After a new connection: what was watched is watched again. */
  private async reopen(): Promise<void> {
    const names = [...this.watched.keys()];
    this.watched.clear();
    byId('cards').replaceChildren();
    for (const name of names) {
      const entry = this.entries.find((each) => each.name === name);
      if (entry) await this.watch(entry);
    }
    await this.list();
  }

  private async lookAtServer(): Promise<void> {
    const query = this.token === '' ? '' : `?token=${encodeURIComponent(this.token)}`;
    const answer = await fetch(`status.json${query}`).catch(() => null);
    if (!answer?.ok) return;
    const status = (await answer.json()) as ServerStatus;
    this.drives = status.drives;
    this.showPorts(status.ports);
    const clients = status.clients.map(({ peer, devices }) =>
      el('p', {}, peer, el('small', { title: devices.join(', ') }, devices.length === 1 ? devices[0] : `${devices.length} devices`)));
    const recording = status.recording
      ? [el('h2', {}, 'Recording'), el('p', { 'data-testid': 'recording' }, status.recording.file,
          el('small', {}, `${status.recording.messages} messages, ${(status.recording.bytes / 1e6).toFixed(1)} MB`))]
      : [];
    byId('server').replaceChildren(el('h2', {}, clients.length === 1 ? '1 client' : `${clients.length} clients`), ...clients, ...recording);
  }

  private showPorts(ports: number[]): void {
    if (String(ports) === String(this.ports)) return;
    this.ports = ports;
    this.portMenu.hidden = ports.length < 2;
    this.portMenu.replaceChildren(...ports.map((port) => el('option', { value: String(port) }, `port ${port}`)));
  }

  private draw(): void {
    for (const watched of this.watched.values()) watched.draw();
    requestAnimationFrame(() => this.draw());
  }
}

void new DevicesPage().run();
