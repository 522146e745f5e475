/** The C client library of Player 3, by its old names, so that old programs compile and run: docs/moving-from-player.md.
 *
 * Functions return 0 if they did their work, -1 if not, and -2 if the server refused the request (NACK);
 * playerc_error_str() then says why. A new program better includes playhouse/c.h. */
#ifndef LIBPLAYERC_PLAYERC_H
#define LIBPLAYERC_PLAYERC_H

#include <libplayercommon/playercommon.h>
#include <libplayerinterface/interface_util.h>
#include <libplayerinterface/player.h>
#include <netinet/in.h>
#include <playerconfig.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PLAYERC_OPEN_MODE PLAYER_OPEN_MODE
#define PLAYERC_CLOSE_MODE PLAYER_CLOSE_MODE
#define PLAYERC_ERROR_MODE PLAYER_ERROR_MODE
#define PLAYERC_DATAMODE_PUSH PLAYER_DATAMODE_PUSH
#define PLAYERC_DATAMODE_PULL PLAYER_DATAMODE_PULL
#define PLAYERC_TRANSPORT_TCP 1
#define PLAYERC_TRANSPORT_UDP 2

/** What went wrong in the last call of this thread that failed. */
const char *playerc_error_str(void);

/* --- clients */

typedef struct _playerc_client_t playerc_client_t;
typedef struct _playerc_device_t playerc_device_t;
struct pollfd;

/** Gets the header (player_msghdr_t) and the body of each message to a device, decoded. */
typedef void (*playerc_putmsg_fn_t)(void *device, char *header, char *data);
/** Called after data have arrived. */
typedef void (*playerc_callback_fn_t)(void *data);

/** Several clients that are read together. */
typedef struct {
  int client_count;
  playerc_client_t *client[128];
  struct pollfd *pollfd;
  /** The latest time that any of the servers told (s). */
  double time;
} playerc_mclient_t;

playerc_mclient_t *playerc_mclient_create(void);
/** The clients remain. */
void playerc_mclient_destroy(playerc_mclient_t *mclient);
int playerc_mclient_addclient(playerc_mclient_t *mclient, playerc_client_t *client);
/** How many of the clients have something to read, within `timeout` ms (for ever, if it is negative); -1: error. */
int playerc_mclient_peek(playerc_mclient_t *mclient, int timeout);
/** The same, and reads it. */
int playerc_mclient_read(playerc_mclient_t *mclient, int timeout);

/** A device of the server. */
typedef struct {
  player_devaddr_t addr;
  char drivername[PLAYER_MAX_DRIVER_STRING_LEN];
} playerc_device_info_t;

/** A connection to a server. */
struct _playerc_client_t {
  /** The client itself. */
  void *id;
  char *host;
  int port;
  int transport;
  struct sockaddr_in server;
  int connected;
  /** How often a lost connection is made anew, -1: until it is there; and the time between (s). */
  int retry_limit;
  double retry_time;
  /** Messages that the server dropped; the program may reset it. */
  uint32_t overflow_count;
  /** The socket, for select(); -1 without a connection. */
  int sock;
  uint8_t mode;
  /** What playerc_client_get_devlist() found. */
  playerc_device_info_t devinfos[PLAYER_MAX_DEVICES];
  int devinfo_count;
  /** The proxies of this client. */
  playerc_device_t *device[PLAYER_MAX_DEVICES];
  int device_count;
  /** The server's time at the last data, and at those before (s). */
  double datatime;
  double lasttime;
  /** How long an answer may take (s). */
  double request_timeout;
  struct playerc_session *session;
};

/** `mclient` may be NULL. */
playerc_client_t *playerc_client_create(playerc_mclient_t *mclient, const char *host, int port);
/** Disconnects, too. Destroy the proxies before. */
void playerc_client_destroy(playerc_client_t *client);
/** PLAYERC_TRANSPORT_TCP or PLAYERC_TRANSPORT_UDP, before connecting. */
void playerc_client_set_transport(playerc_client_t *client, unsigned int transport);
/** Selects pull mode, too. */
int playerc_client_connect(playerc_client_t *client);
int playerc_client_disconnect(playerc_client_t *client);
/** Makes the connection anew as retry_limit says, with the open devices. */
int playerc_client_disconnect_retry(playerc_client_t *client);
int playerc_client_datamode(playerc_client_t *client, uint8_t mode);
/** In pull mode, asks for the next round of data; reading does so itself. */
int playerc_client_requestdata(playerc_client_t *client);
/** -1 stands for every interface, index, type or subtype; `replace` is a PLAYER_PLAYER_MSG_REPLACE_RULE_ constant. */
int playerc_client_set_replace_rule(playerc_client_t *client, int interf, int index, int type, int subtype,
                                    int replace);
int playerc_client_adddevice(playerc_client_t *client, playerc_device_t *device);
int playerc_client_deldevice(playerc_client_t *client, playerc_device_t *device);
/** At most four functions of a device that are called after its data. */
int playerc_client_addcallback(playerc_client_t *client, playerc_device_t *device,
                               playerc_callback_fn_t callback, void *data);
int playerc_client_delcallback(playerc_client_t *client, playerc_device_t *device,
                               playerc_callback_fn_t callback, void *data);
int playerc_client_get_devlist(playerc_client_t *client);
int playerc_client_subscribe(playerc_client_t *client, int code, int index, int access, char *drivername,
                             size_t len);
int playerc_client_unsubscribe(playerc_client_t *client, int code, int index);
/** Sends a request and waits for the answer. `rep_data`, which may be NULL, gets a copy of its body, NULL if it has
 * none: release it by the T_free() of its struct. */
int playerc_client_request(playerc_client_t *client, playerc_device_t *device, uint8_t reqtype,
                           const void *req_data, void **rep_data);
/** Whether there is something to read, within `timeout` ms: 1 or 0; -1: error. Asks for data in pull mode. */
int playerc_client_peek(playerc_client_t *client, int timeout);
/** The same without asking. */
int playerc_client_internal_peek(playerc_client_t *client, int timeout);
/** Waits for data. In pull mode it reads a round of them and returns the client, in push mode it reads one message and
 * returns the proxy that got it. NULL: error. */
void *playerc_client_read(playerc_client_t *client);
/** The same of what is there, without waiting: 1, or 0 if there is no message or no whole round yet; -1: error. */
int playerc_client_read_nonblock(playerc_client_t *client);
/** The same; `proxy` gets what playerc_client_read() returns. */
int playerc_client_read_nonblock_withproxy(playerc_client_t *client, void **proxy);
void playerc_client_set_request_timeout(playerc_client_t *client, uint32_t seconds);
void playerc_client_set_retry_limit(playerc_client_t *client, int limit);
void playerc_client_set_retry_time(playerc_client_t *client, double time);
/** Sends a command; `timestamp` may be NULL and has no meaning to the server. */
int playerc_client_write(playerc_client_t *client, playerc_device_t *device, uint8_t subtype, void *cmd,
                         double *timestamp);

/* --- devices */

/** What every proxy begins with, as its member `info`. */
struct _playerc_device_t {
  /** The proxy itself. */
  void *id;
  playerc_client_t *client;
  player_devaddr_t addr;
  char drivername[PLAYER_MAX_DRIVER_STRING_LEN];
  int subscribed;
  /** The server's time at the last data, and at those before (s). */
  double datatime;
  double lasttime;
  /** Set to 1 when data, a geometry or a configuration arrive; the program resets it. */
  int fresh;
  int freshgeom;
  int freshconfig;
  playerc_putmsg_fn_t putmsg;
  void *user_data;
  int callback_count;
  playerc_callback_fn_t callback[4];
  void *callback_data[4];
};

void playerc_device_init(playerc_device_t *device, playerc_client_t *client, int code, int index,
                         playerc_putmsg_fn_t putmsg);
void playerc_device_term(playerc_device_t *device);
int playerc_device_subscribe(playerc_device_t *device, int access);
int playerc_device_unsubscribe(playerc_device_t *device);
/** 0 if the driver says that it knows the message. */
int playerc_device_hascapability(playerc_device_t *device, uint32_t type, uint32_t subtype);
int playerc_device_get_boolprop(playerc_device_t *device, const char *property, BOOL *value);
int playerc_device_set_boolprop(playerc_device_t *device, const char *property, BOOL value);
int playerc_device_get_intprop(playerc_device_t *device, const char *property, int32_t *value);
int playerc_device_set_intprop(playerc_device_t *device, const char *property, int32_t value);
int playerc_device_get_dblprop(playerc_device_t *device, const char *property, double *value);
int playerc_device_set_dblprop(playerc_device_t *device, const char *property, double value);
/** Release the text by free(). */
int playerc_device_get_strprop(playerc_device_t *device, const char *property, char **value);
int playerc_device_set_strprop(playerc_device_t *device, const char *property, const char *value);

/** What all proxies have. A proxy belongs to the program, which destroys it before its client; lists in it
 * are valid until the next data. */
#define PLAYERC_PROXY_FUNCTIONS(NAME)                                               \
  playerc_##NAME##_t *playerc_##NAME##_create(playerc_client_t *client, int index); \
  void playerc_##NAME##_destroy(playerc_##NAME##_t *device);                        \
  int playerc_##NAME##_subscribe(playerc_##NAME##_t *device, int access);           \
  int playerc_##NAME##_unsubscribe(playerc_##NAME##_t *device);

/* --- bases. Poses and speeds are in m, m/s, rad and rad/s. */

typedef struct {
  playerc_device_t info;
  /** Of playerc_position2d_get_geom(): x, y and heading; length and width. */
  double pose[3];
  double size[2];
  double px, py, pa;
  double vx, vy, va;
  int stall;
} playerc_position2d_t;
PLAYERC_PROXY_FUNCTIONS(position2d)

/** Switches the motors. */
int playerc_position2d_enable(playerc_position2d_t *device, int enable);
int playerc_position2d_get_geom(playerc_position2d_t *device);
int playerc_position2d_set_cmd_vel(playerc_position2d_t *device, double vx, double vy, double va, int state);
int playerc_position2d_set_cmd_pose(playerc_position2d_t *device, double gx, double gy, double ga, int state);
int playerc_position2d_set_cmd_pose_with_vel(playerc_position2d_t *device, player_pose2d_t pos,
                                             player_pose2d_t vel, int state);
/** `vy` and `state` are not sent: the message has no place for them. */
int playerc_position2d_set_cmd_vel_head(playerc_position2d_t *device, double vx, double vy, double pa,
                                        int state);
int playerc_position2d_set_cmd_car(playerc_position2d_t *device, double vx, double a);
int playerc_position2d_set_odom(playerc_position2d_t *device, double ox, double oy, double oa);

typedef struct {
  playerc_device_t info;
  /** Of playerc_position3d_get_geom(): x, y, z; length and width. */
  double pose[3];
  double size[2];
  double pos_x, pos_y, pos_z;
  double pos_roll, pos_pitch, pos_yaw;
  double vel_x, vel_y, vel_z;
  double vel_roll, vel_pitch, vel_yaw;
  int stall;
} playerc_position3d_t;
PLAYERC_PROXY_FUNCTIONS(position3d)

int playerc_position3d_enable(playerc_position3d_t *device, int enable);
int playerc_position3d_get_geom(playerc_position3d_t *device);
int playerc_position3d_set_velocity(playerc_position3d_t *device, double vx, double vy, double vz, double vr,
                                    double vp, double vt, int state);
/** The same without turning. */
int playerc_position3d_set_speed(playerc_position3d_t *device, double vx, double vy, double vz, int state);
int playerc_position3d_set_pose(playerc_position3d_t *device, double gx, double gy, double gz, double gr,
                                double gp, double gt);
int playerc_position3d_set_pose_with_vel(playerc_position3d_t *device, player_pose3d_t pos,
                                         player_pose3d_t vel);
/** playerc_position3d_set_pose() with angles of 0. */
int playerc_position3d_set_cmd_pose(playerc_position3d_t *device, double gx, double gy, double gz);
int playerc_position3d_set_vel_mode(playerc_position3d_t *device, int mode);
int playerc_position3d_set_odom(playerc_position3d_t *device, double ox, double oy, double oz, double oroll,
                                double opitch, double oyaw);
int playerc_position3d_reset_odom(playerc_position3d_t *device);

typedef struct {
  playerc_device_t info;
  /** Of playerc_position1d_get_geom(): x, y and heading; length and width. */
  double pose[3];
  double size[2];
  double pos;
  double vel;
  int stall;
  /** Bits by the numbers PLAYER_POSITION1D_STATUS_. */
  int status;
} playerc_position1d_t;
PLAYERC_PROXY_FUNCTIONS(position1d)

int playerc_position1d_enable(playerc_position1d_t *device, int enable);
int playerc_position1d_get_geom(playerc_position1d_t *device);
int playerc_position1d_set_cmd_vel(playerc_position1d_t *device, double vel, int state);
int playerc_position1d_set_cmd_pos(playerc_position1d_t *device, double pos, int state);
int playerc_position1d_set_cmd_pos_with_vel(playerc_position1d_t *device, double pos, double vel, int state);
int playerc_position1d_set_odom(playerc_position1d_t *device, double odom);

/* --- range finders */

typedef struct {
  playerc_device_t info;
  /** Of playerc_laser_get_geom(): x, y and heading; length and width. */
  double pose[3];
  double size[2];
  /** Of the robot at the scan, if the scan came with it. */
  double robot_pose[3];
  int intensity_on;
  int scan_count;
  /** Of the first beam, and between beams (rad). */
  double scan_start;
  double scan_res;
  double range_res;
  double max_range;
  double scanning_frequency;
  /** In m, from right to left. */
  double *ranges;
  /** The range (m) and the direction (rad) of each beam. */
  double (*scan)[2];
  player_point_2d_t *point;
  int *intensity;
  int scan_id;
  int laser_id;
  /** The shortest ranges of both halves; the middle beam is of the right one. */
  double min_right;
  double min_left;
} playerc_laser_t;
PLAYERC_PROXY_FUNCTIONS(laser)

int playerc_laser_set_config(playerc_laser_t *device, double min_angle, double max_angle, double resolution,
                             double range_res, unsigned char intensity, double scanning_frequency);
int playerc_laser_get_config(playerc_laser_t *device, double *min_angle, double *max_angle,
                             double *resolution, double *range_res, unsigned char *intensity,
                             double *scanning_frequency);
int playerc_laser_get_geom(playerc_laser_t *device);
/** Sets laser_id. */
int playerc_laser_get_id(playerc_laser_t *device);
/** Prints a line; `prefix` may be NULL. */
void playerc_laser_printout(playerc_laser_t *device, const char *prefix);

typedef struct {
  playerc_device_t info;
  uint32_t element_count;
  /** Of playerc_ranger_get_config(), or of data that came with them. */
  double min_angle;
  double max_angle;
  double angular_res;
  double min_range;
  double max_range;
  double range_res;
  double frequency;
  /** Of playerc_ranger_get_geom(), or of data that came with them; `element_count` elements. */
  player_pose3d_t device_pose;
  player_bbox3d_t device_size;
  player_pose3d_t *element_poses;
  player_bbox3d_t *element_sizes;
  uint32_t ranges_count;
  double *ranges;
  uint32_t intensities_count;
  double *intensities;
  /** Of ranges, once the configuration or the elements are known. */
  uint32_t bearings_count;
  double *bearings;
  uint32_t points_count;
  player_point_3d_t *points;
} playerc_ranger_t;
PLAYERC_PROXY_FUNCTIONS(ranger)

int playerc_ranger_get_geom(playerc_ranger_t *device);
int playerc_ranger_power_config(playerc_ranger_t *device, uint8_t value);
int playerc_ranger_intns_config(playerc_ranger_t *device, uint8_t value);
int playerc_ranger_set_config(playerc_ranger_t *device, double min_angle, double max_angle,
                              double angular_res, double min_range, double max_range, double range_res,
                              double frequency);
/** The pointers may be NULL. */
int playerc_ranger_get_config(playerc_ranger_t *device, double *min_angle, double *max_angle,
                              double *angular_res, double *min_range, double *max_range, double *range_res,
                              double *frequency);

typedef struct {
  playerc_device_t info;
  /** Of playerc_sonar_get_geom(). */
  int pose_count;
  player_pose3d_t *poses;
  /** In m. */
  int scan_count;
  double *scan;
} playerc_sonar_t;
PLAYERC_PROXY_FUNCTIONS(sonar)

int playerc_sonar_get_geom(playerc_sonar_t *device);

typedef struct {
  playerc_device_t info;
  player_ir_data_t data;
  /** Of playerc_ir_get_geom(). */
  player_ir_pose_t poses;
} playerc_ir_t;
PLAYERC_PROXY_FUNCTIONS(ir)

int playerc_ir_get_geom(playerc_ir_t *device);

typedef struct {
  playerc_device_t info;
  /** Of playerc_bumper_get_geom(). */
  int pose_count;
  player_bumper_define_t *poses;
  int bumper_count;
  uint8_t *bumpers;
} playerc_bumper_t;
PLAYERC_PROXY_FUNCTIONS(bumper)

int playerc_bumper_get_geom(playerc_bumper_t *device);

/* --- maps, and the way through them */

typedef struct {
  playerc_device_t info;
  /** In m per cell. */
  double resolution;
  int width, height;
  /** Of the corner of cell (0, 0), in m. */
  double origin[2];
  /** Of an occupied cell; a free one has its negative, one that is unknown 0. */
  int8_t data_range;
  /** Row by row, from the origin: PLAYERC_MAP_INDEX(). */
  char *cells;
  /** Of playerc_map_get_vector(). */
  double vminx, vminy, vmaxx, vmaxy;
  int num_segments;
  player_segment_t *segments;
} playerc_map_t;
PLAYERC_PROXY_FUNCTIONS(map)

#define PLAYERC_MAP_INDEX(dev, i, j) (((dev)->width) * (j) + (i))
int playerc_map_get_map(playerc_map_t *device);
int playerc_map_get_vector(playerc_map_t *device);

typedef struct {
  playerc_device_t info;
  uint32_t srid;
  player_extent2d_t extent;
  /** Of playerc_vectormap_get_map_info(); a layer's data are NULL before playerc_vectormap_get_layer_data(). */
  uint32_t layers_count;
  player_vectormap_layer_data_t **layers_data;
  player_vectormap_layer_info_t **layers_info;
} playerc_vectormap_t;
PLAYERC_PROXY_FUNCTIONS(vectormap)

int playerc_vectormap_get_map_info(playerc_vectormap_t *device);
int playerc_vectormap_get_layer_data(playerc_vectormap_t *device, unsigned layer_index);
int playerc_vectormap_write_layer(playerc_vectormap_t *device, const player_vectormap_layer_data_t *data);
/** Releases the layers. */
void playerc_vectormap_cleanup(playerc_vectormap_t *device);
/** A feature's shape as well-known binary, which belongs to the proxy; NULL if there is none of that number. */
uint8_t *playerc_vectormap_get_feature_data(playerc_vectormap_t *device, unsigned layer_index,
                                            unsigned feature_index);
size_t playerc_vectormap_get_feature_data_count(playerc_vectormap_t *device, unsigned layer_index,
                                                unsigned feature_index);

typedef struct playerc_localize_particle {
  double pose[3];
  double weight;
} playerc_localize_particle_t;

typedef struct {
  playerc_device_t info;
  /** Zeros and NULL, as they were: the map is that of the map interface. */
  int map_size_x, map_size_y;
  double map_scale;
  int map_tile_x, map_tile_y;
  int8_t *map_cells;
  int pending_count;
  double pending_time;
  int hypoth_count;
  player_localize_hypoth_t *hypoths;
  /** Of playerc_localize_get_particles(). */
  double mean[3];
  double variance;
  int num_particles;
  playerc_localize_particle_t *particles;
} playerc_localize_t;
PLAYERC_PROXY_FUNCTIONS(localize)

/** `cov`: variances of x, y and heading, then the covariances xy, y heading and x heading; an array of three, as programs
 * for Player 3.0 have, is one without these. */
int playerc_localize_set_pose(playerc_localize_t *device, double pose[3], double cov[6]);
int playerc_localize_set_pose_of(playerc_localize_t *device, const double pose[3], const double *cov,
                                 size_t cov_count);
#define playerc_localize_set_pose(device, pose, cov) \
  playerc_localize_set_pose_of(device, pose, cov, PLAYERC_COV_COUNT(cov))
#define PLAYERC_COV_COUNT(cov) (sizeof(cov) == 3 * sizeof(double) ? 3 : 6)
int playerc_localize_get_particles(playerc_localize_t *device);

typedef struct {
  playerc_device_t info;
  int path_valid;
  int path_done;
  double px, py, pa;
  double gx, gy, ga;
  double wx, wy, wa;
  int curr_waypoint;
  /** With the data, as all above. */
  int waypoint_count;
  /** Of playerc_planner_get_waypoints(), zeros before: x, y and heading of each, and the length of the way (m). */
  double (*waypoints)[3];
  double waypoint_distance;
} playerc_planner_t;
PLAYERC_PROXY_FUNCTIONS(planner)

int playerc_planner_set_cmd_pose(playerc_planner_t *device, double gx, double gy, double ga);
int playerc_planner_set_cmd_start(playerc_planner_t *device, double sx, double sy, double sa);
int playerc_planner_get_waypoints(playerc_planner_t *device);
int playerc_planner_enable(playerc_planner_t *device, int state);

/* --- the simulation */

typedef struct {
  playerc_device_t info;
} playerc_simulation_t;
PLAYERC_PROXY_FUNCTIONS(simulation)

int playerc_simulation_set_pose2d(playerc_simulation_t *device, const char *name, double gx, double gy,
                                  double ga);
int playerc_simulation_get_pose2d(playerc_simulation_t *device, const char *name, double *x, double *y,
                                  double *a);
int playerc_simulation_set_pose3d(playerc_simulation_t *device, const char *name, double gx, double gy,
                                  double gz, double groll, double gpitch, double gyaw);
int playerc_simulation_get_pose3d(playerc_simulation_t *device, const char *name, double *x, double *y,
                                  double *z, double *roll, double *pitch, double *yaw, double *time);
/** A property of a model as the bytes of its C type, of `value_len` bytes. */
int playerc_simulation_set_property(playerc_simulation_t *device, const char *name, const char *property,
                                    void *value, size_t value_len);
int playerc_simulation_get_property(playerc_simulation_t *device, const char *name, const char *property,
                                    void *value, size_t value_len);
/** Stops the run, or lets it go on. */
int playerc_simulation_pause(playerc_simulation_t *device);
int playerc_simulation_reset(playerc_simulation_t *device);
int playerc_simulation_save(playerc_simulation_t *device);

/* --- cameras, and what is found in their images */

typedef struct {
  playerc_device_t info;
  int width, height;
  int bpp;
  /** A PLAYER_CAMERA_FORMAT_ and a PLAYER_CAMERA_COMPRESS_ constant. */
  int format;
  int fdiv;
  int compression;
  int image_count;
  uint8_t *image;
  /** Of playerc_camera_get_source(). */
  char norm[16];
  int source;
} playerc_camera_t;
PLAYERC_PROXY_FUNCTIONS(camera)

/** Writes an uncompressed image to a file, as PPM. */
void playerc_camera_save(playerc_camera_t *device, const char *filename);
int playerc_camera_set_source(playerc_camera_t *device, int source, const char *norm);
int playerc_camera_get_source(playerc_camera_t *device);
int playerc_camera_get_image(playerc_camera_t *device);
/** Makes a JPEG image an uncompressed one of 24 bits, in place. It remains as it is if that fails, as
 * playerc_error_str() tells; an uncompressed one remains in any case. */
void playerc_camera_decompress(playerc_camera_t *device);
void playerc_camera_copy_image(playerc_camera_t *device, void *dst, size_t dst_size);
/** A component of a pixel of an uncompressed image of 8 or 24 bits; 0 if there is none. */
unsigned playerc_camera_get_pixel_component(playerc_camera_t *device, unsigned int x, unsigned int y,
                                            int component);

typedef player_pointcloud3d_stereo_element_t playerc_pointcloud3d_stereo_element_t;
typedef struct {
  playerc_device_t info;
  playerc_camera_t left_channel;
  playerc_camera_t right_channel;
  playerc_camera_t disparity;
  uint32_t points_count;
  playerc_pointcloud3d_stereo_element_t *points;
} playerc_stereo_t;
PLAYERC_PROXY_FUNCTIONS(stereo)

typedef player_blobfinder_blob_t playerc_blobfinder_blob_t;
typedef struct {
  playerc_device_t info;
  unsigned int width, height;
  unsigned int blobs_count;
  playerc_blobfinder_blob_t *blobs;
} playerc_blobfinder_t;
PLAYERC_PROXY_FUNCTIONS(blobfinder)

typedef struct {
  playerc_device_t info;
  /** Of playerc_fiducial_get_geom(). */
  player_fiducial_geom_t fiducial_geom;
  int fiducials_count;
  player_fiducial_item_t *fiducials;
} playerc_fiducial_t;
PLAYERC_PROXY_FUNCTIONS(fiducial)

int playerc_fiducial_get_geom(playerc_fiducial_t *device);

typedef struct {
  playerc_device_t info;
  /** In rad; zoom is the angle of view. */
  double pan, tilt;
  double zoom;
  int status;
} playerc_ptz_t;
PLAYERC_PROXY_FUNCTIONS(ptz)

int playerc_ptz_set(playerc_ptz_t *device, double pan, double tilt, double zoom);
int playerc_ptz_set_ws(playerc_ptz_t *device, double pan, double tilt, double zoom, double panspeed,
                       double tiltspeed);
int playerc_ptz_query_status(playerc_ptz_t *device);
int playerc_ptz_set_control_mode(playerc_ptz_t *device, int mode);

/* --- arms and grippers */

typedef struct {
  playerc_device_t info;
  /** Of playerc_gripper_get_geom(). */
  player_pose3d_t pose;
  player_bbox3d_t outer_size;
  player_bbox3d_t inner_size;
  uint8_t num_beams;
  uint8_t capacity;
  uint8_t state;
  uint32_t beams;
  uint8_t stored;
} playerc_gripper_t;
PLAYERC_PROXY_FUNCTIONS(gripper)

int playerc_gripper_open_cmd(playerc_gripper_t *device);
int playerc_gripper_close_cmd(playerc_gripper_t *device);
int playerc_gripper_stop_cmd(playerc_gripper_t *device);
int playerc_gripper_store_cmd(playerc_gripper_t *device);
int playerc_gripper_retrieve_cmd(playerc_gripper_t *device);
/** Prints a line; `prefix` may be NULL. */
void playerc_gripper_printout(playerc_gripper_t *device, const char *prefix);
int playerc_gripper_get_geom(playerc_gripper_t *device);

#define PLAYERC_ACTARRAY_ACTSTATE_IDLE PLAYER_ACTARRAY_ACTSTATE_IDLE
#define PLAYERC_ACTARRAY_ACTSTATE_MOVING PLAYER_ACTARRAY_ACTSTATE_MOVING
#define PLAYERC_ACTARRAY_ACTSTATE_BRAKED PLAYER_ACTARRAY_ACTSTATE_BRAKED
#define PLAYERC_ACTARRAY_ACTSTATE_STALLED PLAYER_ACTARRAY_ACTSTATE_STALLED
#define PLAYERC_ACTARRAY_TYPE_LINEAR PLAYER_ACTARRAY_TYPE_LINEAR
#define PLAYERC_ACTARRAY_TYPE_ROTARY PLAYER_ACTARRAY_TYPE_ROTARY

typedef struct {
  playerc_device_t info;
  uint32_t actuators_count;
  player_actarray_actuator_t *actuators_data;
  /** Of playerc_actarray_get_geom(). */
  uint32_t actuators_geom_count;
  player_actarray_actuatorgeom_t *actuators_geom;
  uint8_t motor_state;
  player_point_3d_t base_pos;
  player_orientation_3d_t base_orientation;
} playerc_actarray_t;
PLAYERC_PROXY_FUNCTIONS(actarray)

/** Zeros if there is no joint of that number. */
player_actarray_actuator_t playerc_actarray_get_actuator_data(playerc_actarray_t *device, uint32_t index);
player_actarray_actuatorgeom_t playerc_actarray_get_actuator_geom(playerc_actarray_t *device, uint32_t index);
int playerc_actarray_get_geom(playerc_actarray_t *device);
/** A joint of -1 stands for all of them, where the driver knows that. */
int playerc_actarray_position_cmd(playerc_actarray_t *device, int joint, float position);
int playerc_actarray_multi_position_cmd(playerc_actarray_t *device, float *positions, int positions_count);
int playerc_actarray_speed_cmd(playerc_actarray_t *device, int joint, float speed);
int playerc_actarray_multi_speed_cmd(playerc_actarray_t *device, float *speeds, int speeds_count);
int playerc_actarray_home_cmd(playerc_actarray_t *device, int joint);
int playerc_actarray_current_cmd(playerc_actarray_t *device, int joint, float current);
int playerc_actarray_multi_current_cmd(playerc_actarray_t *device, float *currents, int currents_count);
int playerc_actarray_power(playerc_actarray_t *device, uint8_t enable);
int playerc_actarray_brakes(playerc_actarray_t *device, uint8_t enable);
int playerc_actarray_speed_config(playerc_actarray_t *device, int joint, float speed);
int playerc_actarray_accel_config(playerc_actarray_t *device, int joint, float accel);

typedef struct {
  playerc_device_t info;
  player_limb_data_t data;
  /** Of playerc_limb_get_geom(). */
  player_limb_geom_req_t geom;
} playerc_limb_t;
PLAYERC_PROXY_FUNCTIONS(limb)

int playerc_limb_get_geom(playerc_limb_t *device);
int playerc_limb_home_cmd(playerc_limb_t *device);
int playerc_limb_stop_cmd(playerc_limb_t *device);
/** A position, an approach vector and an orientation vector. */
int playerc_limb_setpose_cmd(playerc_limb_t *device, float pX, float pY, float pZ, float aX, float aY,
                             float aZ, float oX, float oY, float oZ);
int playerc_limb_setposition_cmd(playerc_limb_t *device, float pX, float pY, float pZ);
int playerc_limb_vecmove_cmd(playerc_limb_t *device, float x, float y, float z, float length);
int playerc_limb_power(playerc_limb_t *device, uint32_t enable);
int playerc_limb_brakes(playerc_limb_t *device, uint32_t enable);
int playerc_limb_speed_config(playerc_limb_t *device, float speed);

/* --- where and how the robot is */

typedef struct {
  playerc_device_t info;
  /** In s since 1970. */
  double utc_time;
  /** In degrees, and m. */
  double lat, lon;
  double alt;
  double speed;
  double course;
  double utm_e, utm_n;
  double hdop;
  double vdop;
  double err_horz, err_vert;
  int quality;
  int sat_count;
} playerc_gps_t;
PLAYERC_PROXY_FUNCTIONS(gps)

typedef struct {
  playerc_device_t info;
  player_pose3d_t pose;
  player_pose3d_t vel;
  player_pose3d_t acc;
  player_imu_data_calib_t calib_data;
  float q0, q1, q2, q3;
} playerc_imu_t;
PLAYERC_PROXY_FUNCTIONS(imu)

/** `value`: a PLAYER_IMU_DATA_ constant. */
int playerc_imu_datatype(playerc_imu_t *device, int value);
int playerc_imu_reset_orientation(playerc_imu_t *device, int value);
int playerc_imu_reset_euler(playerc_imu_t *device, float roll, float pitch, float yaw);

typedef player_pointcloud3d_element_t playerc_pointcloud3d_element_t;
typedef struct {
  playerc_device_t info;
  /** 65535 of them at most. */
  uint16_t points_count;
  playerc_pointcloud3d_element_t *points;
} playerc_pointcloud3d_t;
PLAYERC_PROXY_FUNCTIONS(pointcloud3d)

typedef struct {
  playerc_device_t info;
  /** Bits PLAYER_POWER_MASK_: which of the others are valid. */
  int valid;
  /** In V, %, J and W. */
  double charge;
  double percent;
  double joules;
  double watts;
  int charging;
} playerc_power_t;
PLAYERC_PROXY_FUNCTIONS(power)

typedef struct {
  playerc_device_t info;
  player_health_cpu_t cpu_usage;
  player_health_memory_t mem;
  player_health_memory_t swap;
} playerc_health_t;
PLAYERC_PROXY_FUNCTIONS(health)

/* --- inputs and outputs */

typedef struct {
  playerc_device_t info;
  /** 255 at most. */
  uint8_t voltages_count;
  float *voltages;
} playerc_aio_t;
PLAYERC_PROXY_FUNCTIONS(aio)

int playerc_aio_set_output(playerc_aio_t *device, uint8_t id, float volt);
/** 0 if there is no input of that number. */
float playerc_aio_get_data(playerc_aio_t *device, uint32_t index);

typedef struct {
  playerc_device_t info;
  uint8_t count;
  uint32_t digin;
} playerc_dio_t;
PLAYERC_PROXY_FUNCTIONS(dio)

int playerc_dio_set_output(playerc_dio_t *device, uint8_t output_count, uint32_t digout);

typedef struct {
  playerc_device_t info;
  int32_t axes_count;
  int32_t pos[8];
  uint32_t buttons;
} playerc_joystick_t;
PLAYERC_PROXY_FUNCTIONS(joystick)

typedef struct {
  playerc_device_t info;
  uint32_t enabled;
  double duty_cycle;
  double period;
  uint8_t red, green, blue;
} playerc_blinkenlight_t;
PLAYERC_PROXY_FUNCTIONS(blinkenlight)

int playerc_blinkenlight_enable(playerc_blinkenlight_t *device, uint32_t enable);
int playerc_blinkenlight_color(playerc_blinkenlight_t *device, uint32_t id, uint8_t red, uint8_t green,
                               uint8_t blue);
int playerc_blinkenlight_blink(playerc_blinkenlight_t *device, uint32_t id, float period, float duty_cycle);

typedef struct {
  playerc_device_t info;
  /** What drawing uses. */
  player_color_t color;
} playerc_graphics2d_t;
PLAYERC_PROXY_FUNCTIONS(graphics2d)

int playerc_graphics2d_setcolor(playerc_graphics2d_t *device, player_color_t col);
int playerc_graphics2d_draw_points(playerc_graphics2d_t *device, player_point_2d_t pts[], int count);
int playerc_graphics2d_draw_polyline(playerc_graphics2d_t *device, player_point_2d_t pts[], int count);
/** A line from each point of even number to the next one. */
int playerc_graphics2d_draw_multiline(playerc_graphics2d_t *device, player_point_2d_t pts[], int count);
int playerc_graphics2d_draw_polygon(playerc_graphics2d_t *device, player_point_2d_t pts[], int count,
                                    int filled, player_color_t fill_color);
int playerc_graphics2d_clear(playerc_graphics2d_t *device);

typedef struct {
  playerc_device_t info;
  player_color_t color;
} playerc_graphics3d_t;
PLAYERC_PROXY_FUNCTIONS(graphics3d)

int playerc_graphics3d_setcolor(playerc_graphics3d_t *device, player_color_t col);
int playerc_graphics3d_draw(playerc_graphics3d_t *device, player_graphics3d_draw_mode_t mode,
                            player_point_3d_t pts[], int count);
int playerc_graphics3d_clear(playerc_graphics3d_t *device);
int playerc_graphics3d_translate(playerc_graphics3d_t *device, double x, double y, double z);
int playerc_graphics3d_rotate(playerc_graphics3d_t *device, double a, double x, double y, double z);

/* --- messages, texts and sounds */

typedef struct {
  playerc_device_t info;
  int data_count;
  uint8_t *data;
} playerc_opaque_t;
PLAYERC_PROXY_FUNCTIONS(opaque)

int playerc_opaque_cmd(playerc_opaque_t *device, player_opaque_data_t *data);
/** `reply`, which may be NULL, gets the answer: release it by player_opaque_data_t_free(). */
int playerc_opaque_req(playerc_opaque_t *device, player_opaque_data_t *request, player_opaque_data_t **reply);

#define PLAYERC_BLACKBOARD_DATA_TYPE_NONE 0
#define PLAYERC_BLACKBOARD_DATA_TYPE_SIMPLE 1
#define PLAYERC_BLACKBOARD_DATA_TYPE_COMPLEX 2
#define PLAYERC_BLACKBOARD_DATA_SUBTYPE_NONE 0
#define PLAYERC_BLACKBOARD_DATA_SUBTYPE_STRING 1
#define PLAYERC_BLACKBOARD_DATA_SUBTYPE_INT 2
#define PLAYERC_BLACKBOARD_DATA_SUBTYPE_DOUBLE 3

typedef struct playerc_blackboard {
  playerc_device_t info;
  /** Called with each entry that changes, if the program has set it; the entry belongs to the library. */
  void (*on_blackboard_event)(struct playerc_blackboard *, player_blackboard_entry_t);
  void *py_private;
} playerc_blackboard_t;
PLAYERC_PROXY_FUNCTIONS(blackboard)

/** `entry`, which may be NULL, gets the value: release it by player_blackboard_entry_t_free(). */
int playerc_blackboard_subscribe_to_key(playerc_blackboard_t *device, const char *key, const char *group,
                                        player_blackboard_entry_t **entry);
int playerc_blackboard_get_entry(playerc_blackboard_t *device, const char *key, const char *group,
                                 player_blackboard_entry_t **entry);
int playerc_blackboard_unsubscribe_from_key(playerc_blackboard_t *device, const char *key, const char *group);
int playerc_blackboard_subscribe_to_group(playerc_blackboard_t *device, const char *group);
int playerc_blackboard_unsubscribe_from_group(playerc_blackboard_t *device, const char *group);
int playerc_blackboard_set_entry(playerc_blackboard_t *device, player_blackboard_entry_t *entry);
int playerc_blackboard_set_string(playerc_blackboard_t *device, const char *key, const char *group,
                                  const char *value);
int playerc_blackboard_set_int(playerc_blackboard_t *device, const char *key, const char *group, int value);
int playerc_blackboard_set_double(playerc_blackboard_t *device, const char *key, const char *group,
                                  double value);

typedef struct {
  playerc_device_t info;
} playerc_speech_t;
PLAYERC_PROXY_FUNCTIONS(speech)

int playerc_speech_say(playerc_speech_t *device, const char *text);

typedef struct {
  playerc_device_t info;
  char *rawText;
  /** The words of it. */
  char **words;
  int wordCount;
} playerc_speechrecognition_t;
PLAYERC_PROXY_FUNCTIONS(speechrecognition)

typedef struct {
  playerc_device_t info;
  player_audio_mixer_channel_list_detail_t channel_details_list;
  player_audio_wav_t wav_data;
  player_audio_seq_t seq_data;
  player_audio_mixer_channel_list_t mixer_data;
  uint32_t state;
} playerc_audio_t;
PLAYERC_PROXY_FUNCTIONS(audio)

int playerc_audio_wav_play_cmd(playerc_audio_t *device, uint32_t data_count, uint8_t data[], uint32_t format);
int playerc_audio_wav_stream_rec_cmd(playerc_audio_t *device, uint8_t state);
int playerc_audio_sample_play_cmd(playerc_audio_t *device, int index);
int playerc_audio_seq_play_cmd(playerc_audio_t *device, player_audio_seq_t *tones);
int playerc_audio_mixer_multchannels_cmd(playerc_audio_t *device, player_audio_mixer_channel_list_t *levels);
int playerc_audio_mixer_channel_cmd(playerc_audio_t *device, uint32_t index, float amplitude, uint8_t active);
/** Sets wav_data. */
int playerc_audio_wav_rec(playerc_audio_t *device);
int playerc_audio_sample_load(playerc_audio_t *device, int index, uint32_t data_count, uint8_t data[],
                              uint32_t format);
/** Sets wav_data. */
int playerc_audio_sample_retrieve(playerc_audio_t *device, int index);
int playerc_audio_sample_rec(playerc_audio_t *device, int index, uint32_t length);
/** Set mixer_data and channel_details_list. */
int playerc_audio_get_mixer_levels(playerc_audio_t *device);
int playerc_audio_get_mixer_details(playerc_audio_t *device);

/* --- radios and tags */

typedef struct {
  /** Texts. */
  uint8_t mac[32];
  uint8_t ip[32];
  uint8_t essid[32];
  int mode;
  int encrypt;
  /** In MHz. */
  double freq;
  int qual, level, noise;
} playerc_wifi_link_t;

typedef struct {
  playerc_device_t info;
  playerc_wifi_link_t *links;
  int link_count;
  char ip[32];
} playerc_wifi_t;
PLAYERC_PROXY_FUNCTIONS(wifi)

/** NULL if there is no link of that number. */
playerc_wifi_link_t *playerc_wifi_get_link(playerc_wifi_t *device, int link);

typedef struct {
  uint32_t type;
  uint32_t guid_count;
  uint8_t *guid;
} playerc_rfidtag_t;

typedef struct {
  playerc_device_t info;
  /** 65535 of them at most. */
  uint16_t tags_count;
  playerc_rfidtag_t *tags;
} playerc_rfid_t;
PLAYERC_PROXY_FUNCTIONS(rfid)

typedef struct {
  playerc_device_t info;
  uint32_t node_type;
  uint32_t node_id;
  uint32_t node_parent_id;
  player_wsn_node_data_t data_packet;
} playerc_wsn_t;
PLAYERC_PROXY_FUNCTIONS(wsn)

int playerc_wsn_set_devstate(playerc_wsn_t *device, int node_id, int group_id, int devnr, int state);
int playerc_wsn_power(playerc_wsn_t *device, int node_id, int group_id, int value);
int playerc_wsn_datatype(playerc_wsn_t *device, int value);
int playerc_wsn_datafreq(playerc_wsn_t *device, int node_id, int group_id, double frequency);

typedef struct {
  playerc_device_t info;
  /** What the last message was: a PLAYER_COOPOBJECT_MSG_ constant, or the type of bytes that users define. */
  int messageType;
  /** Its sender, a PLAYER_COOPOBJECT_ORIGIN_ constant, and the node that relayed it. */
  uint8_t origin;
  uint16_t id;
  uint16_t parent_id;
  /** The last of each kind of message. */
  uint16_t RSSIsender, RSSIvalue, RSSIstamp;
  uint32_t RSSInodeTimeHigh, RSSInodeTimeLow;
  float x, y, z;
  uint8_t status;
  uint32_t sensor_data_count;
  player_coopobject_sensor_t *sensor_data;
  uint32_t alarm_data_count;
  player_coopobject_sensor_t *alarm_data;
  uint32_t user_data_count;
  uint8_t *user_data;
  uint8_t command;
  uint8_t request;
  /** Of the last command or request. */
  uint32_t parameters_count;
  uint8_t *parameters;
} playerc_coopobject_t;
PLAYERC_PROXY_FUNCTIONS(coopobject)

/** The heading goes as z. */
int playerc_coopobject_send_position(playerc_coopobject_t *device, uint16_t node_id, uint16_t source_id,
                                     player_pose2d_t pos, uint8_t status);
int playerc_coopobject_send_data(playerc_coopobject_t *device, int node_id, int source_id, int data_type,
                                 int data_size, unsigned char *extradata);
int playerc_coopobject_send_cmd(playerc_coopobject_t *device, int node_id, int source_id, int command,
                                int cmd_parameters_size, unsigned char *cmd_parameters);
int playerc_coopobject_send_req(playerc_coopobject_t *device, int node_id, int source_id, int request,
                                int req_parameters_size, unsigned char *req_parameters);

/* --- logs */

typedef struct {
  playerc_device_t info;
  /** Of playerc_log_get_state(): a PLAYER_LOG_TYPE_ constant, and whether it runs. */
  int type;
  int state;
} playerc_log_t;
PLAYERC_PROXY_FUNCTIONS(log)

int playerc_log_set_write_state(playerc_log_t *device, int state);
int playerc_log_set_read_state(playerc_log_t *device, int state);
int playerc_log_set_read_rewind(playerc_log_t *device);
int playerc_log_get_state(playerc_log_t *device);
int playerc_log_set_filename(playerc_log_t *device, const char *fname);

#ifdef __cplusplus
}
#endif

#endif /* LIBPLAYERC_PLAYERC_H */
