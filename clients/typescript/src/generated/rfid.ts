/**
 * Interface rfid, code 56. Reads and writes radio tags.
 *
 * Generated from interfaces/056_rfid.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 56;

/** One tag. (player_rfid_tag_t) */
export interface Tag {
  /** Type of tag. */
  type: number;
  /** Id of the tag, as bytes. */
  guid: Uint8Array;
}

export const Tag: Codec<Tag> = new Codec<Tag>('rfid.Tag', {
  zero: () => ({ type: 0, guid: new Uint8Array() }),
  write(to, value) {
    to.uint32(value.type);
    to.length('guid', value.guid.length, 33554392);
    to.length('guid', value.guid.length, 33554392);
    to.opaque(value.guid);
  },
  read(from) {
    const type = from.uint32();
    const guidCount = from.uint32();
    const guid = from.opaque(from.length('guid', guidCount, 1));
    return { type, guid };
  },
});

/** Tags in range. (player_rfid_data_t) */
export interface Data {
  tags: Tag[];
}

export const Data: Codec<Data> = new Codec<Data>('rfid.Data', {
  zero: () => ({ tags: [] }),
  write(to, value) {
    to.length('tags', value.tags.length, 2796199);
    to.length('tags', value.tags.length, 2796199);
    for (const each of value.tags) Tag.write(to, each);
  },
  read(from) {
    const tagsCount = from.uint32();
    const tags = from.many(from.length('tags', tagsCount, 12), () => Tag.read(from));
    return { tags };
  },
});

/** Tags in range. */
export const DATA_TAGS: MessageType<Data> = new MessageType(56, Kind.DATA, 1, 'rfid.data.tags', Data);

/** Switches the reader on or off. */
export const REQ_POWER: MessageType<undefined> = new MessageType(56, Kind.REQ, 1, 'rfid.req.power');

/** Reads a tag. */
export const REQ_READTAG: MessageType<undefined> = new MessageType(56, Kind.REQ, 2, 'rfid.req.readtag');

/** Writes a tag. */
export const REQ_WRITETAG: MessageType<undefined> = new MessageType(56, Kind.REQ, 3, 'rfid.req.writetag');

/** Locks a tag against writing. */
export const REQ_LOCKTAG: MessageType<undefined> = new MessageType(56, Kind.REQ, 4, 'rfid.req.locktag');
