const kConeSteps = 4;

/** What one sensor of a ranger measures. */
export interface PolarScan {
  x: number; // place of the sensor in the frame of the plot, m
  y: number;
  heading: number; // rad
  fov: number; // rad
  bearings: ArrayLike<number>; // of each range, from the heading, rad
  ranges: ArrayLike<number>; // m
  farthest: number; // m
}

/** Polar plot of a ranger's sensors, robot frame pointing up: an outline per scan, and range rings. */
export class PolarPlot {
  private readonly pen: CanvasRenderingContext2D;

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.pen = canvas.getContext('2d')!;
  }

  draw(scans: PolarScan[]): void {
    const ratio = window.devicePixelRatio;
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (width === 0) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const range = Math.max(...scans.map(({ farthest }) => farthest), 0.1);
    const ahead = scans.every(({ heading, fov }) => Math.abs(heading) + fov / 2 <= Math.PI / 2 + 0.2);
    const x = width / 2;
    const y = ahead ? height - 16 : height / 2;
    const scale = Math.min(ahead ? height - 26 : height / 2 - 8, width / 2 - 8) / range;
    this.rings(x, y, scale, range, ahead);
    for (const scan of scans) this.scan(x, y, scale, scan);
    this.pen.fillStyle = getComputedStyle(this.canvas).color;
    this.pen.beginPath();
    this.pen.arc(x, y, 2.5, 0, 2 * Math.PI);
    this.pen.fill();
  }

  private rings(x: number, y: number, scale: number, range: number, ahead: boolean): void {
    const { pen } = this;
    const step = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find((value) => range / value <= 4.5) ?? 100;
    pen.strokeStyle = '#8893a255';
    pen.fillStyle = '#8893a2';
    pen.font = '10px system-ui, sans-serif';
    pen.lineWidth = 1;
    for (let r = step; r <= range * 1.001; r += step) {
      pen.beginPath();
      pen.arc(x, y, r * scale, ahead ? Math.PI : 0, 2 * Math.PI);
      pen.stroke();
      pen.fillText(`${Number(r.toFixed(1))} m`, x + 3, y - r * scale + 11);
    }
  }

  private scan(x: number, y: number, scale: number, scan: PolarScan): void {
    const { pen } = this;
    const { ranges, fov, farthest } = scan;
    if (ranges.length === 0) return;
    const at = (bearing: number, length: number): [number, number] => [
      x - scan.y * scale - Math.sin(scan.heading + bearing) * length * scale,
      y - scan.x * scale - Math.cos(scan.heading + bearing) * length * scale,
    ];
    pen.beginPath();
    pen.moveTo(...at(0, 0));
    if (ranges.length === 1) {
      for (let k = 0; k <= kConeSteps; ++k) pen.lineTo(...at(fov * (k / kConeSteps - 0.5), ranges[0]));
    } else {
      for (let k = 0; k < ranges.length; ++k) pen.lineTo(...at(scan.bearings[k], Math.min(ranges[k], farthest)));
    }
    pen.closePath();
    const far = ranges.length === 1 && ranges[0] >= farthest;
    pen.fillStyle = far ? '#4a8cf71c' : '#4a8cf740';
    pen.strokeStyle = far ? '#4a8cf755' : '#4a8cf7';
    pen.lineWidth = 1.2;
    pen.fill();
    pen.stroke();
  }
}
