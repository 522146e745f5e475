import { Device } from '../device.js';
import { camera } from '../generated/index.js';
import { Image } from '../values.js';

/** A camera. */
export class Camera extends Device {
  /** The newest image. */
  get image(): Image {
    const { value, time } = this.stamped(camera.DATA_STATE);
    const isJpeg = value.compression === camera.COMPRESS_JPEG;
    return new Image(value.width, value.height, value.format, isJpeg, value.image, time);
  }

  /** Reads for ever: one image per new data message. Throws RequestTimeout after `timeout` s without. */
  updates(timeout?: number): AsyncGenerator<Image, never, void> {
    return this.follow(() => this.image, timeout);
  }
}
