/** Uses radio, camera, speech, IMU and drivers on a map of the real server through this library:
 * robots radio|camera|voice|inertia|course|guest HOST:PORT, with worlds/radio.world, camera.world,
 * radio.world, outdoor.world or navigate.cfg respectively. Prints what fails and exits with 1. Run by
 * clients/python/tests/test_server.py. */
#include <math.h>
#include <string.h>

#include "must.h"

static void read_once(ph_client *client) {
  must(ph_client_read(client, PH_OWN_TIMEOUT, NULL, &error));
}

static ph_client *connected(const char *address) {
  return must_have(ph_connect(address, NULL, &error));
}

static ph_robot *robot_of(ph_client *client, const char *name) {
  return must_have(ph_client_robot(client, name, &error));
}

/** Network address of the radio with the best link to this one. */
static void find_nearest(ph_client *client, char address[64]) {
  ph_device *air = must_have(ph_device_open(client, "wifi", 0, PH_ACCESS_ALL, &error));
  while (!ph_device_take_fresh(air)) read_once(client);
  const ph_wifi_data *data = ph_device_latest(air, PH_WIFI_DATA_STATE)->data;
  must_be(data->links_count > 0, "a radio hears another one");
  must_be(data->links[0].level < 0 && data->links[0].noise == -100, "levels are in dBm");
  snprintf(address, 64, "%.*s", (int)data->links[0].ip_count, (const char *)data->links[0].ip);
  ph_device_free(air);
}

static void must_hear(ph_client *client, ph_opaque *radio, const char *wanted, size_t wanted_size) {
  const uint8_t *bytes = NULL;
  size_t size = 0;
  while (!ph_opaque_take_message(radio, &bytes, &size)) read_once(client);
  must_be(size == wanted_size && (size == 0 || memcmp(bytes, wanted, size) == 0),
          "messages come whole and in order");
}

static void use_radios(const char *address) {
  static const char to_one[] = "\0to one";
  ph_client *client = connected(address), *other = connected(address);
  ph_opaque *radio = must_have(ph_robot_opaque(robot_of(client, "r0"), 0, &error));
  ph_opaque *receiver = must_have(ph_robot_opaque(robot_of(other, "r1"), 0, &error));
  char nearest[64];
  char *too_long = must_have(calloc(2305, 1));
  const uint8_t *bytes = NULL;
  size_t size = 0;
  find_nearest(client, nearest);
  must(ph_opaque_send(radio, "to all", 6, &error));
  must(ph_opaque_send_to(radio, nearest, to_one, 7, &error));
  must(ph_opaque_send_to(radio, "", NULL, 0, &error));
  must_hear(other, receiver, "to all", 6);
  must_hear(other, receiver, to_one, 7);
  must_hear(other, receiver, "", 0);
  must_be(!ph_opaque_take_message(receiver, &bytes, &size), "there is nothing else to hear");
  must_be(!ph_opaque_take_message(radio, &bytes, &size), "nobody hears itself");
  must_refuse(ph_opaque_send_to(radio, "10.0.9.9", "x", 1, &error), "an address that no radio has");
  must_refuse(ph_opaque_send_to(radio, "", too_long, 2305, &error), "a message that is too long");
  free(too_long);
  ph_client_free(other);
  ph_client_free(client);
}

static ph_image next_image(ph_client *client, ph_camera *camera) {
  ph_image image;
  while (ph_camera_image(camera, &image, &error) == PH_NO_DATA) read_once(client);
  must(ph_camera_image(camera, &image, &error));
  return image;
}

static ph_view view_of(ph_client *client, ph_ptz *mount) {
  ph_view view;
  while (ph_ptz_view(mount, &view, &error) == PH_NO_DATA) read_once(client);
  must(ph_ptz_view(mount, &view, &error));
  return view;
}

static void turn_camera(ph_client *client, ph_ptz *mount) {
  const ph_view before = view_of(client, mount);
  must(ph_ptz_look(mount, before.pan + 0.25, before.tilt, 0.0, &error));
  while (fabs(view_of(client, mount).pan - before.pan - 0.25) > 0.001) read_once(client);
  must(ph_ptz_set_velocity_control(mount, true, &error));
  must(ph_ptz_turn(mount, -0.5, 0.0, &error));
  while (view_of(client, mount).pan > before.pan) read_once(client);
  must_be(view_of(client, mount).pan_speed < 0, "it turns to the right");
  must(ph_ptz_turn(mount, 0.0, 0.0, &error));
}

static void use_cameras(const char *address) {
  ph_client *client = connected(address);
  ph_robot *robot = robot_of(client, "r0");
  ph_camera *color = must_have(ph_robot_camera(robot, 0, &error));
  ph_camera *depth = must_have(ph_robot_camera(robot, 1, &error));
  ph_ptz *mount = must_have(ph_robot_ptz(robot, 0, &error));
  uint16_t channels[3];
  size_t count = 0;
  const ph_image colors = next_image(client, color);
  must_be(colors.width == 160 && colors.height == 120 && !colors.is_jpeg, "the picture is 160 x 120 and raw");
  must(ph_image_pixel(&colors, 159, 119, channels, &count, &error));
  must_be(count == 3, "a pixel in colors has three values");
  const ph_image distances = next_image(client, depth);
  must(ph_image_pixel(&distances, 40, 59, channels, &count, &error));
  must_be(count == 1 && channels[0] > 50, "the floor before the robot is more than 5 cm away");
  must_be(ph_image_pixel(&distances, 80, 0, channels, &count, &error) == PH_INVALID_VALUE,
          "there is no pixel beside the picture");
  ph_geometry geometry;
  must(ph_ptz_geometry(mount, &geometry, &error));
  must_be(geometry.pose.x == 0.12, "the camera is 12 cm before the robot's middle");
  turn_camera(client, mount);
  ph_client_free(client);
}

/** Reads until these words are heard, before any others. */
static void must_hear_words(ph_client *client, ph_speech_recognition *ears, const char *wanted) {
  const char *text = NULL;
  while ((text = ph_speech_recognition_take_text(ears)) == NULL) read_once(client);
  must_be(strcmp(text, wanted) == 0, "a robot hears others and not itself");
}

static void use_voices(const char *address) {
  ph_client *client = connected(address), *other = connected(address);
  ph_speech *voice = must_have(ph_robot_speech(robot_of(client, "r0"), 0, &error));
  ph_speech *own = must_have(ph_robot_speech(robot_of(other, "r1"), 0, &error));
  ph_speech_recognition *ears = must_have(ph_robot_speech_recognition(robot_of(other, "r1"), 0, &error));
  must(ph_speech_say(own, "my own voice", &error));
  must(ph_speech_say(voice, "marco", &error));
  must_hear_words(other, ears, "marco");
  must(ph_speech_say(voice, "sch\xc3\xb6n", &error));
  must_hear_words(other, ears, "sch\xc3\xb6n");
  must_be(ph_speech_recognition_take_text(ears) == NULL, "a robot hears each text once");
  ph_client_free(other);
  ph_client_free(client);
}

/** Devices of the robot in outdoor.world. */
typedef struct outdoor {
  ph_client *client;
  ph_position3d *base;
  ph_imu *unit;
  ph_gps *receiver;
  ph_pointcloud3d *lidar;
} outdoor;

static void check_measurements(const outdoor *robot) {
  ph_state3d state;
  double attitude[3], quaternion[4];
  ph_fix fix;
  ph_inertia inertia;
  ph_pose3d velocity;
  const ph_cloud_point *points = NULL;
  size_t count = 0;
  must_be(ph_imu_inertia(robot->unit, &inertia, &error) == PH_NO_DATA &&
              ph_imu_attitude(robot->unit, attitude, &error) == PH_NO_DATA,
          "there are no data before the first");
  must(ph_imu_send(robot->unit, PH_IMU_DATA_EULER, &error));
  while (ph_position3d_state(robot->base, &state, &error) != PH_OK ||
         ph_imu_attitude(robot->unit, attitude, &error) != PH_OK ||
         ph_gps_fix(robot->receiver, &fix, &error) != PH_OK ||
         ph_pointcloud3d_points(robot->lidar, &points, &count, &error) != PH_OK || count == 0) {
    read_once(robot->client);
  }
  must(ph_imu_inertia(robot->unit, &inertia, &error));
  must_be(fabs(inertia.acceleration[2] - 9.81) < 1, "it feels gravity");
  must_be(fabs(attitude[0]) < 0.2, "it is level");
  must_be(ph_imu_velocity(robot->unit, &velocity, &error) == PH_NO_DATA &&
              ph_imu_quaternion(robot->unit, quaternion, &error) == PH_NO_DATA,
          "of what is not sent there are no data");
  must_be(fabs(fix.latitude - 50.7747) < 0.001 && fix.quality > 0, "it is in Aachen");
  must_be(points[0].color[3] == 255, "points are opaque");
}

static ph_state3d base_state(const outdoor *robot) {
  ph_state3d state;
  must(ph_position3d_state(robot->base, &state, &error));
  return state;
}

static void check_motion(const outdoor *robot) {
  const ph_pose3d pose = {5, 6, 0, 0, 0, 0};
  ph_pose3d velocity;
  must(ph_position3d_set_odometry(robot->base, pose, &error));
  while (fabs(base_state(robot).pose.x - 5) > 1) read_once(robot->client);
  must_be(ph_position3d_drive(robot->base, (double)INFINITY, 0, 0, 0, &error) == PH_INVALID_VALUE,
          "a number that is not finite is an error");
  must(ph_position3d_drive(robot->base, 0.2, 0, 0, 0, &error));
  while (base_state(robot).velocity.x < 0.1) read_once(robot->client);
  must(ph_imu_send(robot->unit, PH_IMU_DATA_FULLSTATE, &error));
  while (ph_imu_velocity(robot->unit, &velocity, &error) == PH_NO_DATA) read_once(robot->client);
  must(ph_imu_reset_orientation(robot->unit, false, &error));
  must(ph_position3d_close(robot->base, &error));
}

static void use_inertia(const char *address) {
  ph_client *client = connected(address);
  ph_robot *robot = robot_of(client, "r0");
  const outdoor devices = {
      client, must_have(ph_robot_position3d(robot, 0, &error)), must_have(ph_robot_imu(robot, 0, &error)),
      must_have(ph_robot_gps(robot, 0, &error)), must_have(ph_robot_pointcloud3d(robot, 0, &error))};
  check_measurements(&devices);
  check_motion(&devices);
  ph_client_free(client);
}

static double distance(ph_pose a, ph_pose b) {
  return hypot(a.x - b.x, a.y - b.y);
}

static void check_map(ph_map *plan, ph_pose start) {
  ph_cells map;
  ph_cell cell;
  must(ph_map_cells(plan, &map, &error));
  must_be(fabs(map.grid.cell_size - 0.1) < 1e-6, "cells have sides of 0.1 m");
  const ph_point here = {start.x, start.y}, rock = {-7.9, -7.9};
  must_be(ph_grid_cell_of(&map.grid, here, &cell) && map.cells[cell.row * map.grid.width + cell.column] == -1,
          "a robot stands where nothing else is");
  must_be(ph_grid_cell_of(&map.grid, rock, &cell) && map.cells[cell.row * map.grid.width + cell.column] == 1,
          "there is rock around the cave");
}

static ph_pose true_pose(ph_simulation *simulation) {
  ph_pose pose;
  must(ph_simulation_pose(simulation, "r0", &pose, &error));
  return pose;
}

static void check_way(ph_planner *planner, ph_localize *place, ph_simulation *simulation, ph_pose start,
                      ph_pose goal) {
  ph_path path;
  ph_planning state;
  ph_pose pose;
  const ph_particle *particles = NULL;
  size_t count = 0;
  const ph_covariance none = {.xx = -1};
  must(ph_planner_stop(planner, &error));
  must(ph_planner_path(planner, &path, &error));
  must_be(path.count > 0 && distance(path.waypoints[path.count - 1], goal) == 0 &&
              path.length > distance(start, goal),
          "a path leads to the goal");
  must(ph_planner_state(planner, &state, &error));
  must_be(state.valid && !ph_planner_arrived(planner), "it is on its way");
  must(ph_localize_pose(place, &pose, &error));
  must_be(distance(pose, true_pose(simulation)) < 0.3, "it knows where it is");
  must(ph_localize_particles(place, &particles, &count, &error));
  must_be(count >= 100, "there are particles");
  must_refuse(ph_localize_set_estimate(place, start, none, &error), "an invalid covariance");
}

static const char *why_refused(ph_planner *planner) {
  const char *why = NULL;
  must(ph_device_why_refused(ph_planner_device(planner), &why, &error));
  return why;
}

static void use_drivers_on_a_map(const char *address) {
  ph_client *client = connected(address);
  ph_simulation *simulation = must_have(ph_simulation_open(client, 0, PH_ACCESS_ALL, &error));
  const ph_pose start = true_pose(simulation), goal = {6, 4, 1.5};
  check_map(must_have(ph_map_open(client, 0, PH_ACCESS_ALL, &error)), start);
  ph_robot *robot = robot_of(client, "r0");
  ph_localize *place = must_have(ph_robot_localize(robot, 0, &error));
  ph_planner *planner = must_have(ph_robot_planner(robot, 0, &error));
  must(ph_localize_set_estimate(place, start, ph_covariance_of_deviations(0.2, 0.2, 0.1), &error));
  must(ph_planner_go_to(planner, goal, &error));
  ph_planning state;
  while (ph_planner_state(planner, &state, &error) != PH_OK || state.pose.x < start.x + 0.5)
    read_once(client);
  check_way(planner, place, simulation, start, goal);
  must(ph_planner_resume(planner, &error));
  while (!ph_planner_arrived(planner)) read_once(client);
  must_be(distance(true_pose(simulation), goal) < 0.6, "it is at the goal");
  must_be(strcmp(why_refused(planner), "") == 0, "it was not refused");
  must(ph_planner_go_to(planner, (ph_pose){999, 0, 0}, &error));
  while (*why_refused(planner) == '\0') read_once(client);
  must_be(strcmp(why_refused(planner), "no path to (999, 0): the goal is off the map") == 0, "it says why");
  ph_client_free(client);
}

static void use_token(const char *address) {
  ph_options options = PH_DEFAULT_OPTIONS;
  options.token = "no-such-token";
  must_be(ph_connect(address, &options, &error) == NULL && strstr(error.text, "the token is refused") != NULL,
          "a wrong token is refused");
  options.token = "driver-token-1";
  ph_client *client = must_have(ph_connect(address, &options, &error));
  ph_position2d *robot = must_have(ph_position2d_open(client, 0, PH_ACCESS_ALL, &error));
  must(ph_position2d_drive(robot, 0.3, 0, 0, &error));
  ph_state state;
  while (ph_position2d_state(robot, &state, &error) != PH_OK || state.velocity.x < 0.2) read_once(client);
  ph_client_free(client);
}

static const struct {
  const char *name;
  void (*use)(const char *address);
} kUses[] = {
    {"radio", use_radios},    {"camera", use_cameras},          {"voice", use_voices},
    {"inertia", use_inertia}, {"course", use_drivers_on_a_map}, {"guest", use_token},
};

int main(int argc, char **argv) {
  for (size_t i = 0; argc == 3 && i < sizeof kUses / sizeof *kUses; ++i) {
    if (strcmp(kUses[i].name, argv[1]) != 0) continue;
    kUses[i].use(argv[2]);
    return 0;
  }
  fail("usage: robots radio|camera|voice|inertia|course|guest HOST:PORT");
}
