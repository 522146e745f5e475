/**
 * Writes the pixels of a camera as red, green, blue and alpha. Distances [mm] are the brighter the nearer; models have a color each, the
 * same in every image; black is nothing.
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

/** 0xRRGGBB for a number that stands for a model: neighbouring ones differ clearly, 0 is black. */
function colorOf(number: number): number {
  if (number === 0) return 0;
  const mixed = Math.imul(number, 0x9e3779b1) >>> 8;
  return (mixed & 0xffffff) | 0x404040;
}
