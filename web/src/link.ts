import type { Command } from './protocol/generated/commands';
import { Replica } from './protocol/replica';
import { parseText, withChanges, type Changes, type Driven, type History, type Joined, type People, type PhysicsShapes, type SaidLine, type Scene, type WorldFile } from './protocol/scene';
import { Watchdog } from './watchdog';

/** 'slow': connected, but this page draws too slowly. */
export type LinkState = 'connecting' | 'live' | 'slow' | 'silent' | 'lost';

export interface LinkEvents {
  scene(scene: Scene, replica: Replica): void;
  /** The same world with another population. */
  population(scene: Scene, replica: Replica): void;
  packet(): void;
  history(history: History): void;
  /** What was said before this page came. */
  said(lines: SaidLine[]): void;
  file(world: WorldFile): void;
  people(people: People): void;
  /** The viewer's own body was spawned. */
  joined(joined: Joined): void;
  driven(driven: Driven): void;
  physics(shapes: PhysicsShapes): void;
  notice(text: string): void;
  /** `why`: the server's reason for closing the connection, if it gave one. */
  state(state: LinkState, why: string): void;
}

const kLookMs = 500;
const kRetryMs = [300, 600, 1200, 2500, 5000];

/**
 * The connection to the server: applies packets, acknowledges them per drawn frame
 * (flow control: a page that draws slowly gets fewer packets), and reconnects.
 */
export class Link {
  private socket: WebSocket | null = null;
  private replica: Replica | null = null;
  private tries = 0;
  private unacknowledged = 0;
  private current: LinkState = 'connecting';
  private readonly watchdog = new Watchdog(performance.now());

  constructor(
    private readonly url: string,
    private readonly events: LinkEvents,
  ) {
    this.connect();
    window.setInterval(() => this.lookAround(), kLookMs);
    document.addEventListener('visibilitychange', () => this.watchdog.rest(performance.now()));
  }

  send(command: Command): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  /** Call once per drawn frame. */
  acknowledge(): void {
    if (this.unacknowledged === 0) return;
    this.send({ do: 'ack', frame: this.unacknowledged });
    this.unacknowledged = 0;
    this.watchdog.drew(performance.now());
  }

  private connect(): void {
    const socket = new WebSocket(this.url);
    socket.binaryType = 'arraybuffer';
    socket.onmessage = (message) => this.receive(socket, message.data);
    socket.onclose = (event) => this.closed(socket, event.reason);
    this.socket = socket;
  }

  private receive(socket: WebSocket, data: string | ArrayBuffer): void {
    if (socket !== this.socket) return;
    this.watchdog.heard(performance.now());
    try {
      if (typeof data === 'string') this.receiveText(data);
      else this.receivePacket(data);
    } catch (error) {
      this.events.notice(error instanceof Error ? error.message : String(error));
      socket.close();
    }
  }

  private receiveText(text: string): void {
    const message = parseText(text);
    if ('notice' in message) return this.events.notice(message.notice);
    if ('history' in message) return this.events.history(message.history);
    if ('said' in message) return this.events.said(message.said);
    if ('world' in message) return this.events.file(message.world);
    if ('joined' in message) return this.events.joined(message);
    if ('driven' in message) return this.events.driven(message.driven);
    if ('physics' in message) return this.events.physics(message.physics);
    if ('people' in message) return this.events.people(message.people);
    if ('changes' in message) return this.follow(message.changes);
    this.tries = 0;
    this.unacknowledged = 0;
    this.replica = new Replica(message.scene);
    this.watchdog.rest(performance.now());
    this.events.scene(message.scene, this.replica);
    this.change('live');
  }

  private follow(changes: Changes): void {
    if (!this.replica) throw new Error('changes came before the scene');
    const scene = withChanges(this.replica.scene, changes);
    this.replica = this.replica.followedBy(scene, new Set(changes.models.map((model) => model.id)));
    this.events.population(scene, this.replica);
  }

  private receivePacket(packet: ArrayBuffer): void {
    if (!this.replica) throw new Error('a packet came before the scene');
    this.replica.apply(packet);
    this.unacknowledged = this.replica.frame;
    this.watchdog.owes(performance.now());
    this.change(this.watchdog.verdict(performance.now()));
    this.events.packet();
  }

  private closed(socket: WebSocket, why: string): void {
    if (socket !== this.socket) return;
    this.socket = null;
    this.change('lost', why);
    const wait = kRetryMs[Math.min(this.tries++, kRetryMs.length - 1)];
    window.setTimeout(() => this.connect(), wait);
  }

  // A hidden page draws no frames, so it sends no acknowledgements and receives nothing: nobody's fault.
  private lookAround(): void {
    const now = performance.now();
    if (document.hidden) this.watchdog.rest(now);
    this.watchdog.look(now);
    const judges = this.current === 'live' || this.current === 'slow' || this.current === 'silent';
    if (judges) this.change(this.watchdog.verdict(now));
  }

  private change(state: LinkState, why = ''): void {
    if (state === this.current && why === '') return;
    this.current = state;
    this.events.state(state, why);
  }
}
