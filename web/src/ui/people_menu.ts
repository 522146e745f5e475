import type { People, Person } from '../protocol/scene';
import { el, setText } from './dom';

export interface PeopleEvents {
  mute(viewer: number, on: boolean): void;
  kick(viewer: number): void;
  /** Name of a model, by id. */
  nameOf(model: number): string | undefined;
}

/** Connected viewers: a button with their number, which opens a list of names. */
export class PeopleMenu {
  readonly button = el('button', { class: 'desk', 'aria-haspopup': 'true', 'aria-expanded': 'false', 'data-testid': 'people', title: 'Who is here' });
  readonly sheet = el('div', { class: 'sheet people', hidden: true, 'data-testid': 'people-sheet' });

  constructor(private readonly events: PeopleEvents) {
    this.show({ people: [], you: 0, drives: true, joins: true, manages: true, edits: true });
  }

  show(people: People): void {
    this.button.hidden = people.people.length < 2;
    setText(this.button, `People ${people.people.length}`);
    this.sheet.replaceChildren(...people.people.map((person) => this.line(person, people)));
  }

  private line(person: Person, { you, manages }: People): HTMLElement {
    const name = person.name ?? (person.body === undefined ? undefined : this.events.nameOf(person.body)) ?? `viewer ${person.viewer}`;
    const what = [person.viewer === you ? 'you' : '', person.role, person.muted ? 'muted' : ''].filter((word) => word !== '').join(', ');
    const line = el('p', { 'data-person': name }, el('span', {}, name), el('small', {}, what));
    if (!manages || person.viewer === you) return line;
    const mute = el('button', { 'data-testid': 'mute' }, person.muted ? 'Unmute' : 'Mute');
    const kick = el('button', { 'data-testid': 'kick', title: 'Out of this world, for good' }, 'Send out');
    mute.onclick = () => this.events.mute(person.viewer, !person.muted);
    kick.onclick = () => this.events.kick(person.viewer);
    line.append(mute, kick);
    return line;
  }
}
