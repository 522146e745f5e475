/** Repeats the programs behind the recorded sessions with this library: scenarios NAME HOST:PORT.
 * clients/python/tests/test_replay.py plays back the recorded answers and compares what the client sends;
 * clients/python/tests/scenarios.py is the Python counterpart. */
#include <string.h>

#include "must.h"

static const double kPi = 3.141592653589793;

static void read_rounds(ph_client *client, int count) {
  for (int i = 0; i < count; ++i) must(ph_client_read(client, PH_OWN_TIMEOUT, NULL, &error));
}

static ph_position2d *open_base(ph_client *client) {
  return must_have(ph_position2d_open(client, 0, PH_ACCESS_ALL, &error));
}

static void print_position(ph_client *client) {
  open_base(client);
  must(ph_client_set_mode(client, PH_MODE_PULL, &error));
  must(ph_client_set_replace_rule(client, PH_RULE_ACCEPT, NULL, &error));
  read_rounds(client, 3);
}

static void print_defaults(ph_client *client) {
  open_base(client);
  read_rounds(client, 2);
}

static void drive(ph_position2d *robot, double vx, double va, double vy) {
  must(ph_position2d_drive(robot, vx, va, vy, &error));
}

static void check_position(ph_client *client) {
  ph_position2d *robot = open_base(client);
  const ph_pose zero = {0, 0, 0}, elsewhere = {0.1, -0.2, kPi};
  read_rounds(client, 23);
  must(ph_position2d_set_odometry(robot, elsewhere, &error));
  read_rounds(client, 10);
  must(ph_position2d_set_odometry(robot, zero, &error));
  must(ph_position2d_set_motor_power(robot, true, &error));
  drive(robot, 0.1, 0, 0);
  drive(robot, -0.1, 0, 0);
  drive(robot, 0, 0, 0.1);
  drive(robot, 0, 0, -0.1);
  drive(robot, 0, -25 * kPi / 180, 0);
  drive(robot, 0, 25 * kPi / 180, 0);
  drive(robot, 0, 45 * kPi / 180, 0.1);
  drive(robot, 0, -45 * kPi / 180, -0.1);
  must(ph_position2d_stop(robot, &error));
  must(ph_position2d_set_motor_power(robot, false, &error));
  must(ph_position2d_set_odometry(robot, zero, &error));
}

static void check_laser(ph_client *client) {
  ph_laser *laser = must_have(ph_laser_open(client, 0, PH_ACCESS_ALL, &error));
  read_rounds(client, 20);
  const float quarter = (float)(kPi / 2);
  const ph_laser_config config = {-quarter, quarter, 100, 0, 1, 1, 10};
  must_refuse(ph_laser_set_config(laser, &config, &error), "the configuration");
}

static void check_ranger(ph_client *client) {
  ph_ranger *ranger = must_have(ph_ranger_open(client, 1, PH_ACCESS_ALL, &error));
  read_rounds(client, 60);
  must(ph_device_request(ph_ranger_device(ranger), PH_RANGER_REQ_GET_GEOM, NULL, PH_OWN_TIMEOUT, NULL,
                         &error));
  read_rounds(client, 3);
}

static void ask_map(ph_client *client) {
  ph_device *device = must_have(ph_device_open(client, "map", 0, PH_ACCESS_ALL, &error));
  const ph_map_data tiles[] = {{.width = 20, .height = 10}, {.col = 495, .width = 50, .height = 3}};
  must(ph_device_request(device, PH_MAP_REQ_GET_INFO, NULL, PH_OWN_TIMEOUT, NULL, &error));
  for (size_t i = 0; i < 2; ++i) {
    must(ph_device_request(device, PH_MAP_REQ_GET_DATA, &tiles[i], PH_OWN_TIMEOUT, NULL, &error));
  }
  must_refuse(ph_device_request(device, PH_MAP_REQ_GET_VECTOR, NULL, PH_OWN_TIMEOUT, NULL, &error), "lines");
}

static void ask_simulation(ph_client *client) {
  ph_simulation *simulation = must_have(ph_simulation_open(client, 0, PH_ACCESS_ALL, &error));
  const ph_pose elsewhere = {-6, -6, 0.5};
  ph_pose pose;
  ph_pose3d pose3d;
  must(ph_simulation_pose(simulation, "r0", &pose, &error));
  must(ph_simulation_set_pose(simulation, "r0", elsewhere, &error));
  must_refuse(ph_simulation_pose(simulation, "nosuch", &pose, &error), "a model that is not there");
  must(ph_simulation_pose3d(simulation, "r0", &pose3d, &error));
}

static void ask_properties(ph_client *client) {
  ph_device *lights = must_have(ph_device_open(client, "dio", 0, PH_ACCESS_ALL, &error));
  ph_device *stream = must_have(ph_device_open(client, "opaque", 1, PH_ACCESS_ALL, &error));
  int32_t whole = 0;
  double number = 0;
  const char *text = NULL;
  bool yes = false;
  must(ph_device_get_int(lights, "skip_lines", &whole, &error));
  must(ph_device_set_int(lights, "skip_lines", 7, &error));
  must(ph_device_get_int(lights, "skip_lines", &whole, &error));
  must(ph_device_get_double(lights, "max_diff_pixels", &number, &error));
  must(ph_device_set_double(lights, "max_diff_pixels", 0.25, &error));
  must(ph_device_get_double(lights, "max_diff_pixels", &number, &error));
  must(ph_device_get_int(lights, "max_diff_pixels", &whole, &error));
  must_refuse(ph_device_get_int(lights, "nope", &whole, &error), "a property that is not there");
  must(ph_device_has_capability(lights, PH_COMMON_REQ_CAPABILITIES, &yes, &error));
  must(ph_device_get_string(stream, "ip", &text, &error));
  must(ph_device_set_string(stream, "ip", "127.0.0.2", &error));
  must(ph_device_get_string(stream, "ip", &text, &error));
  must_refuse(ph_device_get_bool(stream, "nobool", &yes, &error), "a property that is not there");
}

static const struct {
  const char *name;
  ph_mode mode;
  void (*play)(ph_client *client);
} kScenarios[] = {
    {"05_playerprint_position2d", PH_MODE_PULL, print_position},
    {"06_playerprint_defaults", PH_MODE_PULL, print_defaults},
    {"10_cxxtest_position2d", PH_MODE_PULL, check_position},
    {"11_cxxtest_laser", PH_MODE_PULL, check_laser},
    {"12_cxxtest_ranger", PH_MODE_PULL, check_ranger},
    {"13_raw_map", PH_MODE_PUSH, ask_map},
    {"14_raw_simulation", PH_MODE_PUSH, ask_simulation},
    {"15_raw_properties", PH_MODE_PUSH, ask_properties},
};

int main(int argc, char **argv) {
  for (size_t i = 0; argc == 3 && i < sizeof kScenarios / sizeof *kScenarios; ++i) {
    if (strcmp(kScenarios[i].name, argv[1]) != 0) continue;
    const ph_options options = {kScenarios[i].mode, 5.0, NULL};
    ph_client *client = must_have(ph_connect(argv[2], &options, &error));
    kScenarios[i].play(client);
    ph_client_free(client);
    return 0;
  }
  fail("usage: scenarios NAME HOST:PORT");
}
