/* devices PORT lists the devices, and tries what a server refuses. */
#include <libplayerc/playerc.h>
#include <libplayercore/playercore.h>
#include <stdlib.h>

int main(int argc, char *argv[])
{
  int i;
  int32_t value;
  playerc_client_t *client;
  playerc_simulation_t *simulation;
  playerc_laser_t *laser;
  double x, y, a;
  (void)argc;

  client = playerc_client_create(NULL, "127.0.0.1", atoi(argv[1]));
  playerc_client_set_transport(client, PLAYERC_TRANSPORT_UDP);
  printf("udp %d: %s\n", playerc_client_connect(client), playerc_error_str());
  playerc_client_set_transport(client, PLAYERC_TRANSPORT_TCP);
  if (playerc_client_connect(client) != 0 || playerc_client_get_devlist(client) != 0)
    return 1;
  for (i = 0; i < client->devinfo_count; i++)
    printf("%s:%d (%s)\n", interf_to_str(client->devinfos[i].addr.interf), client->devinfos[i].addr.index,
           client->devinfos[i].drivername);
  laser = playerc_laser_create(client, 7);
  i = playerc_laser_subscribe(laser, PLAYER_OPEN_MODE);
  printf("laser:7 %d %s\n", i, strstr(playerc_error_str(), "there is no laser:7"));
  simulation = playerc_simulation_create(client, 0);
  if (playerc_simulation_subscribe(simulation, PLAYER_OPEN_MODE))
    return 1;
  printf("driver %s\n", simulation->info.drivername);
  printf("nobody %d\n", playerc_simulation_get_pose2d(simulation, "nobody", &x, &y, &a));
  printf("property %d\n", playerc_device_get_intprop(&simulation->info, "no such thing", &value));
  if (playerc_simulation_set_pose2d(simulation, "r1", 1.5, -2, 0.5) != 0 ||
      playerc_simulation_get_pose2d(simulation, "r1", &x, &y, &a) != 0)
    return 1;
  printf("r1 %.2f %.2f %.2f\n", x, y, a);
  playerc_simulation_destroy(simulation);
  playerc_laser_destroy(laser);
  playerc_client_destroy(client);
  return 0;
}
