package playhouse.client;

import java.util.Locale;
import playhouse.client.wire.ImuMessages;
import playhouse.client.wire.MessageType;

/** Base of devices that send one of several data messages. */
abstract class Selecting extends Device {
  Selecting(Opening opening) {
    super(opening);
  }

  /**
   * One of ImuMessages.DATA_STATE (pose()), DATA_CALIB (inertia()), DATA_QUAT (inertia() and quaternion()),
   * DATA_EULER (inertia() and attitude()) and DATA_FULLSTATE (pose() and velocity()), for all subscribers of
   * the device.
   */
  public void send(MessageType<?> datatype) {
    request(ImuMessages.REQ_SET_DATATYPE, new ImuMessages.DatatypeConfig(datatype.subtype()));
  }

  @Override
  String lackOf(MessageType<?> message) {
    String constant = message.name().replaceFirst("imu[.]", "").replace('.', '_').toUpperCase(Locale.ROOT);
    return super.lackOf(message) + (hasData() ? "; send(ImuMessages." + constant + ") selects it" : "");
  }
}
