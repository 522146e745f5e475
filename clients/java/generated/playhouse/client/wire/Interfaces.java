// Generated from interfaces/ by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;
import java.util.Map;

/** Every interface of the Player protocol. */
public final class Interfaces {
  /** Code of an interface, and its name. */
  public static final Map<Integer, String> NAMES = Map.ofEntries(
      Map.entry(1, "player"),
      Map.entry(2, "power"),
      Map.entry(3, "gripper"),
      Map.entry(4, "position2d"),
      Map.entry(5, "sonar"),
      Map.entry(6, "laser"),
      Map.entry(7, "blobfinder"),
      Map.entry(8, "ptz"),
      Map.entry(9, "audio"),
      Map.entry(10, "fiducial"),
      Map.entry(12, "speech"),
      Map.entry(13, "gps"),
      Map.entry(14, "bumper"),
      Map.entry(20, "dio"),
      Map.entry(21, "aio"),
      Map.entry(22, "ir"),
      Map.entry(23, "wifi"),
      Map.entry(25, "localize"),
      Map.entry(30, "position3d"),
      Map.entry(31, "simulation"),
      Map.entry(33, "blinkenlight"),
      Map.entry(40, "camera"),
      Map.entry(42, "map"),
      Map.entry(44, "planner"),
      Map.entry(45, "log"),
      Map.entry(49, "joystick"),
      Map.entry(50, "speech_recognition"),
      Map.entry(51, "opaque"),
      Map.entry(52, "position1d"),
      Map.entry(53, "actarray"),
      Map.entry(54, "limb"),
      Map.entry(55, "graphics2d"),
      Map.entry(56, "rfid"),
      Map.entry(57, "wsn"),
      Map.entry(58, "graphics3d"),
      Map.entry(59, "health"),
      Map.entry(60, "imu"),
      Map.entry(61, "pointcloud3d"),
      Map.entry(62, "ranger"),
      Map.entry(63, "vectormap"),
      Map.entry(64, "blackboard"),
      Map.entry(65, "stereo"),
      Map.entry(66, "coopobject"));

  /** The messages of an interface, without the shared ones; none if there is no such interface. */
  static List<MessageType<?>> messagesOf(int code) {
    return switch (code) {
      case 1 -> PlayerMessages.MESSAGES;
      case 2 -> PowerMessages.MESSAGES;
      case 3 -> GripperMessages.MESSAGES;
      case 4 -> Position2dMessages.MESSAGES;
      case 5 -> SonarMessages.MESSAGES;
      case 6 -> LaserMessages.MESSAGES;
      case 7 -> BlobfinderMessages.MESSAGES;
      case 8 -> PtzMessages.MESSAGES;
      case 9 -> AudioMessages.MESSAGES;
      case 10 -> FiducialMessages.MESSAGES;
      case 12 -> SpeechMessages.MESSAGES;
      case 13 -> GpsMessages.MESSAGES;
      case 14 -> BumperMessages.MESSAGES;
      case 20 -> DioMessages.MESSAGES;
      case 21 -> AioMessages.MESSAGES;
      case 22 -> IrMessages.MESSAGES;
      case 23 -> WifiMessages.MESSAGES;
      case 25 -> LocalizeMessages.MESSAGES;
      case 30 -> Position3dMessages.MESSAGES;
      case 31 -> SimulationMessages.MESSAGES;
      case 33 -> BlinkenlightMessages.MESSAGES;
      case 40 -> CameraMessages.MESSAGES;
      case 42 -> MapMessages.MESSAGES;
      case 44 -> PlannerMessages.MESSAGES;
      case 45 -> LogMessages.MESSAGES;
      case 49 -> JoystickMessages.MESSAGES;
      case 50 -> SpeechRecognitionMessages.MESSAGES;
      case 51 -> OpaqueMessages.MESSAGES;
      case 52 -> Position1dMessages.MESSAGES;
      case 53 -> ActarrayMessages.MESSAGES;
      case 54 -> LimbMessages.MESSAGES;
      case 55 -> Graphics2dMessages.MESSAGES;
      case 56 -> RfidMessages.MESSAGES;
      case 57 -> WsnMessages.MESSAGES;
      case 58 -> Graphics3dMessages.MESSAGES;
      case 59 -> HealthMessages.MESSAGES;
      case 60 -> ImuMessages.MESSAGES;
      case 61 -> Pointcloud3dMessages.MESSAGES;
      case 62 -> RangerMessages.MESSAGES;
      case 63 -> VectormapMessages.MESSAGES;
      case 64 -> BlackboardMessages.MESSAGES;
      case 65 -> StereoMessages.MESSAGES;
      case 66 -> CoopobjectMessages.MESSAGES;
      default -> List.of();
    };
  }

  /** The messages that all interfaces share. */
  static List<MessageType<?>> sharedMessages() {
    return CommonMessages.MESSAGES;
  }

  private Interfaces() {}
}
