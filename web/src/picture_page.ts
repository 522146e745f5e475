import { Replica } from './protocol/replica';
import { parseText, withChanges } from './protocol/scene';
import { byId } from './ui/dom';
import type { Area } from './view/areas';
import { StageView } from './view/stage_view';

/** What a picture shows: its corner at the top left lies at `left`, `top` in the world; x goes right, y up. */
export interface View {
  width: number; // pixels
  height: number;
  left: number; // m
  top: number;
  scale: number; // pixels per metre
}

const kMomentMs = 1000; // between two packets, in which all motion between them ends

/**
 * The page as `playhouse picture` and `playhouse film` open it, in a browser that they started (docs/pictures.md): nothing
 * but the world, from above, drawn when the program says so. The program calls what is public here, in place of a link.
 */
export class PicturePage {
  private readonly canvases = [byId<HTMLCanvasElement>('picture'), byId<HTMLCanvasElement>('overlay')];
  private readonly view = new StageView(this.canvases[0], this.canvases[1], () => ({ left: 0, right: 0, top: 0, bottom: 0 }));
  private replica: Replica | null = null;
  private now = 0; // ms; there is no clock: moments come as fast as the program makes them

  constructor() {
    document.body.classList.add('picture');
    Object.assign(this.view.layers, { sensors: false, fiducials: false }); // the program says what is seen
    this.view.applyLayers();
  }

  /** A text message of the viewer protocol: the scene, or who came and went. */
  tell(text: string): void {
    const message = parseText(text);
    if ('scene' in message) {
      this.replica = new Replica(message.scene);
      this.view.show(message.scene, this.replica);
    } else if ('changes' in message) {
      const replica = this.held();
      const scene = withChanges(replica.scene, message.changes);
      this.replica = replica.followedBy(scene, new Set(message.changes.models.map((model) => model.id)));
      this.view.follow(scene, this.replica);
    }
  }

  /** A packet, in base64. */
  apply(packet: string): void {
    this.held().apply(Uint8Array.from(atob(packet), (byte) => byte.charCodeAt(0)).buffer);
    this.now += kMomentMs;
    this.view.changed(this.now);
  }

  /** The world as it was told last, with what sensors see, as a PNG file in base64. */
  async draw(view: View, seen: Area[]): Promise<string> {
    this.held();
    for (const { style } of this.canvases) Object.assign(style, { width: `${view.width}px`, height: `${view.height}px` });
    await this.view.filesThere();
    this.view.showAreas(seen);
    this.view.advance(this.now + kMomentMs);
    this.view.rig.showFrom(view.left, view.top, view.scale);
    return base64Of(await this.view.picturePng());
  }

  private held(): Replica {
    if (!this.replica) throw new Error('there is no scene yet');
    return this.replica;
  }
}

async function base64Of(file: Blob): Promise<string> {
  const reader = new FileReader();
  const url = await new Promise<string>((done, fail) => {
    reader.onload = () => done(reader.result as string);
    reader.onerror = () => fail(reader.error);
    reader.readAsDataURL(file);
  });
  return url.slice(url.indexOf(',') + 1);
}
