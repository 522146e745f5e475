/**
 * A client of Playhouse and of any Player 3 server.
 *
 *     import { connect } from 'playhouse-client';
 *
 *     const client = await connect('127.0.0.1:6665');
 *     const robot = await client.position2d(0);
 *     await robot.drive(0.2);
 *     for await (const state of robot.updates()) console.log(state.pose);
 */

export { Client, connect, Mode, Rule, type ClientOptions, type DeviceEntry, type RuleScope } from './client.js';
export { Access, Device, type DataCallback } from './device.js';
export * from './errors.js';
export type { DeviceAddress, Model } from './models.js';
export * from './generated/proxies/index.js';
export { Robot } from './robot.js';
export { cString, text } from './text.js';
export * from './values.js';
export { Codec, Kind, MessageType, type AnyMessage } from './wire.js';
