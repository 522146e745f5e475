package playhouse.client;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.SimulationMessages;
import playhouse.client.wire.SimulationMessages.Pose2dReq;
import playhouse.client.wire.SimulationMessages.Pose3dReq;
import playhouse.client.wire.SimulationMessages.PropertyReq;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;

/**
 * The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a top-level
 * model.
 */
public final class Simulation extends Device {
  private static final String ENDED = "the run has ended";  // the server's reason to refuse a step then
  private static final int MOST_TICKS = 1 << 20;

  Simulation(Opening opening) {
    super(opening);
  }

  /** Throws RequestRefusedException if there is no model of that name. */
  public Pose pose(String model) {
    Pose2dReq question = new Pose2dReq(Text.field(model), new CommonMessages.Pose2d());
    return Pose.of(ofModel(model, SimulationMessages.REQ_GET_POSE2D, question).pose());
  }

  /** Throws RequestRefusedException if there is no model of that name. */
  public void setPose(String model, Pose pose) {
    insistOnFinite(pose);
    setOfModel(model, SimulationMessages.REQ_SET_POSE2D, new Pose2dReq(Text.field(model), pose.onWire()));
  }

  /** Throws RequestRefusedException if there is no model of that name. */
  public Pose3d pose3d(String model) {
    Pose3dReq question = new Pose3dReq(Text.field(model), new CommonMessages.Pose3d(), 0);
    return Pose3d.of(ofModel(model, SimulationMessages.REQ_GET_POSE3D, question).pose());
  }

  /** Throws RequestRefusedException if there is no model of that name. */
  public void setPose3d(String model, Pose3d pose) {
    insistOnFinite(pose);
    setOfModel(model, SimulationMessages.REQ_SET_POSE3D, new Pose3dReq(Text.field(model), pose.onWire(), 0));
  }

  /** Pauses or resumes the clock. */
  public void pause() {
    command(SimulationMessages.CMD_PAUSE);
  }

  /**
   * Saves the current world to the file of {@code playhouse run --save-world}; without that option it has no
   * effect.
   */
  public void save() {
    command(SimulationMessages.CMD_SAVE);
  }

  /** Moves everything back to its pose in the world file, while time continues. */
  public void reset() {
    command(SimulationMessages.CMD_RESET);
  }

  /**
   * Restarts the run with a seed, an unsigned number of 64 bits: at tick 0, with the initial models and their
   * ids. Devices have no data until new ones arrive. That requires lock-step, else the server refuses:
   * RequestRefusedException.
   */
  public void reset(long seed) {
    ofWorld("reset", littleEndian(Long.BYTES).putLong(seed), "", session().timeout());
    client().forgetRun();
  }

  /**
   * Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps.
   * Open devices first. Throws RequestRefusedException with the reason.
   */
  public void join(String member) {
    ofWorld("join", ByteBuffer.wrap(Text.field(member)), "", session().timeout());
  }

  /** Runs one tick and waits, without a limit, until it is done. */
  public void step() {
    step(1);
  }

  /** Runs this number of ticks and waits, without a limit, until they are done. */
  public void step(int ticks) {
    step(ticks, Options.FOREVER);
  }

  /**
   * Runs this number of ticks and waits until they are done, in lock-step until all members have requested
   * them. In push mode all data of the ticks have then been delivered to the devices; in pull mode they are
   * queued for read(). Without lock-step a running world refuses: pause() first. Throws RunEndedException
   * when the run has ended.
   */
  public void step(int ticks, Duration timeout) {
    if (ticks < 1 || ticks > MOST_TICKS) {
      throw new InvalidValueException(
          name() + ": ticks is " + ticks + ", not a whole number from 1 to " + MOST_TICKS);
    }
    ofWorld("step", littleEndian(Integer.BYTES).putInt(ticks), "", timeout);
    client().deliverPushed();
  }

  /**
   * Spawns a robot like the model {@code like} at a pose in the world, under a name of the server's choice,
   * which it returns.
   */
  public String spawn(String like, Pose pose) {
    return spawn(like, pose, "");
  }

  /** The same under this name. */
  public String spawn(String like, Pose pose, String model) {
    insistOnFinite(pose);
    byte[] wanted = model.isEmpty() ? new byte[0] : Text.field(model);
    ByteBuffer value = littleEndian(3 * Double.BYTES + wanted.length)
        .putDouble(pose.x()).putDouble(pose.y()).putDouble(pose.a()).put(wanted);
    return Text.of(ofWorld("spawn", value, like, session().timeout()).value());
  }

  /** Removes a top-level model from the world, with its descendants. */
  public void remove(String model) {
    ofWorld("remove", ByteBuffer.allocate(0), model, session().timeout());
  }

  private static ByteBuffer littleEndian(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private PropertyReq ofWorld(String property, ByteBuffer value, String model, Duration timeout) {
    PropertyReq request = new PropertyReq(Text.field(model), Text.field(property), 0, value.array());
    try {
      return request(SimulationMessages.REQ_SET_PROPERTY, request, timeout).orElse(request);
    } catch (RequestRefusedException error) {
      String why = error.body().length > 0
          ? Text.of(PropertyReq.decode(error.body()).value()) : "the server does not do that";
      if (why.equals(ENDED)) {
        throw new RunEndedException(session().peer() + ": " + why);
      }
      throw new RequestRefusedException(session().peer() + ": " + property + " was refused: " + why);
    }
  }

  private <P extends Struct> P ofModel(String model, MessageType<P> message, P question) {
    try {
      return answer(message, question);
    } catch (RequestRefusedException error) {
      throw refusal(model, message);
    }
  }

  private <P extends Struct> void setOfModel(String model, MessageType<P> message, P value) {
    try {
      request(message, value);
    } catch (RequestRefusedException error) {
      throw refusal(model, message);
    }
  }

  private RequestRefusedException refusal(String model, MessageType<?> message) {
    return new RequestRefusedException(
        session().peer() + ": " + message.name() + " of model \"" + model + "\" was refused");
  }
}
