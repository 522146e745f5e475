import type { Motion } from '../motion';
import type { Replica } from '../protocol/replica';
import type { Scene } from '../protocol/scene';
import type { CameraRig } from './camera_rig';
import { kLine as kNameLine, nameHeight } from './labels';
import { Places } from './places';
import type { Theme } from './theme';

const kWidest = 220; // px, of a line
const kLinesMost = 4;
const kLine = 16; // px
const kPadding = 8; // px
const kTail = 7; // px
const kBodyLeast = 9; // px: smaller bodies would vanish behind their bubble
const kBubblesMost = 150;
const kTokensMost = 5; // drawn individually; larger numbers as text
const kToken = { width: 9, height: 14, step: 11 }; // px

/** Speech bubbles above models, and the flags they carry, drawn on the overlay above the names. */
export class Bubbles {
  shown = true;
  /** Texts on the screen, by row. */
  readonly spoken = new Map<number, string>();
  readonly tokens = new Map<number, number>();
  private readonly places = new Places();
  private readonly pen: CanvasRenderingContext2D;

  constructor(
    private readonly scene: Scene,
    private readonly replica: Replica,
    private readonly motion: Motion,
    private readonly rig: CameraRig,
    canvas: HTMLCanvasElement,
    private readonly theme: Theme,
  ) {
    this.pen = canvas.getContext('2d')!;
  }

  /** The overlay holds only names at this point; emphasised rows are placed first, whatever their size. */
  draw(emphasized: (number | null)[]): void {
    this.spoken.clear();
    this.tokens.clear();
    this.places.clear();
    if (!this.shown) return;
    this.replica.flags.forEach((count, row) => {
      if (count > 0) this.carry(row, count);
    });
    const first = emphasized.filter((row) => row !== null && this.replica.says.has(row)) as number[];
    for (const row of new Set([...first, ...this.replica.says.keys()])) {
      if (this.spoken.size >= kBubblesMost) return;
      this.say(row, this.replica.says.get(row)!, first.includes(row));
    }
  }

  /** Top of a model in pixels; null if too small or off screen. */
  private topOf(row: number, strong: boolean): { x: number; y: number } | null {
    const { motion, rig } = this;
    const { size } = this.scene.models[row];
    if (!strong && Math.max(size[0], size[1]) * rig.scale < kBodyLeast) return null;
    const at = rig.pixelOf(motion.x[row], motion.y[row], motion.z[row] + size[2]);
    return at && at.x > -kWidest / 2 && at.y > 0 && at.x < rig.width + kWidest / 2 && at.y < rig.height + 60 ? at : null;
  }

  private say(row: number, text: string, strong: boolean): void {
    const at = this.topOf(row, strong);
    if (!at) return;
    const { pen, theme } = this;
    pen.font = '500 12px system-ui, sans-serif';
    const lines = linesOf(text, (line) => pen.measureText(line).width);
    const width = Math.max(...lines.map((line) => pen.measureText(line).width)) + 2 * kPadding;
    const height = lines.length * kLine + kPadding;
    const { size } = this.scene.models[row];
    const [x, bottom] = [at.x, at.y - nameHeight(Math.max(size[0], size[1]), this.rig.scale) - kNameLine - kTail];
    if (!this.places.take(x, bottom - height / 2, width, height) && !strong) return;
    this.spoken.set(row, text);
    this.outline(x, bottom, width, height);
    pen.fillStyle = theme.text;
    pen.textAlign = 'center';
    lines.forEach((line, k) => pen.fillText(line, x, bottom - height + kPadding / 2 + (k + 0.75) * kLine));
  }

  /** A rounded box whose tail points to the speaker. */
  private outline(x: number, bottom: number, width: number, height: number): void {
    const { pen, theme } = this;
    pen.beginPath();
    pen.roundRect(x - width / 2, bottom - height, width, height, 7);
    pen.moveTo(x - 5, bottom);
    pen.lineTo(x, bottom + kTail);
    pen.lineTo(x + 5, bottom);
    pen.fillStyle = theme.bubble;
    pen.strokeStyle = theme.bubbleEdge;
    pen.lineWidth = 2;
    pen.stroke();
    pen.fill();
  }

  /** A row of pennants above the model; beyond the limit, one and the number. */
  private carry(row: number, count: number): void {
    const at = this.topOf(row, false);
    if (!at) return;
    const { pen, theme } = this;
    this.tokens.set(row, count);
    const drawn = count > kTokensMost ? 1 : count;
    const left = at.x - (drawn * kToken.step) / 2;
    const foot = at.y - 2;
    for (let k = 0; k < drawn; ++k) pennant(pen, left + k * kToken.step, foot, theme);
    if (count <= kTokensMost) return;
    pen.font = '600 11px system-ui, sans-serif';
    pen.textAlign = 'left';
    pen.strokeStyle = theme.halo;
    pen.lineWidth = 3;
    pen.strokeText(`×${count}`, left + kToken.step + 1, foot);
    pen.fillStyle = theme.text;
    pen.fillText(`×${count}`, left + kToken.step + 1, foot);
  }
}

function pennant(pen: CanvasRenderingContext2D, x: number, foot: number, theme: Theme): void {
  pen.beginPath();
  pen.moveTo(x, foot - kToken.height);
  pen.lineTo(x + kToken.width, foot - kToken.height * 0.7);
  pen.lineTo(x, foot - kToken.height * 0.4);
  pen.closePath();
  pen.fillStyle = theme.flag;
  pen.strokeStyle = theme.text;
  pen.lineWidth = 1;
  pen.fill();
  pen.stroke();
  pen.beginPath();
  pen.moveTo(x, foot - kToken.height);
  pen.lineTo(x, foot);
  pen.stroke();
}

/** Wraps text to the maximum width, at word boundaries if possible; excess text ends with "…". */
export function linesOf(text: string, widthOf: (line: string) => number): string[] {
  const lines: string[] = [];
  let rest = text.trim();
  while (rest !== '' && lines.length < kLinesMost) {
    let count = letters(rest).length;
    while (count > 1 && widthOf(start(rest, count)) > kWidest) count = Math.min(count - 1, Math.ceil((count * kWidest) / widthOf(start(rest, count))));
    let line = start(rest, count);
    const space = line.lastIndexOf(' ');
    if (line.length < rest.length && rest[line.length] !== ' ' && space > 0) line = line.slice(0, space);
    lines.push(line.trim());
    rest = rest.slice(line.length).trim();
  }
  if (rest !== '') lines.push(`${letters(lines.pop()!).slice(0, -1).join('')}…`);
  return lines.length > 0 ? lines : [''];
}

function letters(text: string): string[] {
  return [...text];
}

function start(text: string, count: number): string {
  return letters(text).slice(0, count).join('');
}
