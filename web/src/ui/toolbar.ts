import type { LinkState } from '../link';
import type { People } from '../protocol/scene';
import type { Layers } from '../view/stage_view';
import { el, icon, setText } from './dom';
import type { PeopleMenu } from './people_menu';

export interface ToolbarEvents {
  togglePause(): void;
  step(): void;
  speed(timesRealTime: number): void;
  layers(): void;
  tilt(): void;
  fit(): void;
  toggleList(): void;
  /** Spawns a robot, by its index in the list. */
  add(robot: number): void;
  /** Joins as a person, or leaves. */
  join(): void;
  /** Waves a hand. */
  wave(): void;
  /** Toggles free flight of the camera. */
  fly(): void;
  /** Saves the current world as a file. */
  save(): void;
  /** Saves the current view as an image. */
  picture(): void;
  help(): void;
}

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, 0];
const kLayers: [keyof Layers, string, string][] = [
  ['sensors', 'Sensors', 'V'],
  ['fiducials', 'Fiducials', 'M'],
  ['trails', 'Trails', 'R'],
  ['names', 'Names', 'N'],
  ['speech', 'Speech and flags', 'B'],
  ['grid', 'Grid', 'G'],
  ['drawings', 'Drawings of clients', 'J'],
  ['physics', 'Physics shapes', 'X'],
];

const kEdge = 8; // px, margin of a sheet to the window's edge
const kNarrow = window.matchMedia('(max-width: 1100px)');

function speedText(speed: number): string {
  if (kNarrow.matches) return speed === 0 ? 'fastest' : `${speed}×`;
  return speed === 0 ? 'as fast as possible' : `${speed}× real time`;
}

/** Whether a select's list is open; older browsers cannot tell (then false). */
function isOpen(select: HTMLSelectElement): boolean {
  return CSS.supports('selector(:open)') && select.matches(':open');
}

/** Title of a world: its name, or the file name if the world has no name of its own. */
export function worldTitle(name: string): string {
  return name.endsWith('.world') ? name.slice(name.lastIndexOf('/') + 1, -'.world'.length) : name;
}

/** Toolbar at the top: world, run control, view. */
export class Toolbar {
  private readonly dot = el('span', { class: 'dot', 'data-testid': 'link' });
  private readonly world = el('span', { class: 'world', 'data-testid': 'world' });
  private readonly pause = el('button', { class: 'main', 'data-testid': 'pause', title: 'Pause or go on (space)' });
  private readonly speeds = el('select', { 'data-testid': 'speed', 'aria-label': 'Speed', title: 'Speed' });
  private readonly sheet = el('div', { class: 'sheet', hidden: true });
  private readonly addSheet = el('div', { class: 'sheet', hidden: true });
  private readonly addButton = el('button', { 'aria-haspopup': 'true', 'aria-expanded': 'false', 'data-testid': 'add', title: 'Another robot, in the middle of the picture' }, 'Add');
  private readonly saveButton = el('button', { class: 'desk', 'data-testid': 'save', title: 'The world as it stands now, as a world file' }, 'Save world');
  private readonly joinButton = el('button', { 'data-testid': 'join', hidden: true, title: 'Come into the world as a person' }, 'Join');
  private readonly waveButton = el('button', { 'data-testid': 'wave', hidden: true, title: 'Wave (H)' }, 'Wave');
  private readonly flyButton = el('button', { class: 'desk', 'data-testid': 'fly', 'aria-pressed': 'false', title: 'Fly through the world (O)' }, 'Fly');
  private readonly boxes = new Map<keyof Layers, HTMLInputElement>();
  private readonly stepButton = el('button', { 'data-testid': 'step', title: 'One tick (.)', 'aria-label': 'Step' }, icon('step'), el('span', { class: 'desk' }, ' Step'));
  private readonly tiltButton = el('button', { 'data-testid': 'tilt', title: 'From above or tilted (T)' });
  private paused: boolean | null = null;
  private live = false;
  private rights: Pick<People, 'manages' | 'edits'> = { manages: true, edits: true };
  private addable = 0; // number of spawnable robot types

  constructor(
    bar: HTMLElement,
    private readonly layers: Layers,
    people: PeopleMenu,
    private readonly events: ToolbarEvents,
  ) {
    const list = el('button', { class: 'phone', title: 'Robots', 'aria-label': 'Robots', 'data-testid': 'list' }, icon('list'));
    const fit = el('button', { class: 'desk', title: 'Everything on the screen (F)', 'data-testid': 'fit' }, 'Fit');
    const picture = el('button', { class: 'desk', 'data-testid': 'picture', title: 'What is on the screen, as a PNG file (P)' }, 'Picture');
    const help = el('button', { title: 'Help (?)', 'aria-label': 'Help', 'data-testid': 'help' }, '?');
    this.pause.onclick = events.togglePause;
    this.stepButton.onclick = events.step;
    list.onclick = events.toggleList;
    fit.onclick = events.fit;
    help.onclick = events.help;
    this.joinButton.onclick = events.join;
    this.waveButton.onclick = events.wave;
    this.flyButton.onclick = events.fly;
    this.saveButton.onclick = events.save;
    picture.onclick = events.picture;
    this.tiltButton.onclick = events.tilt;
    this.speeds.onchange = () => events.speed(Number(this.speeds.value));
    // The focused select handles the arrow keys: after a choice by mouse it loses the focus, so that they drive again.
    this.speeds.onpointerup = () => this.speeds.addEventListener('change', () => this.speeds.blur(), { once: true });
    this.showSpeed(1);
    bar.append(
      el('span', { class: 'brand' }, this.dot, el('span', { class: 'desk' }, 'Playhouse'), this.world),
      list, el('span', { class: 'rule' }), this.pause, this.stepButton, this.speeds, el('span', { class: 'gap' }),
      this.waveButton, this.joinButton, this.menu(people.button, people.sheet), this.menu(this.addButton, this.addSheet), this.saveButton, picture, this.flyButton, this.tiltButton, fit, this.layerMenu(), help,
    );
    this.showPaused(false);
    this.showTilted(false);
  }

  showLink(state: LinkState, text: string, live: boolean): void {
    this.dot.dataset.state = state;
    this.dot.title = text;
    this.live = live;
    this.showAllowed();
  }

  showRights(rights: People): void {
    this.rights = rights;
    this.showAllowed();
  }

  private showAllowed(): void {
    this.joinButton.disabled = this.waveButton.disabled = !this.live;
    for (const control of [this.pause, this.stepButton, this.speeds]) control.disabled = !this.live || !this.rights.manages;
    for (const control of [this.addButton, this.saveButton]) control.disabled = !this.live;
    this.addButton.hidden = !this.rights.edits || this.addable === 0;
    this.saveButton.hidden = !this.rights.edits;
  }

  showWorld(name: string): void {
    const short = worldTitle(name);
    setText(this.world, short);
    this.world.title = name;
    document.title = `${short} · Playhouse`;
  }

  showAddable(names: string[]): void {
    this.addable = names.length;
    this.showAllowed();
    this.addSheet.replaceChildren(...names.map((name, robot) => {
      const choice = el('button', { 'data-add': name }, name);
      choice.onclick = () => {
        this.addButton.click();
        this.events.add(robot);
      };
      return choice;
    }));
  }

  /** Shows whether joining is possible, and whether the viewer has joined. */
  showJoin(possible: boolean, joined: boolean): void {
    this.joinButton.hidden = !possible;
    this.waveButton.hidden = !joined;
    setText(this.joinButton, joined ? 'Leave' : 'Join');
  }

  showPaused(paused: boolean): void {
    if (paused === this.paused) return;
    this.paused = paused;
    this.pause.replaceChildren(icon(paused ? 'play' : 'pause'), el('span', { class: 'desk' }, paused ? ' Go on' : ' Pause'));
    this.pause.setAttribute('aria-label', paused ? 'Go on' : 'Pause');
  }

  showSpeed(speed: number): void {
    if (isOpen(this.speeds)) return;
    const rounded = Number(speed.toPrecision(6));
    if (this.speeds.value === String(rounded) && this.speeds.options.length > 0) return;
    const all = kSpeeds.includes(rounded) ? kSpeeds : [rounded, ...kSpeeds];
    this.speeds.replaceChildren(...all.map((value) => el('option', { value: String(value) }, speedText(value))));
    this.speeds.value = String(rounded);
  }

  showFlies(flies: boolean): void {
    this.flyButton.setAttribute('aria-pressed', String(flies));
  }

  showTilted(tilted: boolean): void {
    setText(this.tiltButton, tilted ? 'Top' : 'Tilt');
  }

  toggle(layer: keyof Layers): void {
    this.layers[layer] = !this.layers[layer];
    this.showLayers();
    this.events.layers();
  }

  showLayers(): void {
    for (const [layer, box] of this.boxes) box.checked = this.layers[layer];
  }

  private layerMenu(): HTMLElement {
    const button = el('button', { 'aria-haspopup': 'true', 'aria-expanded': 'false', 'data-testid': 'layers' }, 'Show');
    for (const [layer, text, key] of kLayers) {
      const box = el('input', { type: 'checkbox', 'data-testid': `layer-${layer}` });
      box.onchange = () => this.toggle(layer);
      this.boxes.set(layer, box);
      this.sheet.append(el('label', {}, box, text, el('kbd', {}, key)));
    }
    this.showLayers();
    return this.menu(button, this.sheet);
  }

  /** A button that opens a sheet. */
  private menu(button: HTMLElement, sheet: HTMLElement): HTMLElement {
    const show = (open: boolean) => {
      sheet.hidden = !open;
      sheet.style.right = '';
      const { left } = sheet.getBoundingClientRect();
      if (open && left < kEdge) sheet.style.right = `${left - kEdge}px`;
      button.setAttribute('aria-expanded', String(open));
    };
    button.onclick = () => show(sheet.hidden);
    document.addEventListener('pointerdown', (event) => {
      if (!menu.contains(event.target as Node)) show(false);
    });
    const menu = el('span', { class: 'menu' }, button, sheet);
    return menu;
  }
}
