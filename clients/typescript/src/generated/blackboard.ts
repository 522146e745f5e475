/**
 * Interface blackboard, code 64. Named values shared by clients.
 *
 * Generated from interfaces/064_blackboard.toml by codegen; do not edit.
 */

import { Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 64;

/** Subscribes to one entry; the answer has its value. */
export const REQ_SUBSCRIBE_TO_KEY: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  1,
  'blackboard.req.subscribe_to_key',
  common.BlackboardEntry,
);

/** Unsubscribes one entry. */
export const REQ_UNSUBSCRIBE_FROM_KEY: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  2,
  'blackboard.req.unsubscribe_from_key',
  common.BlackboardEntry,
);

/** Sets an entry. */
export const REQ_SET_ENTRY: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  3,
  'blackboard.req.set_entry',
  common.BlackboardEntry,
);

/** Subscribes to all entries of a group. */
export const REQ_SUBSCRIBE_TO_GROUP: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  4,
  'blackboard.req.subscribe_to_group',
  common.BlackboardEntry,
);

/** Unsubscribes a group. */
export const REQ_UNSUBSCRIBE_FROM_GROUP: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  5,
  'blackboard.req.unsubscribe_from_group',
  common.BlackboardEntry,
);

/** Requests an entry once. */
export const REQ_GET_ENTRY: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.REQ,
  6,
  'blackboard.req.get_entry',
  common.BlackboardEntry,
);

/** A subscribed entry has changed. */
export const DATA_UPDATE: MessageType<common.BlackboardEntry> = new MessageType(
  64,
  Kind.DATA,
  1,
  'blackboard.data.update',
  common.BlackboardEntry,
);
