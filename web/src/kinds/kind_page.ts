import type { Object3D } from 'three';
import type { Motion } from '../motion';
import type { Kind, Trait } from '../protocol/generated/views';
import type { Replica } from '../protocol/replica';
import type { Model, Scene } from '../protocol/scene';
import type { Layers } from '../view/stage_view';
import type { Theme } from '../view/theme';

/** What the page does with models of a kind, or with a trait, beyond their bodies: a file of this folder each, found by itself. */
export interface KindPage {
  kind: Kind | Trait;
  /** What the panel says of one model. */
  panel?(model: Model, panel: PanelTools): Node[];
  /** What is drawn beside bodies, of all models of the kind. */
  drawings?(stage: Stage): Drawing[];
  /** How bright a body is drawn, from 0 to 1, by the bits of its state. */
  shade?(state: number): number;
}

/** What a panel's lines are made of. Texts are asked for again after every packet. */
export interface PanelTools {
  /** What this viewer holds now; rows in it move when robots come or go. */
  replica(): Replica;
  /** Row of a model now. */
  row(id: number): number;
  /** Runs after every packet. */
  refresh(what: () => void): void;
  line(name: string, text: () => string, id?: string): HTMLElement;
  detail(text: () => string, id?: string): HTMLElement;
  /** The devices of a part, as a client opens them. */
  codes(model: Model): HTMLElement[];
}

/** What drawings read; of one population. */
export interface Stage {
  scene: Scene;
  replica: Replica;
  motion: Motion;
  theme: Theme;
}

export interface Drawing {
  /** Which layer it is shown with; without one it always is. */
  layer?: keyof Layers;
  object: Object3D;
  /** Lays it anew; called before a picture when the layer is shown. */
  draw(): void;
  dispose(): void;
}

const kFiles = import.meta.glob<{ default: KindPage }>(['./*.ts', '!./kind_page.ts', '!./*.test.ts'], { eager: true });

export const kKindPages: KindPage[] = Object.values(kFiles).map((file) => file.default);
