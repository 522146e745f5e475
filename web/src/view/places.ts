const kCell = 64; // px
const kGap = { x: 10, y: 6 }; // px, spacing of texts

interface Place {
  x: number; // centre
  y: number;
  width: number;
  height: number;
}

/** Occupancy of the screen by texts, to prevent overlaps. */
export class Places {
  private readonly cells = new Map<number, Place[]>();

  clear(): void {
    this.cells.clear();
  }

  /** Reserves a rectangle; false if it overlaps another. */
  take(x: number, y: number, width: number, height: number): boolean {
    const place = { x, y, width, height };
    const keys = this.keysOf(place);
    if (keys.some((key) => this.cells.get(key)?.some((other) => touch(other, place)))) return false;
    for (const key of keys) this.cells.set(key, [...(this.cells.get(key) ?? []), place]);
    return true;
  }

  private keysOf({ x, y, width, height }: Place): number[] {
    const cell = (at: number) => Math.floor(at / kCell);
    const keys: number[] = [];
    const [left, right] = [cell(x - width / 2 - kGap.x), cell(x + width / 2 + kGap.x)];
    const [top, bottom] = [cell(y - height / 2 - kGap.y), cell(y + height / 2 + kGap.y)];
    for (let i = left; i <= right; ++i) for (let j = top; j <= bottom; ++j) keys.push(i * 4096 + j);
    return keys;
  }
}

function touch(a: Place, b: Place): boolean {
  return Math.abs(a.x - b.x) < (a.width + b.width) / 2 + kGap.x && Math.abs(a.y - b.y) < (a.height + b.height) / 2 + kGap.y;
}
