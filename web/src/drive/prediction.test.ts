import { describe, expect, it } from 'vitest';
import type { PhysicsSolid } from '../protocol/scene';
import { kStill, type Velocity } from './hands';
import { Obstacles } from './obstacles';
import { Prediction } from './prediction';
import { Walker, type Walk, type Walking } from './walker';

const kInterval = 0.05; // s
const kWalk: Walk = { engine: 'arena', ahead: [-0.8, 2], aside: [-0.8, 0.8], turn: [-3, 3] };
const kAhead: Velocity = { forward: 1.5, sideways: 0, turn: 0 };
const kFrame = 1 / 60; // s
const kBody: PhysicsSolid[] = [{ z: [0.3, 1.75], loop: [0.15, -0.25, 0.15, 0.25, -0.15, 0.25, -0.15, -0.25] }];
const kWall: PhysicsSolid[] = [{ z: [0, 1.2], loop: [2, -4, 2.2, -4, 2.2, 4, 2, 4] }];

/** Numbers that look random, the same in every run. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
}

function walkerOf(walk: Walk, walls: PhysicsSolid[]): Walker {
  const walker = new Walker(walk);
  walker.meet(kBody, new Obstacles(walls));
  return walker;
}

/** A program that walks a body in ticks, a link with delays on both ways, and the page at its end. */
class Run {
  now = 0;
  readonly body: Walking = { x: 0, y: 0, a: 0, vx: 0, vy: 0 };
  readonly prediction: Prediction;
  private readonly walker: Walker;
  private readonly queues = { up: [] as [number, () => void][], down: [] as [number, () => void][] };
  private readonly random = numbers(7);
  private tick = 0;
  private wanted: Velocity = kStill;
  private counts: number[] = [];

  constructor(
    private readonly delay: number, // s, each way
    private readonly jitter: number, // s
    walls: PhysicsSolid[] = [],
    walk = kWalk,
    private readonly pushed: (body: Walking, tick: number) => void = () => {},
  ) {
    this.walker = walkerOf(walk, walls);
    this.prediction = new Prediction(walkerOf(walk, walls), kInterval);
  }

  /** Later on one way never arrives before earlier. */
  private send(way: 'up' | 'down', what: () => void): void {
    const queue = this.queues[way];
    const arrival = this.now + this.delay + this.jitter * this.random();
    queue.push([Math.max(arrival, queue.at(-1)?.[0] ?? 0), what]);
  }

  command(velocity: Velocity): void {
    const input = this.prediction.command(velocity, this.now);
    this.send('up', () => {
      this.wanted = velocity;
      this.counts.push(input);
    });
  }

  /** On by one picture; what is drawn in it. */
  frame(): { x: number; y: number; a: number } | null {
    this.now += kFrame;
    for (const way of ['up', 'down'] as const) {
      const queue = this.queues[way];
      while (queue.length > 0 && queue[0][0] <= this.now) queue.shift()![1]();
    }
    while ((this.tick + 1) * kInterval <= this.now) this.next();
    return this.prediction.at(this.now);
  }

  frames(count: number): ({ x: number; y: number; a: number } | null)[] {
    return Array.from({ length: count }, () => this.frame());
  }

  private next(): void {
    const { tick } = this;
    for (const input of this.counts.splice(0)) this.send('down', () => this.prediction.counts(input, tick));
    for (let k = 0; k < 5; ++k) this.walker.step(this.body, this.wanted, 0, kInterval / 5);
    this.pushed(this.body, tick);
    this.tick += 1;
    const shown = { tick: this.tick, x: Math.round(this.body.x * 1000) / 1000, y: Math.round(this.body.y * 1000) / 1000, a: this.body.a, z: 0, tickSeconds: kInterval };
    this.send('down', () => this.prediction.correct(shown, this.now));
  }
}

describe('Prediction', () => {
  it('moves the body in the first picture after a key, however late the program answers', () => {
    const run = new Run(0.15, 0.02);
    const before = run.frames(60).at(-1)!;
    run.command(kAhead);
    const drawn = run.frame()!;
    expect(drawn.x).toBeGreaterThan(before.x + 0.001);
    expect(run.body.x).toBe(0);
    expect(run.frames(7).at(-1)!.x).toBeGreaterThan(0.08); // 0.12 s later: still nothing has come back
    expect(run.body.x).toBe(0);
  });

  it('is where the program has the body, once nothing is told any more', () => {
    for (const delay of [0, 0.05, 0.15, 0.3]) {
      const run = new Run(delay, 0.04);
      run.frames(30);
      for (const velocity of [kAhead, { forward: 0.75, sideways: 0.8, turn: 1 }, { forward: 0, sideways: 0, turn: -2 }, { ...kAhead, forward: -1 }, kStill]) {
        run.command(velocity);
        run.frames(37);
      }
      const drawn = run.frames(120).at(-1)!;
      expect(Math.hypot(run.body.x, run.body.y)).toBeGreaterThan(0.3);
      expect(Math.hypot(drawn.x - run.body.x, drawn.y - run.body.y)).toBeLessThan(0.0015);
      expect(drawn.a).toBeCloseTo(run.body.a, 4);
    }
  });

  it('goes on evenly while somebody walks, although the delay varies', () => {
    const run = new Run(0.1, 0.04);
    run.frames(60);
    let last = 0;
    const steps: number[] = [];
    for (let k = 0; k < 240; ++k) {
      if (k % 9 === 0) run.command(kAhead);
      const { x } = run.frame()!;
      if (k > 30) steps.push((x - last) / kFrame);
      last = x;
    }
    expect(Math.min(...steps)).toBeGreaterThan(1.2);
    expect(Math.max(...steps)).toBeLessThan(1.8);
  });

  it('stands still at a wall that one walks into', () => {
    const run = new Run(0.15, 0.04, kWall);
    run.frames(60);
    for (let k = 0; k < 18; ++k) {
      run.command(kAhead);
      run.frames(9);
    }
    const drawn = run.frames(60).map((place) => place!.x);
    expect(run.body.x).toBeCloseTo(1.855, 2);
    expect(Math.max(...drawn) - Math.min(...drawn)).toBeLessThan(0.002);
    expect(drawn[0]).toBeCloseTo(run.body.x, 2);
  });

  it('slides along a wall as the program does', () => {
    const run = new Run(0.1, 0.02, kWall);
    run.frames(30);
    run.body.x = 1.7;
    run.frames(30);
    for (let k = 0; k < 20; ++k) {
      run.command({ forward: 0.8, sideways: 0.8, turn: 0 });
      run.frames(6);
    }
    run.command(kStill);
    const drawn = run.frames(90).at(-1)!;
    expect(run.body.y).toBeGreaterThan(0.4);
    expect(drawn.y).toBeCloseTo(run.body.y, 2);
  });

  it('is pushed by what it cannot know of, and jumps only when it is put elsewhere', () => {
    let push = 0;
    const run = new Run(0.1, 0.02, [], kWalk, (body) => (body.x += push));
    run.frames(60);
    push = 0.02; // 0.4 m/s
    const drawn = run.frames(120).map((place) => place!.x);
    const steps = drawn.slice(1).map((x, k) => x - drawn[k]);
    expect(Math.max(...steps)).toBeLessThan(0.02);
    push = 0;
    run.frames(60);
    run.body.x += 5;
    const after = run.frames(40).map((place) => place!.x);
    expect(after.some((x, k) => k > 0 && x - after[k - 1] > 4.9)).toBe(true);
    expect(after.at(-1)).toBeCloseTo(run.body.x, 2);
  });

  it('stands while time does, and forgets what was told when time goes back', () => {
    const prediction = new Prediction(walkerOf(kWalk, []), kInterval);
    prediction.correct({ tick: 100, x: 1, y: 2, a: 0, z: 0, tickSeconds: 0 }, 0);
    prediction.command(kAhead, 0.1);
    expect(prediction.at(3)).toEqual({ x: 1, y: 2, a: 0 });
    prediction.correct({ tick: 20, x: 0, y: 0, a: 0, z: 0, tickSeconds: kInterval }, 4);
    expect(prediction.at(10)!.x).toBeCloseTo(0, 6);
  });

  it('follows the stage engine, where bodies respond at once and stop at walls', () => {
    const walk = { ...kWalk, engine: 'stage' };
    const run = new Run(0.1, 0.03, kWall, walk);
    run.frames(30);
    run.command({ ...kAhead, turn: 0 });
    run.frames(120);
    const drawn = run.frame()!;
    expect(run.body.x).toBeGreaterThan(1.8);
    expect(Math.abs(drawn.x - run.body.x)).toBeLessThan(0.02);
  });
});
