// Generated from interfaces/025_localize.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface localize, code 25. Localization on a map: weighted hypotheses of the robot's pose. */
public final class LocalizeMessages {
  /** The interface's code. */
  public static final int CODE = 25;

  /**
   * A hypothesis. (player_localize_hypoth_t)
   *
   * @param mean Mean of the hypothesis (in m, m, rad, frame X_MR).
   * @param cov Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad, 6 elements).
   * @param alpha Weight; the weights sum to 1.
   */
  public record Hypoth(CommonMessages.Pose2d mean, double[] cov, double alpha) implements Struct {
    /** Every number 0, every list empty. */
    public Hypoth() {
      this(new CommonMessages.Pose2d(), new double[6], 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Hypoth decode(byte[] body) {
      return Reader.decode("localize.Hypoth", body, Hypoth::read);
    }

    static Hypoth read(Reader in) {
      CommonMessages.Pose2d mean = CommonMessages.Pose2d.read(in);
      double[] cov = in.float64s(6);
      double alpha = in.float64();
      return new Hypoth(mean, cov, alpha);
    }

    @Override
    public void write(Writer out) {
      mean.write(out);
      out.exactly("cov", cov.length, 6);
      out.float64s(cov);
      out.float64(alpha);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Hypoth that && mean.equals(that.mean) && Arrays.equals(cov, that.cov)
          && Double.compare(alpha, that.alpha) == 0;
    }

    @Override
    public int hashCode() {
      return Objects.hash(mean, alpha, Arrays.hashCode(cov));
    }
  }

  /**
   * The hypotheses. (player_localize_data_t)
   *
   * @param pendingCount Number of queued sensor readings.
   * @param pendingTime Time of the last processed reading (in s).
   * @param hypoths Hypoths.
   */
  public record Data(long pendingCount, double pendingTime, List<Hypoth> hypoths) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0.0, List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("localize.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long pendingCount = in.uint32();
      double pendingTime = in.float64();
      long hypothsCount = in.uint32();
      List<Hypoth> hypoths = in.structs(in.length("hypoths", hypothsCount, 80), Hypoth::read);
      return new Data(pendingCount, pendingTime, hypoths);
    }

    @Override
    public void write(Writer out) {
      out.uint32(pendingCount);
      out.float64(pendingTime);
      out.length("hypoths", hypoths.size(), 419429);
      out.length("hypoths", hypoths.size(), 419429);
      out.structs(hypoths);
    }
  }

  /**
   * Pose of the robot. (player_localize_set_pose_t)
   *
   * @param mean Mean of the hypothesis (in m, m, rad, frame X_MR).
   * @param cov Spread: xx, yy, aa, xy, ya, xa (in m^2, m^2, rad^2, m^2, m rad, m rad, 6 elements).
   */
  public record SetPose(CommonMessages.Pose2d mean, double[] cov) implements Struct {
    /** Every number 0, every list empty. */
    public SetPose() {
      this(new CommonMessages.Pose2d(), new double[6]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetPose decode(byte[] body) {
      return Reader.decode("localize.SetPose", body, SetPose::read);
    }

    static SetPose read(Reader in) {
      CommonMessages.Pose2d mean = CommonMessages.Pose2d.read(in);
      double[] cov = in.float64s(6);
      return new SetPose(mean, cov);
    }

    @Override
    public void write(Writer out) {
      mean.write(out);
      out.exactly("cov", cov.length, 6);
      out.float64s(cov);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof SetPose that && mean.equals(that.mean) && Arrays.equals(cov, that.cov);
    }

    @Override
    public int hashCode() {
      return Objects.hash(mean, Arrays.hashCode(cov));
    }
  }

  /**
   * One particle. (player_localize_particle_t)
   *
   * @param pose The particle's estimate of the robot's pose (in m, m, rad, frame X_MR).
   * @param alpha Weight.
   */
  public record Particle(CommonMessages.Pose2d pose, double alpha) implements Struct {
    /** Every number 0, every list empty. */
    public Particle() {
      this(new CommonMessages.Pose2d(), 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Particle decode(byte[] body) {
      return Reader.decode("localize.Particle", body, Particle::read);
    }

    static Particle read(Reader in) {
      CommonMessages.Pose2d pose = CommonMessages.Pose2d.read(in);
      double alpha = in.float64();
      return new Particle(pose, alpha);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      out.float64(alpha);
    }
  }

  /**
   * The particles of the filter. (player_localize_get_particles_t)
   *
   * @param mean Of the most likely hypothesis (in m, m, rad, frame X_MR).
   * @param variance Of the most likely hypothesis (in m^2).
   * @param particles Particles.
   */
  public record GetParticles(
      CommonMessages.Pose2d mean, double variance, List<Particle> particles)
      implements Struct {
    /** Every number 0, every list empty. */
    public GetParticles() {
      this(new CommonMessages.Pose2d(), 0.0, List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static GetParticles decode(byte[] body) {
      return Reader.decode("localize.GetParticles", body, GetParticles::read);
    }

    static GetParticles read(Reader in) {
      CommonMessages.Pose2d mean = CommonMessages.Pose2d.read(in);
      double variance = in.float64();
      long particlesCount = in.uint32();
      List<Particle> particles = in.structs(in.length("particles", particlesCount, 32), Particle::read);
      return new GetParticles(mean, variance, particles);
    }

    @Override
    public void write(Writer out) {
      mean.write(out);
      out.float64(variance);
      out.length("particles", particles.size(), 1048574);
      out.length("particles", particles.size(), 1048574);
      out.structs(particles);
    }
  }

  /** The hypotheses, the most likely first. */
  public static final MessageType<Data> DATA_HYPOTHS =
      new MessageType<>(25, Kind.DATA, 1, "localize.data.hypoths", Data::decode);

  /** Sets the robot's pose estimate. */
  public static final MessageType<SetPose> REQ_SET_POSE =
      new MessageType<>(25, Kind.REQ, 1, "localize.req.set_pose", SetPose::decode);

  /** Requests the particles of the driver's filter. */
  public static final MessageType<GetParticles> REQ_GET_PARTICLES =
      new MessageType<>(25, Kind.REQ, 2, "localize.req.get_particles", GetParticles::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_HYPOTHS, REQ_SET_POSE, REQ_GET_PARTICLES);

  private LocalizeMessages() {}
}
