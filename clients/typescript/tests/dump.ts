/**
 * Prints every message of a recorded stream as a line of JSON: its name, its value, and the bytes that the value encodes
 * to. dump FILE; clients/python/tests/test_conformance.py compares the lines with the values decoded in Python.
 */

import { readFileSync } from 'node:fs';
import { WireError } from '../src/errors.js';
import { findMessage } from '../src/generated/index.js';
import { decodeHeader, HEADER_BYTES, type AnyMessage } from '../src/wire.js';

const kBannerBytes = 32;
// These fields have capitals in the definitions too.
const kWithCapitals = new Set(['basePos', 'nodeTimeHigh', 'nodeTimeLow']);

/** The field's name in the definitions. */
function wireName(field: string): string {
  return kWithCapitals.has(field) ? field : field.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

function json(value: unknown): string {
  if (value instanceof Uint8Array) return `{"base64":"${Buffer.from(value).toString('base64')}"}`;
  if (value instanceof Float32Array || value instanceof Float64Array) return json(Array.from(value));
  if (Array.isArray(value)) return `[${value.map(json).join(',')}]`;
  if (typeof value === 'number') return Number.isFinite(value) ? String(value) : 'null';
  if (typeof value !== 'object' || value === null) return String(value);
  return `{${Object.entries(value).map(([field, part]) => `"${wireName(field)}":${json(part)}`).join(',')}}`;
}

function decoded(row: AnyMessage | undefined, body: Buffer): unknown {
  if (!row?.payload || body.length === 0) return undefined;
  try {
    return row.payload.decode(body);
  } catch (error) {
    if (error instanceof WireError) return undefined;
    throw error;
  }
}

function line(row: AnyMessage | undefined, body: Buffer): string {
  const value = decoded(row, body);
  const again = value === undefined ? '' : Buffer.from(row!.payload!.encode(value as object)).toString('hex');
  return `{"name":"${row?.name ?? ''}","value":${value === undefined ? 'null' : json(value)},"again":"${again}"}`;
}

function dump(file: string): void {
  const bytes = readFileSync(file);
  const lines: string[] = [];
  let at = file.endsWith('.s2c') ? kBannerBytes : 0;
  while (at + HEADER_BYTES <= bytes.length) {
    const header = decodeHeader(bytes, at);
    const end = at + HEADER_BYTES + header.size;
    if (end > bytes.length) break;
    lines.push(line(findMessage(header.interface, header.kind, header.subtype), bytes.subarray(at + HEADER_BYTES, end)));
    at = end;
  }
  process.stdout.write(lines.map((each) => `${each}\n`).join(''));
}

const [file] = process.argv.slice(2);
if (file === undefined) {
  console.error('usage: dump FILE');
  process.exitCode = 2;
} else {
  dump(file);
}
