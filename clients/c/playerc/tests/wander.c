/* As programs of a first course in robotics are: wander PORT drives ahead until a wall is near, turns, and says what it
 * saw. */
#include <libplayerc/playerc.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, const char **argv)
{
  int i, turned = 0, bad = 0;
  playerc_client_t *client;
  playerc_position2d_t *position2d;
  playerc_laser_t *laser;

  client = playerc_client_create(NULL, "localhost", argc > 1 ? atoi(argv[1]) : 6665);
  if (0 != playerc_client_connect(client))
  {
    fprintf(stderr, "error: %s\n", playerc_error_str());
    return -1;
  }
  position2d = playerc_position2d_create(client, 0);
  if (playerc_position2d_subscribe(position2d, PLAYER_OPEN_MODE))
    return -1;
  laser = playerc_laser_create(client, 0);
  if (playerc_laser_subscribe(laser, PLAYERC_OPEN_MODE) != 0)
    return -1;
  if (playerc_client_datamode(client, PLAYERC_DATAMODE_PULL) != 0)
    return -1;
  if (playerc_client_set_replace_rule(client, -1, -1, PLAYER_MSGTYPE_DATA, -1, 1) != 0)
    return -1;
  playerc_position2d_enable(position2d, 1);
  playerc_position2d_get_geom(position2d);
  playerc_laser_get_geom(laser);
  printf("size %.2f %.2f\n", position2d->size[0], position2d->size[1]);

  while (!turned || position2d->pa < DTOR(45))
  {
    if (playerc_client_read(client) != client->id)
      return -1;
    if (!laser->info.fresh)
      continue;
    laser->info.fresh = 0;
    for (i = 0; i < laser->scan_count; i++)
      if (laser->scan[i][0] != laser->ranges[i] || laser->point[i].px != laser->ranges[i] * cos(laser->scan[i][1]))
        bad++;
    turned = turned || laser->ranges[laser->scan_count / 2] < 1.0;
    playerc_position2d_set_cmd_vel(position2d, turned ? 0 : 0.4, 0, turned ? DTOR(40) : 0, 1);
  }
  printf("beams %d start %.4f step %.4f max %.1f bad %d\n", laser->scan_count, laser->scan_start, laser->scan_res,
         laser->max_range, bad);
  printf("pose %.2f %.2f %.2f time %d\n", position2d->px, position2d->py, position2d->pa,
         position2d->info.datatime > position2d->info.lasttime);

  playerc_position2d_unsubscribe(position2d);
  playerc_position2d_destroy(position2d);
  playerc_laser_unsubscribe(laser);
  playerc_laser_destroy(laser);
  playerc_client_disconnect(client);
  playerc_client_destroy(client);
  return 0;
}
