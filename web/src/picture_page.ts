import { Replica } from './protocol/replica';
import { parseText, withChanges } from './protocol/scene';
import { byId } from './ui/dom';
import type { Area } from './view/areas';
import type { Eye } from './view/camera_rig';
import { StageView } from './view/stage_view';

/** View of an image: `left`, `top` is the world position of the top left corner; x points right, y up. */
export interface View {
  width: number; // pixels
  height: number;
  left: number; // m
  top: number;
  scale: number; // pixels per metre
  eye?: Eye; // a camera in the world, in place of the view from above
  hides?: number | null; // id of the model whose eye it is
}

const kMomentMs = 1000; // ms per packet: long enough that every interpolation has ended

/**
 * The page for `playhouse picture` and `playhouse film`, in a headless browser (docs/pictures.md): only the
 * world from above, drawn on request. The public functions are called by the server, in place of a link.
 */
export class PicturePage {
  private readonly canvases = [byId<HTMLCanvasElement>('picture'), byId<HTMLCanvasElement>('overlay')];
  private readonly view = new StageView(this.canvases[0], this.canvases[1], () => ({ left: 0, right: 0, top: 0, bottom: 0 }));
  private replica: Replica | null = null;
  private now = 0; // ms; virtual time, advanced per packet

  constructor() {
    document.body.classList.add('picture');
    Object.assign(this.view.layers, { sensors: false, fiducials: false }); // the server chooses the areas seen by sensors
    this.view.applyLayers();
  }

  /** Applies a text message of the viewer protocol: the scene, or changes of the population. */
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

  /** Applies a packet in base64. */
  apply(packet: string): void {
    this.held().apply(Uint8Array.from(atob(packet), (byte) => byte.charCodeAt(0)).buffer);
    this.now += kMomentMs;
    this.view.changed(this.now);
  }

  /** Draws the current world, with areas seen by sensors. Returns a PNG in base64. */
  async draw(view: View, seen: Area[]): Promise<string> {
    this.held();
    for (const { style } of this.canvases) Object.assign(style, { width: `${view.width}px`, height: `${view.height}px` });
    await this.view.filesThere();
    this.view.showAreas(seen);
    if (view.eye) this.view.lookFrom(view.eye, view.hides ?? null);
    this.view.advance(this.now + kMomentMs);
    if (!view.eye) this.view.rig.showFrom(view.left, view.top, view.scale);
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
