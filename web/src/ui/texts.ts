/** Formatting of numbers and names. */

export function metres(value: number): string {
  return `${value.toFixed(2)} m`;
}

export function degrees(radians: number): string {
  return `${((radians * 180) / Math.PI).toFixed(1)}°`;
}

/** A number that travels in steps of `worth`, in a unit of the definitions. */
export function quantity(value: number | undefined, worth: number, unit: string): string {
  if (value === undefined) return 'no data yet';
  if (unit === 'rad') return degrees(value);
  return `${value.toFixed(worth < 1 ? 2 : 0)} ${unit.replace('degC', '°C')}`.trimEnd();
}

/** "r0.ranger:1" to "ranger:1". */
export function shortName(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1);
}

/** A unique name of at most `most` characters: with a number appended if it is taken. */
export function freeName(name: string, taken: ReadonlySet<string>, most: number): string {
  for (let number = 1; ; ++number) {
    const tail = number === 1 ? '' : String(number);
    const free = name.slice(0, most - tail.length) + tail;
    if (!taken.has(free)) return free;
  }
}

/** 3723.4 s as "1:02:03.4". */
export function clockText(seconds: number): string {
  const tenths = Math.round(seconds * 10);
  const h = Math.floor(tenths / 36000);
  const m = Math.floor((tenths / 600) % 60);
  const s = ((tenths % 600) / 10).toFixed(1).padStart(4, '0');
  return h > 0 ? `${h}:${String(m).padStart(2, '0')}:${s}` : `${m}:${s}`;
}
