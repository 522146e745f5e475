/* push PORT reads single messages and tells the proxies apart by what reading returns; ends with the run. */
#include <libplayerc/playerc.h>
#include <stdlib.h>

static int calls = 0;

static void called(void *data)
{
  playerc_laser_t *laser = data;
  if (laser->scan_count > 0)
    calls++;
}

int main(int argc, char **argv)
{
  int positions = 0, lasers = 0, others = 0;
  playerc_client_t *client = playerc_client_create(NULL, "localhost", argc > 1 ? atoi(argv[1]) : 6665);
  playerc_position2d_t *pos2d = playerc_position2d_create(client, 0);
  playerc_laser_t *laser = playerc_laser_create(client, 0);
  void *id;

  if (0 != playerc_client_connect(client))
    return 1;
  if (playerc_position2d_subscribe(pos2d, PLAYER_OPEN_MODE) || playerc_laser_subscribe(laser, PLAYER_OPEN_MODE))
    return 1;
  playerc_client_addcallback(client, &laser->info, called, laser);
  if (0 != playerc_client_datamode(client, PLAYERC_DATAMODE_PUSH))
    return 1;
  while (positions < 5 || lasers < 5)
  {
    id = playerc_client_read(client);
    if (id == NULL)
      return 1;
    if (id == pos2d->info.id)
      positions++;
    else if (id == laser->info.id)
      lasers++;
    else
      others++;
  }
  printf("others %d calls %s\n", others, calls == lasers ? "as many" : "not as many");
  fflush(stdout);
  while (playerc_client_read(client) != NULL)
    ;
  printf("%s\n", playerc_error_str());
  playerc_position2d_destroy(pos2d);
  playerc_laser_destroy(laser);
  playerc_client_destroy(client);
  return 0;
}
