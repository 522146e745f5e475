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
constexpr Word kWordsOfModel[62] = {
    {.name = "name", .use = Use::kRead, .type = "text", .told = "the type and its number, as position:0", .doc = "What the model is called; inside a parent it is parent.name, with a leading / it stands as it is."},
    {.name = "pose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Where the model is in its parent."},
    {.name = "origin", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Where body and sensors are, from the pose."},
    {.name = "size", .use = Use::kRead, .type = "size", .form = "[x y z]", .unit = "m", .told = "the kind's own", .doc = "The box that the body fills; 0 in x or y is a wall 0.01 m thick."},
    {.name = "color", .use = Use::kRead, .type = "color", .told = "the kind's own", .doc = "The name of an X11 color, or random, which is the same in each run."},
    {.name = "color_rgba", .use = Use::kRead, .type = "rgba", .form = "[red green blue alpha]", .told = "the kind's own", .doc = "The color as shares from 0 to 1; counts where there is no color."},
    {.name = "bitmap", .use = Use::kRead, .type = "text", .doc = "An image, PNG, PGM, PPM, PBM or BMP, whose dark pixels (first channel up to 127) are solid and fill the size."},
    {.name = "mesh", .use = Use::kRead, .type = "text", .doc = "A file of a modelling program, COLLADA, glTF or OBJ: how the model looks, and its body. It fills the size where that is said, else it has its own. See docs/meshes.md."},
    {.name = "noblocks", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "There is no box where there are neither blocks nor a bitmap nor a mesh."},
    {.name = "boundary", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Four walls stand inside the edges of the size, beside a bitmap or blocks."},
    {.name = "stack_children", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "Models inside this one stand on top of it."},
    {.name = "obstacle_return", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "It collides."},
    {.name = "ranger_return", .use = Use::kRead, .type = "number", .otherwise = "1", .doc = "The intensity that rangers report; below 0 they do not see it."},
    {.name = "fiducial_return", .use = Use::kRead, .type = "integer", .otherwise = "0", .doc = "The number that fiducial finders see; 0: none sees it."},
    {.name = "fiducial_key", .use = Use::kRead, .type = "integer", .otherwise = "0", .doc = "Finders see marks of their own key only."},
    {.name = "gripper_return", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Grippers see it, and take it up with all its parts: it has to be at the top level, and holds nothing that drives."},
    {.name = "mass", .use = Use::kRead, .type = "number", .unit = "kg", .otherwise = "0", .limits = "not negative", .doc = "Driving it takes 10 W for each kg and m/s, and for each rad/s. In the plane nothing is pushed, so that it means nothing else; it is kept for engines with forces."},
    {.name = "friction", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "not negative", .doc = "How much its faces rub. In the plane nothing slides, so that it means nothing there, as in Stage; the arena multiplies it with that of what it touches."},
    {.name = "friction_axes", .use = Use::kRead, .type = "tuple", .form = "[x y]", .otherwise = "[1 1]", .limits = "from 0 to 1", .doc = "Shares of its friction along its x and y, in the arena: with [0.1 1] it slides along its x, as a sledge."},
    {.name = "material", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "What it is made of, as \"glass\": a name that detectors may look for, or through."},
    {.name = "lamp", .use = Use::kRead, .type = "number", .unit = "cd", .otherwise = "0", .limits = "not negative", .doc = "How bright it shines, every way alike, in its color; a bulb of 60 W has 65. A lamp that can be switched off shines while it is lit. For cameras of the arena engine, and a light for detectors."},
    {.name = "update_interval", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "100", .limits = "not negative", .doc = "Time between two measurements of a sensor, at least a tick."},
    {.name = "alwayson", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "It moves or measures although nobody has opened it."},
    {.name = "gui_move", .use = Use::kRead, .type = "flag", .told = "1, inside another model 0", .doc = "A person may drag it in the page."},
    {.name = "gui_nose", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws a point ahead of its body, as it does of everything that drives."},
    {.name = "gui_outline", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws the edges of its box on the floor."},
    {.name = "gui_grid", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The page draws a line per metre of its box."},
    {.name = "say", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "What it says at the start, in a bubble of the page: one line, of which 1024 bytes count. Controllers and clients have it say something else."},
    {.name = "trail_length", .use = Use::kRead, .type = "integer", .otherwise = "20", .limits = "not negative", .doc = "How many places of the past the page draws."},
    {.name = "ctrl", .use = Use::kRead, .type = "texts", .doc = "The controllers that drive it, each a name and its arguments."},
    {.name = "watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power that it draws from its battery, or its parent's; kinds that say what they draw have that instead."},
    {.name = "joules", .use = Use::kRead, .type = "number", .unit = "J", .told = "no battery", .doc = "Energy in its battery, which is full of it; below 0 without end."},
    {.name = "joules_capacity", .use = Use::kRead, .type = "number", .unit = "J", .told = "what is in it", .limits = "not negative", .doc = "Energy that its battery can hold; what does not fit is not in it."},
    {.name = "kjoules", .use = Use::kRead, .type = "number", .unit = "kJ", .told = "no battery", .doc = "As joules, in thousands; counts after both words in joules."},
    {.name = "kjoules_capacity", .use = Use::kRead, .type = "number", .unit = "kJ", .told = "what is in it", .limits = "not negative", .doc = "As joules_capacity, in thousands; counts last."},
    {.name = "give_watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power with which it charges others that touch it."},
    {.name = "take_watts", .use = Use::kRead, .type = "number", .unit = "W", .otherwise = "0", .limits = "not negative", .doc = "Power with which others may charge it."},
    {.name = "blob_return", .use = Use::kSilent},
    {.name = "map_resolution", .use = Use::kSilent},
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

constexpr KindInterface kInterfacesOfModel[2] = {
    {"speech", 12, Index::kRobot, Need::kNothing, Need::kRobot, true},
    {"speech_recognition", 50, Index::kRobot, Need::kNothing, Need::kRobot, false},
};

constexpr Word kWordsOfPosition[12] = {
    {.name = "drive", .use = Use::kRead, .type = "choice", .form = "\"diff\" | \"omni\" | \"walk\" | \"car\"", .otherwise = "\"diff\"", .doc = "How it can move. \"diff\": ahead and turning, as two wheels do; \"omni\": in any direction and turning; \"walk\": on legs: in any direction and turning; with the arena engine it climbs steps of up to 0.3 m; \"car\": ahead, and turning by the angle of a steered axle."},
    {.name = "localization", .use = Use::kRead, .type = "choice", .form = "\"gps\" | \"odom\"", .otherwise = "\"gps\"", .doc = "What it believes about its pose. \"gps\": the truth; \"odom\": what its wheels counted, with an error."},
    {.name = "localization_origin", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .told = "odom: the start pose, gps: 0 0 0 0", .doc = "Where in the world its coordinates begin."},
    {.name = "velocity", .use = Use::kRead, .type = "twist", .form = "[x y z heading]", .unit = "m/s, m/s, m/s, deg/s", .otherwise = "[0 0 0 0]", .doc = "Its first command."},
    {.name = "velocity_bounds", .use = Use::kRead, .type = "bounds", .form = "[xmin xmax ymin ymax zmin zmax amin amax]", .unit = "m/s, m/s, m/s, deg/s", .otherwise = "[-1 1 -1 1 -1 1 -90 90]", .doc = "The least and the largest velocity along each axis."},
    {.name = "acceleration_bounds", .use = Use::kRead, .type = "bounds", .form = "[xmin xmax ymin ymax zmin zmax amin amax]", .unit = "m/s^2, m/s^2, m/s^2, deg/s^2", .otherwise = "[-1 1 -1 1 -1 1 -90 90]", .doc = "The same of accelerations, which count when a controller commands them."},
    {.name = "wheelbase", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "1", .limits = "above 0", .doc = "Of a car, from the front axle to the rear one."},
    {.name = "odom_error", .use = Use::kRead, .type = "twist", .form = "[x y z heading]", .told = "drawn per robot: up to 0.015 in x and y, 0.025 in heading", .doc = "Errors of odometry along each axis, as fractions of the motion."},
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
    {.name = "range_min", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Nearer marks are not seen."},
    {.name = "range_max", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "8", .limits = "not negative", .doc = "Farther marks are not seen."},
    {.name = "range_max_id", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "5", .limits = "not negative", .doc = "Of farther marks the number cannot be told, and is 0."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "180", .limits = "not negative", .doc = "The field of view, half to each side."},
    {.name = "ignore_zloc", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Marks are seen at any height."},
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
    {.name = "colors_count", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 256", .doc = "How many of the colors it looks for; 0: all that it names, and any color if it names none."},
    {.name = "colors", .use = Use::kRead, .type = "colors", .doc = "The names of the colors that it looks for."},
    {.name = "image", .use = Use::kRead, .type = "tuple", .form = "[width height]", .unit = "px", .otherwise = "[80 60]", .limits = "from 1 to 4096", .doc = "The size of the image."},
    {.name = "range", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "12", .limits = "not negative", .doc = "How far it sees."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "60", .limits = "not negative", .doc = "The field of view, half to each side."},
    {.name = "pan", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "How far it is turned to the left."},
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
    {.name = "bcount", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 256", .doc = "How many switches it has."},
    {.name = "bpose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .counted_by = "bcount", .doc = "The middle of the face of a switch, counted from 0, and where the face looks; without a number that of all others."},
    {.name = "blength", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .counted_by = "bcount", .doc = "The length of the face of a switch, counted from 0; without a number that of all others."},
};

constexpr KindInterface kInterfacesOfBumper[1] = {
    {"bumper", 14, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfBlinkenlight[3] = {
    {.name = "period", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "1000", .limits = "not negative", .doc = "Time from one flash to the next; 0: it burns steadily."},
    {.name = "dutycycle", .use = Use::kRead, .type = "number", .otherwise = "1", .limits = "not negative", .doc = "The share of the period in which it is lit, from its begin on; 1 or more: it burns steadily."},
    {.name = "enabled", .use = Use::kRead, .type = "flag", .otherwise = "1", .doc = "It is on at the start."},
};

constexpr KindInterface kInterfacesOfBlinkenlight[1] = {
    {"blinkenlight", 33, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr KindInterface kInterfacesOfLightindicator[1] = {
    {"blinkenlight", 33, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfGripper[3] = {
    {.name = "paddle_size", .use = Use::kRead, .type = "tuple", .form = "[x y z]", .otherwise = "[0.66 0.1 0.4]", .limits = "from 0 to 1", .doc = "How large a paddle is, as fractions of the model's size."},
    {.name = "paddle_state", .use = Use::kRead, .type = "choices", .form = "[(\"open\" | \"closed\") (\"down\" | \"up\")]", .otherwise = "[\"open\" \"down\"]", .doc = "How the paddles are at the start."},
    {.name = "autosnatch", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "It closes by itself when something is between the paddles, and opens when nothing is."},
};

constexpr KindInterface kInterfacesOfGripper[1] = {
    {"gripper", 3, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfActuator[6] = {
    {.name = "type", .use = Use::kRead, .type = "choice", .form = "\"linear\" | \"rotational\"", .otherwise = "\"linear\"", .doc = "How it moves. \"linear\": it slides; \"rotational\": it turns."},
    {.name = "axis", .use = Use::kRead, .type = "tuple", .form = "[x y z]", .otherwise = "[0 0 0]", .doc = "The direction in which it slides, of any length, in its own frame; [0 0 0] is ahead. It turns about z alone, to the right if z is negative."},
    {.name = "min_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "0", .doc = "Where it stops at the lower end, counted from its pose."},
    {.name = "max_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "1", .doc = "Where it stops at the upper end; where that is below the lower one, it does not move."},
    {.name = "max_speed", .use = Use::kRead, .type = "number", .unit = "m/s or rad/s", .otherwise = "1", .limits = "not negative", .doc = "How fast it can move."},
    {.name = "start_position", .use = Use::kRead, .type = "number", .unit = "m or rad", .otherwise = "0", .doc = "Where it is at the start, counted from its pose."},
};

constexpr KindInterface kInterfacesOfActuator[1] = {
    {"actarray", 53, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfWifi[16] = {
    {.name = "ip", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Its network address; without one 10.x.y.z by its number."},
    {.name = "mac", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "Its hardware address; without one 02:00:00:xx:yy:zz by its number."},
    {.name = "essid", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "The name of its network: radios of other networks are not heard."},
    {.name = "freq", .use = Use::kRead, .type = "number", .unit = "MHz", .otherwise = "2450", .limits = "not negative", .doc = "Where it sends."},
    {.name = "bitrate", .use = Use::kRead, .type = "number", .unit = "bit/s", .otherwise = "1.1e+07", .limits = "not negative", .doc = "What it is set to."},
    {.name = "power", .use = Use::kRead, .type = "number", .unit = "dBm", .otherwise = "15", .doc = "How strongly it sends."},
    {.name = "sensitivity", .use = Use::kRead, .type = "number", .unit = "dBm", .otherwise = "-70", .doc = "What arrives weaker is not heard."},
    {.name = "model", .use = Use::kRead, .type = "choice", .form = "\"friis\" | \"simple\" | \"ITU indoor\" | \"log distance\" | \"raytrace\"", .otherwise = "\"friis\"", .doc = "How what it hears has become weaker on its way. \"friis\": as in free space; \"simple\": as in free space, and not heard beyond range; \"ITU indoor\": as in a building, by plc (ITU-R P.1238); \"log distance\": as in free space for the first metre, then by ple; \"raytrace\": as in free space, and by wall_factor for each wall."},
    {.name = "range", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "30", .limits = "not negative", .doc = "How far it hears, with model \"simple\"."},
    {.name = "plc", .use = Use::kRead, .type = "number", .otherwise = "30", .limits = "not negative", .doc = "Loss for ten times the distance in dB, with model \"ITU indoor\"."},
    {.name = "ple", .use = Use::kRead, .type = "number", .otherwise = "3", .limits = "not negative", .doc = "The power of the distance by which it gets weaker, with model \"log distance\": 2 in free space, 3 to 5 in buildings."},
    {.name = "wall_factor", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "5", .limits = "not negative", .doc = "Loss for each wall on the straight line, with model \"raytrace\"."},
    {.name = "fading", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "0", .limits = "not negative", .doc = "Standard deviation of what else makes a link stronger or weaker, drawn anew each time it is measured."},
    {.name = "loss", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 100", .doc = "Of the messages of radios that it hears, how many are lost, in percent; drawn for each message."},
    {.name = "range_db", .use = Use::kOld, .instead = "write sensitivity"},
    {.name = "random_seed", .use = Use::kOld},
};

constexpr KindInterface kInterfacesOfWifi[2] = {
    {"wifi", 23, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"opaque", 51, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfCamera[12] = {
    {.name = "resolution", .use = Use::kRead, .type = "tuple", .form = "[width height]", .unit = "px", .otherwise = "[32 32]", .limits = "from 1 to 2048", .doc = "The size of the image."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0.2 8]", .limits = "0 <= min <= max", .doc = "The nearest and the farthest thing that it shows, along the way it looks."},
    {.name = "fov", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "deg", .otherwise = "[70 40]", .limits = "from 1 to 170", .doc = "The field of view at the start."},
    {.name = "pantilt", .use = Use::kRead, .type = "tuple", .form = "[pan tilt]", .unit = "deg", .otherwise = "[0 0]", .doc = "Where it looks at the start: to the left, and up."},
    {.name = "pan_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[-100 100]", .doc = "How far clients may turn it to the right and to the left."},
    {.name = "tilt_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[-25 25]", .doc = "How far clients may turn it down and up."},
    {.name = "zoom_limits", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "deg", .otherwise = "[5 70]", .limits = "from 1 to 170", .doc = "The smallest and the largest horizontal field of view that clients may ask for."},
    {.name = "pantilt_speed", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "90", .limits = "not negative", .doc = "How fast it turns at most, and changes its field of view, in a second."},
    {.name = "image", .use = Use::kRead, .type = "choice", .form = "\"color\" | \"gray\" | \"depth\" | \"segmentation\"", .otherwise = "\"color\"", .doc = "What a pixel says. \"color\": red, green and blue; \"gray\": how bright it is; \"depth\": how far it is along the way that the camera looks, in mm; 0 where nothing is in range; \"segmentation\": which model it is: its id plus 1, in 24 bits; 0 where there is none in range."},
    {.name = "compression", .use = Use::kRead, .type = "choice", .form = "\"raw\" | \"jpeg\"", .otherwise = "\"raw\"", .doc = "How images are sent; those of distances and of models always raw. \"raw\": as rows of pixels; \"jpeg\": as a JPEG file."},
    {.name = "quality", .use = Use::kRead, .type = "count", .otherwise = "85", .limits = "from 1 to 100", .doc = "That of JPEG files, in percent."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[value depth]", .otherwise = "[0 0]", .limits = "from 0 to 1", .doc = "Errors of a pixel: the standard deviation of red, green and blue each, as a share of the brightest, and that of distances, as a share of them."},
};

constexpr KindInterface kInterfacesOfCamera[2] = {
    {"camera", 40, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"ptz", 8, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfDetector[15] = {
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "60", .limits = "from 0 to 360", .doc = "The field of view, half to each side. Its beams have equal shares of it, the first the rightmost."},
    {.name = "fov_vertical", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .limits = "from 0 to 170", .doc = "The field of view upwards and downwards, half to each; with 0 it sees what is at half its own height."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0 8]", .limits = "0 <= min <= max", .doc = "The nearest and the farthest thing that it tells of, along the line to it."},
    {.name = "samples", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 65536", .doc = "How many beams it has. A beam tells the range of the nearest thing in its share of the field of view."},
    {.name = "rays", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 1024", .doc = "The lines along which each beam looks, evenly spread over its share: 1 is as thin as a laser, many are as wide as a sonar."},
    {.name = "layers", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 256", .doc = "How often each of them looks, evenly spread from below upwards."},
    {.name = "sees", .use = Use::kRead, .type = "texts", .doc = "What it tells of: conditions of which one holds, as \"kind=position color=red\" (docs/detectors.md); without any, everything."},
    {.name = "through", .use = Use::kRead, .type = "texts", .doc = "What is no hindrance: conditions as of sees, as \"material=glass\"."},
    {.name = "walls", .use = Use::kRead, .type = "count", .otherwise = "0", .limits = "from 0 to 1000", .doc = "How many bodies it sees through on a line, beside those of through."},
    {.name = "attenuation", .use = Use::kRead, .type = "tuple", .form = "[body metre]", .unit = "dB", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "What is lost in each body that it sees through, and for each metre of the way in it."},
    {.name = "spread", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "not negative", .doc = "The power of the distance by which what comes back gets weaker, from 1 m on: 2 for a lamp, 4 for a radar's echo."},
    {.name = "budget", .use = Use::kRead, .type = "number", .unit = "dB", .otherwise = "100", .limits = "not negative", .doc = "How much may be lost on the way to what it still tells of. What is left of that is told as the level."},
    {.name = "resolution", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Ranges are told in steps of this; 0: as they are."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[constant proportional angular]", .unit = "m, 1, deg", .otherwise = "[0 0 0]", .limits = "from 0 to 360", .doc = "Standard deviations of errors: of a range, as a length and as a share of it, and of the bearing of what is found."},
    {.name = "miss", .use = Use::kRead, .type = "number", .otherwise = "0", .limits = "from 0 to 1", .doc = "The probability that something in view is not noticed, for each thing in each measurement."},
};

constexpr KindInterface kInterfacesOfDetector[2] = {
    {"ranger", 62, Index::kCount, Need::kNothing, Need::kNothing, false},
    {"fiducial", 10, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfCustom[1] = {
    {.name = "library", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "The library's name, and arguments behind it."},
};

constexpr KindInterface kInterfacesOfCustom[1] = {
    {"aio", 21, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfImu[6] = {
    {.name = "acceleration_noise", .use = Use::kRead, .type = "tuple", .form = "[white walk]", .unit = "m/s^2/sqrt(Hz), m/s^3/sqrt(Hz)", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "Errors along each axis: the density of white noise, and that of the noise by which the bias wanders."},
    {.name = "gyro_noise", .use = Use::kRead, .type = "tuple", .form = "[white walk]", .unit = "rad/s/sqrt(Hz), rad/s^2/sqrt(Hz)", .otherwise = "[0 0]", .limits = "from 0 to 1000", .doc = "The same of the turn rate about each axis."},
    {.name = "acceleration_bias", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "0", .limits = "not negative", .doc = "The standard deviation of the bias of each axis with which it begins."},
    {.name = "gyro_bias", .use = Use::kRead, .type = "number", .unit = "rad/s", .otherwise = "0", .limits = "not negative", .doc = "The same of the turn rate about each axis."},
    {.name = "acceleration_range", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "156.906", .limits = "above 0", .doc = "More than this along an axis reads as this, here 16 times the gravity of the earth."},
    {.name = "gyro_range", .use = Use::kRead, .type = "number", .unit = "rad/s", .otherwise = "34.9066", .limits = "above 0", .doc = "More than this about an axis reads as this, here 2000 degrees per second."},
};

constexpr KindInterface kInterfacesOfImu[1] = {
    {"imu", 60, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr Word kWordsOfGps[6] = {
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "m", .otherwise = "[0 0]", .limits = "from 0 to 1000000", .doc = "Standard deviations of the errors that every fix has anew, to the east and to the north, and upwards."},
    {.name = "drift", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .unit = "m", .otherwise = "[0 0]", .limits = "from 0 to 1000000", .doc = "Standard deviations of the errors that vary slowly, as what the air and the satellites' clocks add."},
    {.name = "drift_time", .use = Use::kRead, .type = "number", .unit = "s", .otherwise = "300", .limits = "above 0", .doc = "After this time the errors that vary slowly have lost all but a share of 1/e of what they were (Gauss-Markov process of first order)."},
    {.name = "velocity_noise", .use = Use::kRead, .type = "number", .unit = "m/s", .otherwise = "0", .limits = "not negative", .doc = "The standard deviation of its velocity, to the east and to the north."},
    {.name = "satellites", .use = Use::kRead, .type = "count", .otherwise = "8", .limits = "from 0 to 64", .doc = "How many it hears; with less than four it has no fix."},
    {.name = "dop", .use = Use::kRead, .type = "tuple", .form = "[horizontal vertical]", .otherwise = "[1 1.5]", .limits = "from 0 to 100", .doc = "How well they are spread over the sky, as it is told: dilutions of precision."},
};

constexpr KindInterface kInterfacesOfGps[1] = {
    {"gps", 13, Index::kCount, Need::kNothing, Need::kNothing, false},
};

constexpr std::string_view kOld_block_height_to[] = {"z.1"};
constexpr Meaning kOld_block_height{.how = Meaning::How::kWords, .to = kOld_block_height_to};
constexpr Word kWordsOfBlock[7] = {
    {.name = "points", .use = Use::kRead, .type = "integer", .doc = "How many corners the outline has, at least 2; two are a wall 0.01 m thick."},
    {.name = "point", .use = Use::kRead, .type = "tuple", .form = "[x y]", .unit = "m", .otherwise = "[0 0]", .doc = "A corner, counted from 0; beside a bitmap in its pixels."},
    {.name = "z", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .told = "as high as the model", .doc = "From where to where the prism reaches, the floor being 0."},
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
    {.name = "pose", .use = Use::kRead, .type = "pose", .form = "[x y z heading]", .unit = "m, m, m, deg", .otherwise = "[0 0 0 0]", .doc = "Where the sensor is in the ranger."},
    {.name = "size", .use = Use::kRead, .type = "size", .form = "[x y z]", .unit = "m", .otherwise = "[0.02 0.02 0.02]", .doc = "For drawing; beams start at half its height above the pose."},
    {.name = "range", .use = Use::kRead, .type = "tuple", .form = "[min max]", .unit = "m", .otherwise = "[0 5]", .limits = "0 <= min <= max", .doc = "The nearest and the farthest thing that it reports."},
    {.name = "fov", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "5.729577951308232", .limits = "not negative", .doc = "Beams spread over this angle, half to each side, the first rightmost; a single one looks ahead."},
    {.name = "samples", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 65536", .doc = "How many beams it has."},
    {.name = "rings", .use = Use::kRead, .type = "count", .otherwise = "1", .limits = "from 1 to 256", .doc = "How many rows of beams it has, one above the other, as lidars with several lasers do. `samples` is how many beams each row has."},
    {.name = "ring_fov", .use = Use::kRead, .type = "tuple", .form = "[lowest highest]", .unit = "deg", .otherwise = "[0 0]", .limits = "from -89 to 89", .doc = "The elevations of the lowest ring and of the highest, between which the others are spread evenly. With the stage engine all are level."},
    {.name = "error", .use = Use::kRead, .type = "choice", .form = "\"none\" | \"lidar\"", .otherwise = "\"none\"", .doc = "How its beams fail, beyond their noise, at surfaces that are far away, dark, slanted, shiny or clear. \"none\": they do not; \"lidar\": as light does: what comes back of it follows from colour, material, incidence and distance, and what is too weak is not seen; with the arena engine (docs/arena.md)."},
    {.name = "range_dark", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "10", .limits = "above 0", .doc = "Of error \"lidar\": how far away it still sees a surface that it looks at straight on and that returns a tenth of the light."},
    {.name = "noise_weak", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "Of error \"lidar\": the standard deviation of a range that is told by the weakest echo that it notices. It falls as echoes get stronger."},
    {.name = "noise", .use = Use::kRead, .type = "tuple", .form = "[constant proportional angular]", .unit = "m, 1, deg", .otherwise = "[0 0 0]", .doc = "Errors: a standard deviation, a fraction of the range, and the angle by which a beam may be turned."},
    {.name = "color", .use = Use::kRead, .type = "color", .told = "blue, which one can see through", .doc = "The name of an X11 color, or random, which is the same in each run."},
    {.name = "color_rgba", .use = Use::kRead, .type = "rgba", .form = "[red green blue alpha]", .otherwise = "[0 0 1 0.15]", .doc = "The color as shares from 0 to 1; counts where there is no color."},
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
    {.name = "center", .use = Use::kRead, .type = "point", .form = "[x y]", .unit = "m", .otherwise = "[0 0]", .doc = "The place in the middle of the window, in metres whatever the file's unit."},
    {.name = "scale", .use = Use::kRead, .type = "number", .unit = "px/m", .otherwise = "0", .limits = "not negative", .doc = "Pixels per metre; 0: the whole scene is shown."},
    {.name = "rotate", .use = Use::kRead, .type = "tuple", .form = "[pitch yaw]", .unit = "deg", .otherwise = "[0 0]", .doc = "The direction of view, in degrees whatever the file's unit."},
    {.name = "show_data", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "Sensors are shown from the start."},
    {.name = "follow_model", .use = Use::kRead, .type = "text", .otherwise = "\"\"", .doc = "The name of a model that stays in the middle; none: the view stands still."},
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
    {.name = "interval_sim", .use = Use::kRead, .type = "number", .unit = "ms", .otherwise = "100", .limits = "above 0", .doc = "Simulated time of one tick, in whole microseconds."},
    {.name = "resolution", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "0.02", .limits = "above 0", .doc = "Told to clients as the resolution of ranges; geometry here is exact."},
    {.name = "gravity", .use = Use::kRead, .type = "number", .unit = "m/s^2", .otherwise = "9.81", .limits = "not negative", .doc = "How fast what falls gets faster, in the arena, and what an imu feels that stands still; 1.62 is the moon's."},
    {.name = "ground", .use = Use::kRead, .type = "text", .otherwise = "\"concrete\"", .doc = "What the ground is made of, in the arena: a material, as of models (docs/arena.md)."},
    {.name = "quit_time", .use = Use::kRead, .type = "number", .unit = "s", .otherwise = "0", .limits = "not negative", .doc = "Simulated time after which the run ends; 0: never."},
    {.name = "robot_types", .use = Use::kRead, .type = "texts", .doc = "Words of defines, of robots and of sensors that these may carry: `playhouse robot` makes robots of them while the world runs (docs/robot-client.md). None of them stands in the world at the start."},
    {.name = "unit_length", .use = Use::kRead, .type = "choice", .form = "\"m\" | \"cm\" | \"mm\"", .otherwise = "\"m\"", .doc = "The unit of all lengths in the file."},
    {.name = "unit_angle", .use = Use::kRead, .type = "choice", .form = "\"degrees\" | \"radians\"", .otherwise = "\"degrees\"", .doc = "The unit of all angles in the file."},
    {.name = "speedup", .use = Use::kRead, .type = "number", .otherwise = "1", .doc = "Times real time; 0 or less: as fast as possible."},
    {.name = "paused", .use = Use::kRead, .type = "flag", .otherwise = "0", .doc = "The run starts paused."},
    {.name = "sky", .use = Use::kRead, .type = "tuple", .form = "[red green blue]", .otherwise = "[0.6235 0.7686 0.9098]", .limits = "from 0 to 1", .doc = "The color of the sky in the images of cameras, as shares from 0 to 1."},
    {.name = "sun", .use = Use::kRead, .type = "tuple", .form = "[heading elevation brightness]", .unit = "deg, deg, 1", .otherwise = "[-125 50 1]", .doc = "Where the sun is, seen from the world, and how bright; one that is not above the horizon has set. Of cameras of the arena engine."},
    {.name = "fog", .use = Use::kRead, .type = "length", .unit = "m", .otherwise = "0", .limits = "not negative", .doc = "How far one sees: at this distance fog leaves 5 % of a contrast; 0: there is none. Of cameras of the arena engine."},
    {.name = "fog_color", .use = Use::kRead, .type = "tuple", .form = "[red green blue]", .otherwise = "[0.8 0.82 0.84]", .limits = "from 0 to 1", .doc = "The color of the fog, as shares from 0 to 1. Of cameras of the arena engine."},
    {.name = "latitude", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "Where on the earth the point 0 0 0 is, positive to the north (WGS84): what gps receivers tell follows from it. x is east there, y north."},
    {.name = "longitude", .use = Use::kRead, .type = "angle", .unit = "deg", .otherwise = "0", .doc = "The same, positive to the east."},
    {.name = "altitude", .use = Use::kRead, .type = "number", .unit = "m", .otherwise = "0", .doc = "The same, above the ellipsoid."},
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
    {.name = "model", .doc = "A plain body; its words are those of every model, whatever its kind.", .entity = EntityForm::kModel, .table = "models", .kind = ModelKind::kPlain, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfModel, .interfaces = kInterfacesOfModel},
    {.name = "position", .doc = "A robot that drives in the plane.", .entity = EntityForm::kModel, .table = "positions", .kind = ModelKind::kPosition, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfPosition, .interfaces = kInterfacesOfPosition},
    {.name = "ranger", .doc = "Range finders of any kind: a laser has one sensor with many samples, a ring of sonars many with one.", .entity = EntityForm::kModel, .table = "rangers", .kind = ModelKind::kRanger, .simulated = true, .solid = false, .size = {0.15, 0.15, 0.2}, .color = {0, 0, 0.5f, 1}, .words = kWordsOfRanger, .interfaces = kInterfacesOfRanger},
    {.name = "fiducial", .doc = "A finder of marks: sees models with a fiducial_return and tells which they are and where.", .entity = EntityForm::kModel, .table = "fiducials", .kind = ModelKind::kFiducial, .simulated = true, .solid = false, .size = {0, 0, 0}, .color = {1, 0, 0, 1}, .words = kWordsOfFiducial, .interfaces = kInterfacesOfFiducial},
    {.name = "blobfinder", .doc = "A camera that finds patches of a colour.", .entity = EntityForm::kModel, .table = "blobfinders", .kind = ModelKind::kBlobfinder, .simulated = true, .solid = false, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfBlobfinder, .interfaces = kInterfacesOfBlobfinder},
    {.name = "bumper", .doc = "Switches that feel a touch.", .entity = EntityForm::kModel, .table = "bumpers", .kind = ModelKind::kBumper, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfBumper, .interfaces = kInterfacesOfBumper},
    {.name = "blinkenlight", .doc = "A lamp that can blink.", .entity = EntityForm::kModel, .table = "blinkenlights", .kind = ModelKind::kBlinkenlight, .simulated = true, .solid = true, .size = {0.02, 0.02, 0.02}, .color = {0, 1, 0, 1}, .words = kWordsOfBlinkenlight, .interfaces = kInterfacesOfBlinkenlight},
    {.name = "lightindicator", .doc = "A body that is darker while it is off, as it is at the start.", .entity = EntityForm::kModel, .table = "lightindicators", .kind = ModelKind::kLightindicator, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .interfaces = kInterfacesOfLightindicator},
    {.name = "gripper", .doc = "Two paddles that close around a thing and carry it.", .entity = EntityForm::kModel, .table = "grippers", .kind = ModelKind::kGripper, .simulated = true, .solid = true, .size = {0.2, 0.3, 0.2}, .color = {0.3f, 0.3f, 0.3f, 1}, .words = kWordsOfGripper, .interfaces = kInterfacesOfGripper},
    {.name = "actuator", .doc = "A joint that slides or turns, with what it carries.", .entity = EntityForm::kModel, .table = "actuators", .kind = ModelKind::kActuator, .simulated = true, .solid = true, .size = {0.4, 0.4, 1.0}, .color = {1, 0, 0, 1}, .words = kWordsOfActuator, .interfaces = kInterfacesOfActuator},
    {.name = "wifi", .doc = "A radio: tells which others of its network it hears, and how well, and carries messages between them.", .entity = EntityForm::kModel, .table = "wifis", .kind = ModelKind::kWifi, .simulated = true, .solid = false, .size = {0, 0, 0}, .color = {0.2f, 0.6f, 0.9f, 1}, .words = kWordsOfWifi, .interfaces = kInterfacesOfWifi},
    {.name = "camera", .doc = "A camera: takes images of the bodies, the floor and the sky, in colours, in grey, of distances, or of which model is where, and pans, tilts and zooms.", .entity = EntityForm::kModel, .table = "cameras", .kind = ModelKind::kCamera, .simulated = true, .solid = true, .size = {0.1, 0.07, 0.05}, .color = {0, 0, 0, 1}, .words = kWordsOfCamera, .interfaces = kInterfacesOfCamera},
    {.name = "detector", .doc = "A sensor made up in the world file: what it sees, what it sees through, how far, how finely and how well (docs/detectors.md).", .entity = EntityForm::kModel, .table = "detectors", .kind = ModelKind::kDetector, .simulated = true, .solid = false, .size = {0.1, 0.1, 0.1}, .color = {0.4f, 0.1f, 0.6f, 1}, .words = kWordsOfDetector, .interfaces = kInterfacesOfDetector},
    {.name = "custom", .doc = "A model or a sensor whose code is in a shared library.", .entity = EntityForm::kModel, .table = "customs", .kind = ModelKind::kCustom, .simulated = true, .solid = true, .size = {0.1, 0.1, 0.1}, .color = {1, 0.5f, 0, 1}, .words = kWordsOfCustom, .interfaces = kInterfacesOfCustom},
    {.name = "imu", .doc = "An inertial measurement unit: feels how it is accelerated, with gravity, and how fast it turns, and tells how it stands.", .entity = EntityForm::kModel, .table = "imus", .kind = ModelKind::kImu, .simulated = true, .solid = false, .size = {0.03, 0.03, 0.01}, .color = {0.1f, 0.4f, 0.2f, 1}, .words = kWordsOfImu, .interfaces = kInterfacesOfImu},
    {.name = "gps", .doc = "A satellite receiver: tells where on the earth it is, as the world's latitude, longitude and altitude have it.", .entity = EntityForm::kModel, .table = "receivers", .kind = ModelKind::kGps, .simulated = true, .solid = false, .size = {0.06, 0.06, 0.02}, .color = {0.9f, 0.9f, 0.9f, 1}, .words = kWordsOfGps, .interfaces = kInterfacesOfGps},
    {.name = "block", .doc = "A prism, as a part of a model's body; all blocks together are stretched to fill the model's size.", .entity = EntityForm::kPart, .inside = "model", .simulated = true, .words = kWordsOfBlock},
    {.name = "sensor", .doc = "One transducer or scanner of a ranger.", .entity = EntityForm::kPart, .inside = "ranger", .table = "sensors", .simulated = true, .words = kWordsOfSensor},
    {.name = "pack", .doc = "A battery, from which a model draws, and what is inside it and has none of its own.", .entity = EntityForm::kTrait, .table = "packs", .simulated = true, .interfaces = kInterfacesOfPack, .has = has_pack},
    {.name = "window", .doc = "How to look at the scene; the first window of a file counts.", .entity = EntityForm::kWindow, .simulated = true, .words = kWordsOfWindow},
    {.name = "world", .doc = "The world file itself: words that stand outside of all entities, anywhere in the file.", .entity = EntityForm::kWorld, .simulated = true, .words = kWordsOfWorld, .interfaces = kInterfacesOfWorld},
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
