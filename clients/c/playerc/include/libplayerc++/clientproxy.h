/** What all proxies have: a part of playerc++.h, which programs include alone as well. */
#ifndef LIBPLAYERCPP_CLIENTPROXY_H
#define LIBPLAYERCPP_CLIENTPROXY_H

#include <libplayerc++/playerclient.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace PlayerCc {

/** A program may have proxies of its own: their constructor sets mInfo, their destructor unsubscribes. */
class ClientProxy {
  struct Subscriber {
    explicit Subscriber(std::function<void()> what) : call(std::move(what)), connected(true) {}
    std::function<void()> call;
    std::atomic<bool> connected;
  };

 public:
  typedef PlayerClient::scoped_lock_t scoped_lock_t;

  /** What ConnectReadSignal() has connected; it may outlive the proxy. */
  class connection_t {
   public:
    connection_t() {}
    bool connected() const {
      const std::shared_ptr<Subscriber> subscriber = subscriber_.lock();
      return subscriber && subscriber->connected;
    }
    void disconnect() const {
      if (const std::shared_ptr<Subscriber> subscriber = subscriber_.lock()) subscriber->connected = false;
    }

   private:
    friend class ClientProxy;
    explicit connection_t(const std::shared_ptr<Subscriber> &subscriber) : subscriber_(subscriber) {}
    std::weak_ptr<Subscriber> subscriber_;
  };

  virtual ~ClientProxy() {
    scoped_lock_t lock(mPc->mMutex);
    Leave();
  }
  ClientProxy(const ClientProxy &) = delete;
  ClientProxy &operator=(const ClientProxy &) = delete;

  /** Whether any data have come. */
  bool IsValid() const { return GetVar(mInfo->datatime) != 0.0; }
  /** Whether data have come since NotFresh(). */
  bool IsFresh() const { return GetVar(mInfo->fresh) != 0; }
  void NotFresh() {
    scoped_lock_t lock(mPc->mMutex);
    mInfo->fresh = 0;
  }
  std::string GetDriverName() const { return mInfo->drivername; }
  /** The server's time of the last data, and how much later than those before they are (s). */
  double GetDataTime() const { return GetVar(mInfo->datatime); }
  double GetElapsedTime() const {
    scoped_lock_t lock(mPc->mMutex);
    return mInfo->datatime - mInfo->lasttime;
  }
  PlayerClient *GetPlayerClient() const { return mPc; }
  uint32_t GetIndex() const { return mInfo->addr.index; }
  uint32_t GetInterface() const { return mInfo->addr.interf; }
  std::string GetInterfaceStr() const { return interf_to_str(mInfo->addr.interf); }
  void SetReplaceRule(bool aReplace, int aType = -1, int aSubtype = -1) {
    scoped_lock_t lock(mPc->mMutex);
    Insist(playerc_client_set_replace_rule(mPc->mClient, mInfo->addr.interf, mInfo->addr.index, aType,
                                           aSubtype, aReplace ? 1 : 0),
           "ClientProxy::SetReplaceRule()");
  }
  int HasCapability(uint32_t aType, uint32_t aSubtype) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_hascapability(mInfo, aType, aSubtype) == 0 ? 1 : 0;
  }
  int GetBoolProp(char *property, bool *value) {
    scoped_lock_t lock(mPc->mMutex);
    BOOL told = FALSE;
    const int result = playerc_device_get_boolprop(mInfo, property, &told);
    if (result == 0) *value = told != FALSE;
    return result;
  }
  int SetBoolProp(char *property, bool value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_set_boolprop(mInfo, property, value ? TRUE : FALSE);
  }
  int GetIntProp(char *property, int32_t *value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_get_intprop(mInfo, property, value);
  }
  int SetIntProp(char *property, int32_t value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_set_intprop(mInfo, property, value);
  }
  int GetDblProp(char *property, double *value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_get_dblprop(mInfo, property, value);
  }
  int SetDblProp(char *property, double value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_set_dblprop(mInfo, property, value);
  }
  int GetStrProp(char *property, char **value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_get_strprop(mInfo, property, value);
  }
  int SetStrProp(char *property, char *value) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_device_set_strprop(mInfo, property, value);
  }

  /** Has PlayerClient::Read() call `aSubscriber`, a function or an object without arguments, after new data of this
   * proxy, in the thread that reads, under the lock. It may disconnect itself and others, and destroy proxies. */
  template <typename T>
  connection_t ConnectReadSignal(T aSubscriber) {
    scoped_lock_t lock(mPc->mMutex);
    subscribers_.push_back(std::make_shared<Subscriber>(aSubscriber));
    return connection_t(subscribers_.back());
  }
  void DisconnectReadSignal(connection_t aSubscriber) { aSubscriber.disconnect(); }
  /** For PlayerClient, after reading: the proxy may be destroyed by what it calls. */
  void ReadSignal() {
    if (mInfo == NULL || mInfo->datatime == told_) return;
    told_ = mInfo->datatime;
    const auto is_over = [](const std::shared_ptr<Subscriber> &each) { return !each->connected; };
    subscribers_.erase(std::remove_if(subscribers_.begin(), subscribers_.end(), is_over), subscribers_.end());
    const std::vector<std::shared_ptr<Subscriber>> subscribers = subscribers_;
    for (const std::shared_ptr<Subscriber> &each : subscribers) {
      if (each->connected) each->call();
    }
  }

 protected:
  /** The index is for proxies of programs: their constructor calls Subscribe() by itself, as it did. */
  explicit ClientProxy(PlayerClient *aPc, uint32_t = 0)
      : mPc(aPc), mClient(aPc->mClient), mInfo(NULL), told_(0), absent_told_(false) {
    scoped_lock_t lock(mPc->mMutex);
    mPc->mProxyList.push_back(this);
  }
  virtual void Subscribe(uint32_t) {}
  virtual void Unsubscribe() {}

  /** A member of the proxy, read under the lock. */
  template <typename T>
  T GetVar(const T &aV) const {
    scoped_lock_t lock(mPc->mMutex);
    return aV;
  }
  /** A list of it, copied under the lock. */
  template <typename T>
  void GetVarByRef(const T aBegin, const T aEnd, T aDest) const {
    scoped_lock_t lock(mPc->mMutex);
    std::copy(aBegin, aEnd, aDest);
  }
  /** An element of a list of `count`. If there is none of that number it is zeros, as before the first data, so that
   * programs that count one too far go on; then a line on standard error tells once. */
  template <typename T, typename Count>
  T GetElement(T *const &list, const Count &count, uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    if (aIndex < static_cast<uint32_t>(count)) return list[aIndex];
    if (IsValid() && !absent_told_) {
      absent_told_ = true;
      std::cerr << "ClientProxy: " << Absent(aIndex, count) << ": zeros" << std::endl;
    }
    return T();
  }
  /** "there is no element 3 of 3 of laser" */
  std::string Absent(uint32_t aIndex, int64_t count) const {
    return "there is no element " + std::to_string(aIndex) + " of " + std::to_string(count) + " of " +
           GetInterfaceStr();
  }
  /** Before the proxy goes, under the lock: what ReadSignal() is about to call may use it. */
  void Leave() {
    for (const std::shared_ptr<Subscriber> &each : subscribers_) each->connected = false;
    mPc->mProxyList.remove(this);
  }
  /** Fails as `fun` unless the result is 0. */
  void Check(int result, const char *fun) const { Insist(result, fun); }

  PlayerClient *mPc;
  playerc_client_t *mClient;
  playerc_device_t *mInfo;

 private:
  std::vector<std::shared_ptr<Subscriber>> subscribers_;
  double told_;  // time of the data that the subscribers know of
  mutable bool absent_told_;
};

inline void PlayerClient::Read() {
  scoped_lock_t lock(mMutex);
  if (playerc_client_read(mClient) == NULL) throw PlayerError("PlayerClient::Read()", playerc_error_str());
  const std::list<ClientProxy *> proxies = mProxyList;
  for (ClientProxy *const each : proxies) {
    if (std::find(mProxyList.begin(), mProxyList.end(), each) != mProxyList.end()) each->ReadSignal();
  }
}

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_CLIENTPROXY_H */
