/**
 * Converts a camera's samples to RGBA. Depth [mm]: nearer is
 * brighter. Segmentation: a fixed colour per model. Black: nothing.
 */
export function paint(samples: number[], image: string, out: Uint8ClampedArray): void {
  const farthest = image === 'depth' ? samples.reduce((most, sample) => Math.max(most, sample), 1) : 1;
  samples.forEach((sample, k) => {
    const grey = image === 'depth' ? (sample === 0 ? 0 : Math.round(255 - (200 * sample) / farthest)) : sample;
    const shown = image === 'segmentation' ? colorOf(sample) : sample;
    const rgb =
      image === 'color' || image === 'segmentation' ? [shown >> 16, (shown >> 8) & 0xff, shown & 0xff] : [grey, grey, grey];
    out.set([...rgb, 255], 4 * k);
  });
}

/** Colour 0xRRGGBB of a segmentation id: adjacent ids differ clearly; 0 is black. */
function colorOf(number: number): number {
  if (number === 0) return 0;
  const mixed = Math.imul(number, 0x9e3779b1) >>> 8;
  return (mixed & 0xffffff) | 0x404040;
}
