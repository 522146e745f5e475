/** Text in fields of messages, and numbers and names in errors. */

import { WireError } from './errors.js';

const kDecoder = new TextDecoder('utf-8', { ignoreBOM: true });
const kEncoder = new TextEncoder();

/** The text of a string field, up to the first NUL. */
export function text(data: Uint8Array): string {
  const end = data.indexOf(0);
  return kDecoder.decode(end < 0 ? data : data.subarray(0, end));
}

/** Encodes text as a string field, with a NUL at the end and none inside. Throws WireError. */
export function cString(value: string): Uint8Array {
  if (/\p{Surrogate}/u.test(value)) {
    throw new WireError(`${shown(value)} cannot be sent as UTF-8: surrogates not allowed`);
  }
  if (value.includes('\0')) throw new WireError(`${shown(value)} has a NUL in it, where receivers would end it`);
  return kEncoder.encode(`${value}\0`);
}

/** Bytes one behind the other. */
export function joined(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Text as UTF-8, other bytes as they are. */
export function bytesOf(message: Uint8Array | string): Uint8Array {
  return typeof message === 'string' ? utf8(message) : message;
}

/** Encodes text as UTF-8. */
export function utf8(value: string): Uint8Array {
  return kEncoder.encode(value);
}

/** A value of any type for an error's line, as the other languages show it. */
export function shown(value: unknown): string {
  if (typeof value === 'number') return shownNumber(value);
  if (typeof value === 'string') return JSON.stringify(value);
  return String(value);
}

function shownNumber(value: number): string {
  if (Number.isNaN(value)) return 'nan';
  if (!Number.isFinite(value)) return value > 0 ? 'inf' : '-inf';
  return String(value);
}

/** ' (did you mean "laser"?)' for the nearest known word, empty if none is near. */
export function didYouMean(word: string, known: Iterable<string>): string {
  const rated = [...known].map((each) => ({ each, rating: similarity(word, each) }));
  const near = rated.reduce((a, b) => (b.rating > a.rating ? b : a), { each: '', rating: kNear });
  return near.each ? ` (did you mean "${near.each}"?)` : '';
}

const kNear = 0.6 - 1e-9; // similarity of a word that may be meant

/** From 0 to 1: the part of both words that is in common blocks, the longest first (Ratcliff and Obershelp). */
function similarity(a: string, b: string): number {
  return a.length + b.length > 0 ? (2 * commonLength(a, b)) / (a.length + b.length) : 1;
}

function commonLength(a: string, b: string): number {
  let [length, atA, atB] = [0, 0, 0];
  for (let i = 0; i < a.length; ++i) {
    for (let j = 0; j < b.length; ++j) {
      let k = 0;
      while (i + k < a.length && j + k < b.length && a[i + k] === b[j + k]) ++k;
      if (k > length) [length, atA, atB] = [k, i, j];
    }
  }
  if (length === 0) return 0;
  const before = commonLength(a.slice(0, atA), b.slice(0, atB));
  return before + length + commonLength(a.slice(atA + length), b.slice(atB + length));
}
