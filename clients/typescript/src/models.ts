/** The simulator's list of models and their devices: lines of text in a property of the simulation interface. */

import type { Device } from './device.js';
import { WireError } from './errors.js';
import { simulation } from './generated/index.js';
import { cString, shown, text } from './text.js';

/** Address of a device: port of its server, interface and index, with the full name of its model. */
export interface DeviceAddress {
  port: number;
  interface: string;
  index: number;
  model: string;
}

/**
 * One model of the world: full name, type ("position", independent of macros), name of its parent (empty for a top-level
 * one), own devices, and id, which is unique in the run.
 */
export interface Model {
  name: string;
  type: string;
  parent: string;
  devices: DeviceAddress[];
  id: number;
}

/** All models of a simulation device's world. Throws RequestRefused if the simulator does not report them. */
export async function askModels(simulator: Device): Promise<Model[]> {
  const found: Model[] = [];
  let index = 0;
  for (;;) {
    const question = simulation.PropertyReq.make({ name: cString(''), prop: cString('models'), index });
    const answer = (await simulator.request(simulation.REQ_GET_PROPERTY, question)) ?? question;
    found.push(...parseModels(text(answer.value)));
    if (answer.index === 0) return found;
    if (answer.index <= index) throw new WireError(`the list of models goes on at ${answer.index} after ${index}`);
    index = answer.index;
  }
}

/** The models of one answer, one per line: id, name, type, parent and devices, separated by TABs. Throws WireError. */
export function parseModels(lines: string): Model[] {
  return lines.split('\n').filter(Boolean).map(parseLine);
}

/** For each model, in order: itself and all its descendants, in the order of the list. */
export function families(models: readonly Model[]): Model[][] {
  const found = models.map((model) => [model]);
  const parents: (number | undefined)[] = [];
  const places = new Map<string, number>(); // of equal names the last one so far
  models.forEach((model, at) => { // parents come before children
    parents.push(places.get(model.parent));
    places.set(model.name, at);
    for (let above = parents[at]; above !== undefined; above = parents[above]) found[above]!.push(model);
  });
  return found;
}

function parseLine(line: string): Model {
  const fields = line.split('\t');
  if (fields.length !== 5) {
    throw new WireError(`a line of the list of models has ${fields.length} fields instead of 5: ${shown(line)}`);
  }
  const [id, name, type, parent, devices] = fields as [string, string, string, string, string];
  if (!isNumber(id)) throw new WireError(`${shown(id)} in the list of models is not an id`);
  const model = unescaped(name);
  return {
    name: model,
    type: unescaped(type),
    parent: unescaped(parent),
    devices: devices.split(/\s+/).filter(Boolean).map((word) => parseDevice(word, model)),
    id: Number(id),
  };
}

function parseDevice(word: string, model: string): DeviceAddress {
  const [, port, name, index] = /^(\d+):([^:]*):(\d+)$/.exec(word) ?? [];
  if (port === undefined || name === undefined || index === undefined) {
    throw new WireError(`${shown(word)} in the list of models is not PORT:INTERFACE:INDEX`);
  }
  return { port: Number(port), interface: name, index: Number(index), model };
}

function isNumber(word: string): boolean {
  return /^\d+$/.test(word);
}

function unescaped(field: string): string {
  return field.replace(/\\[\\tn]/g, (found) => (found === '\\t' ? '\t' : found === '\\n' ? '\n' : '\\'));
}
