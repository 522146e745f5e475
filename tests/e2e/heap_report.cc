// Preloaded into a program (LD_PRELOAD) it makes the program print what glibc's heap has in
// use on each SIGUSR2, as malloc_stats(3) does: resident memory also counts freed blocks that
// the heap keeps, which is a matter of how the blocks happen to lie.

#include <malloc.h>
#include <pthread.h>
#include <signal.h>

#include <thread>

namespace {

[[gnu::constructor]] void start() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGUSR2);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // threads that start later inherit it
  std::thread([signals] {
    for (int signal = 0; sigwait(&signals, &signal) == 0;) malloc_stats();
  }).detach();
}

}  // namespace
