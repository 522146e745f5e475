/** Cooperating objects: nodes and robots that report to each other. */
#include "inside.h"

static void put_sender(playerc_coopobject_t *device, const player_coopobject_header_t *header, int type) {
  device->messageType = type;
  device->origin = header->origin;
  device->id = header->id;
  device->parent_id = header->parent_id;
}

static void put_position(playerc_coopobject_t *device, float x, float y, float z) {
  device->x = x;
  device->y = y;
  device->z = z;
}

static void put_strength(playerc_coopobject_t *device, const player_coopobject_rssi_t *data) {
  put_sender(device, &data->header, PLAYER_COOPOBJECT_MSG_RSSI);
  device->RSSIsender = data->sender_id;
  device->RSSIvalue = data->rssi;
  device->RSSIstamp = data->stamp;
  device->RSSInodeTimeHigh = data->nodeTimeHigh;
  device->RSSInodeTimeLow = data->nodeTimeLow;
  put_position(device, data->x, data->y, data->z);
}

static void put_parameters(playerc_coopobject_t *device, const uint8_t *bytes, uint32_t count) {
  if (playerc_keep(&device->parameters, bytes, count, 1)) device->parameters_count = count;
}

/** The first member of each message is its sender. */
static void put_coopobject(void *proxy, char *header, char *body) {
  playerc_coopobject_t *device = proxy;
  const void *message = body;
  const player_coopobject_position_t *place = message;
  const player_coopobject_data_sensor_t *sensors = message;
  const player_coopobject_data_userdefined_t *user = message;
  const player_coopobject_req_t *request = message;
  const player_coopobject_cmd_t *command = message;
  switch (playerc_subtype(header)) {
    case PLAYER_COOPOBJECT_DATA_HEALTH:
      put_sender(device, message, PLAYER_COOPOBJECT_MSG_HEALTH);
      break;
    case PLAYER_COOPOBJECT_DATA_RSSI:
      put_strength(device, message);
      break;
    case PLAYER_COOPOBJECT_DATA_POSITION:
      put_sender(device, &place->header, PLAYER_COOPOBJECT_MSG_POSITION);
      put_position(device, place->x, place->y, place->z);
      device->status = place->status;
      break;
    case PLAYER_COOPOBJECT_DATA_SENSOR:
      put_sender(device, &sensors->header, PLAYER_COOPOBJECT_MSG_SENSOR);
      if (playerc_keep(&device->sensor_data, sensors->data, sensors->data_count, sizeof *sensors->data))
        device->sensor_data_count = sensors->data_count;
      break;
    case PLAYER_COOPOBJECT_DATA_ALARM:
      put_sender(device, &sensors->header, PLAYER_COOPOBJECT_MSG_ALARM);
      if (playerc_keep(&device->alarm_data, sensors->data, sensors->data_count, sizeof *sensors->data))
        device->alarm_data_count = sensors->data_count;
      break;
    case PLAYER_COOPOBJECT_DATA_USERDEFINED:
      put_sender(device, &user->header, user->type);
      if (playerc_keep(&device->user_data, user->data, user->data_count, 1))
        device->user_data_count = user->data_count;
      break;
    case PLAYER_COOPOBJECT_DATA_REQUEST:
      put_sender(device, &request->header, PLAYER_COOPOBJECT_MSG_REQUEST);
      device->request = request->request;
      put_parameters(device, request->parameters, request->parameters_count);
      break;
    case PLAYER_COOPOBJECT_DATA_COMMAND:
      put_sender(device, &command->header, PLAYER_COOPOBJECT_MSG_COMMAND);
      device->command = command->command;
      put_parameters(device, command->parameters, command->parameters_count);
      break;
    default:
      break;
  }
}

playerc_coopobject_t *playerc_coopobject_create(playerc_client_t *client, int index) {
  playerc_coopobject_t *device =
      playerc_proxy_create(sizeof *device, client, PLAYER_COOPOBJECT_CODE, index, put_coopobject);
  if (device != NULL) device->messageType = PLAYER_COOPOBJECT_MSG_NONE;
  return device;
}

void playerc_coopobject_destroy(playerc_coopobject_t *device) {
  if (device == NULL) return;
  free(device->sensor_data);
  free(device->alarm_data);
  free(device->user_data);
  free(device->parameters);
  playerc_proxy_destroy(&device->info);
}

int playerc_coopobject_subscribe(playerc_coopobject_t *device, int access) {
  return playerc_device_subscribe(&device->info, access);
}

int playerc_coopobject_unsubscribe(playerc_coopobject_t *device) {
  return playerc_device_unsubscribe(&device->info);
}

static player_coopobject_header_t to_node(int node_id, int source_id) {
  const player_coopobject_header_t header = {PLAYER_COOPOBJECT_ORIGIN_ROBOT, (uint16_t)node_id,
                                             (uint16_t)source_id};
  return header;
}

/** Their number, 0 of a negative one. */
static uint32_t bytes_of(int size) {
  return size > 0 ? (uint32_t)size : 0;
}

int playerc_coopobject_send_position(playerc_coopobject_t *device, uint16_t node_id, uint16_t source_id,
                                     player_pose2d_t pos, uint8_t status) {
  const player_coopobject_position_t place = {to_node(node_id, source_id), (float)pos.px, (float)pos.py,
                                              (float)pos.pa, status};
  return playerc_command(&device->info, PLAYER_COOPOBJECT_CMD_POSITION, &place);
}

int playerc_coopobject_send_data(playerc_coopobject_t *device, int node_id, int source_id, int data_type,
                                 int data_size, unsigned char *extradata) {
  const player_coopobject_data_userdefined_t data = {to_node(node_id, source_id), (uint8_t)data_type,
                                                     bytes_of(data_size), extradata};
  return playerc_command(&device->info, PLAYER_COOPOBJECT_CMD_DATA, &data);
}

int playerc_coopobject_send_cmd(playerc_coopobject_t *device, int node_id, int source_id, int command,
                                int cmd_parameters_size, unsigned char *cmd_parameters) {
  const player_coopobject_cmd_t order = {to_node(node_id, source_id), (uint8_t)command,
                                         bytes_of(cmd_parameters_size), cmd_parameters};
  return playerc_command(&device->info, PLAYER_COOPOBJECT_CMD_STANDARD, &order);
}

int playerc_coopobject_send_req(playerc_coopobject_t *device, int node_id, int source_id, int request,
                                int req_parameters_size, unsigned char *req_parameters) {
  const player_coopobject_req_t asked = {to_node(node_id, source_id), (uint8_t)request,
                                         bytes_of(req_parameters_size), req_parameters};
  return playerc_tell(&device->info, PLAYER_COOPOBJECT_REQ_STANDARD, &asked);
}
