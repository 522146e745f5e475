package playhouse.client;

import java.util.List;

/** A planned path: its waypoints on the map, from the robot to the goal, and its length in m. */
public record Path(List<Pose> waypoints, double length) {}
