package playhouse.client;

import java.util.List;
import java.util.stream.IntStream;
import playhouse.client.wire.BumperMessages;

/** Contact switches. */
public final class Bumper extends Updating<List<Boolean>> {
  Bumper(Opening opening) {
    super(opening);
  }

  /** Whether each switch is pressed, in the order of faces(). Throws NoDataException. */
  public List<Boolean> pressed() {
    byte[] states = stamped(BumperMessages.DATA_STATE).value().bumpers();
    return IntStream.range(0, states.length).mapToObj(i -> states[i] != 0).toList();
  }

  /** Faces of the switches on the robot. */
  public List<Face> faces() {
    return answer(BumperMessages.REQ_GET_GEOM).bumperDef().stream()
        .map(one -> new Face(Pose3d.of(one.pose()), one.length(), one.radius())).toList();
  }

  @Override
  List<Boolean> newest() {
    return pressed();
  }
}
