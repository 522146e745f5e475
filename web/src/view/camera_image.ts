/** Writes the pixels of a camera as red, green, blue and alpha. Distances [mm] are the brighter the nearer; black is nothing. */
export function paint(samples: number[], image: string, out: Uint8ClampedArray): void {
  const farthest = image === 'depth' ? samples.reduce((most, sample) => Math.max(most, sample), 1) : 1;
  samples.forEach((sample, k) => {
    const grey = image === 'depth' ? (sample === 0 ? 0 : Math.round(255 - (200 * sample) / farthest)) : sample;
    const rgb = image === 'color' ? [sample >> 16, (sample >> 8) & 0xff, sample & 0xff] : [grey, grey, grey];
    out.set([...rgb, 255], 4 * k);
  });
}
