import { describe, expect, it } from 'vitest';
import { Watchdog } from './watchdog';

/** A watchdog that is asked every half second, as the page does; what it says at each full second. */
function watched(seconds: number, meanwhile: (dog: Watchdog, now: number) => void): string[] {
  const dog = new Watchdog(0);
  const said: string[] = [];
  for (let now = 500; now <= seconds * 1000; now += 500) {
    meanwhile(dog, now);
    dog.look(now);
    if (now % 1000 === 0) said.push(dog.verdict(now));
  }
  return said;
}

function packet(dog: Watchdog, now: number): void {
  dog.heard(now);
  dog.owes(now);
}

describe('Watchdog', () => {
  it('blames nobody while packets come and are drawn', () => {
    const said = watched(10, (dog, now) => {
      packet(dog, now);
      dog.drew(now + 20);
    });
    expect(new Set(said)).toEqual(new Set(['live']));
  });

  it('blames the program that sends nothing although all it sent is drawn', () => {
    const said = watched(7, (dog, now) => {
      if (now > 1000) return;
      packet(dog, now);
      dog.drew(now + 20);
    });
    expect(said).toEqual(['live', 'live', 'live', 'live', 'live', 'silent', 'silent']);
  });

  it('blames the page that does not draw what has come, until it has drawn for a while', () => {
    const said = watched(16, (dog, now) => {
      if (now <= 2000) packet(dog, now);
      if (now === 8000) dog.drew(now);
      if (now > 8000) {
        packet(dog, now);
        dog.drew(now + 20);
      }
    });
    expect(said.slice(0, 4)).toEqual(['live', 'live', 'live', 'live']);
    expect(said.slice(4, 11)).toEqual(Array(7).fill('slow'));
    expect(said.slice(11)).toEqual(Array(5).fill('live'));
  });

  it('blames nobody for what it could not hear while it stood still', () => {
    const dog = new Watchdog(0);
    dog.look(500);
    dog.look(9000);
    expect(dog.verdict(9000)).toBe('live');
    for (let now = 9500; now <= 13500; now += 500) dog.look(now);
    expect(dog.verdict(13500)).toBe('silent');
  });

  it('blames nobody for the time in which it was hidden', () => {
    const dog = new Watchdog(0);
    packet(dog, 100);
    dog.rest(60000);
    dog.drew(60010);
    expect(dog.verdict(60010)).toBe('live');
  });
});
