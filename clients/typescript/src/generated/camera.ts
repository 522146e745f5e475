/**
 * Interface camera, code 40. Images.
 *
 * Generated from interfaces/040_camera.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 40;

// Values of Data.format.
export const FORMAT_MONO8 = 1;
export const FORMAT_MONO16 = 2;
export const FORMAT_RGB565 = 4;
export const FORMAT_RGB888 = 5;

// Values of Data.compression.
export const COMPRESS_RAW = 0;
export const COMPRESS_JPEG = 1;

/** One image. (player_camera_data_t) */
export interface Data {
  /** In px. */
  width: number;
  /** In px. */
  height: number;
  /** Per pixel (in bit). */
  bpp: number;
  /** Order and size of the colors. */
  format: number;
  /** Divides the values of a disparity image; 1 otherwise. */
  fdiv: number;
  /** Raw or JPEG. */
  compression: number;
  /** Rows from the top, pixels from the left, or a JPEG file. */
  image: Uint8Array;
}

export const Data: Codec<Data> = new Codec<Data>('camera.Data', {
  zero: () => ({ width: 0, height: 0, bpp: 0, format: 0, fdiv: 0, compression: 0, image: new Uint8Array() }),
  write(to, value) {
    to.uint32(value.width);
    to.uint32(value.height);
    to.uint32(value.bpp);
    to.uint32(value.format);
    to.uint32(value.fdiv);
    to.uint32(value.compression);
    to.length('image', value.image.length, 33554392);
    to.length('image', value.image.length, 33554392);
    to.opaque(value.image);
  },
  read(from) {
    const width = from.uint32();
    const height = from.uint32();
    const bpp = from.uint32();
    const format = from.uint32();
    const fdiv = from.uint32();
    const compression = from.uint32();
    const imageCount = from.uint32();
    const image = from.opaque(from.length('image', imageCount, 1));
    return { width, height, bpp, format, fdiv, compression, image };
  },
});

/** An input of the camera. (player_camera_source_t) */
export interface Source {
  /** Video norm, such as PAL or NTSC, NUL-terminated. */
  norm: Uint8Array;
  /** Index of the input. */
  source: number;
}

export const Source: Codec<Source> = new Codec<Source>('camera.Source', {
  zero: () => ({ norm: new Uint8Array(), source: 0 }),
  write(to, value) {
    to.length('norm', value.norm.length, 33554392);
    to.length('norm', value.norm.length, 33554392);
    to.opaque(value.norm);
    to.int32(value.source);
  },
  read(from) {
    const normCount = from.uint32();
    const norm = from.opaque(from.length('norm', normCount, 1));
    const source = from.int32();
    return { norm, source };
  },
});

/** One image. */
export const DATA_STATE: MessageType<Data> = new MessageType(40, Kind.DATA, 1, 'camera.data.state', Data);

/** Requests the camera's input and norm. */
export const REQ_GET_SOURCE: MessageType<Source> = new MessageType(40, Kind.REQ, 1, 'camera.req.get_source', Source);

/** Selects the input and norm. */
export const REQ_SET_SOURCE: MessageType<Source> = new MessageType(40, Kind.REQ, 2, 'camera.req.set_source', Source);

/** Requests one image now. */
export const REQ_GET_IMAGE: MessageType<Data> = new MessageType(40, Kind.REQ, 3, 'camera.req.get_image', Data);
