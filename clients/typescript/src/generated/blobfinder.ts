/**
 * Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images.
 *
 * Generated from interfaces/007_blobfinder.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 7;

/** A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t) */
export interface Blob {
  /** Channel that detected it. */
  id: number;
  /** 0xRRGGBB, for display. */
  color: number;
  /** Area in pixels (in px). */
  area: number;
  /** Column of its centre (in px). */
  x: number;
  /** Row of its centre (in px). */
  y: number;
  /** First column (in px). */
  left: number;
  /** Last column (in px). */
  right: number;
  /** First row (in px). */
  top: number;
  /** Last row (in px). */
  bottom: number;
  /** Distance; 0 if unknown (in m). */
  range: number;
}

export const Blob: Codec<Blob> = new Codec<Blob>('blobfinder.Blob', {
  zero: () => ({ id: 0, color: 0, area: 0, x: 0, y: 0, left: 0, right: 0, top: 0, bottom: 0, range: 0 }),
  write(to, value) {
    to.uint32(value.id);
    to.uint32(value.color);
    to.uint32(value.area);
    to.uint32(value.x);
    to.uint32(value.y);
    to.uint32(value.left);
    to.uint32(value.right);
    to.uint32(value.top);
    to.uint32(value.bottom);
    to.float32(value.range);
  },
  read(from) {
    const id = from.uint32();
    const color = from.uint32();
    const area = from.uint32();
    const x = from.uint32();
    const y = from.uint32();
    const left = from.uint32();
    const right = from.uint32();
    const top = from.uint32();
    const bottom = from.uint32();
    const range = from.float32();
    return { id, color, area, x, y, left, right, top, bottom, range };
  },
});

/** The blobs of one image. (player_blobfinder_data_t) */
export interface Data {
  /** Of the image (in px). */
  width: number;
  /** Of the image (in px). */
  height: number;
  blobs: Blob[];
}

export const Data: Codec<Data> = new Codec<Data>('blobfinder.Data', {
  zero: () => ({ width: 0, height: 0, blobs: [] }),
  write(to, value) {
    to.uint32(value.width);
    to.uint32(value.height);
    to.length('blobs', value.blobs.length, 838859);
    to.length('blobs', value.blobs.length, 838859);
    for (const each of value.blobs) Blob.write(to, each);
  },
  read(from) {
    const width = from.uint32();
    const height = from.uint32();
    const blobsCount = from.uint32();
    const blobs = from.many(from.length('blobs', blobsCount, 40), () => Blob.read(from));
    return { width, height, blobs };
  },
});

/** The colors that a channel detects, as ranges of red, green and blue. (player_blobfinder_color_config_t) */
export interface ColorConfig {
  /** Channel; -1 means all (signed). */
  channel: number;
  rmin: number;
  rmax: number;
  gmin: number;
  gmax: number;
  bmin: number;
  bmax: number;
}

export const ColorConfig: Codec<ColorConfig> = new Codec<ColorConfig>('blobfinder.ColorConfig', {
  zero: () => ({ channel: 0, rmin: 0, rmax: 0, gmin: 0, gmax: 0, bmin: 0, bmax: 0 }),
  write(to, value) {
    to.int32(value.channel);
    to.uint32(value.rmin);
    to.uint32(value.rmax);
    to.uint32(value.gmin);
    to.uint32(value.gmax);
    to.uint32(value.bmin);
    to.uint32(value.bmax);
  },
  read(from) {
    const channel = from.int32();
    const rmin = from.uint32();
    const rmax = from.uint32();
    const gmin = from.uint32();
    const gmax = from.uint32();
    const bmin = from.uint32();
    const bmax = from.uint32();
    return { channel, rmin, rmax, gmin, gmax, bmin, bmax };
  },
});

/** Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t) */
export interface ImagerConfig {
  /** 0 to 255. */
  brightness: number;
  /** 0 to 255. */
  contrast: number;
  /** 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance. */
  colormode: number;
  /** 0 off, 1 on. */
  autogain: number;
}

export const ImagerConfig: Codec<ImagerConfig> = new Codec<ImagerConfig>('blobfinder.ImagerConfig', {
  zero: () => ({ brightness: 0, contrast: 0, colormode: 0, autogain: 0 }),
  write(to, value) {
    to.int32(value.brightness);
    to.int32(value.contrast);
    to.int32(value.colormode);
    to.int32(value.autogain);
  },
  read(from) {
    const brightness = from.int32();
    const contrast = from.int32();
    const colormode = from.int32();
    const autogain = from.int32();
    return { brightness, contrast, colormode, autogain };
  },
});

/** The blobs of one image. */
export const DATA_BLOBS: MessageType<Data> = new MessageType(7, Kind.DATA, 1, 'blobfinder.data.blobs', Data);

/** Sets the colors that a channel detects. */
export const REQ_SET_COLOR: MessageType<ColorConfig> = new MessageType(
  7,
  Kind.REQ,
  1,
  'blobfinder.req.set_color',
  ColorConfig,
);

/** Sets brightness, contrast and other settings of the camera. */
export const REQ_SET_IMAGER_PARAMS: MessageType<ImagerConfig> = new MessageType(
  7,
  Kind.REQ,
  2,
  'blobfinder.req.set_imager_params',
  ImagerConfig,
);

/** Requests the colors that a channel detects. */
export const REQ_GET_COLOR: MessageType<ColorConfig> = new MessageType(
  7,
  Kind.REQ,
  3,
  'blobfinder.req.get_color',
  ColorConfig,
);
