import type { AnyMessage, Camera, Device, Image, Laser, Ranger, Scan, Sonar } from '../../../clients/typescript/src/index';
import { el, setText } from '../ui/dom';
import { PolarPlot } from '../ui/polar_plot';

/** What a card shows of its device. */
export interface Panel {
  readonly nodes: Node[];
  /** Draws the newest data; called only after data have arrived. */
  show(message: AnyMessage, value: unknown): void;
}

const kNumbersMost = 8; // of a list, in a cell
const kRowsMost = 40;
const kSonarFov = 0.26; // rad, of the cones that are drawn: sonars do not tell theirs

/** The panel of a device by its interface: a picture where that says more than numbers. */
export function panelOf(device: Device): Panel {
  switch (device.interface) {
    case 'laser':
      return scanPanel(() => (device as Laser).scan());
    case 'ranger':
      return scanPanel(() => (device as Ranger).scan());
    case 'sonar':
      return sonarPanel(device as Sonar);
    case 'camera':
      return imagePanel(device as Camera);
    default:
      return valuesPanel();
  }
}

function scanPanel(scanNow: () => Scan): Panel {
  const canvas = el('canvas', { class: 'polar' });
  const plot = new PolarPlot(canvas);
  const nearest = el('td', { 'data-testid': 'nearest' });
  const show = () => {
    const { ranges, angles, maxRange } = scanNow();
    if (ranges.length === 0) return;
    const fov = Math.abs(angles[angles.length - 1] - angles[0]);
    plot.draw([{ x: 0, y: 0, heading: 0, fov, bearings: angles, ranges, farthest: maxRange }]);
    setText(nearest, `${Math.min(...ranges).toFixed(2)} m of ${ranges.length} ranges`);
  };
  return { nodes: [canvas, el('table', {}, el('tr', {}, el('th', {}, 'nearest'), nearest))], show: ignoringNoData(show) };
}

function sonarPanel(sonar: Sonar): Panel {
  const canvas = el('canvas', { class: 'polar' });
  const plot = new PolarPlot(canvas);
  const values = valuesPanel();
  const asked = sonar.poses().catch(() => []);
  const show = (message: AnyMessage, value: unknown) => {
    values.show(message, value);
    void asked.then((poses) => {
      const farthest = Math.max(...sonar.ranges, 1);
      plot.draw(
        poses.slice(0, sonar.ranges.length).map(({ x, y, yaw }, k) => (
          { x, y, heading: yaw, fov: kSonarFov, bearings: [0], ranges: [sonar.ranges[k]], farthest })),
      );
    });
  };
  return { nodes: [canvas, ...values.nodes], show };
}

function imagePanel(camera: Camera): Panel {
  const canvas = el('canvas', { class: 'image', 'data-testid': 'image' });
  return { nodes: [canvas], show: ignoringNoData(() => void paint(canvas, camera.image)) };
}

async function paint(canvas: HTMLCanvasElement, image: Image): Promise<void> {
  const pen = canvas.getContext('2d')!;
  if (image.isJpeg) {
    const picture = await createImageBitmap(new Blob([image.data.slice()], { type: 'image/jpeg' }));
    Object.assign(canvas, { width: picture.width, height: picture.height });
    pen.drawImage(picture, 0, 0);
    return;
  }
  if (image.width === 0 || image.height === 0) return;
  const pixels = new ImageData(image.width, image.height);
  for (let row = 0, at = 0; row < image.height; ++row) {
    for (let column = 0; column < image.width; ++column, at += 4) {
      const [red, green = red, blue = red] = image.pixel(column, row);
      pixels.data.set([red, green, blue, 255], at);
    }
  }
  Object.assign(canvas, { width: image.width, height: image.height });
  pen.putImageData(pixels, 0, 0);
}

/** Fields of the newest message of each kind, by the names of the definitions. */
function valuesPanel(): Panel {
  const tables = new Map<number, HTMLTableElement>();
  const box = el('div');
  const show = (message: AnyMessage, value: unknown) => {
    let table = tables.get(message.subtype);
    if (!table) {
      table = el('table', { 'data-testid': message.name });
      tables.set(message.subtype, table);
      box.append(table);
    }
    const rows = flat(value).slice(0, kRowsMost);
    while (table.rows.length > rows.length) table.deleteRow(-1);
    rows.forEach(([name, text], k) => {
      const row = table.rows[k] ?? table.appendChild(el('tr', {}, el('th'), el('td')));
      setText(row.cells[0], name);
      setText(row.cells[1], text);
    });
  };
  return { nodes: [box], show };
}

/** Names and values of all fields, those of inner values as "pos.px". */
export function flat(value: unknown, name = ''): [name: string, text: string][] {
  if (value === null || typeof value !== 'object') return [[name, shown(value)]];
  if (value instanceof Uint8Array) return [[name, bytesText(value)]];
  if (ArrayBuffer.isView(value) || (Array.isArray(value) && value.every((each) => typeof each === 'number'))) {
    const numbers = [...(value as unknown as Iterable<number>)];
    const more = numbers.length > kNumbersMost ? ` … (${numbers.length})` : '';
    return [[name, numbers.slice(0, kNumbersMost).map(shown).join(', ') + more]];
  }
  return Object.entries(value).flatMap(([field, inner]) => flat(inner, name === '' ? field : `${name}.${field}`));
}

function shown(value: unknown): string {
  return typeof value === 'number' && !Number.isInteger(value) ? value.toFixed(3) : String(value);
}

/** Text, if all bytes up to the first NUL are letters. */
function bytesText(bytes: Uint8Array): string {
  const end = bytes.indexOf(0);
  const text = new TextDecoder('latin1').decode(end < 0 ? bytes : bytes.subarray(0, end));
  return text !== '' && /^[\x20-\x7e]{1,80}$/.test(text) ? text : `${bytes.length} bytes`;
}

/** Some devices publish more than one kind of message: what is shown may have no data yet. */
function ignoringNoData(act: () => void): () => void {
  return () => {
    try {
      act();
    } catch (error) {
      if ((error as Error).name !== 'NoData') throw error;
    }
  };
}
