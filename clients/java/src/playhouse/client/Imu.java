package playhouse.client;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Locale;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.ImuMessages;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.Struct;

/** An inertial unit. send() selects the data message; initially it is that of pose(). */
public final class Imu extends Device {
  Imu(Opening opening) {
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

  /** Estimated pose. Throws NoDataException. */
  public Pose3d pose() {
    Struct data = newestOf(ImuMessages.DATA_STATE, ImuMessages.DATA_FULLSTATE);
    return Pose3d.of(
        data instanceof ImuMessages.DataState state ? state.pose() : ((ImuMessages.DataFullstate) data).pose());
  }

  /** Estimated velocity, along and about its own axes. Throws NoDataException. */
  public Pose3d velocity() {
    return Pose3d.of(stamped(ImuMessages.DATA_FULLSTATE).value().vel());
  }

  /** The newest measurement. Throws NoDataException. */
  public Inertia inertia() {
    Struct data = newestOf(ImuMessages.DATA_CALIB, ImuMessages.DATA_QUAT, ImuMessages.DATA_EULER);
    if (data instanceof ImuMessages.DataQuat quat) {
      return inertiaOf(quat.calibData());
    }
    return inertiaOf(
        data instanceof ImuMessages.DataEuler euler ? euler.calibData() : (ImuMessages.DataCalib) data);
  }

  /** Throws NoDataException. */
  public Attitude attitude() {
    CommonMessages.Orientation3d turns = stamped(ImuMessages.DATA_EULER).value().orientation();
    return new Attitude(turns.proll(), turns.ppitch(), turns.pyaw());
  }

  /** Throws NoDataException. */
  public Quaternion quaternion() {
    ImuMessages.DataQuat data = stamped(ImuMessages.DATA_QUAT).value();
    return new Quaternion(data.q0(), data.q1(), data.q2(), data.q3());
  }

  /** Makes the current heading the reference; with {@code allAxes} the whole current orientation. */
  public void resetOrientation(boolean allAxes) {
    request(ImuMessages.REQ_RESET_ORIENTATION, new ImuMessages.ResetOrientationConfig(allAxes ? 1 : 0));
  }

  /** Sets the current orientation. */
  public void resetAttitude(Attitude attitude) {
    insistOnFinite("roll", attitude.roll());
    insistOnFinite("pitch", attitude.pitch());
    insistOnFinite("yaw", attitude.yaw());
    Pose3d turned = new Pose3d(0, 0, 0, attitude.roll(), attitude.pitch(), attitude.yaw());
    request(ImuMessages.REQ_RESET_EULER, new ImuMessages.ResetEulerConfig(turned.onWire()));
  }

  @Override
  String lackOf(MessageType<?> message) {
    String constant = message.name().replaceFirst("imu[.]", "").replace('.', '_').toUpperCase(Locale.ROOT);
    return super.lackOf(message) + (hasData() ? "; send(ImuMessages." + constant + ") selects it" : "");
  }

  private static Inertia inertiaOf(ImuMessages.DataCalib data) {
    return new Inertia(new Vector3(data.accelX(), data.accelY(), data.accelZ()),
        new Vector3(data.gyroX(), data.gyroY(), data.gyroZ()), new Vector3(data.magnX(), data.magnY(), data.magnZ()));
  }

  /** The newest of several kinds of data; of those with one time the first. */
  private Struct newestOf(MessageType<?>... kinds) {
    return Arrays.stream(kinds).filter(kind -> latest(kind).isPresent()).<Stamped<? extends Struct>>map(this::stamped)
        .max(Comparator.comparingDouble(Stamped::time)).orElseGet(() -> stamped(kinds[0])).value();
  }
}
