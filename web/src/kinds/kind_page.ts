import type { Object3D } from 'three';
import type { Motion } from '../motion';
import type { Kind, Trait } from '../protocol/generated/views';
import type { Replica } from '../protocol/replica';
import type { Model, Scene } from '../protocol/scene';
import type { Layers } from '../view/stage_view';
import type { Theme } from '../view/theme';

/** Panel and drawings of a kind or trait; one file of this folder each, found by the bundler. */
export interface KindPage {
  kind: Kind | Trait;
  /** Content of the panel for one model. */
  panel?(model: Model, panel: PanelTools): Node[];
  /** Drawings besides the bodies, for all models of the kind. */
  drawings?(stage: Stage): Drawing[];
  /** Brightness of a body, 0 to 1, from its state bits. */
  shade?(state: number): number;
}

/** Building blocks of panels. Texts are evaluated again after every packet. */
export interface PanelTools {
  /** This viewer's current replica; its rows change when the population does. */
  replica(): Replica;
  /** Current row of a model. */
  row(id: number): number;
  /** Runs after every packet. */
  refresh(what: () => void): void;
  line(name: string, text: () => string, id?: string): HTMLElement;
  detail(text: () => string, id?: string): HTMLElement;
  /** Devices of a part, in the notation of clients. */
  codes(model: Model): HTMLElement[];
}

/** Inputs of drawings; valid for one population. */
export interface Stage {
  scene: Scene;
  replica: Replica;
  motion: Motion;
  theme: Theme;
}

export interface Drawing {
  /** The layer that shows it; none: always visible. */
  layer?: keyof Layers;
  object: Object3D;
  /** Rebuilds the geometry; called before a frame if the layer is visible. */
  draw(): void;
  dispose(): void;
}

const kFiles = import.meta.glob<{ default: KindPage }>(['./*.ts', '!./kind_page.ts', '!./*.test.ts'], { eager: true });

export const kKindPages: KindPage[] = Object.values(kFiles).map((file) => file.default);
