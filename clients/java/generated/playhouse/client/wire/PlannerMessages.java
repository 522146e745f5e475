// Generated from interfaces/044_planner.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface planner, code 44. Plans and follows a path to a goal. */
public final class PlannerMessages {
  /** The interface's code. */
  public static final int CODE = 44;

  /**
   * Progress of the robot along its path. (player_planner_data_t)
   *
   * @param valid 1 if there is a path to the goal.
   * @param done 1 if the goal is reached.
   * @param pos The robot (in m, m, rad, frame X_MR).
   * @param goal The goal (in m, m, rad, frame X_MG).
   * @param waypoint Current waypoint of the robot (in m, m, rad, frame X_MP).
   * @param waypointIdx Index of that waypoint in the path; -1 if there is none.
   * @param waypointsCount Number of waypoints of the path.
   */
  public record Data(
      int valid, int done, CommonMessages.Pose2d pos, CommonMessages.Pose2d goal, CommonMessages.Pose2d
      waypoint, int waypointIdx, long waypointsCount)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0, 0, new CommonMessages.Pose2d(), new CommonMessages.Pose2d(), new CommonMessages.Pose2d(), 0,
          0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("planner.Data", body, Data::read);
    }

    static Data read(Reader in) {
      int valid = in.uint8();
      int done = in.uint8();
      CommonMessages.Pose2d pos = CommonMessages.Pose2d.read(in);
      CommonMessages.Pose2d goal = CommonMessages.Pose2d.read(in);
      CommonMessages.Pose2d waypoint = CommonMessages.Pose2d.read(in);
      int waypointIdx = in.int32();
      long waypointsCount = in.uint32();
      return new Data(valid, done, pos, goal, waypoint, waypointIdx, waypointsCount);
    }

    @Override
    public void write(Writer out) {
      out.uint8(valid);
      out.uint8(done);
      pos.write(out);
      goal.write(out);
      waypoint.write(out);
      out.int32(waypointIdx);
      out.uint32(waypointsCount);
    }
  }

  /**
   * A goal. (player_planner_cmd_t)
   *
   * @param goal Goal pose (in m, m, rad, frame X_MG).
   */
  public record Cmd(CommonMessages.Pose2d goal) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(new CommonMessages.Pose2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("planner.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      CommonMessages.Pose2d goal = CommonMessages.Pose2d.read(in);
      return new Cmd(goal);
    }

    @Override
    public void write(Writer out) {
      goal.write(out);
    }
  }

  /**
   * The planned path. (player_planner_waypoints_req_t)
   *
   * @param waypointsDistance Length of the path (in m).
   * @param waypoints From the robot to the goal (in m, m, rad, frame X_MP).
   */
  public record WaypointsReq(
      double waypointsDistance, List<CommonMessages.Pose2d> waypoints)
      implements Struct {
    /** Every number 0, every list empty. */
    public WaypointsReq() {
      this(0.0, List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static WaypointsReq decode(byte[] body) {
      return Reader.decode("planner.WaypointsReq", body, WaypointsReq::read);
    }

    static WaypointsReq read(Reader in) {
      double waypointsDistance = in.float64();
      long waypointsCount = in.uint32();
      List<CommonMessages.Pose2d> waypoints = in.structs(in.length("waypoints", waypointsCount, 24),
          CommonMessages.Pose2d::read);
      return new WaypointsReq(waypointsDistance, waypoints);
    }

    @Override
    public void write(Writer out) {
      out.float64(waypointsDistance);
      out.length("waypoints", waypoints.size(), 1398099);
      out.length("waypoints", waypoints.size(), 1398099);
      out.structs(waypoints);
    }
  }

  /**
   * The planner's switch. (player_planner_enable_req_t)
   *
   * @param state 1: may move, 0: stop.
   */
  public record EnableReq(int state) implements Struct {
    /** Every number 0, every list empty. */
    public EnableReq() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static EnableReq decode(byte[] body) {
      return Reader.decode("planner.EnableReq", body, EnableReq::read);
    }

    static EnableReq read(Reader in) {
      int state = in.uint8();
      return new EnableReq(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /** Progress of the robot along its path. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(44, Kind.DATA, 1, "planner.data.state", Data::decode);

  /** Sets the goal. */
  public static final MessageType<Cmd> CMD_GOAL =
      new MessageType<>(44, Kind.CMD, 1, "planner.cmd.goal", Cmd::decode);

  /** Sets the goal and starts to move. */
  public static final MessageType<Cmd> CMD_START =
      new MessageType<>(44, Kind.CMD, 2, "planner.cmd.start", Cmd::decode);

  /** Requests the planned path. */
  public static final MessageType<WaypointsReq> REQ_GET_WAYPOINTS =
      new MessageType<>(44, Kind.REQ, 1, "planner.req.get_waypoints", WaypointsReq::decode);

  /** Enables or stops the robot. */
  public static final MessageType<EnableReq> REQ_ENABLE =
      new MessageType<>(44, Kind.REQ, 2, "planner.req.enable", EnableReq::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, CMD_GOAL, CMD_START, REQ_GET_WAYPOINTS, REQ_ENABLE);

  private PlannerMessages() {}
}
