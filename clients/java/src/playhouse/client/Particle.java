package playhouse.client;

/** A particle of the localization's filter: a possible pose of the robot on the map, and its weight. */
public record Particle(Pose pose, double weight) {}
