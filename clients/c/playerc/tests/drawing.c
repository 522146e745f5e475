/* drawing PORT draws a triangle on the floor and a line above it, in the frame of a robot. */
#include <libplayerc/playerc.h>
#include <stdlib.h>

int main(int argc, char *argv[])
{
  player_point_2d_t corners[3] = {{1, -0.5}, {1, 0.5}, {2, 0}};
  player_point_3d_t ends[2] = {{0, 0, 0}, {0, 0, 1}};
  player_color_t red, fill;
  playerc_client_t *client;
  playerc_simulation_t *simulation;
  playerc_graphics2d_t *floor;
  playerc_graphics3d_t *space;
  double x, y, a;
  (void)argc;

  memset(&red, 0, sizeof red);
  red.red = 255;
  fill = red;
  fill.alpha = 51;
  client = playerc_client_create(NULL, "127.0.0.1", atoi(argv[1]));
  if (playerc_client_connect(client) != 0)
    return 1;
  floor = playerc_graphics2d_create(client, 0);
  space = playerc_graphics3d_create(client, 0);
  simulation = playerc_simulation_create(client, 0);
  if (playerc_graphics2d_subscribe(floor, PLAYER_OPEN_MODE) != 0 ||
      playerc_graphics3d_subscribe(space, PLAYER_OPEN_MODE) != 0 ||
      playerc_simulation_subscribe(simulation, PLAYER_OPEN_MODE) != 0)
    return 1;
  playerc_graphics2d_clear(floor);
  playerc_graphics2d_setcolor(floor, red);
  playerc_graphics2d_draw_polygon(floor, corners, 3, 1, fill);
  playerc_graphics3d_setcolor(space, red);
  playerc_graphics3d_translate(space, 0, 0, 0.5);
  playerc_graphics3d_draw(space, PLAYER_DRAW_LINES, ends, 2);
  /* Answered behind what was drawn. */
  if (playerc_simulation_get_pose2d(simulation, "r", &x, &y, &a) != 0)
    return 1;
  playerc_graphics2d_destroy(floor);
  playerc_graphics3d_destroy(space);
  playerc_simulation_destroy(simulation);
  playerc_client_destroy(client);
  return 0;
}
