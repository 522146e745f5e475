/** Numbers as the page writes them. */

export function metres(value: number): string {
  return `${value.toFixed(2)} m`;
}

export function degrees(radians: number): string {
  return `${((radians * 180) / Math.PI).toFixed(1)}°`;
}

/** "r0.ranger:1" to "ranger:1". */
export function shortName(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1);
}
