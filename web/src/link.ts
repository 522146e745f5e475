import type { Command } from './protocol/generated/commands';
import { Replica } from './protocol/replica';
import { parseText, withChanges, type Changes, type Driven, type History, type Joined, type People, type PhysicsShapes, type Scene, type WorldFile } from './protocol/scene';

export type LinkState = 'connecting' | 'live' | 'silent' | 'lost';

export interface LinkEvents {
  scene(scene: Scene, replica: Replica): void;
  /** The same world with another population. */
  population(scene: Scene, replica: Replica): void;
  packet(): void;
  history(history: History): void;
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

const kSilentMs = 4000; // the server sends at least one message per second
const kRetryMs = [300, 600, 1200, 2500, 5000];

/**
 * The connection to the server: applies packets, acknowledges them per drawn frame
 * (flow control: a page that draws slowly gets fewer packets), and reconnects.
 */
export class Link {
  private socket: WebSocket | null = null;
  private replica: Replica | null = null;
  private tries = 0;
  private lastHeard = 0;
  private unacknowledged = 0;
  private current: LinkState = 'connecting';

  constructor(
    private readonly url: string,
    private readonly events: LinkEvents,
  ) {
    this.connect();
    window.setInterval(() => this.listenForSilence(), 500);
  }

  send(command: Command): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  /** Call once per drawn frame. */
  acknowledge(): void {
    if (this.unacknowledged === 0) return;
    this.send({ do: 'ack', frame: this.unacknowledged });
    this.unacknowledged = 0;
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
    this.lastHeard = performance.now();
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
    if ('world' in message) return this.events.file(message.world);
    if ('joined' in message) return this.events.joined(message);
    if ('driven' in message) return this.events.driven(message.driven);
    if ('physics' in message) return this.events.physics(message.physics);
    if ('people' in message) return this.events.people(message.people);
    if ('changes' in message) return this.follow(message.changes);
    this.tries = 0;
    this.unacknowledged = 0;
    this.replica = new Replica(message.scene);
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
    this.change('live');
    this.events.packet();
  }

  private closed(socket: WebSocket, why: string): void {
    if (socket !== this.socket) return;
    this.socket = null;
    this.change('lost', why);
    const wait = kRetryMs[Math.min(this.tries++, kRetryMs.length - 1)];
    window.setTimeout(() => this.connect(), wait);
  }

  // A hidden page draws no frames, so it sends no acknowledgements and receives nothing: not a timeout.
  private listenForSilence(): void {
    if (document.hidden) this.lastHeard = performance.now();
    if (this.current === 'live' && performance.now() - this.lastHeard > kSilentMs) this.change('silent');
  }

  private change(state: LinkState, why = ''): void {
    if (state === this.current && why === '') return;
    this.current = state;
    this.events.state(state, why);
  }
}
