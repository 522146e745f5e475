import type { Model } from '../protocol/scene';
import { el } from '../ui/dom';
import type { KindPage, PanelTools } from './kind_page';
import { paint } from '../view/camera_image';

export default { kind: 'camera', panel } satisfies KindPage;

function panel(model: Model, { replica, row, refresh, codes }: PanelTools): Node[] {
  const [width, height] = model.resolution ?? [1, 1];
  const canvas = el('canvas', { class: 'image', width: `${width}`, height: `${height}`, 'data-testid': 'image' });
  const context = canvas.getContext('2d')!;
  const image = context.createImageData(width, height);
  refresh(() => {
    const pixels = replica().views('camera').get(row(model.id));
    if (!pixels || pixels.length !== width * height) return;
    paint(pixels.map(({ sample }) => sample), model.shows ?? 'color', image.data);
    context.putImageData(image, 0, 0);
    canvas.dataset.tick = `${replica().tick}`;
  });
  const degrees = (model.view ?? []).map((angle) => Math.round((angle * 180) / Math.PI));
  const detail = el('span', { class: 'detail' }, `${width} × ${height}, ${degrees.join(' × ')}°`);
  const enlarge = el('button', { class: 'enlarge', 'data-testid': 'enlarge', 'aria-pressed': 'false', title: 'The image large, or small again' }, 'Large');
  enlarge.onclick = () => {
    const large = canvas.closest('#panel')?.classList.toggle('large') ?? false;
    enlarge.setAttribute('aria-pressed', String(large));
  };
  return [el('h3', {}, 'Camera', ...codes(model), detail), enlarge, canvas];
}
