/* udp PORT reads a laser by UDP, drives, and tells how far the robot came. */
#include <libplayerc/playerc.h>
#include <stdlib.h>

int main(int argc, char *argv[]) {
  int i, rounds = 0;
  playerc_client_t *client;
  playerc_laser_t *laser;
  playerc_position2d_t *position;
  (void)argc;

  client = playerc_client_create(NULL, "127.0.0.1", atoi(argv[1]));
  playerc_client_set_transport(client, PLAYERC_TRANSPORT_UDP);
  if (playerc_client_connect(client) != 0) {
    printf("%s\n", playerc_error_str());
    return 1;
  }
  laser = playerc_laser_create(client, 0);
  position = playerc_position2d_create(client, 0);
  if (playerc_laser_subscribe(laser, PLAYER_OPEN_MODE) ||
      playerc_position2d_subscribe(position, PLAYER_OPEN_MODE))
    return 1;
  for (i = 0; i < 500 && position->px < 0.3; i++) {
    if (playerc_client_read(client) == NULL) return 1;
    if (playerc_position2d_set_cmd_vel(position, 0.5, 0, 0, 1) != 0) return 1;
    rounds += laser->scan_count == 181;
  }
  printf("came %.1f, %s\n", position->px, rounds > 0 ? "scans of 181 beams" : "no scan");
  playerc_position2d_set_cmd_vel(position, 0, 0, 0, 1);
  playerc_client_disconnect(client);
  playerc_client_destroy(client);
  return 0;
}
