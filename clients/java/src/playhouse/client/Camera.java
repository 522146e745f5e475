package playhouse.client;

import playhouse.client.wire.CameraMessages;

/** A camera. */
public final class Camera extends Updating<Image> {
  Camera(Opening opening) {
    super(opening);
  }

  /** The newest image. Throws NoDataException. */
  public Image image() {
    Stamped<CameraMessages.Data> stamped = stamped(CameraMessages.DATA_STATE);
    CameraMessages.Data data = stamped.value();
    return new Image(whole(data.width()), whole(data.height()), whole(data.format()),
        data.compression() == CameraMessages.COMPRESS_JPEG, data.image(), stamped.time());
  }

  @Override
  Image newest() {
    return image();
  }

  /** No message has room for pictures with numbers beyond. */
  private static int whole(long number) {
    return (int) Math.min(number, Integer.MAX_VALUE);
  }
}
