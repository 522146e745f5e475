import { Device } from '../device.js';
import { WireError } from '../errors.js';
import { map } from '../generated/index.js';
import { joined } from '../text.js';
import { Grid } from '../values.js';
import { contents, poseOf } from './convert.js';

const kTile = 512; // cells along a side of a tile of a map, so that any map fits into messages
const kMostCells = 2 ** 26; // of a map

/** A grid map. */
export class Map extends Device {
  /** Size and place of the map, without its cells. Throws WireError if the numbers are those of no map. */
  async grid(): Promise<Grid> {
    const { scale, width, height, origin } = await contents(this.request(map.REQ_GET_INFO));
    const { x, y, a } = poseOf(origin);
    if (!(scale > 0 && [scale, x, y, a].every(Number.isFinite))) {
      throw new WireError(`${this.name}: invalid map: cells of ${scale} m from (${x}, ${y}, ${a}) on`);
    }
    return new Grid(scale, width, height, { x, y, a });
  }

  /**
   * The whole map, row by row from the bottom: cells()[row][column] is 1 if the cell is occupied, -1 if it is free, 0 if
   * that is unknown. Throws WireError for a map of more than 2^26 cells, and for faulty answers.
   */
  async cells(): Promise<Int8Array[]> {
    const { width, height } = await this.grid();
    if (width * height > kMostCells) {
      throw new WireError(`${this.name}: ${width} x ${height} cells are over the limit of ${kMostCells}`);
    }
    const rows: Int8Array[] = [];
    for (let row = 0; width > 0 && row < height; row += kTile) {
      rows.push(...(await this.band(row, width, Math.min(kTile, height - row))));
    }
    return rows;
  }

  /** All cells of the rows from `row` on, as high as a tile. */
  private async band(row: number, width: number, height: number): Promise<Int8Array[]> {
    const rows = Array.from({ length: height }, () => new Int8Array(width));
    for (let column = 0; column < width; column += kTile) {
      const part = Math.min(kTile, width - column);
      const cells = await this.tile(column, row, part, height);
      rows.forEach((cellsOfRow, i) => cellsOfRow.set(cells.subarray(i * part, (i + 1) * part), column));
    }
    return rows;
  }

  private async tile(column: number, row: number, width: number, height: number): Promise<Int8Array> {
    const tile = await contents(this.request(map.REQ_GET_DATA, { col: column, row, width, height }));
    const values = await uncompressed(tile.data, width * height);
    if (values?.length !== width * height) {
      throw new WireError(`${this.name}: a tile of ${width} x ${height} cells is damaged`);
    }
    const limit = Math.max(tile.dataRange, 1);
    return Int8Array.from(values, (byte) => occupancy(2 * ((byte << 24) >> 24), limit));
  }
}

/** At most `count` bytes, else undefined; the data themselves if they are not a zlib stream, as of a server without it. */
async function uncompressed(data: Uint8Array, count: number): Promise<Uint8Array | undefined> {
  const parts: Uint8Array[] = [];
  let size = 0;
  try {
    const stream = new Blob([data.slice()]).stream().pipeThrough(new DecompressionStream('deflate'));
    for (const reader = stream.getReader(); size <= count; ) {
      const { done, value } = await reader.read();
      if (done) break;
      parts.push(value);
      size += value.length;
    }
  } catch {
    if (size === 0) return data;
  }
  return size > count ? undefined : joined(parts);
}

function occupancy(twice: number, limit: number): number {
  return Number(twice > limit) - Number(twice < -limit);
}
