// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#include "playhouse/scene/kinds.h"

namespace playhouse::scene {
namespace {

constexpr std::string_view kOld_model_laser_return_to[] = {"ranger_return"};
constexpr SaidWord kOld_model_laser_return_values[] = {{"0", "-1"}};
constexpr Meaning kOld_model_laser_return{.how = Meaning::How::kWords, .to = kOld_model_laser_return_to, .values = kOld_model_laser_return_values};
constexpr std::string_view kOld_model_blobfinder_return_to[] = {"blob_return"};
constexpr Meaning kOld_model_blobfinder_return{.how = Meaning::How::kWords, .to = kOld_model_blobfinder_return_to};
constexpr std::string_view kOld_model_vision_return_to[] = {"blob_return"};
constexpr Meaning kOld_model_vision_return{.how = Meaning::How::kWords, .to = kOld_model_vision_return_to};
constexpr std::string_view kOld_model_puck_return_to[] = {"gripper_return"};
constexpr Meaning kOld_model_puck_return{.how = Meaning::How::kWords, .to = kOld_model_puck_return_to};
constexpr std::string_view kOld_model_gui_movemask_to[] = {"gui_move"};
constexpr Meaning kOld_model_gui_movemask{.how = Meaning::How::kWords, .to = kOld_model_gui_movemask_to};
constexpr std::string_view kOld_model_offset_to[] = {"origin.0", "origin.1"};
constexpr Meaning kOld_model_offset{.how = Meaning::How::kWords, .to = kOld_model_offset_to};
constexpr std::string_view kOld_model_size3_to[] = {"size"};
constexpr Meaning kOld_model_size3{.how = Meaning::How::kWords, .to = kOld_model_size3_to};
constexpr Meaning kOld_model_polygons{.how = Meaning::How::kCount, .part = "block"};
constexpr SaidWord kOld_model_polygon_part_words[] = {{"z", "0 1"}};
constexpr Meaning kOld_model_polygon{.how = Meaning::How::kNested, .part = "block", .part_words = kOld_model_polygon_part_words};
constexpr Meaning kOld_model_blocks{.how = Meaning::How::kCount, .part = "block"};
constexpr SaidWord kOld_model_block_part_words[] = {{"z", "0 1"}};
constexpr Meaning kOld_model_block{.how = Meaning::How::kNested, .part = "block", .part_words = kOld_model_block_part_words};
constexpr Word kWordsOfModel[70] = {
    {.name = "name", .use = Use::kRead, .type = "text", .told = "the type and its number, as position:0", .doc = "Name of the model. Inside a parent the full name is parent.name; a name with a leading / is used as given."},
    {.name = "pose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Pose in the parent."},
    {.name = "tilt", .use = Use::kRead, .type = "tuple", .form = "[roll pitch]", .unit = "deg", .otherwise = "[0 0]", .limits = "from -180 to 180", .doc = "Roll and pitch in the parent, in the arena: turned about its x axis by the roll, then about y by the pitch, then by its heading; a positive pitch lowers its front. The stage engine keeps all models upright."},
    {.name = "origin", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Pose of the body and of the sensors, relative to the model's pose."},
    {.name = "size", .use = Use::kRead, .type = "size", .form = "[x y z]", .unit = "m", .told = "the kind's own", .doc = "Bounding box that the body fills; 0 in x or y makes a wall 0.01 m thick."},
    {.name = "color", .use = Use::kRead, .type = "color", .told = "the kind's own", .doc = "Name of an X11 color, or random, which is the same in every run."},
    {.name = "color_rgba", .use = Use::kRead, .type = "rgba", .form = "[red green blue alpha]", .told = "the kind's own", .doc = "Color components from 0 to 1; used if there is no color."},
    {.name = "bitmap", .use = Use::kRead, .type = "text", .doc = "An image (PNG, JPEG, PGM, PPM, PBM or BMP). Its dark pixels (first channel up to 127) are solid, transparent ones (alpha up to 127) are free; it is scaled to the size."},
    {.name = "mesh", .use = Use::kRead, .type = "text", .doc = "A mesh file (COLLADA, glTF, OBJ or STL) for the appearance and the body. It is scaled to the size if one is given, else it keeps its own. See docs/meshes.md."},
    {.name = "look", .use = Use::kRead, .type = "text", .doc = "A mesh file for the appearance alone, scaled to the size: on the page, in pictures and for cameras of the arena. Its white surfaces have the color of the model. Everything else sees and meets the body. See docs/meshes.md."},
    {.name = "mesh_pose", .use = Use::kRead, .type = "tuple", .form = "[x y z roll pitch yaw]", .unit = "m, m, m, deg, deg, deg", .otherwise = "[0 0 0 0 0 0]", .doc = "Pose of the mesh file in the body: rotations about its x, y and z axes, in this order, as rpy of URDF. The place counts with mesh_fit 0."},
    {.name = "mesh_scale", .use = Use::kRead, .type = "tuple", .form = "[x y z]", .otherwise = "[1 1 1]", .doc = "Factors on the axes of the mesh file, before it is turned, or one for all; below 0 it is mirrored. 0.001 is for files in millimetres."},
    {.name = "mesh_fit", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "The mesh is moved to the middle of the body, onto its floor, and scaled to the size. With 0 it keeps its own origin and size."},
    {.name = "noblocks", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "No default box for a model without blocks, bitmap or mesh."},
    {.name = "boundary", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Four walls inside the edges of the size, in addition to a bitmap or blocks."},
    {.name = "stack_children", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "Child models stand on top of it."},
    {.name = "obstacle_return", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "Collides with other models."},
    {.name = "ranger_return", .use = Use::kRead, .type = "number", .otherwise = "1", .doc = "Intensity that rangers report; below 0 it is invisible to rangers."},
    {.name = "fiducial_return", .use = Use::kRead, .type = "integer", .otherwise = "0", .doc = "Marker id that fiducial finders report; 0: no marker."},
    {.name = "fiducial_key", .use = Use::kRead, .type = "integer", .otherwise = "0", .doc = "Finders detect only markers of their own key."},
    {.name = "gripper_return", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Grippers can lift it, with all its parts: it must be a top-level model without a part that drives."},
    {.name = "mass", .use = Use::kRead, .type = "number", .unit = "kg", .otherwise = "0", .limits = "not negative", .doc = "Mass. Driving draws 10 W per kg and m/s, and per kg and rad/s. The stage engine has no dynamics and uses it for nothing else; the arena does."},
    {.name = "friction", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "not negative", .doc = "Friction coefficient of its surface. No effect in the stage engine and in Stage, where nothing slides; the arena multiplies the coefficients of the two surfaces in contact."},
    {.name = "friction_axes", .use = Use::kRead, .type = "tuple", .form = "[x y]", .otherwise = "[1 1]", .limits = "from 0 to 1", .doc = "Fractions of its friction along its x and y, in the arena: with [0.1 1] it slides along its x, like a sledge."},
    {.name = "material", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Name of its material, as \"glass\": a property for detectors (sees, through), and its surface in the arena (docs/arena.md)."},
    {.name = "restitution", .use = Use::kRead, .type = "number", .told = "that of its material", .limits = "from 0 to 1", .doc = "Fraction of the speed of impact with which it bounces off, in the arena; of two surfaces in contact the larger one applies."},
    {.name = "roughness", .use = Use::kRead, .type = "number", .told = "that of its material", .limits = "from 0 to 1", .doc = "Roughness of its surface for light, from 0, a mirror, to 1, matt. For cameras of the arena engine and the page."},
    {.name = "lamp", .use = Use::kRead, .type = "number", .unit = "cd", .otherwise = "0", .limits = "not negative", .doc = "Luminous intensity of an omnidirectional light in its color; a bulb of 60 W has 65. A lamp that can be switched off shines while it is lit. Rendered by cameras of the arena engine; a light for detectors."},
    {.name = "update_interval", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "100", .limits = "not negative", .doc = "Measurement period of a sensor, at least one tick."},
    {.name = "alwayson", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Moves and measures without a subscriber."},
    {.name = "gui_move", .use = Use::kRead, .type = "flag", .told = "1, inside another model 0", .doc = "A viewer may drag it in the page."},
    {.name = "gui_nose", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws a point ahead of its body, as for every model that drives."},
    {.name = "gui_outline", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws the edges of its bounding box on the floor."},
    {.name = "gui_grid", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws a grid on its bounding box, one line per metre."},
    {.name = "say", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Text that it says at the start, shown as a speech bubble in the page: one line, truncated to 1024 bytes. Controllers and clients can change it."},
    {.name = "trail_length", .use = Use::kRead, .type = "integer", .otherwise = "20", .limits = "not negative", .doc = "Number of past positions that the page draws."},
    {.name = "ctrl", .use = Use::kRead, .type = "texts", .doc = "Its controllers, each a name and arguments."},
    {.name = "watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power drawn from its battery, or its parent's. Kinds with a power consumption of their own use that instead."},
    {.name = "joules", .use = Use::kRead, .type = "number", .unit = "J", .told = "no battery", .doc = "Initial energy of its battery, and its capacity; below 0: infinite."},
    {.name = "joules_capacity", .use = Use::kRead, .type = "number", .unit = "J", .told = "the initial energy", .limits = "not negative", .doc = "Capacity of its battery; initial energy above it is discarded."},
    {.name = "kjoules", .use = Use::kRead, .type = "number", .unit = "kJ", .told = "no battery", .doc = "As joules, in kJ; applied after joules and joules_capacity."},
    {.name = "kjoules_capacity", .use = Use::kRead, .type = "number", .unit = "kJ", .told = "the initial energy", .limits = "not negative", .doc = "As joules_capacity, in kJ; applied last."},
    {.name = "give_watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power with which it charges models in contact with it."},
    {.name = "take_watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power with which other models may charge it."},
    {.name = "map_resolution", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0.1", .limits = "not negative", .doc = "Cell size of its device `map` ([drivers.md](../drivers.md)); with 0 it has none."},
    {.name = "map_height", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0.2", .doc = "Height above the floor of the world at which its device `map` shows walls ([drivers.md](../drivers.md))."},
    {.name = "blob_return", .use = Use::kSilent},
    {.name = "trail_interval", .use = Use::kSilent},
    {.name = "event_queue", .use = Use::kSilent},
    {.name = "debug", .use = Use::kSilent},
    {.name = "laser_return", .use = Use::kOld, .instead = "write ranger_return, -1 for what rangers see through", .meaning = &kOld_model_laser_return},
    {.name = "sonar_return", .use = Use::kOld, .instead = "ranger_return is for lasers and sonars"},
    {.name = "blobfinder_return", .use = Use::kOld, .instead = "write blob_return", .meaning = &kOld_model_blobfinder_return},
    {.name = "vision_return", .use = Use::kOld, .instead = "write blob_return", .meaning = &kOld_model_vision_return},
    {.name = "puck_return", .use = Use::kOld, .instead = "write gripper_return", .meaning = &kOld_model_puck_return},
    {.name = "gui_movemask", .use = Use::kOld, .instead = "write gui_move", .meaning = &kOld_model_gui_movemask},
    {.name = "gui_boundary", .use = Use::kOld},
    {.name = "gui_geometry", .use = Use::kOld},
    {.name = "shape", .use = Use::kOld},
    {.name = "reversed", .use = Use::kOld},
    {.name = "scale", .use = Use::kOld},
    {.name = "port", .use = Use::kOld},
    {.name = "block_return", .use = Use::kOld},
    {.name = "offset", .use = Use::kOld, .instead = "write origin [x y z heading]", .meaning = &kOld_model_offset},
    {.name = "size3", .use = Use::kOld, .instead = "write size [x y z]", .meaning = &kOld_model_size3},
    {.name = "polygons", .use = Use::kOld, .instead = "the block( ) entities are counted", .meaning = &kOld_model_polygons},
    {.name = "polygon", .use = Use::kOld, .instead = "write block( points N point[0] [x y] ... )", .meaning = &kOld_model_polygon},
    {.name = "blocks", .use = Use::kOld, .instead = "the block( ) entities are counted", .meaning = &kOld_model_blocks},
    {.name = "block", .use = Use::kOld, .instead = "write block( points N point[0] [x y] ... z [min max] )", .meaning = &kOld_model_block},
    {.name = "interval_real", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfModel[3] = {
    {"speech", 12, Index::kRobot, Need::kNothing, Need::kRobot, true},
    {"speech_recognition", 50, Index::kRobot, Need::kNothing, Need::kRobot, false},
    {"map", 42, Index::kCount, Need::kNothing, Need::kNever, true},
};

constexpr Word kWordsOfPosition[14] = {
    {.name = "drive", .use = Use::kRead, .type = "choice", .form = "\"diff\" | \"omni\" | \"walk\" | \"car\"", .otherwise = "\"diff\"", .doc = "Drive model. \"diff\": differential: forward velocity and turn rate, like two wheels; \"omni\": omnidirectional; \"walk\": legs: omnidirectional; with the arena engine it climbs steps of up to 0.3 m; \"car\": forward velocity and the steering angle of an axle."},
    {.name = "localization", .use = Use::kRead, .type = "choice", .form = "\"gps\" | \"odom\"", .otherwise = "\"gps\"", .doc = "Source of its pose estimate. \"gps\": the true pose; \"odom\": wheel odometry, with an error."},
    {.name = "localization_origin", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .told = "odom: the start pose, gps: 0 0 0 0", .doc = "Pose in the world of the origin of its pose estimate."},
    {.name = "velocity", .use = Use::kRead, .type = "twist", .form = "[x y z heading]", .unit = "m/s, m/s, m/s, deg/s", .otherwise = "[0 0 0 0]", .doc = "Initial command."},
    {.name = "velocity_bounds", .use = Use::kRead, .type = "bounds", .form = "[xmin xmax ymin ymax zmin zmax amin amax]", .unit = "m/s, m/s, m/s, deg/s", .otherwise = "[-1 1 -1 1 -1 1 -90 90]", .doc = "Minimum and maximum velocity along each axis."},
    {.name = "acceleration_bounds", .use = Use::kRead, .type = "bounds", .form = "[xmin xmax ymin ymax zmin zmax amin amax]", .unit = "m/s^2, m/s^2, m/s^2, deg/s^2", .otherwise = "[-1 1 -1 1 -1 1 -90 90]", .doc = "Minimum and maximum acceleration along each axis, for commanded accelerations of controllers."},
    {.name = "wheelbase", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "1", .limits = "above 0", .doc = "Distance between the front and the rear axle of a car."},
    {.name = "max_force", .use = Use::kRead, .type = "number", .unit = "N", .told = "as much as its wheels grip", .limits = "above 0", .doc = "Largest force with which its motors push it along the ground, in the arena: with mass m it gains at most max_force / m of speed a second."},
    {.name = "max_power", .use = Use::kRead, .type = "number", .unit = "W", .told = "no limit", .limits = "above 0", .doc = "Largest mechanical power of its motors, in the arena: at speed v they push with at most max_power / v."},
    {.name = "odom_error", .use = Use::kRead, .type = "twist", .form = "[x y z heading]", .told = "drawn per robot: up to 0.015 in x and y, 0.025 in heading", .doc = "Odometry errors along each axis, as fractions of the motion."},
    {.name = "show_waypoints", .use = Use::kOld},
    {.name = "odom", .use = Use::kOld, .instead = "write localization \"odom\""},
    {.name = "power", .use = Use::kOld},
    {.name = "steer", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfPosition[2] = {
    {"position2d", 4, Index::kRobot, Need::kNothing, Need::kNothing, false},
    {"position3d", 30, Index::kRobot, Need::kNothing, Need::kNothing, false},
};

constexpr std::string_view kOld_ranger_range_max_to[] = {"range.1"};
constexpr Meaning kOld_ranger_range_max{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_range_max_to};
constexpr std::string_view kOld_ranger_range_min_to[] = {"range.0"};
constexpr Meaning kOld_ranger_range_min{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_range_min_to};
constexpr std::string_view kOld_ranger_view_to[] = {"range.0", "range.1", "fov"};
constexpr Meaning kOld_ranger_view{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_view_to};
constexpr std::string_view kOld_ranger_ssize_to[] = {"size.0", "size.1"};
constexpr Meaning kOld_ranger_ssize{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_ssize_to};
constexpr std::string_view kOld_ranger_spose_to[] = {"pose.0", "pose.1", "pose.3"};
constexpr Meaning kOld_ranger_spose{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_spose_to};
constexpr Meaning kOld_ranger_scount{.how = Meaning::How::kCount, .part = "sensor"};
constexpr std::string_view kOld_ranger_sview_to[] = {"range.0", "range.1", "fov"};
constexpr Meaning kOld_ranger_sview{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_sview_to};
constexpr std::string_view kOld_ranger_srange_to[] = {"range.0", "range.1"};
constexpr Meaning kOld_ranger_srange{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_srange_to};
constexpr std::string_view kOld_ranger_samples_to[] = {"samples"};
constexpr Meaning kOld_ranger_samples{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_samples_to};
constexpr std::string_view kOld_ranger_fov_to[] = {"fov"};
constexpr Meaning kOld_ranger_fov{.how = Meaning::How::kWords, .part = "sensor", .to = kOld_ranger_fov_to};
constexpr Word kWordsOfRanger[11] = {
    {.name = "range_max", .use = Use::kOld, .instead = "it belongs into a sensor( range [min max] )", .meaning = &kOld_ranger_range_max},
    {.name = "range_min", .use = Use::kOld, .instead = "it belongs into a sensor( range [min max] )", .meaning = &kOld_ranger_range_min},
    {.name = "view", .use = Use::kOld, .instead = "write sensor( range [min max] fov degrees )", .meaning = &kOld_ranger_view},
    {.name = "ssize", .use = Use::kOld, .instead = "write sensor( size [x y z] )", .meaning = &kOld_ranger_ssize},
    {.name = "spose", .use = Use::kOld, .instead = "write one sensor( pose [x y z heading] ) each", .meaning = &kOld_ranger_spose},
    {.name = "scount", .use = Use::kOld, .instead = "the sensor( ) entities are counted", .meaning = &kOld_ranger_scount},
    {.name = "sview", .use = Use::kOld, .instead = "write sensor( range [min max] fov degrees )", .meaning = &kOld_ranger_sview},
    {.name = "srange", .use = Use::kOld, .instead = "write sensor( range [min max] )", .meaning = &kOld_ranger_srange},
    {.name = "samples", .use = Use::kOld, .instead = "it belongs into a sensor( ... )", .meaning = &kOld_ranger_samples},
    {.name = "fov", .use = Use::kOld, .instead = "it belongs into a sensor( ... )", .meaning = &kOld_ranger_fov},
    {.name = "laser_sample_skip", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfRanger[4] = {
    {"ranger", 62, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"laser", 6, Index::kRobot, Need::kScanner, Need::kScanner, false},
    {"sonar", 5, Index::kRobot, Need::kNothing, Need::kSeveralSensors, false},
    {"pointcloud3d", 61, Index::kCount, Need::kRings, Need::kRings, false},
};

constexpr std::string_view kOld_fiducial_range_to[] = {"range_max"};
constexpr Meaning kOld_fiducial_range{.how = Meaning::How::kWords, .to = kOld_fiducial_range_to};
constexpr Word kWordsOfFiducial[6] = {
    {.name = "range_min", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Minimum range of detection."},
    {.name = "range_max", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "8", .limits = "not negative", .doc = "Maximum range of detection."},
    {.name = "range_max_id", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "5", .limits = "not negative", .doc = "Maximum range of identification; the id of a marker beyond it is reported as 0."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "180", .limits = "not negative", .doc = "Horizontal field of view, symmetric about the axis."},
    {.name = "ignore_zloc", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Detects markers at any height."},
    {.name = "range", .use = Use::kOld, .instead = "write range_max", .meaning = &kOld_fiducial_range},
};

constexpr KindInterface kInterfacesOfFiducial[1] = {
    {"fiducial", 10, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr std::string_view kOld_blobfinder_channel_count_to[] = {"colors_count"};
constexpr Meaning kOld_blobfinder_channel_count{.how = Meaning::How::kWords, .to = kOld_blobfinder_channel_count_to};
constexpr std::string_view kOld_blobfinder_channels_to[] = {"colors"};
constexpr Meaning kOld_blobfinder_channels{.how = Meaning::How::kWords, .to = kOld_blobfinder_channels_to};
constexpr std::string_view kOld_blobfinder_channels_count_to[] = {"colors_count"};
constexpr Meaning kOld_blobfinder_channels_count{.how = Meaning::How::kWords, .to = kOld_blobfinder_channels_count_to};
constexpr std::string_view kOld_blobfinder_range_max_to[] = {"range"};
constexpr Meaning kOld_blobfinder_range_max{.how = Meaning::How::kWords, .to = kOld_blobfinder_range_max_to};
constexpr std::string_view kOld_blobfinder_ptz_to[] = {"pan", "", "fov"};
constexpr Meaning kOld_blobfinder_ptz{.how = Meaning::How::kWords, .to = kOld_blobfinder_ptz_to};
constexpr Word kWordsOfBlobfinder[11] = {
    {.name = "colors_count", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 256", .doc = "Number of colors, of those listed, that it detects; 0: all listed ones, and any color if none is listed."},
    {.name = "colors", .use = Use::kRead, .type = "colors", .doc = "Names of the colors that it detects."},
    {.name = "image", .use = Use::kRead, .type = "tuple", .form = "[width height]", .unit = "px", .otherwise = "[80 60]", .limits = "from 1 to 4096", .doc = "Image size."},
    {.name = "range", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "12", .limits = "not negative", .doc = "Maximum range."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "60", .limits = "not negative", .doc = "Horizontal field of view, symmetric about the axis."},
    {.name = "pan", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "Direction of view, positive to the left."},
    {.name = "channel_count", .use = Use::kOld, .instead = "write colors_count", .meaning = &kOld_blobfinder_channel_count},
    {.name = "channels", .use = Use::kOld, .instead = "write colors", .meaning = &kOld_blobfinder_channels},
    {.name = "channels_count", .use = Use::kOld, .instead = "write colors_count", .meaning = &kOld_blobfinder_channels_count},
    {.name = "range_max", .use = Use::kOld, .instead = "write range", .meaning = &kOld_blobfinder_range_max},
    {.name = "ptz", .use = Use::kOld, .instead = "write pan and fov", .meaning = &kOld_blobfinder_ptz},
};

constexpr KindInterface kInterfacesOfBlobfinder[1] = {
    {"blobfinder", 7, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfBumper[3] = {
    {.name = "bcount", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 256", .doc = "Number of switches."},
    {.name = "bpose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .counted_by = "bcount", .doc = "Centre of a switch's face and its outward direction, indexed from 0; without an index: of all other switches."},
    {.name = "blength", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .counted_by = "bcount", .doc = "Length of a switch's face, indexed from 0; without an index: of all other switches."},
};

constexpr KindInterface kInterfacesOfBumper[1] = {
    {"bumper", 14, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfBlinkenlight[3] = {
    {.name = "period", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "1000", .limits = "not negative", .doc = "Period of the flashes; 0: steady light."},
    {.name = "dutycycle", .use = Use::kRead, .type = "number", .otherwise = "1", .limits = "not negative", .doc = "Fraction of the period in which it is lit, from the start of the period; 1 or more: steady light."},
    {.name = "enabled", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "Switched on at the start."},
};

constexpr KindInterface kInterfacesOfBlinkenlight[1] = {
    {"blinkenlight", 33, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr KindInterface kInterfacesOfLightindicator[1] = {
    {"blinkenlight", 33, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfGripper[3] = {
    {.name = "paddle_size", .use = Use::kRead, .type = "tuple", .form = "[x y z]", .otherwise = "[0.66 0.1 0.4]", .limits = "from 0 to 1", .doc = "Size of a paddle, as fractions of the model's size."},
    {.name = "paddle_state", .use = Use::kRead, .type = "choices", .form = "[(\"open\" | \"closed\") (\"down\" | \"up\")]", .otherwise = "[\"open\" \"down\"]", .doc = "Initial state of the paddles."},
    {.name = "autosnatch", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Closes when an object is between the paddles, and opens when none is."},
};

constexpr KindInterface kInterfacesOfGripper[1] = {
    {"gripper", 3, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfActuator[6] = {
    {.name = "type", .use = Use::kRead, .type = "choice", .form = "\"linear\" | \"rotational\"", .otherwise = "\"linear\"", .doc = "Type of joint. \"linear\": prismatic, it slides; \"rotational\": revolute, it turns."},
    {.name = "axis", .use = Use::kRead, .type = "tuple", .form = "[x y z]", .otherwise = "[0 0 0]", .doc = "Direction of sliding in its own frame, of any length; [0 0 0] is ahead. A revolute joint turns about z alone, to the right if z is negative."},
    {.name = "min_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "0", .doc = "Lower limit of travel, relative to its pose."},
    {.name = "max_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "1", .doc = "Upper limit of travel; if it is below the lower limit, the joint does not move."},
    {.name = "max_speed", .use = Use::kRead, .type = "number", .unit = "m/s or rad/s", .otherwise = "1", .limits = "not negative", .doc = "Maximum speed."},
    {.name = "start_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "0", .doc = "Initial position, relative to its pose."},
};

constexpr KindInterface kInterfacesOfActuator[1] = {
    {"actarray", 53, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfWifi[16] = {
    {.name = "ip", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Network address; default: 10.x.y.z, from its number."},
    {.name = "mac", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Hardware address; default: 02:00:00:xx:yy:zz, from its number."},
    {.name = "essid", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Name of its network; radios of other networks are not received."},
    {.name = "freq", .use = Use::kRead, .type = "number", .unit = "MHz", .otherwise = "2450", .limits = "not negative", .doc = "Carrier frequency."},
    {.name = "bitrate", .use = Use::kRead, .type = "number", .unit = "bit/s", .otherwise = "1.1e+07", .limits = "not negative", .doc = "Reported bit rate."},
    {.name = "power", .use = Use::kRead, .type = "number", .unit = "dBm", .otherwise = "15", .doc = "Transmit power."},
    {.name = "sensitivity", .use = Use::kRead, .type = "number", .unit = "dBm", .otherwise = "-70", .doc = "Minimum received level; weaker signals are not received."},
    {.name = "model", .use = Use::kRead, .type = "choice", .form = "\"friis\" | \"simple\" | \"ITU indoor\" | \"log distance\" | \"raytrace\"", .otherwise = "\"friis\"", .doc = "Propagation model. \"friis\": free space; \"simple\": free space, no reception beyond range; \"ITU indoor\": indoor, with plc (ITU-R P.1238); \"log distance\": free space up to 1 m, then with ple; \"raytrace\": free space, and wall_factor for each wall."},
    {.name = "range", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "30", .limits = "not negative", .doc = "Maximum range of reception, with model \"simple\"."},
    {.name = "plc", .use = Use::kRead, .type = "number", .otherwise = "30", .limits = "not negative", .doc = "Path loss in dB per decade of distance, with model \"ITU indoor\"."},
    {.name = "ple", .use = Use::kRead, .type = "number", .otherwise = "3", .limits = "not negative", .doc = "Path loss exponent, with model \"log distance\": 2 in free space, 3 to 5 in buildings."},
    {.name = "wall_factor", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "5", .limits = "not negative", .doc = "Loss per wall on the straight line, with model \"raytrace\"."},
    {.name = "fading", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "0", .limits = "not negative", .doc = "Standard deviation of the fading of a link, drawn anew for each measurement."},
    {.name = "loss", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 100", .doc = "Percentage of lost messages from received radios, drawn for each message."},
    {.name = "range_db", .use = Use::kOld, .instead = "write sensitivity"},
    {.name = "random_seed", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfWifi[2] = {
    {"wifi", 23, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"opaque", 51, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfCamera[12] = {
    {.name = "resolution", .use = Use::kRead, .type = "tuple", .form = "[width height]", .unit = "px", .otherwise = "[32 32]", .limits = "from 1 to 2048", .doc = "Image size."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0.2 8]", .limits = "0 <= min <= max", .doc = "Near and far clipping distance, along the optical axis."},
    {.name = "fov", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "deg", .otherwise = "[70 40]", .limits = "from 1 to 170", .doc = "Initial field of view."},
    {.name = "pantilt", .use = Use::kRead, .type = "tuple", .form = "[pan tilt]", .unit = "deg", .otherwise = "[0 0]", .doc = "Initial direction of view, positive to the left and upwards."},
    {.name = "pan_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[-100 100]", .doc = "Pan limits for clients: right and left."},
    {.name = "tilt_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[-25 25]", .doc = "Tilt limits for clients: down and up."},
    {.name = "zoom_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[5 70]", .limits = "from 1 to 170", .doc = "Limits of the horizontal field of view for clients."},
    {.name = "pantilt_speed", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "90", .limits = "not negative", .doc = "Maximum speed of pan, tilt and field of view, per second."},
    {.name = "image", .use = Use::kRead, .type = "choice", .form = "\"color\" | \"gray\" | \"depth\" | \"segmentation\"", .otherwise = "\"color\"", .doc = "Content of a pixel. \"color\": red, green and blue; \"gray\": brightness; \"depth\": distance along the optical axis, in mm; 0 if nothing is in range, or only beyond 65.535 m; \"segmentation\": the model's id plus 1, in 24 bits; 0 if none is in range."},
    {.name = "compression", .use = Use::kRead, .type = "choice", .form = "\"raw\" | \"jpeg\"", .otherwise = "\"raw\"", .doc = "Encoding of images; depth and segmentation images are always raw. \"raw\": rows of pixels; \"jpeg\": a JPEG file."},
    {.name = "quality", .use = Use::kRead, .type = "count", .otherwise = "85", .limits = "from 1 to 100", .doc = "JPEG quality, in percent."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[value depth]", .otherwise = "[0 0]", .limits = "from 0 to 1", .doc = "Pixel noise: standard deviation of each of red, green and blue, as a fraction of full scale, and of depth, as a fraction of the distance."},
};

constexpr KindInterface kInterfacesOfCamera[2] = {
    {"camera", 40, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"ptz", 8, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfDetector[15] = {
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "60", .limits = "from 0 to 360", .doc = "Horizontal field of view, symmetric about the axis. Beams have equal shares of it; the first is the rightmost."},
    {.name = "fov_vertical", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .limits = "from 0 to 170", .doc = "Vertical field of view, symmetric about the horizontal; 0: lines are horizontal, at half its own height."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0 8]", .limits = "0 <= min <= max", .doc = "Minimum and maximum range of reported objects, along the line of sight."},
    {.name = "samples", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 65536", .doc = "Number of beams. A beam reports the range of the nearest object in its share of the field of view."},
    {.name = "rays", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 1024", .doc = "Number of lines of sight per beam, evenly spaced over its share: 1 is a thin beam like a laser's, many a wide one like a sonar's."},
    {.name = "layers", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 256", .doc = "Number of elevations at which each line is cast, evenly spaced from below upwards."},
    {.name = "sees", .use = Use::kRead, .type = "texts", .doc = "Conditions that select reported objects, one of which must hold, as \"kind=position color=red\" (docs/detectors.md); without any, everything is reported."},
    {.name = "through", .use = Use::kRead, .type = "texts", .doc = "Conditions for bodies that do not obstruct, with the syntax of sees, as \"material=glass\"."},
    {.name = "walls", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 1000", .doc = "Number of obstructing bodies that a line penetrates, in addition to those that match through."},
    {.name = "attenuation", .use = Use::kRead, .type = "tuple", .form = "[body metre]", .unit = "dB", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "Loss in each penetrated body, and per metre of path inside it."},
    {.name = "spread", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "not negative", .doc = "Exponent of the path loss with distance, counted from 1 m: 2 for a lamp, 4 for a radar echo."},
    {.name = "budget", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "100", .limits = "not negative", .doc = "Maximum total loss of a reported object. Its level is the remaining budget."},
    {.name = "resolution", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Quantisation step of ranges; 0: none."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[constant proportional angular]", .unit = "m, 1, deg", .otherwise = "[0 0 0]", .limits = "from 0 to 360", .doc = "Standard deviations: of ranges, as a length and as a fraction of the range, and of bearings of detected objects."},
    {.name = "miss", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "from 0 to 1", .doc = "Probability of missing an object in view, drawn for each object in each measurement."},
};

constexpr KindInterface kInterfacesOfDetector[2] = {
    {"ranger", 62, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"fiducial", 10, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfCustom[1] = {
    {.name = "library", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Name of the library, followed by arguments."},
};

constexpr KindInterface kInterfacesOfCustom[1] = {
    {"aio", 21, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfImu[6] = {
    {.name = "acceleration_noise", .use = Use::kRead, .type = "tuple", .form = "[white walk]", .unit = "m/s^2/sqrt(Hz), m/s^3/sqrt(Hz)", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "Noise of the accelerometer along each axis: density of white noise, and density of the noise that drives the random walk of the bias."},
    {.name = "gyro_noise", .use = Use::kRead, .type = "tuple", .form = "[white walk]", .unit = "rad/s/sqrt(Hz), rad/s^2/sqrt(Hz)", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "The same for the gyroscope, about each axis."},
    {.name = "acceleration_bias", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "0", .limits = "not negative", .doc = "Standard deviation of the initial bias of each accelerometer axis."},
    {.name = "gyro_bias", .use = Use::kRead, .type = "number", .unit = "rad/s", .otherwise = "0", .limits = "not negative", .doc = "Standard deviation of the initial bias of each gyroscope axis."},
    {.name = "acceleration_range", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "156.906", .limits = "above 0", .doc = "Measuring range of each accelerometer axis; larger values saturate. The default is 16 times the earth's gravity."},
    {.name = "gyro_range", .use = Use::kRead, .type = "number", .unit = "rad/s", .otherwise = "34.9066", .limits = "above 0", .doc = "Measuring range of each gyroscope axis; larger values saturate. The default is 2000 degrees per second."},
};

constexpr KindInterface kInterfacesOfImu[1] = {
    {"imu", 60, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfGps[6] = {
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "m", .otherwise = "[0 0]", .limits = "from 0 to 1000000", .doc = "Standard deviations of white noise, drawn anew for every fix: east and north, and up."},
    {.name = "drift", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "m", .otherwise = "[0 0]", .limits = "from 0 to 1000000", .doc = "Standard deviations of slowly varying errors, such as those of the atmosphere and of satellite clocks."},
    {.name = "drift_time", .use = Use::kRead, .type = "number", .unit = "s", .otherwise = "300", .limits = "above 0", .doc = "Time constant of the slowly varying errors: their autocorrelation falls to 1/e (Gauss-Markov process of first order)."},
    {.name = "velocity_noise", .use = Use::kRead, .type = "number", .unit = "m/s", .otherwise = "0", .limits = "not negative", .doc = "Standard deviation of its velocity: east and north."},
    {.name = "satellites", .use = Use::kRead, .type = "count", .otherwise = "8", .limits = "from 0 to 64", .doc = "Number of received satellites; with less than four there is no fix."},
    {.name = "dop", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .otherwise = "[1 1.5]", .limits = "from 0 to 100", .doc = "Dilutions of precision that it reports."},
};

constexpr KindInterface kInterfacesOfGps[1] = {
    {"gps", 13, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr std::string_view kOld_block_height_to[] = {"z.1"};
constexpr Meaning kOld_block_height{.how = Meaning::How::kWords, .to = kOld_block_height_to};
constexpr Word kWordsOfBlock[7] = {
    {.name = "points", .use = Use::kRead, .type = "integer", .doc = "Number of vertices of the outline, at least 2; two make a wall 0.01 m thick."},
    {.name = "point", .use = Use::kRead, .type = "tuple", .form = "[x y]", .unit = "m", .otherwise = "[0 0]", .doc = "A vertex, indexed from 0; in pixels if the model has a bitmap as well."},
    {.name = "z", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .told = "the model's full height", .doc = "Lower and upper end of the prism, above the floor."},
    {.name = "height", .use = Use::kOld, .instead = "write z [min max]", .meaning = &kOld_block_height},
    {.name = "fill", .use = Use::kOld},
    {.name = "filled", .use = Use::kOld},
    {.name = "color", .use = Use::kOld},
};

constexpr std::string_view kOld_sensor_range_max_to[] = {"range.1"};
constexpr Meaning kOld_sensor_range_max{.how = Meaning::How::kWords, .to = kOld_sensor_range_max_to};
constexpr std::string_view kOld_sensor_range_min_to[] = {"range.0"};
constexpr Meaning kOld_sensor_range_min{.how = Meaning::How::kWords, .to = kOld_sensor_range_min_to};
constexpr std::string_view kOld_sensor_view_to[] = {"range.0", "range.1", "fov"};
constexpr Meaning kOld_sensor_view{.how = Meaning::How::kWords, .to = kOld_sensor_view_to};
constexpr Word kWordsOfSensor[19] = {
    {.name = "pose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Pose in the ranger."},
    {.name = "size", .use = Use::kRead, .type = "size", .form = "[x y z]", .unit = "m", .otherwise = "[0.02 0.02 0.02]", .doc = "Size of the drawn transducer; beams start at half its height above the pose."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0 5]", .limits = "0 <= min <= max", .doc = "Minimum and maximum reported range."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "5.729577951308232", .limits = "from 0 to 36000", .doc = "Horizontal angle over which the beams are spread, symmetric about the axis, the first the rightmost; a single beam points ahead."},
    {.name = "samples", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 65536", .doc = "Number of beams."},
    {.name = "rings", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 256", .doc = "Number of rows of beams, one above the other, as in lidars with several lasers. `samples` is the number of beams per row."},
    {.name = "ring_fov", .use = Use::kRead, .type = "tuple", .form = "[lowest highest]", .unit = "deg", .otherwise = "[0 0]", .limits = "from -89 to 89", .doc = "Elevations of the lowest and the highest ring; the others are evenly spaced between them. The stage engine simulates them as horizontal."},
    {.name = "error", .use = Use::kRead, .type = "choice", .form = "\"none\" | \"lidar\"", .otherwise = "\"none\"", .doc = "Error model of its beams, in addition to noise, for distant, dark, oblique, specular or transparent surfaces. \"none\": no error model; \"lidar\": the power of returned light depends on color, material, incidence and distance, and weak echoes are not detected; with the arena engine (docs/arena.md)."},
    {.name = "range_dark", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "10", .limits = "above 0", .doc = "With error \"lidar\": maximum range at normal incidence of a surface that returns a tenth of the light."},
    {.name = "noise_weak", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "With error \"lidar\": standard deviation of ranges at the weakest detectable echo. It falls with the power of the echo."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[constant proportional angular]", .unit = "m, 1, deg", .otherwise = "[0 0 0]", .doc = "Range noise: a standard deviation, the largest uniform error as a fraction of the range, and the largest uniform error of a beam's direction."},
    {.name = "color", .use = Use::kRead, .type = "color", .told = "transparent blue", .doc = "Name of an X11 color, or random, which is the same in every run."},
    {.name = "color_rgba", .use = Use::kRead, .type = "rgba", .form = "[red green blue alpha]", .otherwise = "[0 0 1 0.15]", .doc = "Color components from 0 to 1; used if there is no color."},
    {.name = "range_max", .use = Use::kOld, .instead = "write range [min max]", .meaning = &kOld_sensor_range_max},
    {.name = "range_min", .use = Use::kOld, .instead = "write range [min max]", .meaning = &kOld_sensor_range_min},
    {.name = "view", .use = Use::kOld, .instead = "write range [min max] fov degrees", .meaning = &kOld_sensor_view},
    {.name = "ranger_return", .use = Use::kOld},
    {.name = "obstacle_return", .use = Use::kOld},
    {.name = "alwayson", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfPack[1] = {
    {"power", 2, Index::kRobot, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfWindow[51] = {
    {.name = "center", .use = Use::kRead, .type = "point", .form = "[x y]", .unit = "m", .otherwise = "[0 0]", .doc = "Position in the middle of the window, in metres, independent of the file's unit."},
    {.name = "scale", .use = Use::kRead, .type = "number", .unit = "px/m", .otherwise = "0", .limits = "not negative", .doc = "Pixels per metre; 0: the whole scene is shown."},
    {.name = "rotate", .use = Use::kRead, .type = "tuple", .form = "[pitch yaw]", .unit = "deg", .otherwise = "[0 0]", .doc = "Direction of view, in degrees, independent of the file's unit."},
    {.name = "show_data", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Sensor data are shown from the start."},
    {.name = "follow_model", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Name of the model that the view follows; none: a fixed view."},
    {.name = "size", .use = Use::kSilent},
    {.name = "pcam_loc", .use = Use::kSilent},
    {.name = "pcam_angle", .use = Use::kSilent},
    {.name = "pcam_on", .use = Use::kSilent},
    {.name = "interval", .use = Use::kSilent},
    {.name = "screenshots", .use = Use::kSilent},
    {.name = "screenshot_skip", .use = Use::kSilent},
    {.name = "show_blocks", .use = Use::kSilent},
    {.name = "show_flags", .use = Use::kSilent},
    {.name = "show_clock", .use = Use::kSilent},
    {.name = "show_follow", .use = Use::kSilent},
    {.name = "show_footprints", .use = Use::kSilent},
    {.name = "show_grid", .use = Use::kSilent},
    {.name = "show_status", .use = Use::kSilent},
    {.name = "show_trailarrows", .use = Use::kSilent},
    {.name = "show_trailrise", .use = Use::kSilent},
    {.name = "show_trailfast", .use = Use::kSilent},
    {.name = "show_trailblur", .use = Use::kSilent},
    {.name = "show_occupancy", .use = Use::kSilent},
    {.name = "show_voxels", .use = Use::kSilent},
    {.name = "show_boundingboxes", .use = Use::kSilent},
    {.name = "show_ranger_transducers", .use = Use::kSilent},
    {.name = "show_ranger_ranges", .use = Use::kSilent},
    {.name = "show_ranger_strikes", .use = Use::kSilent},
    {.name = "show_ranger_fov", .use = Use::kSilent},
    {.name = "show_fiducial", .use = Use::kSilent},
    {.name = "show_fiducial_fov", .use = Use::kSilent},
    {.name = "show_gripper_data", .use = Use::kSilent},
    {.name = "show_blinken", .use = Use::kSilent},
    {.name = "show_camera", .use = Use::kSilent},
    {.name = "show_bumper_hits", .use = Use::kSilent},
    {.name = "show_position_coords", .use = Use::kSilent},
    {.name = "show_position_waypoints", .use = Use::kSilent},
    {.name = "ranger_vis", .use = Use::kSilent},
    {.name = "blobfinder_vis", .use = Use::kSilent},
    {.name = "raster_vis", .use = Use::kSilent},
    {.name = "custom_vis", .use = Use::kSilent},
    {.name = "energy_dissipation", .use = Use::kSilent},
    {.name = "energy_input", .use = Use::kSilent},
    {.name = "energy_stored", .use = Use::kSilent},
    {.name = "fill_polygons", .use = Use::kOld},
    {.name = "polygons", .use = Use::kOld},
    {.name = "grid", .use = Use::kOld},
    {.name = "rangerdata", .use = Use::kOld},
    {.name = "laserdata", .use = Use::kOld},
    {.name = "show_tree", .use = Use::kOld},
};

constexpr std::string_view kOld_world_threadpool_to[] = {"threads"};
constexpr Meaning kOld_world_threadpool{.how = Meaning::How::kWords, .to = kOld_world_threadpool_to};
constexpr Word kWordsOfWorld[31] = {
    {.name = "name", .use = Use::kRead, .type = "text", .told = "the file's path", .doc = "The name of the world."},
    {.name = "interval_sim", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "100", .limits = "above 0", .doc = "Simulated time per tick, in whole microseconds."},
    {.name = "resolution", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "0.02", .limits = "above 0", .doc = "Resolution of ranges that is reported to clients; geometry here is exact."},
    {.name = "gravity", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "9.81", .limits = "not negative", .doc = "Acceleration of free fall in the arena, and specific force measured by an imu at rest; 1.62 is the moon's."},
    {.name = "ground", .use = Use::kRead, .type = "text", .otherwise = "\"concrete\"", .doc = "Material of the ground in the arena, one of those of models (docs/arena.md)."},
    {.name = "quit_time", .use = Use::kRead, .type = "number", .unit = "s", .otherwise = "0", .limits = "not negative", .doc = "Simulated time at which the run ends; 0: never."},
    {.name = "robot_types", .use = Use::kRead, .type = "texts", .doc = "Names of defines: of robots, and of sensors that they may carry. `playhouse robot` spawns robots of these types during the run (docs/robot-client.md). None of them is in the world at the start."},
    {.name = "unit_length", .use = Use::kRead, .type = "choice", .form = "\"m\" | \"cm\" | \"mm\"", .otherwise = "\"m\"", .doc = "Unit of all lengths in the file."},
    {.name = "unit_angle", .use = Use::kRead, .type = "choice", .form = "\"degrees\" | \"radians\"", .otherwise = "\"degrees\"", .doc = "Unit of all angles in the file."},
    {.name = "speedup", .use = Use::kRead, .type = "number", .otherwise = "1", .doc = "Speed relative to real time; 0 or less: as fast as possible."},
    {.name = "paused", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The run starts paused."},
    {.name = "sky", .use = Use::kRead, .type = "tuple", .form = "[red green blue]", .otherwise = "[0.6235 0.7686 0.9098]", .limits = "from 0 to 1", .doc = "Color of the sky in camera images, as components from 0 to 1."},
    {.name = "sun", .use = Use::kRead, .type = "tuple", .form = "[heading elevation brightness]", .unit = "deg, deg, 1", .otherwise = "[-125 50 1]", .doc = "Direction of the sun in the world frame, and its brightness; at an elevation of 0 or less it has set. For cameras of the arena engine."},
    {.name = "fog", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Visibility: at this distance fog reduces contrast to 5 %; 0: no fog. For cameras of the arena engine."},
    {.name = "fog_color", .use = Use::kRead, .type = "tuple", .form = "[red green blue]", .otherwise = "[0.8 0.82 0.84]", .limits = "from 0 to 1", .doc = "Color of the fog, as components from 0 to 1. For cameras of the arena engine."},
    {.name = "latitude", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "Latitude of the point 0 0 0, positive to the north (WGS84), for gps receivers. x is east there, y north."},
    {.name = "longitude", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "Longitude of the point 0 0 0, positive to the east."},
    {.name = "altitude", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "0", .doc = "Altitude of the point 0 0 0 above the ellipsoid."},
    {.name = "show_clock", .use = Use::kSilent},
    {.name = "show_clock_interval", .use = Use::kSilent},
    {.name = "threads", .use = Use::kSilent},
    {.name = "confirm_on_quit", .use = Use::kSilent},
    {.name = "test", .use = Use::kSilent},
    {.name = "size", .use = Use::kOld, .instead = "there is no edge, the floor goes on"},
    {.name = "interval_real", .use = Use::kOld, .instead = "write speedup, interval_sim / interval_real"},
    {.name = "gui_interval", .use = Use::kOld},
    {.name = "gui_menu_interval", .use = Use::kOld},
    {.name = "gui_disable", .use = Use::kOld},
    {.name = "threadpool", .use = Use::kOld, .instead = "write threads", .meaning = &kOld_world_threadpool},
    {.name = "truth_server", .use = Use::kOld},
    {.name = "map_resolution", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfWorld[1] = {
    {"simulation", 31, Index::kOne, Need::kNothing, Need::kNothing, false},
};

constexpr Kind kKinds[21] = {
    {.name = "model", .doc = "A plain body. Models of every kind have its words.", .entity = EntityForm::kModel, .table = "models", .kind = ModelKind::kPlain, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfModel, .interfaces = kInterfacesOfModel},
    {.name = "position", .doc = "A mobile base: a robot that drives in the plane.", .entity = EntityForm::kModel, .table = "positions", .kind = ModelKind::kPosition, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfPosition, .interfaces = kInterfacesOfPosition},
    {.name = "ranger", .doc = "Range finders of any type: a laser has one sensor with many samples, a sonar ring many sensors with one.", .entity = EntityForm::kModel, .table = "rangers", .kind = ModelKind::kRanger, .simulated = true, .solid = false, .size = {0.15, 0.15, 0.2}, .color = {0, 0, 0.5f, 1}, .words = kWordsOfRanger, .interfaces = kInterfacesOfRanger},
    {.name = "fiducial", .doc = "A fiducial finder: detects markers (models with a fiducial_return) and reports their ids and poses.", .entity = EntityForm::kModel, .table = "fiducials", .kind = ModelKind::kFiducial, .simulated = true, .solid = false, .size = {0, 0, 0}, .color = {1, 0, 0, 1}, .words = kWordsOfFiducial, .interfaces = kInterfacesOfFiducial},
    {.name = "blobfinder", .doc = "A camera that reports regions of one color (blobs).", .entity = EntityForm::kModel, .table = "blobfinders", .kind = ModelKind::kBlobfinder, .simulated = true, .solid = false, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfBlobfinder, .interfaces = kInterfacesOfBlobfinder},
    {.name = "bumper", .doc = "Contact switches.", .entity = EntityForm::kModel, .table = "bumpers", .kind = ModelKind::kBumper, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfBumper, .interfaces = kInterfacesOfBumper},
    {.name = "blinkenlight", .doc = "A flashing lamp.", .entity = EntityForm::kModel, .table = "blinkenlights", .kind = ModelKind::kBlinkenlight, .simulated = true, .solid = true, .size = {0.02, 0.02, 0.02}, .color = {0, 1, 0, 1}, .words = kWordsOfBlinkenlight, .interfaces = kInterfacesOfBlinkenlight},
    {.name = "lightindicator", .doc = "A body that indicates an on/off state; it is darker while off, its initial state.", .entity = EntityForm::kModel, .table = "lightindicators", .kind = ModelKind::kLightindicator, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .interfaces = kInterfacesOfLightindicator},
    {.name = "gripper", .doc = "A gripper: two paddles that close around an object and carry it.", .entity = EntityForm::kModel, .table = "grippers", .kind = ModelKind::kGripper, .simulated = true, .solid = true, .size = {0.2, 0.3, 0.2}, .color = {0.3f, 0.3f, 0.3f, 1}, .words = kWordsOfGripper, .interfaces = kInterfacesOfGripper},
    {.name = "actuator", .doc = "A prismatic or revolute joint that moves the models on it.", .entity = EntityForm::kModel, .table = "actuators", .kind = ModelKind::kActuator, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfActuator, .interfaces = kInterfacesOfActuator},
    {.name = "wifi", .doc = "A radio: reports the received radios of its network with their signal levels, and carries messages between them.", .entity = EntityForm::kModel, .table = "wifis", .kind = ModelKind::kWifi, .simulated = true, .solid = false, .size = {0, 0, 0}, .color = {0.2f, 0.6f, 0.9f, 1}, .words = kWordsOfWifi, .interfaces = kInterfacesOfWifi},
    {.name = "camera", .doc = "A camera with pan, tilt and zoom. It renders color, gray, depth or segmentation images of bodies, floor and sky.", .entity = EntityForm::kModel, .table = "cameras", .kind = ModelKind::kCamera, .simulated = true, .solid = true, .size = {0.1, 0.07, 0.05}, .color = {0, 0, 0, 1}, .words = kWordsOfCamera, .interfaces = kInterfacesOfCamera},
    {.name = "detector", .doc = "A sensor specified in the world file: what it detects and penetrates, its range, resolution and noise (docs/detectors.md).", .entity = EntityForm::kModel, .table = "detectors", .kind = ModelKind::kDetector, .simulated = true, .solid = false, .size = {0.1, 0.1, 0.1}, .color = {0.4f, 0.1f, 0.6f, 1}, .words = kWordsOfDetector, .interfaces = kInterfacesOfDetector},
    {.name = "custom", .doc = "A model or sensor implemented in a shared library.", .entity = EntityForm::kModel, .table = "customs", .kind = ModelKind::kCustom, .simulated = true, .solid = true, .size = {0.1, 0.1, 0.1}, .color = {1, 0.5f, 0, 1}, .words = kWordsOfCustom, .interfaces = kInterfacesOfCustom},
    {.name = "imu", .doc = "An inertial measurement unit: measures specific force and turn rate, and estimates its orientation.", .entity = EntityForm::kModel, .table = "imus", .kind = ModelKind::kImu, .simulated = true, .solid = false, .size = {0.03, 0.03, 0.01}, .color = {0.1f, 0.4f, 0.2f, 1}, .words = kWordsOfImu, .interfaces = kInterfacesOfImu},
    {.name = "gps", .doc = "A satellite receiver: reports its position on the earth, derived from the world's latitude, longitude and altitude.", .entity = EntityForm::kModel, .table = "receivers", .kind = ModelKind::kGps, .simulated = true, .solid = false, .size = {0.06, 0.06, 0.02}, .color = {0.9f, 0.9f, 0.9f, 1}, .words = kWordsOfGps, .interfaces = kInterfacesOfGps},
    {.name = "block", .doc = "A prism, part of a model's body. All blocks together are scaled to the model's size.", .entity = EntityForm::kPart, .inside = "model", .simulated = true, .words = kWordsOfBlock},
    {.name = "sensor", .doc = "One transducer or scanner of a ranger.", .entity = EntityForm::kPart, .inside = "ranger", .table = "sensors", .simulated = true, .words = kWordsOfSensor},
    {.name = "pack", .doc = "A battery that supplies a model and its descendants without one of their own.", .entity = EntityForm::kTrait, .table = "packs", .simulated = true, .interfaces = kInterfacesOfPack, .has = has_pack},
    {.name = "window", .doc = "The view of the scene; the first window of a file is used.", .entity = EntityForm::kWindow, .simulated = true, .words = kWordsOfWindow},
    {.name = "world", .doc = "The world file itself: words outside all entities, anywhere in the file.", .entity = EntityForm::kWorld, .simulated = true, .words = kWordsOfWorld, .interfaces = kInterfacesOfWorld},
};

constexpr SaidWord kOldType_map_words[] = {{"boundary", "1"}, {"color", "gray30"}, {"gui_move", "0"}};
constexpr SaidWord kOldType_puck_words[] = {{"size", "0.08 0.08 0.1"}, {"gripper_return", "1"}};
constexpr SaidWord kOldType_charger_words[] = {{"joules", "-1"}, {"give_watts", "1000"}};
constexpr SaidWord kOldType_laser_part_words[] = {{"range", "0 8"}, {"fov", "180"}, {"samples", "180"}};
constexpr SaidWord kOldType_sonar_part_words[] = {{"range", "0 5"}, {"fov", "15"}};
constexpr OldType kOldTypes[19] = {
    {.name = "map", .instead = "write model( bitmap \"file.png\" size [x y z] boundary 1 ), or the floorplan macro of map.inc", .is_read = true, .type = "model", .words = kOldType_map_words},
    {.name = "environment", .instead = "write model( bitmap \"file.png\" size [x y z] boundary 1 )"},
    {.name = "box", .instead = "write model( size [x y z] )", .is_read = true, .type = "model"},
    {.name = "puck", .instead = "write: define puck model( size [0.08 0.08 0.1] gripper_return 1 )", .is_read = true, .type = "model", .words = kOldType_puck_words},
    {.name = "charger", .instead = "write model( joules -1 give_watts 1000 )", .is_read = true, .type = "model", .words = kOldType_charger_words},
    {.name = "power", .instead = "leave it out; joules and watts are words of any model", .is_read = true},
    {.name = "powerpack", .instead = "leave it out; joules and watts are words of any model", .is_read = true},
    {.name = "audio", .instead = "leave it out; any model has say \"text\"", .is_read = true},
    {.name = "speech", .instead = "leave it out; any model has say \"text\"", .is_read = true},
    {.name = "truth", .instead = "leave it out; every model's pose is known by its name", .is_read = true},
    {.name = "laser", .instead = "write ranger( sensor( range [0 8] fov 180 samples 180 ) )", .is_read = true, .type = "ranger", .part = "sensor", .part_words = kOldType_laser_part_words},
    {.name = "sonar", .instead = "write ranger( sensor( pose [x y z heading] range [0 5] fov 15 ) ... )", .is_read = true, .type = "ranger", .part = "sensor", .part_words = kOldType_sonar_part_words},
    {.name = "fiducialfinder", .instead = "write fiducial", .is_read = true, .type = "fiducial"},
    {.name = "lbd", .instead = "write fiducial", .is_read = true, .type = "fiducial"},
    {.name = "vision", .instead = "write blobfinder", .is_read = true, .type = "blobfinder"},
    {.name = "visionfinder", .instead = "write blobfinder", .is_read = true, .type = "blobfinder"},
    {.name = "ptz", .instead = "write camera( pantilt [pan tilt] fov [horizontal vertical] )", .is_read = true, .type = "camera"},
    {.name = "player", .instead = "leave it out; devices are named in the configuration file", .is_read = true},
    {.name = "driver", .instead = "this is a configuration file, for playhouse serve"},
};

}  // namespace

std::span<const Kind> kinds() { return kKinds; }

std::span<const OldType> old_types() { return kOldTypes; }

}  // namespace playhouse::scene
