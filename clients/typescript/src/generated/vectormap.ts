/**
 * Interface vectormap, code 63. Maps of points, lines and areas in layers.
 *
 * Generated from interfaces/063_vectormap.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';
import * as common from './common.js';

export const CODE = 63;

/** One feature. (player_vectormap_feature_data_t) */
export interface FeatureData {
  name: Uint8Array;
  /** Its shape, as OGC well-known binary, in map coordinates. */
  wkb: Uint8Array;
  /** Free text. */
  attrib: Uint8Array;
}

export const FeatureData: Codec<FeatureData> = new Codec<FeatureData>('vectormap.FeatureData', {
  zero: () => ({ name: new Uint8Array(), wkb: new Uint8Array(), attrib: new Uint8Array() }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    to.length('wkb', value.wkb.length, 33554392);
    to.length('wkb', value.wkb.length, 33554392);
    to.opaque(value.wkb);
    to.length('attrib', value.attrib.length, 33554392);
    to.length('attrib', value.attrib.length, 33554392);
    to.opaque(value.attrib);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const wkbCount = from.uint32();
    const wkb = from.opaque(from.length('wkb', wkbCount, 1));
    const attribCount = from.uint32();
    const attrib = from.opaque(from.length('attrib', attribCount, 1));
    return { name, wkb, attrib };
  },
});

/** Description of a layer. (player_vectormap_layer_info_t) */
export interface LayerInfo {
  name: Uint8Array;
  /** Bounding box of all its features (in m, frame p_MP). */
  extent: common.Extent2d;
}

export const LayerInfo: Codec<LayerInfo> = new Codec<LayerInfo>('vectormap.LayerInfo', {
  zero: () => ({ name: new Uint8Array(), extent: common.Extent2d.make() }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    common.Extent2d.write(to, value.extent);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const extent = common.Extent2d.read(from);
    return { name, extent };
  },
});

/** A layer's features. (player_vectormap_layer_data_t) */
export interface LayerData {
  name: Uint8Array;
  features: FeatureData[];
}

export const LayerData: Codec<LayerData> = new Codec<LayerData>('vectormap.LayerData', {
  zero: () => ({ name: new Uint8Array(), features: [] }),
  write(to, value) {
    to.length('name', value.name.length, 33554392);
    to.length('name', value.name.length, 33554392);
    to.opaque(value.name);
    to.length('features', value.features.length, 1398099);
    to.length('features', value.features.length, 1398099);
    for (const each of value.features) FeatureData.write(to, each);
  },
  read(from) {
    const nameCount = from.uint32();
    const name = from.opaque(from.length('name', nameCount, 1));
    const featuresCount = from.uint32();
    const features = from.many(from.length('features', featuresCount, 24), () => FeatureData.read(from));
    return { name, features };
  },
});

/** List of layers. (player_vectormap_info_t) */
export interface Info {
  /** Id of the spatial reference system; 0: none. */
  srid: number;
  layers: LayerInfo[];
  /** Bounding box of all layers (in m, frame p_MP). */
  extent: common.Extent2d;
}

export const Info: Codec<Info> = new Codec<Info>('vectormap.Info', {
  zero: () => ({ srid: 0, layers: [], extent: common.Extent2d.make() }),
  write(to, value) {
    to.uint32(value.srid);
    to.length('layers', value.layers.length, 838859);
    to.length('layers', value.layers.length, 838859);
    for (const each of value.layers) LayerInfo.write(to, each);
    common.Extent2d.write(to, value.extent);
  },
  read(from) {
    const srid = from.uint32();
    const layersCount = from.uint32();
    const layers = from.many(from.length('layers', layersCount, 40), () => LayerInfo.read(from));
    const extent = common.Extent2d.read(from);
    return { srid, layers, extent };
  },
});

/** Requests the list of layers. */
export const REQ_GET_MAP_INFO: MessageType<Info> = new MessageType(63, Kind.REQ, 1, 'vectormap.req.get_map_info', Info);

/** Requests the features of a layer. */
export const REQ_GET_LAYER_DATA: MessageType<LayerData> = new MessageType(
  63,
  Kind.REQ,
  3,
  'vectormap.req.get_layer_data',
  LayerData,
);

/** Replaces the features of a layer. */
export const REQ_WRITE_LAYER: MessageType<LayerData> = new MessageType(
  63,
  Kind.REQ,
  4,
  'vectormap.req.write_layer',
  LayerData,
);
