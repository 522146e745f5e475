#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <poll.h>
#include <string.h>

#include "exchange.h"

playerc_mclient_t *playerc_mclient_create(void) {
  playerc_mclient_t *mclient = calloc(1, sizeof *mclient);
  if (mclient != NULL)
    mclient->pollfd = calloc(sizeof mclient->client / sizeof *mclient->client, sizeof *mclient->pollfd);
  if (mclient != NULL && mclient->pollfd != NULL) return mclient;
  free(mclient);
  playerc_fail_no_memory();
  return NULL;
}

void playerc_mclient_destroy(playerc_mclient_t *mclient) {
  if (mclient == NULL) return;
  free(mclient->pollfd);
  free(mclient);
}

int playerc_mclient_addclient(playerc_mclient_t *mclient, playerc_client_t *client) {
  const int most = sizeof mclient->client / sizeof *mclient->client;
  if (mclient->client_count >= most) return playerc_fail("%d clients are read together at most", most);
  mclient->client[mclient->client_count++] = client;
  return 0;
}

int playerc_mclient_peek(playerc_mclient_t *mclient, int timeout) {
  int here = 0;
  for (int i = 0; i < mclient->client_count; ++i) {
    const int result = playerc_client_peek(mclient->client[i], 0);
    if (result < 0) return -1;
    here += result;
    mclient->pollfd[i] = (struct pollfd){.fd = mclient->client[i]->sock, .events = POLLIN};
  }
  if (here > 0) return here;
  const int count = poll(mclient->pollfd, (nfds_t)mclient->client_count, timeout);
  if (count >= 0 || errno == EINTR) return count > 0 ? count : 0;
  return playerc_fail("cannot wait for data: %s", strerror(errno));
}

int playerc_mclient_read(playerc_mclient_t *mclient, int timeout) {
  int count = playerc_mclient_peek(mclient, timeout);
  if (count <= 0) return count;
  count = 0;
  for (int i = 0; i < mclient->client_count; ++i) {
    playerc_client_t *client = mclient->client[i];
    const int result = playerc_client_read_nonblock(client);
    if (result < 0) return -1;
    count += result;
    if (client->datatime > mclient->time) mclient->time = client->datatime;
  }
  return count;
}
