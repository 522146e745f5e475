/** Proxies of devices that few robots have, a part of playerc++.h. */
#ifndef LIBPLAYERCPP_EQUIPMENT_H
#define LIBPLAYERCPP_EQUIPMENT_H

#ifndef PLAYERCC_BASE
#error "include <libplayerc++/playerc++.h>"
#endif

namespace PlayerCc {

class Position1dProxy : public PLAYERCC_BASE(position1d) {
 public:
  Position1dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetSpeed(double aVel) { PLAYERCC_DO(playerc_position1d_set_cmd_vel, mDevice, aVel, 1); }
  void GoTo(double aPos, double aVel) {
    PLAYERCC_DO(playerc_position1d_set_cmd_pos_with_vel, mDevice, aPos, aVel, 1);
  }
  void SetMotorEnable(bool enable) { PLAYERCC_DO(playerc_position1d_enable, mDevice, enable ? 1 : 0); }
  void SetOdometry(double aPos) { PLAYERCC_DO(playerc_position1d_set_odom, mDevice, aPos); }
  void ResetOdometry() { SetOdometry(0); }
  void RequestGeom() { PLAYERCC_DO(playerc_position1d_get_geom, mDevice); }
  player_pose3d_t GetPose() const {
    scoped_lock_t lock(mPc->mMutex);
    const player_pose3d_t pose = {mDevice->pose[0], mDevice->pose[1], 0, 0, 0, mDevice->pose[2]};
    return pose;
  }
  player_bbox3d_t GetSize() const {
    scoped_lock_t lock(mPc->mMutex);
    const player_bbox3d_t size = {mDevice->size[1], mDevice->size[0], 0};
    return size;
  }
  double GetPos() const { return GetVar(mDevice->pos); }
  double GetVel() const { return GetVar(mDevice->vel); }
  bool GetStall() const { return GetVar(mDevice->stall) != 0; }
  uint8_t GetStatus() const { return static_cast<uint8_t>(GetVar(mDevice->status)); }
  bool IsLimitMin() const { return Has(PLAYER_POSITION1D_STATUS_LIMIT_MIN); }
  bool IsLimitCen() const { return Has(PLAYER_POSITION1D_STATUS_LIMIT_CEN); }
  bool IsLimitMax() const { return Has(PLAYER_POSITION1D_STATUS_LIMIT_MAX); }
  bool IsOverCurrent() const { return Has(PLAYER_POSITION1D_STATUS_OC); }
  bool IsTrajComplete() const { return Has(PLAYER_POSITION1D_STATUS_TRAJ_COMPLETE); }
  bool IsEnabled() const { return Has(PLAYER_POSITION1D_STATUS_ENABLED); }

 private:
  bool Has(int bit) const { return (GetStatus() >> bit & 1) != 0; }
};

class LimbProxy : public PLAYERCC_BASE(limb) {
 public:
  LimbProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void RequestGeometry() { PLAYERCC_DO(playerc_limb_get_geom, mDevice); }
  void SetPowerConfig(bool aVal) { PLAYERCC_DO(playerc_limb_power, mDevice, aVal ? 1 : 0); }
  void SetBrakesConfig(bool aVal) { PLAYERCC_DO(playerc_limb_brakes, mDevice, aVal ? 1 : 0); }
  void SetSpeedConfig(float aSpeed) { PLAYERCC_DO(playerc_limb_speed_config, mDevice, aSpeed); }
  void MoveHome() { PLAYERCC_DO(playerc_limb_home_cmd, mDevice); }
  void Stop() { PLAYERCC_DO(playerc_limb_stop_cmd, mDevice); }
  void SetPose(float aPX, float aPY, float aPZ, float aAX, float aAY, float aAZ, float aOX, float aOY,
               float aOZ) {
    PLAYERCC_DO(playerc_limb_setpose_cmd, mDevice, aPX, aPY, aPZ, aAX, aAY, aAZ, aOX, aOY, aOZ);
  }
  void SetPosition(float aX, float aY, float aZ) {
    PLAYERCC_DO(playerc_limb_setposition_cmd, mDevice, aX, aY, aZ);
  }
  void VectorMove(float aX, float aY, float aZ, float aLength) {
    PLAYERCC_DO(playerc_limb_vecmove_cmd, mDevice, aX, aY, aZ, aLength);
  }
  player_limb_data_t GetData() const { return GetVar(mDevice->data); }
  player_limb_geom_req_t GetGeom() const { return GetVar(mDevice->geom); }
};

class RFIDProxy : public PLAYERCC_BASE(rfid) {
 public:
  RFIDProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetTagsCount() const { return GetVar(mDevice->tags_count); }
  playerc_rfidtag_t GetRFIDTag(uint32_t aIndex) const {
    return GetElement<playerc_rfidtag_t>(mDevice->tags, mDevice->tags_count, aIndex);
  }
  playerc_rfidtag_t operator[](uint32_t aIndex) const { return GetRFIDTag(aIndex); }
};

class WSNProxy : public PLAYERCC_BASE(wsn) {
 public:
  WSNProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetNodeType() const { return GetVar(mDevice->node_type); }
  uint32_t GetNodeID() const { return GetVar(mDevice->node_id); }
  uint32_t GetNodeParentID() const { return GetVar(mDevice->node_parent_id); }
  player_wsn_node_data_t GetNodeDataPacket() const { return GetVar(mDevice->data_packet); }
  void SetDevState(int nodeID, int groupID, int devNr, int value) {
    PLAYERCC_DO(playerc_wsn_set_devstate, mDevice, nodeID, groupID, devNr, value);
  }
  void Power(int nodeID, int groupID, int value) {
    PLAYERCC_DO(playerc_wsn_power, mDevice, nodeID, groupID, value);
  }
  void DataType(int value) { PLAYERCC_DO(playerc_wsn_datatype, mDevice, value); }
  void DataFreq(int nodeID, int groupID, float frequency) {
    PLAYERCC_DO(playerc_wsn_datafreq, mDevice, nodeID, groupID, static_cast<double>(frequency));
  }
};

class CoopObjectProxy : public PLAYERCC_BASE(coopobject) {
 public:
  CoopObjectProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex), id_(aIndex) {}

  int MessageType() const { return GetVar(mDevice->messageType); }
  uint32_t GetOrigin() const { return GetVar(mDevice->origin); }
  uint32_t GetID() const { return GetVar(mDevice->id); }
  uint32_t GetParentID() const { return GetVar(mDevice->parent_id); }
  /** What is sent comes from this node, by default that of the index. */
  uint32_t GetProxyID() const { return GetVar(id_); }
  void SetProxyID(uint32_t value) {
    scoped_lock_t lock(mPc->mMutex);
    id_ = value;
  }
  uint32_t GetSensorNumber() const { return GetVar(mDevice->sensor_data_count); }
  uint8_t GetSensorType(uint32_t index) const { return Sensor(index).type; }
  uint16_t GetSensorData(uint32_t index) const { return static_cast<uint16_t>(Sensor(index).value); }
  uint32_t GetAlarmNumber() const { return GetVar(mDevice->alarm_data_count); }
  uint8_t GetAlarmType(uint32_t index) const { return Alarm(index).type; }
  uint16_t GetAlarmData(uint32_t index) const { return static_cast<uint16_t>(Alarm(index).value); }
  uint32_t GetUserDataNumber() const { return GetVar(mDevice->user_data_count); }
  /** Valid until the next data, as the parameters of commands and requests. */
  uint8_t *GetAllUserData() const { return GetVar(mDevice->user_data); }
  uint8_t GetUserData(uint32_t index) const {
    return Byte(mDevice->user_data, mDevice->user_data_count, index);
  }
  uint8_t *GetAllParameters() const { return GetVar(mDevice->parameters); }
  uint32_t GetParametersSize() const { return GetVar(mDevice->parameters_count); }
  uint8_t GetParameter(uint32_t index) const {
    return Byte(mDevice->parameters, mDevice->parameters_count, index);
  }
  uint32_t GetCommand() const { return GetVar(mDevice->command); }
  uint32_t GetRequest() const { return GetVar(mDevice->request); }
  /** Of the last message about a signal. */
  uint16_t GetRSSIsenderId() const { return GetVar(mDevice->RSSIsender); }
  uint16_t GetRSSIvalue() const { return GetVar(mDevice->RSSIvalue); }
  uint16_t GetRSSIstamp() const { return GetVar(mDevice->RSSIstamp); }
  double GetRSSInodeTime() const {
    scoped_lock_t lock(mPc->mMutex);
    return mDevice->RSSInodeTimeHigh + 1e-6 * mDevice->RSSInodeTimeLow;
  }
  /** Of the last message about a position (m). */
  float GetX() const { return GetVar(mDevice->x); }
  float GetY() const { return GetVar(mDevice->y); }
  float GetZ() const { return GetVar(mDevice->z); }
  uint8_t GetStatus() const { return GetVar(mDevice->status); }
  /** The source is the node of this proxy, as in the original. */
  void SendData(int nodeID, int, player_pose2d_t pos, int status) {
    PLAYERCC_DO(playerc_coopobject_send_position, mDevice, static_cast<uint16_t>(nodeID),
                static_cast<uint16_t>(id_), pos, static_cast<uint8_t>(status));
  }
  void SendData(int nodeID, int, int extradata_type, uint32_t extradata_size, unsigned char *extradata) {
    PLAYERCC_DO(playerc_coopobject_send_data, mDevice, nodeID, static_cast<int>(id_), extradata_type,
                static_cast<int>(extradata_size), extradata);
  }
  void SendCommand(int nodeID, int, int command, uint32_t cmd_parameters_size = 0,
                   unsigned char *cmd_parameters = NULL) {
    PLAYERCC_DO(playerc_coopobject_send_cmd, mDevice, nodeID, static_cast<int>(id_), command,
                static_cast<int>(cmd_parameters_size), cmd_parameters);
  }
  void SendRequest(int nodeID, int, int request, uint32_t req_parameters_size = 0,
                   unsigned char *req_parameters = NULL) {
    PLAYERCC_DO(playerc_coopobject_send_req, mDevice, nodeID, static_cast<int>(id_), request,
                static_cast<int>(req_parameters_size), req_parameters);
  }

 private:
  player_coopobject_sensor_t Sensor(uint32_t index) const {
    return GetElement<player_coopobject_sensor_t>(mDevice->sensor_data, mDevice->sensor_data_count, index);
  }
  player_coopobject_sensor_t Alarm(uint32_t index) const {
    return GetElement<player_coopobject_sensor_t>(mDevice->alarm_data, mDevice->alarm_data_count, index);
  }

  /** 255 if there is none of that number, as in the original. */
  uint8_t Byte(uint8_t *const &bytes, const uint32_t &count, uint32_t index) const {
    scoped_lock_t lock(mPc->mMutex);
    return index < count ? bytes[index] : static_cast<uint8_t>(0xFF);
  }

  uint32_t id_;
};

class LinuxjoystickProxy : public PLAYERCC_BASE(joystick) {
 public:
  LinuxjoystickProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  /** A bit for each. */
  uint32_t GetButtons() const { return GetVar(mDevice->buttons); }
  uint32_t GetAxesCount() const { return static_cast<uint32_t>(GetVar(mDevice->axes_count)); }
  /** -1 if there is no axis of that number. */
  double GetAxes(uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    return aIndex < GetAxesCount() && aIndex < 8 ? mDevice->pos[aIndex] : -1.0;
  }
  double operator[](uint32_t aIndex) const { return GetAxes(aIndex); }
};

/** What it returns as pointers is valid until the next data. A link that does not exist throws. */
class WiFiProxy : public PLAYERCC_BASE(wifi) {
 public:
  WiFiProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  const playerc_wifi_link_t *GetLink(int aLink) const {
    scoped_lock_t lock(mPc->mMutex);
    const playerc_wifi_link_t *const link = playerc_wifi_get_link(mDevice, aLink);
    if (link == NULL) throw PlayerError("WiFiProxy::GetLink()", "there is no such link");
    return link;
  }
  int GetLinkCount() const { return GetVar(mDevice->link_count); }
  char *GetOwnIP() const { return mDevice->ip; }
  char *GetLinkIP(int index) const { return Text(GetLink(index)->ip); }
  char *GetLinkMAC(int index) const { return Text(GetLink(index)->mac); }
  char *GetLinkESSID(int index) const { return Text(GetLink(index)->essid); }
  double GetLinkFreq(int index) const { return Number(index, &playerc_wifi_link_t::freq); }
  int GetLinkMode(int index) const { return Number(index, &playerc_wifi_link_t::mode); }
  int GetLinkEncrypt(int index) const { return Number(index, &playerc_wifi_link_t::encrypt); }
  int GetLinkQuality(int index) const { return Number(index, &playerc_wifi_link_t::qual); }
  int GetLinkLevel(int index) const { return Number(index, &playerc_wifi_link_t::level); }
  int GetLinkNoise(int index) const { return Number(index, &playerc_wifi_link_t::noise); }

 private:
  /** Of a link, read under the lock. */
  template <typename T>
  T Number(int index, T playerc_wifi_link_t::*member) const {
    scoped_lock_t lock(mPc->mMutex);
    return GetLink(index)->*member;
  }
  static char *Text(const uint8_t *text) { return const_cast<char *>(reinterpret_cast<const char *>(text)); }
};

class HealthProxy : public PLAYERCC_BASE(health) {
 public:
  HealthProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  /** In percent. */
  float GetIdleCPU() const { return GetVar(mDevice->cpu_usage.idle); }
  float GetSystemCPU() const { return GetVar(mDevice->cpu_usage.system); }
  float GetUserCPU() const { return GetVar(mDevice->cpu_usage.user); }
  int64_t GetMemTotal() const { return GetVar(mDevice->mem.total); }
  int64_t GetMemUsed() const { return GetVar(mDevice->mem.used); }
  int64_t GetMemFree() const { return GetVar(mDevice->mem.free); }
  int64_t GetSwapTotal() const { return GetVar(mDevice->swap.total); }
  int64_t GetSwapUsed() const { return GetVar(mDevice->swap.used); }
  int64_t GetSwapFree() const { return GetVar(mDevice->swap.free); }
  /** In percent; 0 of nothing. */
  float GetPercMemUsed() const { return Percent(GetMemUsed(), GetMemTotal()); }
  float GetPercSwapUsed() const { return Percent(GetSwapUsed(), GetSwapTotal()); }
  float GetPercTotalUsed() const {
    scoped_lock_t lock(mPc->mMutex);
    return Percent(GetMemUsed() + GetSwapUsed(), GetMemTotal() + GetSwapTotal());
  }

 private:
  static float Percent(int64_t part, int64_t whole) {
    return whole > 0 ? static_cast<float>(100.0 * static_cast<double>(part) / static_cast<double>(whole)) : 0;
  }
};

class LogProxy : public PLAYERCC_BASE(log) {
 public:
  LogProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void QueryState() { PLAYERCC_DO(playerc_log_get_state, mDevice); }
  /** Of QueryState(). */
  int GetType() const { return GetVar(mDevice->type); }
  int GetState() const { return GetVar(mDevice->state); }
  /** Of reading or writing, whichever the device does. */
  void SetState(int aState) {
    if (GetType() == 0) QueryState();
    GetType() == PLAYER_LOG_TYPE_WRITE ? SetWriteState(aState) : SetReadState(aState);
  }
  void SetWriteState(int aState) { PLAYERCC_DO(playerc_log_set_write_state, mDevice, aState); }
  void SetReadState(int aState) { PLAYERCC_DO(playerc_log_set_read_state, mDevice, aState); }
  void Rewind() { PLAYERCC_DO(playerc_log_set_read_rewind, mDevice); }
  void SetFilename(const std::string aFilename) {
    PLAYERCC_DO(playerc_log_set_filename, mDevice, aFilename.c_str());
  }
};

class BlackBoardProxy : public PLAYERCC_BASE(blackboard) {
 public:
  BlackBoardProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  /** Release the entry by player_blackboard_entry_t_free(). */
  player_blackboard_entry_t *SubscribeToKey(const char *key, const char *group = "") {
    player_blackboard_entry_t *entry = NULL;
    PLAYERCC_DO(playerc_blackboard_subscribe_to_key, mDevice, key, group, &entry);
    return entry;
  }
  player_blackboard_entry_t *GetEntry(const char *key, const char *group) {
    player_blackboard_entry_t *entry = NULL;
    PLAYERCC_DO(playerc_blackboard_get_entry, mDevice, key, group, &entry);
    return entry;
  }
  void UnsubscribeFromKey(const char *key, const char *group = "") {
    PLAYERCC_DO(playerc_blackboard_unsubscribe_from_key, mDevice, key, group);
  }
  void SubscribeToGroup(const char *group) {
    PLAYERCC_DO(playerc_blackboard_subscribe_to_group, mDevice, group);
  }
  void UnsubscribeFromGroup(const char *group) {
    PLAYERCC_DO(playerc_blackboard_unsubscribe_from_group, mDevice, group);
  }
  void SetEntry(const player_blackboard_entry_t &entry) {
    player_blackboard_entry_t copy = entry;
    PLAYERCC_DO(playerc_blackboard_set_entry, mDevice, &copy);
  }
  void SetEventHandler(void (*on_blackboard_event)(playerc_blackboard_t *, player_blackboard_entry_t)) {
    scoped_lock_t lock(mPc->mMutex);
    mDevice->on_blackboard_event = on_blackboard_event;
  }
};

class AudioProxy : public PLAYERCC_BASE(audio) {
 public:
  AudioProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  /** Of GetMixerDetails(). */
  uint32_t GetMixerDetailsCount() const { return GetVar(mDevice->channel_details_list.details_count); }
  player_audio_mixer_channel_detail_t GetMixerDetails(int aIndex) const {
    return GetElement<player_audio_mixer_channel_detail_t>(mDevice->channel_details_list.details,
                                                           mDevice->channel_details_list.details_count,
                                                           static_cast<uint32_t>(aIndex));
  }
  uint32_t GetDefaultOutputChannel() const {
    return static_cast<uint32_t>(GetVar(mDevice->channel_details_list.default_output));
  }
  uint32_t GetDefaultInputChannel() const {
    return static_cast<uint32_t>(GetVar(mDevice->channel_details_list.default_input));
  }
  /** Of RecordWav() or GetSample(), or of data. */
  uint32_t GetWavDataLength() const { return GetVar(mDevice->wav_data.data_count); }
  void GetWavData(uint8_t *aData) const {
    scoped_lock_t lock(mPc->mMutex);
    for (uint32_t i = 0; i < mDevice->wav_data.data_count; ++i) aData[i] = mDevice->wav_data.data[i];
  }
  uint32_t GetSeqCount() const { return GetVar(mDevice->seq_data.tones_count); }
  player_audio_seq_item_t GetSeqItem(int aIndex) const {
    return GetElement<player_audio_seq_item_t>(mDevice->seq_data.tones, mDevice->seq_data.tones_count,
                                               static_cast<uint32_t>(aIndex));
  }
  uint32_t GetChannelCount() const { return GetVar(mDevice->mixer_data.channels_count); }
  player_audio_mixer_channel_t GetChannel(int aIndex) const {
    return GetElement<player_audio_mixer_channel_t>(
        mDevice->mixer_data.channels, mDevice->mixer_data.channels_count, static_cast<uint32_t>(aIndex));
  }
  uint32_t GetState() const { return GetVar(mDevice->state); }
  void PlayWav(uint32_t aDataCount, uint8_t *aData, uint32_t aFormat) {
    PLAYERCC_DO(playerc_audio_wav_play_cmd, mDevice, aDataCount, aData, aFormat);
  }
  /** The name is the original's. */
  void SetWavStremRec(bool aState) {
    PLAYERCC_DO(playerc_audio_wav_stream_rec_cmd, mDevice, static_cast<uint8_t>(aState ? 1 : 0));
  }
  void PlaySample(int aIndex) { PLAYERCC_DO(playerc_audio_sample_play_cmd, mDevice, aIndex); }
  void PlaySeq(player_audio_seq_t *aTones) { PLAYERCC_DO(playerc_audio_seq_play_cmd, mDevice, aTones); }
  void SetMultMixerLevels(player_audio_mixer_channel_list_t *aLevels) {
    PLAYERCC_DO(playerc_audio_mixer_multchannels_cmd, mDevice, aLevels);
  }
  void SetMixerLevel(uint32_t index, float amplitude, uint8_t active) {
    PLAYERCC_DO(playerc_audio_mixer_channel_cmd, mDevice, index, amplitude, active);
  }
  void RecordWav() { PLAYERCC_DO(playerc_audio_wav_rec, mDevice); }
  void LoadSample(int aIndex, uint32_t aDataCount, uint8_t *aData, uint32_t aFormat) {
    PLAYERCC_DO(playerc_audio_sample_load, mDevice, aIndex, aDataCount, aData, aFormat);
  }
  void GetSample(int aIndex) { PLAYERCC_DO(playerc_audio_sample_retrieve, mDevice, aIndex); }
  void RecordSample(int aIndex, uint32_t aLength) {
    PLAYERCC_DO(playerc_audio_sample_rec, mDevice, aIndex, aLength);
  }
  void GetMixerLevels() { PLAYERCC_DO(playerc_audio_get_mixer_levels, mDevice); }
  void GetMixerDetails() { PLAYERCC_DO(playerc_audio_get_mixer_details, mDevice); }
};

class VectorMapProxy : public PLAYERCC_BASE(vectormap) {
 public:
  VectorMapProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void GetMapInfo() { PLAYERCC_DO(playerc_vectormap_get_map_info, mDevice); }
  void GetLayerData(unsigned layer_index) {
    PLAYERCC_DO(playerc_vectormap_get_layer_data, mDevice, layer_index);
  }
  int GetLayerCount() const { return static_cast<int>(GetVar(mDevice->layers_count)); }
  std::vector<std::string> GetLayerNames() const {
    scoped_lock_t lock(mPc->mMutex);
    std::vector<std::string> names;
    for (uint32_t i = 0; i < mDevice->layers_count; ++i) {
      const char *const name = mDevice->layers_info[i]->name;
      names.push_back(name != NULL ? name : "");
    }
    return names;
  }
  /** Of GetLayerData(); 0 before. */
  int GetFeatureCount(unsigned layer_index) const {
    scoped_lock_t lock(mPc->mMutex);
    const player_vectormap_layer_data_t *const layer =
        GetElement<player_vectormap_layer_data_t *>(mDevice->layers_data, mDevice->layers_count, layer_index);
    return layer != NULL ? static_cast<int>(layer->features_count) : 0;
  }
  const uint8_t *GetFeatureData(unsigned layer_index, unsigned feature_index) const {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_vectormap_get_feature_data(mDevice, layer_index, feature_index);
  }
  size_t GetFeatureDataCount(unsigned layer_index, unsigned feature_index) const {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_vectormap_get_feature_data_count(mDevice, layer_index, feature_index);
  }
};

class Graphics3dProxy : public PLAYERCC_BASE(graphics3d) {
 public:
  Graphics3dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void Color(player_color_t col) { PLAYERCC_DO(playerc_graphics3d_setcolor, mDevice, col); }
  void Color(uint8_t red, uint8_t green, uint8_t blue, uint8_t alpha) {
    const player_color_t color = {alpha, red, green, blue};
    Color(color);
  }
  void Clear() { PLAYERCC_DO(playerc_graphics3d_clear, mDevice); }
  void Draw(player_graphics3d_draw_mode_t mode, player_point_3d_t pts[], int count) {
    PLAYERCC_DO(playerc_graphics3d_draw, mDevice, mode, pts, count);
  }
};

/** Two images, and how far apart they see what they see. */
class StereoProxy : public PLAYERCC_BASE(stereo) {
 public:
  StereoProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex), frames_() {}

  void SaveLeftFrame(const std::string aPrefix, uint32_t aWidth = 4) {
    Save(mDevice->left_channel, frames_[0], aPrefix, aWidth);
  }
  void SaveRightFrame(const std::string aPrefix, uint32_t aWidth = 4) {
    Save(mDevice->right_channel, frames_[1], aPrefix, aWidth);
  }
  void SaveDisparityFrame(const std::string aPrefix, uint32_t aWidth = 4) {
    Save(mDevice->disparity, frames_[2], aPrefix, aWidth);
  }
  void DecompressLeft() { Decompress(mDevice->left_channel); }
  void DecompressRight() { Decompress(mDevice->right_channel); }
  void DecompressDisparity() { Decompress(mDevice->disparity); }

/** What there is of each of the three images. */
#define PLAYERCC_CHANNEL(NAME, MEMBER)                                                                     \
  uint32_t Get##NAME##Depth() const {                                                                      \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.bpp));                                             \
  }                                                                                                        \
  uint32_t Get##NAME##Width() const {                                                                      \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.width));                                           \
  }                                                                                                        \
  uint32_t Get##NAME##Height() const {                                                                     \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.height));                                          \
  }                                                                                                        \
  uint32_t Get##NAME##Format() const {                                                                     \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.format));                                          \
  }                                                                                                        \
  uint32_t Get##NAME##ImageSize() const {                                                                  \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.image_count));                                     \
  }                                                                                                        \
  uint32_t Get##NAME##Compression() const {                                                                \
    return static_cast<uint32_t>(GetVar(mDevice->MEMBER.compression));                                     \
  }                                                                                                        \
  void Get##NAME##Image(uint8_t *aImage) const {                                                           \
    scoped_lock_t lock(mPc->mMutex);                                                                       \
    playerc_camera_copy_image(&mDevice->MEMBER, aImage, static_cast<size_t>(mDevice->MEMBER.image_count)); \
  }
  PLAYERCC_CHANNEL(Left, left_channel)
  PLAYERCC_CHANNEL(Right, right_channel)
  PLAYERCC_CHANNEL(Disparity, disparity)
#undef PLAYERCC_CHANNEL

  uint32_t GetCount() const {
    return GetVar(mDevice->points_count);
  }
  player_pointcloud3d_stereo_element_t GetPoint(uint32_t aIndex) const {
    return GetElement<player_pointcloud3d_stereo_element_t>(mDevice->points, mDevice->points_count, aIndex);
  }
  player_pointcloud3d_stereo_element_t operator[](uint32_t aIndex) const {
    return GetPoint(aIndex);
  }

 private:
  void Save(playerc_camera_t &image, uint32_t &frame, const std::string &prefix, uint32_t width) {
    scoped_lock_t lock(mPc->mMutex);
    playerc_camera_save(&image, FrameFile(prefix, frame++, width).c_str());
  }
  void Decompress(playerc_camera_t &image) {
    scoped_lock_t lock(mPc->mMutex);
    playerc_camera_decompress(&image);
  }

  uint32_t frames_[3];
};

class Pointcloud3dProxy : public PLAYERCC_BASE(pointcloud3d) {
 public:
  Pointcloud3dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return GetVar(mDevice->points_count); }
  player_pointcloud3d_element_t GetPoint(uint32_t aIndex) const {
    return GetElement<player_pointcloud3d_element_t>(mDevice->points, mDevice->points_count, aIndex);
  }
  player_pointcloud3d_element_t operator[](uint32_t aIndex) const { return GetPoint(aIndex); }
};

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_EQUIPMENT_H */
