import type { Replica } from '../protocol/replica';
import type { SaidLine } from '../protocol/scene';
import { kWave } from '../protocol/generated/commands';
import { el } from './dom';
import { clockText } from './texts';

const kLinesMost = 200;
const kTextMost = 1000; // characters

interface Heard {
  tick: number;
  line: HTMLElement;
}

/** Chat log, with the last lines of before the page was opened: text, speaker and time; and an input field for viewers who have joined. */
export class Chat {
  private readonly lines = el('ol', { 'data-testid': 'chat-lines', tabindex: '0' });
  private readonly field = el('input', { type: 'text', autocomplete: 'off', enterkeyhint: 'send', maxlength: `${kTextMost}`, placeholder: 'Say something (Enter)', 'data-testid': 'say', 'aria-label': 'Say' });
  private heard: Heard[] = [];
  private said = new Map<number, string>(); // current text, by model id
  private speaks = false;
  private wanted = true;

  constructor(
    private readonly box: HTMLElement,
    say: (text: string) => void,
  ) {
    box.append(this.lines, this.field);
    this.field.addEventListener('keydown', (event) => {
      event.stopPropagation();
      if (event.key === 'Enter' && !event.isComposing) {
        const text = this.field.value.trim();
        this.field.value = '';
        if (text !== '') say(text);
      }
      if (event.key === 'Enter' || event.key === 'Escape') this.field.blur();
    });
    this.show();
  }

  /** Viewers without the right to speak have no input field. */
  showSpeaks(speaks: boolean): void {
    this.speaks = speaks;
    this.show();
  }

  toggle(): void {
    this.wanted = !this.wanted;
    this.show();
  }

  focus(): void {
    if (!this.speaks) return;
    this.wanted = true;
    this.show();
    this.field.focus();
  }

  /** A new world was loaded: discards the log. */
  clear(): void {
    this.heard = [];
    this.said.clear();
    this.lines.replaceChildren();
    this.show();
  }

  /** Logs what was said before this page came. */
  recall(lines: SaidLine[], interval: number): void {
    for (const { tick, model, name, text } of lines) {
      this.said.set(model, text);
      this.add(tick, clockText(tick * interval), name, text);
    }
  }

  /** Logs the changes of the models' texts. */
  listen(replica: Replica, interval: number): void {
    const { tick, scene } = replica;
    while (this.heard.length > 0 && this.heard[this.heard.length - 1].tick > tick) this.heard.pop()!.line.remove();
    const now = new Map<number, string>();
    for (const [row, text] of replica.says) {
      const { id, name } = scene.models[row];
      now.set(id, text);
      if (this.said.get(id) !== text) this.add(tick, clockText(tick * interval), name, text);
    }
    this.said = now;
  }

  private add(tick: number, time: string, who: string, text: string): void {
    const atEnd = this.lines.scrollTop + this.lines.clientHeight >= this.lines.scrollHeight - 8;
    const said = text === kWave ? el('i', {}, 'waves') : el('span', {}, text);
    const line = el('li', { 'data-who': who }, el('time', {}, time), el('b', {}, who), said);
    this.lines.append(line);
    this.heard.push({ tick, line });
    if (this.heard.length > kLinesMost) this.heard.shift()!.line.remove();
    this.show();
    if (atEnd) this.lines.scrollTop = this.lines.scrollHeight;
  }

  private show(): void {
    this.box.hidden = !this.wanted || (this.heard.length === 0 && !this.speaks);
    this.lines.hidden = this.heard.length === 0;
    this.field.hidden = !this.speaks;
  }
}
