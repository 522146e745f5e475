package playhouse.client;

/**
 * The data of a planner; poses are on the map.
 *
 * @param valid Whether there is a path to the goal.
 * @param done Whether the goal is reached.
 * @param pose Of the robot.
 * @param goal Where it is to go.
 * @param waypoint Where it drives to now.
 * @param index Of that waypoint in the path; -1 if there is none.
 * @param count Number of waypoints of the path.
 * @param time The server's, in s.
 */
public record PlannerState(
    boolean valid, boolean done, Pose pose, Pose goal, Pose waypoint, int index, long count, double time) {}
