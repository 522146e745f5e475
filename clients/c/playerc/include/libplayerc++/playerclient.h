/** A connection to a server: a part of playerc++.h, which programs include alone as well. */
#ifndef LIBPLAYERCPP_PLAYERCLIENT_H
#define LIBPLAYERCPP_PLAYERCLIENT_H

#include <libplayerc++/playererror.h>
#include <libplayerc++/utility.h>
#include <libplayerc/playerc.h>
#include <unistd.h>  // programs expect sleep() of this header

#include <atomic>
#include <chrono>
#include <exception>
#include <list>
#include <mutex>
#include <thread>

namespace PlayerCc {

/** Throws the reason of the last call of the C library that failed. */
inline void Insist(int result, const char *fun) {
  if (result != 0) throw PlayerError(fun, playerc_error_str(), result);
}

class ClientProxy;

/** A connection to a server; one lock guards it and its proxies. */
class PlayerClient {
 public:
  typedef std::recursive_mutex mutex_t;
  typedef std::unique_lock<mutex_t> scoped_lock_t;

  /** Connects, or throws. */
  PlayerClient(const std::string aHostname = PLAYER_HOSTNAME, uint32_t aPort = PLAYER_PORTNUM,
               int transport = PLAYERC_TRANSPORT_TCP)
      : mClient(playerc_client_create(NULL, aHostname.c_str(), static_cast<int>(aPort))) {
    if (mClient == NULL) throw PlayerError("PlayerClient::PlayerClient()", playerc_error_str());
    playerc_client_set_transport(mClient, static_cast<unsigned>(transport));
    if (playerc_client_connect(mClient) == 0) return;
    const PlayerError error("PlayerClient::PlayerClient()", playerc_error_str());
    playerc_client_destroy(mClient);
    throw error;
  }
  ~PlayerClient() {
    StopThread();
    playerc_client_destroy(mClient);
  }
  PlayerClient(const PlayerClient &) = delete;
  PlayerClient &operator=(const PlayerClient &) = delete;

  bool Connected() { return mClient->connected != 0; }
  std::string GetHostname() const { return mClient->host; }
  uint32_t GetPort() const { return static_cast<uint32_t>(mClient->port); }
  int GetTransport() const { return mClient->transport; }
  /** How many messages the server has dropped since the last call. */
  uint32_t GetOverflowCount() {
    scoped_lock_t lock(mMutex);
    const uint32_t count = mClient->overflow_count;
    mClient->overflow_count = 0;
    return count;
  }

  /** Waits for data: a round of them in pull mode, a message in push mode. Then calls what
   * ClientProxy::ConnectReadSignal() has connected to the proxies that got some. */
  void Read();
  /** Whether there are data within so many ms. */
  bool Peek(uint32_t timeout = 0) {
    scoped_lock_t lock(mMutex);
    return playerc_client_peek(mClient, static_cast<int>(timeout)) > 0;
  }
  void ReadIfWaiting() {
    if (Peek()) Read();
  }
  void SetDataMode(uint32_t aMode) {
    scoped_lock_t lock(mMutex);
    Insist(playerc_client_datamode(mClient, static_cast<uint8_t>(aMode)), "PlayerClient::SetDataMode()");
  }
  void RequestData() {
    scoped_lock_t lock(mMutex);
    Insist(playerc_client_requestdata(mClient), "PlayerClient::RequestData()");
  }
  void SetReplaceRule(bool aReplace, int aType = -1, int aSubtype = -1, int aInterf = -1) {
    scoped_lock_t lock(mMutex);
    Insist(playerc_client_set_replace_rule(mClient, aInterf, -1, aType, aSubtype, aReplace ? 1 : 0),
           "PlayerClient::SetReplaceRule()");
  }
  void RequestDeviceList() {
    scoped_lock_t lock(mMutex);
    Insist(playerc_client_get_devlist(mClient), "PlayerClient::RequestDeviceList()");
  }
  std::list<playerc_device_info_t> GetDeviceList() {
    scoped_lock_t lock(mMutex);
    return std::list<playerc_device_info_t>(mClient->devinfos, mClient->devinfos + mClient->devinfo_count);
  }
  void SetRequestTimeout(uint32_t seconds) { playerc_client_set_request_timeout(mClient, seconds); }
  void SetRetryLimit(int limit) { playerc_client_set_retry_limit(mClient, limit); }
  int GetRetryLimit() { return mClient->retry_limit; }
  void SetRetryTime(double time) { playerc_client_set_retry_time(mClient, time); }
  double GetRetryTime() { return mClient->retry_time; }
  int LookupCode(std::string aName) const { return str_to_interf(aName.c_str()); }
  std::string LookupName(int aCode) const { return interf_to_str(static_cast<uint16_t>(aCode)); }

  /** Reads whatever comes, until Stop(); looks every so many ms. */
  void Run(uint32_t aTimeout = 10) {
    while (!mStop) {
      if (HasData(aTimeout)) Read();
    }
  }
  void Stop() { mStop = true; }
  /** The same in a thread, until StopThread() or an exception, which is printed. Also again after these. */
  void StartThread() {
    if (mRuns && !mStop) return;
    StopThread();
    mStop = false;
    if (IsThread()) return;  // which goes on
    mRuns = true;
    mThread = std::thread([this] { RunAlone(); });
  }
  /** From a function that the thread calls, it ends after that call. */
  void StopThread() {
    Stop();
    if (mThread.joinable() && !IsThread()) mThread.join();
  }

  playerc_client_t *mClient;
  mutable mutex_t mMutex;
  std::list<ClientProxy *> mProxyList;

 private:
  /** Waits without the lock, so that others may use the proxies meanwhile. */
  bool HasData(uint32_t timeout) {
    if (Peek()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout));
    return Peek();
  }

  bool IsThread() const { return mRunner == std::this_thread::get_id(); }
  void RunAlone() {
    mRunner = std::this_thread::get_id();
    try {
      Run();
    } catch (const PlayerError &error) {  // the run has ended, or the server is gone
      std::cerr << error << std::endl;
    } catch (const std::exception &error) {  // of a function that is connected
      std::cerr << "PlayerClient::StartThread(): " << error.what() << std::endl;
    } catch (...) {
      std::cerr << "PlayerClient::StartThread(): an exception of a kind that is not known" << std::endl;
    }
    mRunner = std::thread::id();
    mRuns = false;
  }

  std::atomic<bool> mStop{false};
  std::atomic<bool> mRuns{false};  // the thread
  std::atomic<std::thread::id> mRunner{std::thread::id()};
  std::thread mThread;
};

inline std::ostream &operator<<(std::ostream &os, const PlayerClient &client) {
  return os << client.GetHostname() << ":" << client.GetPort();
}

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_PLAYERCLIENT_H */
