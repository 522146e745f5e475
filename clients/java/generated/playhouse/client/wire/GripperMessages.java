// Generated from interfaces/003_gripper.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/**
 * Interface gripper, code 3. A two-finger gripper, with break beams between the fingers and optionally a
 * store for objects.
 */
public final class GripperMessages {
  /** The interface's code. */
  public static final int CODE = 3;

  // Values of Data.state.
  public static final int STATE_OPEN = 1;
  public static final int STATE_CLOSED = 2;
  public static final int STATE_MOVING = 3;
  public static final int STATE_ERROR = 4;

  /**
   * State of the fingers and of the break beams. (player_gripper_data_t)
   *
   * @param state Open, closed, moving or faulty.
   * @param beams One bit per break beam, set if it is interrupted.
   * @param stored Number of stored objects.
   */
  public record Data(int state, long beams, int stored) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0, 0L, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("gripper.Data", body, Data::read);
    }

    static Data read(Reader in) {
      int state = in.uint8();
      long beams = in.uint32();
      int stored = in.uint8();
      return new Data(state, beams, stored);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
      out.uint32(beams);
      out.uint8(stored);
    }
  }

  /**
   * The gripper's size and pose. (player_gripper_geom_t)
   *
   * @param pose Pose of the gripper on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param outerSize Around the fingers (in m, m, m).
   * @param innerSize Of the gap between the open fingers (in m, m, m).
   * @param numBeams Number of break beams.
   * @param capacity Capacity of the store, in objects.
   */
  public record Geom(
      CommonMessages.Pose3d pose, CommonMessages.Bbox3d outerSize, CommonMessages.Bbox3d innerSize, int
      numBeams, int capacity)
      implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d(), new CommonMessages.Bbox3d(), 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("gripper.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d outerSize = CommonMessages.Bbox3d.read(in);
      CommonMessages.Bbox3d innerSize = CommonMessages.Bbox3d.read(in);
      int numBeams = in.uint8();
      int capacity = in.uint8();
      return new Geom(pose, outerSize, innerSize, numBeams, capacity);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      outerSize.write(out);
      innerSize.write(out);
      out.uint8(numBeams);
      out.uint8(capacity);
    }
  }

  /** State of the fingers and of the break beams. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(3, Kind.DATA, 1, "gripper.data.state", Data::decode);

  /** Requests the gripper's size and pose. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(3, Kind.REQ, 1, "gripper.req.get_geom", Geom::decode);

  /** Opens the fingers. */
  public static final MessageType<Nothing> CMD_OPEN =
      new MessageType<>(3, Kind.CMD, 1, "gripper.cmd.open", null);

  /** Closes the fingers. */
  public static final MessageType<Nothing> CMD_CLOSE =
      new MessageType<>(3, Kind.CMD, 2, "gripper.cmd.close", null);

  /** Stops the fingers at their current position. */
  public static final MessageType<Nothing> CMD_STOP =
      new MessageType<>(3, Kind.CMD, 3, "gripper.cmd.stop", null);

  /** Moves the held object into the store. */
  public static final MessageType<Nothing> CMD_STORE =
      new MessageType<>(3, Kind.CMD, 4, "gripper.cmd.store", null);

  /** Moves the object stored last between the fingers. */
  public static final MessageType<Nothing> CMD_RETRIEVE =
      new MessageType<>(3, Kind.CMD, 5, "gripper.cmd.retrieve", null);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, REQ_GET_GEOM, CMD_OPEN, CMD_CLOSE, CMD_STOP, CMD_STORE, CMD_RETRIEVE);

  private GripperMessages() {}
}
