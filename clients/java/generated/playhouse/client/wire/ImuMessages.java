// Generated from interfaces/060_imu.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface imu, code 60. Accelerations, turn rates, magnetic field and orientation. */
public final class ImuMessages {
  /** The interface's code. */
  public static final int CODE = 60;

  /**
   * Pose by integration. (player_imu_data_state_t)
   *
   * @param pose In m, m, m, rad, rad, rad, frame X_WS.
   */
  public record DataState(CommonMessages.Pose3d pose) implements Struct {
    /** Every number 0, every list empty. */
    public DataState() {
      this(new CommonMessages.Pose3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataState decode(byte[] body) {
      return Reader.decode("imu.DataState", body, DataState::read);
    }

    static DataState read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      return new DataState(pose);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
    }
  }

  /**
   * Calibrated readings. (player_imu_data_calib_t)
   *
   * @param accelX In m/s^2, frame a_WS_S.
   * @param accelY In m/s^2, frame a_WS_S.
   * @param accelZ In m/s^2, frame a_WS_S.
   * @param gyroX In rad/s, frame v_WS_S.
   * @param gyroY In rad/s, frame v_WS_S.
   * @param gyroZ In rad/s, frame v_WS_S.
   * @param magnX Magnetic field, in a driver-specific unit (frame n_S).
   * @param magnY Frame n_S.
   * @param magnZ Frame n_S.
   */
  public record DataCalib(
      float accelX, float accelY, float accelZ, float gyroX, float gyroY, float gyroZ, float magnX, float
      magnY, float magnZ)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataCalib() {
      this(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataCalib decode(byte[] body) {
      return Reader.decode("imu.DataCalib", body, DataCalib::read);
    }

    static DataCalib read(Reader in) {
      float accelX = in.float32();
      float accelY = in.float32();
      float accelZ = in.float32();
      float gyroX = in.float32();
      float gyroY = in.float32();
      float gyroZ = in.float32();
      float magnX = in.float32();
      float magnY = in.float32();
      float magnZ = in.float32();
      return new DataCalib(accelX, accelY, accelZ, gyroX, gyroY, gyroZ, magnX, magnY, magnZ);
    }

    @Override
    public void write(Writer out) {
      out.float32(accelX);
      out.float32(accelY);
      out.float32(accelZ);
      out.float32(gyroX);
      out.float32(gyroY);
      out.float32(gyroZ);
      out.float32(magnX);
      out.float32(magnY);
      out.float32(magnZ);
    }
  }

  /**
   * Calibrated readings and orientation as a quaternion. (player_imu_data_quat_t)
   *
   * @param calibData Calib data.
   * @param q0 Real part (frame R_WS).
   * @param q1 Frame R_WS.
   * @param q2 Frame R_WS.
   * @param q3 Frame R_WS.
   */
  public record DataQuat(DataCalib calibData, float q0, float q1, float q2, float q3) implements Struct {
    /** Every number 0, every list empty. */
    public DataQuat() {
      this(new DataCalib(), 0f, 0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataQuat decode(byte[] body) {
      return Reader.decode("imu.DataQuat", body, DataQuat::read);
    }

    static DataQuat read(Reader in) {
      DataCalib calibData = DataCalib.read(in);
      float q0 = in.float32();
      float q1 = in.float32();
      float q2 = in.float32();
      float q3 = in.float32();
      return new DataQuat(calibData, q0, q1, q2, q3);
    }

    @Override
    public void write(Writer out) {
      calibData.write(out);
      out.float32(q0);
      out.float32(q1);
      out.float32(q2);
      out.float32(q3);
    }
  }

  /**
   * Calibrated readings and orientation as angles. (player_imu_data_euler_t)
   *
   * @param calibData Calib data.
   * @param orientation In rad, frame R_WS.
   */
  public record DataEuler(DataCalib calibData, CommonMessages.Orientation3d orientation) implements Struct {
    /** Every number 0, every list empty. */
    public DataEuler() {
      this(new DataCalib(), new CommonMessages.Orientation3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataEuler decode(byte[] body) {
      return Reader.decode("imu.DataEuler", body, DataEuler::read);
    }

    static DataEuler read(Reader in) {
      DataCalib calibData = DataCalib.read(in);
      CommonMessages.Orientation3d orientation = CommonMessages.Orientation3d.read(in);
      return new DataEuler(calibData, orientation);
    }

    @Override
    public void write(Writer out) {
      calibData.write(out);
      orientation.write(out);
    }
  }

  /**
   * Pose, velocity and acceleration. (player_imu_data_fullstate_t)
   *
   * @param pose In m, m, m, rad, rad, rad, frame X_WS.
   * @param vel In m/s, m/s, m/s, rad/s, rad/s, rad/s, frame v_WS_S.
   * @param acc In m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, frame a_WS_S.
   */
  public record DataFullstate(
      CommonMessages.Pose3d pose, CommonMessages.Pose3d vel, CommonMessages.Pose3d acc)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataFullstate() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Pose3d(), new CommonMessages.Pose3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataFullstate decode(byte[] body) {
      return Reader.decode("imu.DataFullstate", body, DataFullstate::read);
    }

    static DataFullstate read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Pose3d vel = CommonMessages.Pose3d.read(in);
      CommonMessages.Pose3d acc = CommonMessages.Pose3d.read(in);
      return new DataFullstate(pose, vel, acc);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      vel.write(out);
      acc.write(out);
    }
  }

  /**
   * Selected data message. (player_imu_datatype_config_t)
   *
   * @param value Its subtype.
   */
  public record DatatypeConfig(int value) implements Struct {
    /** Every number 0, every list empty. */
    public DatatypeConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DatatypeConfig decode(byte[] body) {
      return Reader.decode("imu.DatatypeConfig", body, DatatypeConfig::read);
    }

    static DatatypeConfig read(Reader in) {
      int value = in.uint8();
      return new DatatypeConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint8(value);
    }
  }

  /**
   * Quantity that becomes the reference. (player_imu_reset_orientation_config_t)
   *
   * @param value 0: heading, 1: orientation, 2: driver-specific.
   */
  public record ResetOrientationConfig(long value) implements Struct {
    /** Every number 0, every list empty. */
    public ResetOrientationConfig() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ResetOrientationConfig decode(byte[] body) {
      return Reader.decode("imu.ResetOrientationConfig", body, ResetOrientationConfig::read);
    }

    static ResetOrientationConfig read(Reader in) {
      long value = in.uint32();
      return new ResetOrientationConfig(value);
    }

    @Override
    public void write(Writer out) {
      out.uint32(value);
    }
  }

  /**
   * A new orientation. (player_imu_reset_euler_config_t)
   *
   * @param orientation Only the angles apply (in m, m, m, rad, rad, rad, frame X_WS).
   */
  public record ResetEulerConfig(CommonMessages.Pose3d orientation) implements Struct {
    /** Every number 0, every list empty. */
    public ResetEulerConfig() {
      this(new CommonMessages.Pose3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ResetEulerConfig decode(byte[] body) {
      return Reader.decode("imu.ResetEulerConfig", body, ResetEulerConfig::read);
    }

    static ResetEulerConfig read(Reader in) {
      CommonMessages.Pose3d orientation = CommonMessages.Pose3d.read(in);
      return new ResetEulerConfig(orientation);
    }

    @Override
    public void write(Writer out) {
      orientation.write(out);
    }
  }

  /** Pose by integration. */
  public static final MessageType<DataState> DATA_STATE =
      new MessageType<>(60, Kind.DATA, 1, "imu.data.state", DataState::decode);

  /** Calibrated readings. */
  public static final MessageType<DataCalib> DATA_CALIB =
      new MessageType<>(60, Kind.DATA, 2, "imu.data.calib", DataCalib::decode);

  /** Calibrated readings and orientation as a quaternion. */
  public static final MessageType<DataQuat> DATA_QUAT =
      new MessageType<>(60, Kind.DATA, 3, "imu.data.quat", DataQuat::decode);

  /** Calibrated readings and orientation as angles. */
  public static final MessageType<DataEuler> DATA_EULER =
      new MessageType<>(60, Kind.DATA, 4, "imu.data.euler", DataEuler::decode);

  /** Pose, velocity and acceleration. */
  public static final MessageType<DataFullstate> DATA_FULLSTATE =
      new MessageType<>(60, Kind.DATA, 5, "imu.data.fullstate", DataFullstate::decode);

  /** Selects which data message is sent. */
  public static final MessageType<DatatypeConfig> REQ_SET_DATATYPE =
      new MessageType<>(60, Kind.REQ, 1, "imu.req.set_datatype", DatatypeConfig::decode);

  /** Makes the current orientation the reference. */
  public static final MessageType<ResetOrientationConfig> REQ_RESET_ORIENTATION =
      new MessageType<>(60, Kind.REQ, 2, "imu.req.reset_orientation", ResetOrientationConfig::decode);

  /** Sets the current orientation. */
  public static final MessageType<ResetEulerConfig> REQ_RESET_EULER =
      new MessageType<>(60, Kind.REQ, 3, "imu.req.reset_euler", ResetEulerConfig::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, DATA_CALIB, DATA_QUAT, DATA_EULER, DATA_FULLSTATE, REQ_SET_DATATYPE, REQ_RESET_ORIENTATION,
      REQ_RESET_EULER);

  private ImuMessages() {}
}
