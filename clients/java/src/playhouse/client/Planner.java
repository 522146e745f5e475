package playhouse.client;

import java.util.Optional;
import playhouse.client.wire.PlannerMessages;

/**
 * A planner, which drives a robot to goals on a map. It goes on while any client has it open; wavefront
 * cancels the goal when the last one closes it.
 */
public final class Planner extends Updating<PlannerState> {
  private static final double SAME_HEADING = 1e-6;  // rad

  private Pose goal;  // of the last goTo()

  Planner(Opening opening) {
    super(opening);
  }

  /** The newest data. Throws NoDataException. */
  public PlannerState state() {
    Stamped<PlannerMessages.Data> stamped = stamped(PlannerMessages.DATA_STATE);
    PlannerMessages.Data data = stamped.value();
    return new PlannerState(data.valid() != 0, data.done() != 0, Pose.of(data.pos()), Pose.of(data.goal()),
        Pose.of(data.waypoint()), data.waypointIdx(), data.waypointsCount(), stamped.time());
  }

  /**
   * Whether the last data say that the goal of the last goTo() is reached; data of another goal do not count.
   */
  public boolean hasArrived() {
    Optional<PlannerMessages.Data> data = latest(PlannerMessages.DATA_STATE);
    return goal != null && data.isPresent() && data.get().done() != 0 && isGoal(Pose.of(data.get().goal()));
  }

  /** Plans a path to a pose on the map and drives there; after stop(), from resume() on. */
  public void goTo(Pose pose) {
    insistOnFinite(pose);
    goal = pose;
    command(PlannerMessages.CMD_GOAL, new PlannerMessages.Cmd(pose.onWire()));
  }

  /** Stops the robot until resume(); the planner keeps its goal. */
  public void stop() {
    request(PlannerMessages.REQ_ENABLE, new PlannerMessages.EnableReq(0));
  }

  /** Ends stop(). */
  public void resume() {
    request(PlannerMessages.REQ_ENABLE, new PlannerMessages.EnableReq(1));
  }

  /** The path as it was planned last; without waypoints if there is none. */
  public Path path() {
    PlannerMessages.WaypointsReq answer = answer(PlannerMessages.REQ_GET_WAYPOINTS);
    return new Path(answer.waypoints().stream().map(Pose::of).toList(), answer.waypointsDistance());
  }

  @Override
  PlannerState newest() {
    return state();
  }

  /** Whole turns aside, which drivers drop. */
  private boolean isGoal(Pose told) {
    return told.x() == goal.x() && told.y() == goal.y()
        && Math.abs(Math.IEEEremainder(told.a() - goal.a(), 2 * Math.PI)) < SAME_HEADING;
  }
}
