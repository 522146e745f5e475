// Generated from interfaces/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Every struct as a list of fields, and every message as a type. For tests that fill values at random and check
/// properties of all messages. each_field(m, f) calls f.field(member), f.list(member, max) for counted and dynamic
/// arrays, f.fixed_text(member, length) for text of fixed length. each_message(f) calls f.operator()<Payload>(name).

#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/power.h"
#include "playhouse/wire/generated/gripper.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/sonar.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/blobfinder.h"
#include "playhouse/wire/generated/ptz.h"
#include "playhouse/wire/generated/audio.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/speech.h"
#include "playhouse/wire/generated/gps.h"
#include "playhouse/wire/generated/bumper.h"
#include "playhouse/wire/generated/dio.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/ir.h"
#include "playhouse/wire/generated/wifi.h"
#include "playhouse/wire/generated/localize.h"
#include "playhouse/wire/generated/position3d.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/wire/generated/blinkenlight.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse/wire/generated/planner.h"
#include "playhouse/wire/generated/log.h"
#include "playhouse/wire/generated/joystick.h"
#include "playhouse/wire/generated/speech_recognition.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/generated/position1d.h"
#include "playhouse/wire/generated/actarray.h"
#include "playhouse/wire/generated/limb.h"
#include "playhouse/wire/generated/graphics2d.h"
#include "playhouse/wire/generated/rfid.h"
#include "playhouse/wire/generated/wsn.h"
#include "playhouse/wire/generated/graphics3d.h"
#include "playhouse/wire/generated/health.h"
#include "playhouse/wire/generated/imu.h"
#include "playhouse/wire/generated/pointcloud3d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/vectormap.h"
#include "playhouse/wire/generated/blackboard.h"
#include "playhouse/wire/generated/stereo.h"
#include "playhouse/wire/generated/coopobject.h"

namespace playhouse::wire {

template <typename F>
void each_field(Devaddr& m, F& f) {
  f.field(m.host);
  f.field(m.robot);
  f.field(m.interf);
  f.field(m.index);
}

template <typename F>
void each_field(Point2d& m, F& f) {
  f.field(m.px);
  f.field(m.py);
}

template <typename F>
void each_field(Point3d& m, F& f) {
  f.field(m.px);
  f.field(m.py);
  f.field(m.pz);
}

template <typename F>
void each_field(Orientation3d& m, F& f) {
  f.field(m.proll);
  f.field(m.ppitch);
  f.field(m.pyaw);
}

template <typename F>
void each_field(Pose2d& m, F& f) {
  f.field(m.px);
  f.field(m.py);
  f.field(m.pa);
}

template <typename F>
void each_field(Pose3d& m, F& f) {
  f.field(m.px);
  f.field(m.py);
  f.field(m.pz);
  f.field(m.proll);
  f.field(m.ppitch);
  f.field(m.pyaw);
}

template <typename F>
void each_field(Bbox2d& m, F& f) {
  f.field(m.sw);
  f.field(m.sl);
}

template <typename F>
void each_field(Bbox3d& m, F& f) {
  f.field(m.sw);
  f.field(m.sl);
  f.field(m.sh);
}

template <typename F>
void each_field(BlackboardEntry& m, F& f) {
  f.list(m.key, 33554392);
  f.list(m.group, 33554392);
  f.field(m.type);
  f.field(m.subtype);
  f.list(m.data, 33554392);
  f.field(m.timestamp_sec);
  f.field(m.timestamp_usec);
}

template <typename F>
void each_field(Segment& m, F& f) {
  f.field(m.x0);
  f.field(m.y0);
  f.field(m.x1);
  f.field(m.y1);
}

template <typename F>
void each_field(Extent2d& m, F& f) {
  f.field(m.x0);
  f.field(m.y0);
  f.field(m.x1);
  f.field(m.y1);
}

template <typename F>
void each_field(Color& m, F& f) {
  f.field(m.alpha);
  f.field(m.red);
  f.field(m.green);
  f.field(m.blue);
}

template <typename F>
void each_field(Bool& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(Uint32& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(CapabilitiesReq& m, F& f) {
  f.field(m.type);
  f.field(m.subtype);
}

template <typename F>
void each_field(BoolpropReq& m, F& f) {
  f.list(m.key, 33554392);
  f.field(m.value);
}

template <typename F>
void each_field(IntpropReq& m, F& f) {
  f.list(m.key, 33554392);
  f.field(m.value);
}

template <typename F>
void each_field(DblpropReq& m, F& f) {
  f.list(m.key, 33554392);
  f.field(m.value);
}

template <typename F>
void each_field(StrpropReq& m, F& f) {
  f.list(m.key, 33554392);
  f.list(m.value, 33554392);
}

}  // namespace playhouse::wire

namespace playhouse::wire::player {

template <typename F>
void each_field(DeviceDevlist& m, F& f) {
  f.list(m.devices, 4096);
}

template <typename F>
void each_field(DeviceDriverinfo& m, F& f) {
  f.field(m.addr);
  f.list(m.driver_name, 64);
}

template <typename F>
void each_field(DeviceReq& m, F& f) {
  f.field(m.addr);
  f.field(m.access);
  f.list(m.driver_name, 64);
}

template <typename F>
void each_field(DeviceDatamodeReq& m, F& f) {
  f.field(m.mode);
}

template <typename F>
void each_field(DeviceAuthReq& m, F& f) {
  f.list(m.auth_key, 32);
}

template <typename F>
void each_field(DeviceNameserviceReq& m, F& f) {
  f.list(m.name, 64);
  f.field(m.port);
}

template <typename F>
void each_field(AddReplaceRuleReq& m, F& f) {
  f.field(m.interf);
  f.field(m.index);
  f.field(m.type);
  f.field(m.subtype);
  f.field(m.replace);
}

}  // namespace playhouse::wire::player

namespace playhouse::wire::power {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.valid);
  f.field(m.volts);
  f.field(m.percent);
  f.field(m.joules);
  f.field(m.watts);
  f.field(m.charging);
}

template <typename F>
void each_field(ChargepolicyConfig& m, F& f) {
  f.field(m.enable_input);
  f.field(m.enable_output);
}

}  // namespace playhouse::wire::power

namespace playhouse::wire::gripper {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.state);
  f.field(m.beams);
  f.field(m.stored);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.outer_size);
  f.field(m.inner_size);
  f.field(m.num_beams);
  f.field(m.capacity);
}

}  // namespace playhouse::wire::gripper

namespace playhouse::wire::position2d {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.stall);
}

template <typename F>
void each_field(CmdVel& m, F& f) {
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(CmdPos& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(CmdCar& m, F& f) {
  f.field(m.velocity);
  f.field(m.angle);
}

template <typename F>
void each_field(CmdVelHead& m, F& f) {
  f.field(m.velocity);
  f.field(m.angle);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(VelocityModeConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(PositionModeReq& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(SetOdomReq& m, F& f) {
  f.field(m.pose);
}

template <typename F>
void each_field(SpeedPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(PositionPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(SpeedProfReq& m, F& f) {
  f.field(m.speed);
  f.field(m.acc);
}

}  // namespace playhouse::wire::position2d

namespace playhouse::wire::sonar {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.ranges, 8388598);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.list(m.poses, 699049);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

}  // namespace playhouse::wire::sonar

namespace playhouse::wire::laser {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.min_angle);
  f.field(m.max_angle);
  f.field(m.resolution);
  f.field(m.max_range);
  f.list(m.ranges, 8388598);
  f.list(m.intensity, 33554392);
  f.field(m.id);
}

template <typename F>
void each_field(DataScanpose& m, F& f) {
  f.field(m.scan);
  f.field(m.pose);
}

template <typename F>
void each_field(DataScanangle& m, F& f) {
  f.field(m.max_range);
  f.list(m.ranges, 8388598);
  f.list(m.angles, 8388598);
  f.list(m.intensity, 33554392);
  f.field(m.id);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
}

template <typename F>
void each_field(Config& m, F& f) {
  f.field(m.min_angle);
  f.field(m.max_angle);
  f.field(m.resolution);
  f.field(m.max_range);
  f.field(m.range_res);
  f.field(m.intensity);
  f.field(m.scanning_frequency);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(GetIdConfig& m, F& f) {
  f.field(m.serial_number);
}

template <typename F>
void each_field(SetFilterConfig& m, F& f) {
  f.field(m.filter_type);
  f.list(m.parameters, 8);
}

}  // namespace playhouse::wire::laser

namespace playhouse::wire::blobfinder {

template <typename F>
void each_field(Blob& m, F& f) {
  f.field(m.id);
  f.field(m.color);
  f.field(m.area);
  f.field(m.x);
  f.field(m.y);
  f.field(m.left);
  f.field(m.right);
  f.field(m.top);
  f.field(m.bottom);
  f.field(m.range);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.width);
  f.field(m.height);
  f.list(m.blobs, 838859);
}

template <typename F>
void each_field(ColorConfig& m, F& f) {
  f.field(m.channel);
  f.field(m.rmin);
  f.field(m.rmax);
  f.field(m.gmin);
  f.field(m.gmax);
  f.field(m.bmin);
  f.field(m.bmax);
}

template <typename F>
void each_field(ImagerConfig& m, F& f) {
  f.field(m.brightness);
  f.field(m.contrast);
  f.field(m.colormode);
  f.field(m.autogain);
}

}  // namespace playhouse::wire::blobfinder

namespace playhouse::wire::ptz {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pan);
  f.field(m.tilt);
  f.field(m.zoom);
  f.field(m.panspeed);
  f.field(m.tiltspeed);
  f.field(m.status);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.pan);
  f.field(m.tilt);
  f.field(m.zoom);
  f.field(m.panspeed);
  f.field(m.tiltspeed);
}

template <typename F>
void each_field(ReqStatus& m, F& f) {
  f.field(m.status);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pos);
  f.field(m.size);
}

template <typename F>
void each_field(ReqGeneric& m, F& f) {
  f.list(m.config, 8388598);
}

template <typename F>
void each_field(ReqControlMode& m, F& f) {
  f.field(m.mode);
}

}  // namespace playhouse::wire::ptz

namespace playhouse::wire::audio {

template <typename F>
void each_field(Wav& m, F& f) {
  f.list(m.data, 33554392);
  f.field(m.format);
}

template <typename F>
void each_field(SeqItem& m, F& f) {
  f.field(m.freq);
  f.field(m.duration);
  f.field(m.amplitude);
  f.field(m.link);
}

template <typename F>
void each_field(Seq& m, F& f) {
  f.list(m.tones, 2097149);
}

template <typename F>
void each_field(MixerChannel& m, F& f) {
  f.field(m.amplitude);
  f.field(m.active);
  f.field(m.index);
}

template <typename F>
void each_field(MixerChannelList& m, F& f) {
  f.list(m.channels, 2796199);
}

template <typename F>
void each_field(MixerChannelDetail& m, F& f) {
  f.list(m.name, 33554392);
  f.field(m.caps);
}

template <typename F>
void each_field(MixerChannelListDetail& m, F& f) {
  f.list(m.details, 2796199);
  f.field(m.default_output);
  f.field(m.default_input);
}

template <typename F>
void each_field(Sample& m, F& f) {
  f.field(m.sample);
  f.field(m.index);
}

template <typename F>
void each_field(SampleItem& m, F& f) {
  f.field(m.index);
}

template <typename F>
void each_field(SampleRecReq& m, F& f) {
  f.field(m.index);
  f.field(m.length);
}

template <typename F>
void each_field(State& m, F& f) {
  f.field(m.state);
}

}  // namespace playhouse::wire::audio

namespace playhouse::wire::fiducial {

template <typename F>
void each_field(Item& m, F& f) {
  f.field(m.id);
  f.field(m.pose);
  f.field(m.upose);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.fiducials, 335543);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
  f.field(m.fiducial_size);
}

template <typename F>
void each_field(Fov& m, F& f) {
  f.field(m.min_range);
  f.field(m.max_range);
  f.field(m.view_angle);
}

template <typename F>
void each_field(Id& m, F& f) {
  f.field(m.id);
}

}  // namespace playhouse::wire::fiducial

namespace playhouse::wire::speech {

template <typename F>
void each_field(Cmd& m, F& f) {
  f.list(m.string, 33554392);
}

}  // namespace playhouse::wire::speech

namespace playhouse::wire::gps {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.time_sec);
  f.field(m.time_usec);
  f.field(m.latitude);
  f.field(m.longitude);
  f.field(m.altitude);
  f.field(m.speed);
  f.field(m.course);
  f.field(m.utm_e);
  f.field(m.utm_n);
  f.field(m.quality);
  f.field(m.num_sats);
  f.field(m.hdop);
  f.field(m.vdop);
  f.field(m.err_horz);
  f.field(m.err_vert);
}

}  // namespace playhouse::wire::gps

namespace playhouse::wire::bumper {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.bumpers, 33554392);
}

template <typename F>
void each_field(Define& m, F& f) {
  f.field(m.pose);
  f.field(m.length);
  f.field(m.radius);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.list(m.bumper_def, 599185);
}

}  // namespace playhouse::wire::bumper

namespace playhouse::wire::dio {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.count);
  f.field(m.bits);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.count);
  f.field(m.digout);
}

}  // namespace playhouse::wire::dio

namespace playhouse::wire::aio {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.voltages, 8388598);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.id);
  f.field(m.voltage);
}

}  // namespace playhouse::wire::aio

namespace playhouse::wire::ir {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.voltages, 8388598);
  f.list(m.ranges, 8388598);
}

template <typename F>
void each_field(Pose& m, F& f) {
  f.list(m.poses, 699049);
}

template <typename F>
void each_field(PowerReq& m, F& f) {
  f.field(m.state);
}

}  // namespace playhouse::wire::ir

namespace playhouse::wire::wifi {

template <typename F>
void each_field(Link& m, F& f) {
  f.list(m.mac, 32);
  f.list(m.ip, 32);
  f.list(m.essid, 32);
  f.field(m.mode);
  f.field(m.freq);
  f.field(m.encrypt);
  f.field(m.qual);
  f.field(m.level);
  f.field(m.noise);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.links, 699049);
  f.field(m.throughput);
  f.field(m.bitrate);
  f.field(m.mode);
  f.field(m.qual_type);
  f.field(m.maxqual);
  f.field(m.maxlevel);
  f.field(m.maxnoise);
  f.fixed_text(m.ap, 32);
}

template <typename F>
void each_field(MacReq& m, F& f) {
  f.list(m.mac, 32);
}

template <typename F>
void each_field(IwspyAddrReq& m, F& f) {
  f.fixed_text(m.address, 32);
}

}  // namespace playhouse::wire::wifi

namespace playhouse::wire::localize {

template <typename F>
void each_field(Hypoth& m, F& f) {
  f.field(m.mean);
  f.field(m.cov);
  f.field(m.alpha);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pending_count);
  f.field(m.pending_time);
  f.list(m.hypoths, 419429);
}

template <typename F>
void each_field(SetPose& m, F& f) {
  f.field(m.mean);
  f.field(m.cov);
}

template <typename F>
void each_field(Particle& m, F& f) {
  f.field(m.pose);
  f.field(m.alpha);
}

template <typename F>
void each_field(GetParticles& m, F& f) {
  f.field(m.mean);
  f.field(m.variance);
  f.list(m.particles, 1048574);
}

}  // namespace playhouse::wire::localize

namespace playhouse::wire::position3d {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.stall);
}

template <typename F>
void each_field(CmdPos& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(CmdVel& m, F& f) {
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(PositionModeReq& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(VelocityModeConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(SetOdomReq& m, F& f) {
  f.field(m.pos);
}

template <typename F>
void each_field(SpeedPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(PositionPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(SpeedProfReq& m, F& f) {
  f.field(m.speed);
  f.field(m.acc);
}

}  // namespace playhouse::wire::position3d

namespace playhouse::wire::simulation {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.data);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.cmd);
}

template <typename F>
void each_field(Pose2dReq& m, F& f) {
  f.list(m.name, 33554392);
  f.field(m.pose);
}

template <typename F>
void each_field(Pose3dReq& m, F& f) {
  f.list(m.name, 33554392);
  f.field(m.pose);
  f.field(m.simtime);
}

template <typename F>
void each_field(PropertyReq& m, F& f) {
  f.list(m.name, 33554392);
  f.list(m.prop, 33554392);
  f.field(m.index);
  f.list(m.value, 33554392);
}

}  // namespace playhouse::wire::simulation

namespace playhouse::wire::blinkenlight {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.enable);
  f.field(m.period);
  f.field(m.dutycycle);
  f.field(m.color);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.id);
  f.field(m.enable);
  f.field(m.period);
  f.field(m.dutycycle);
  f.field(m.color);
}

template <typename F>
void each_field(CmdPower& m, F& f) {
  f.field(m.id);
  f.field(m.enable);
}

template <typename F>
void each_field(CmdColor& m, F& f) {
  f.field(m.id);
  f.field(m.color);
}

template <typename F>
void each_field(CmdFlash& m, F& f) {
  f.field(m.id);
  f.field(m.period);
  f.field(m.dutycycle);
}

}  // namespace playhouse::wire::blinkenlight

namespace playhouse::wire::camera {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.width);
  f.field(m.height);
  f.field(m.bpp);
  f.field(m.format);
  f.field(m.fdiv);
  f.field(m.compression);
  f.list(m.image, 33554392);
}

template <typename F>
void each_field(Source& m, F& f) {
  f.list(m.norm, 33554392);
  f.field(m.source);
}

}  // namespace playhouse::wire::camera

namespace playhouse::wire::map {

template <typename F>
void each_field(Info& m, F& f) {
  f.field(m.scale);
  f.field(m.width);
  f.field(m.height);
  f.field(m.origin);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.col);
  f.field(m.row);
  f.field(m.width);
  f.field(m.height);
  f.field(m.data_range);
  f.list(m.data, 33554392);
}

template <typename F>
void each_field(DataVector& m, F& f) {
  f.field(m.minx);
  f.field(m.maxx);
  f.field(m.miny);
  f.field(m.maxy);
  f.list(m.segments, 1048574);
}

}  // namespace playhouse::wire::map

namespace playhouse::wire::planner {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.valid);
  f.field(m.done);
  f.field(m.pos);
  f.field(m.goal);
  f.field(m.waypoint);
  f.field(m.waypoint_idx);
  f.field(m.waypoints_count);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.goal);
}

template <typename F>
void each_field(WaypointsReq& m, F& f) {
  f.field(m.waypoints_distance);
  f.list(m.waypoints, 1398099);
}

template <typename F>
void each_field(EnableReq& m, F& f) {
  f.field(m.state);
}

}  // namespace playhouse::wire::planner

namespace playhouse::wire::log {

template <typename F>
void each_field(SetWriteState& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(SetReadState& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(GetState& m, F& f) {
  f.field(m.type);
  f.field(m.state);
}

template <typename F>
void each_field(SetFilename& m, F& f) {
  f.list(m.filename, 256);
}

}  // namespace playhouse::wire::log

namespace playhouse::wire::joystick {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pos);
  f.field(m.scale);
  f.field(m.buttons);
  f.field(m.axes_count);
}

}  // namespace playhouse::wire::joystick

namespace playhouse::wire::speech_recognition {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.text, 33554392);
}

}  // namespace playhouse::wire::speech_recognition

namespace playhouse::wire::opaque {

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.data, 33554392);
}

}  // namespace playhouse::wire::opaque

namespace playhouse::wire::position1d {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.stall);
  f.field(m.status);
}

template <typename F>
void each_field(CmdVel& m, F& f) {
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(CmdPos& m, F& f) {
  f.field(m.pos);
  f.field(m.vel);
  f.field(m.state);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(VelocityModeConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(ResetOdomConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(PositionModeReq& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(SetOdomReq& m, F& f) {
  f.field(m.pos);
}

template <typename F>
void each_field(SpeedPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(PositionPidReq& m, F& f) {
  f.field(m.kp);
  f.field(m.ki);
  f.field(m.kd);
}

template <typename F>
void each_field(SpeedProfReq& m, F& f) {
  f.field(m.speed);
  f.field(m.acc);
}

}  // namespace playhouse::wire::position1d

namespace playhouse::wire::actarray {

template <typename F>
void each_field(Actuator& m, F& f) {
  f.field(m.position);
  f.field(m.speed);
  f.field(m.acceleration);
  f.field(m.current);
  f.field(m.state);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.actuators, 1677719);
  f.field(m.motor_state);
}

template <typename F>
void each_field(Actuatorgeom& m, F& f) {
  f.field(m.type);
  f.field(m.length);
  f.field(m.orientation);
  f.field(m.axis);
  f.field(m.min);
  f.field(m.centre);
  f.field(m.max);
  f.field(m.home);
  f.field(m.config_speed);
  f.field(m.hasbrakes);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.list(m.actuators, 419429);
  f.field(m.base_pos);
  f.field(m.base_orientation);
}

template <typename F>
void each_field(PositionCmd& m, F& f) {
  f.field(m.joint);
  f.field(m.position);
}

template <typename F>
void each_field(MultiPositionCmd& m, F& f) {
  f.list(m.positions, 8388598);
}

template <typename F>
void each_field(SpeedCmd& m, F& f) {
  f.field(m.joint);
  f.field(m.speed);
}

template <typename F>
void each_field(MultiSpeedCmd& m, F& f) {
  f.list(m.speeds, 8388598);
}

template <typename F>
void each_field(HomeCmd& m, F& f) {
  f.field(m.joint);
}

template <typename F>
void each_field(CurrentCmd& m, F& f) {
  f.field(m.joint);
  f.field(m.current);
}

template <typename F>
void each_field(MultiCurrentCmd& m, F& f) {
  f.list(m.currents, 8388598);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(BrakesConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(SpeedConfig& m, F& f) {
  f.field(m.joint);
  f.field(m.speed);
}

template <typename F>
void each_field(AccelConfig& m, F& f) {
  f.field(m.joint);
  f.field(m.accel);
}

}  // namespace playhouse::wire::actarray

namespace playhouse::wire::limb {

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.position);
  f.field(m.approach);
  f.field(m.orientation);
  f.field(m.state);
}

template <typename F>
void each_field(SetposeCmd& m, F& f) {
  f.field(m.position);
  f.field(m.approach);
  f.field(m.orientation);
}

template <typename F>
void each_field(SetpositionCmd& m, F& f) {
  f.field(m.position);
}

template <typename F>
void each_field(VecmoveCmd& m, F& f) {
  f.field(m.direction);
  f.field(m.length);
}

template <typename F>
void each_field(PowerReq& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(BrakesReq& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(GeomReq& m, F& f) {
  f.field(m.basePos);
}

template <typename F>
void each_field(SpeedReq& m, F& f) {
  f.field(m.speed);
}

}  // namespace playhouse::wire::limb

namespace playhouse::wire::graphics2d {

template <typename F>
void each_field(CmdPoints& m, F& f) {
  f.list(m.points, 2097149);
  f.field(m.color);
}

template <typename F>
void each_field(CmdPolyline& m, F& f) {
  f.list(m.points, 2097149);
  f.field(m.color);
}

template <typename F>
void each_field(CmdPolygon& m, F& f) {
  f.list(m.points, 2097149);
  f.field(m.color);
  f.field(m.fill_color);
  f.field(m.filled);
}

template <typename F>
void each_field(CmdMultiline& m, F& f) {
  f.list(m.points, 2097149);
  f.field(m.color);
}

}  // namespace playhouse::wire::graphics2d

namespace playhouse::wire::rfid {

template <typename F>
void each_field(Tag& m, F& f) {
  f.field(m.type);
  f.list(m.guid, 33554392);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.tags, 2796199);
}

}  // namespace playhouse::wire::rfid

namespace playhouse::wire::wsn {

template <typename F>
void each_field(NodeData& m, F& f) {
  f.field(m.light);
  f.field(m.mic);
  f.field(m.accel_x);
  f.field(m.accel_y);
  f.field(m.accel_z);
  f.field(m.magn_x);
  f.field(m.magn_y);
  f.field(m.magn_z);
  f.field(m.temperature);
  f.field(m.battery);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.node_type);
  f.field(m.node_id);
  f.field(m.node_parent_id);
  f.field(m.data_packet);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.node_id);
  f.field(m.group_id);
  f.field(m.device);
  f.field(m.enable);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.node_id);
  f.field(m.group_id);
  f.field(m.value);
}

template <typename F>
void each_field(DatatypeConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(DatafreqConfig& m, F& f) {
  f.field(m.node_id);
  f.field(m.group_id);
  f.field(m.frequency);
}

}  // namespace playhouse::wire::wsn

namespace playhouse::wire::graphics3d {

template <typename F>
void each_field(CmdDraw& m, F& f) {
  f.field(m.draw_mode);
  f.list(m.points, 1398099);
  f.field(m.color);
}

template <typename F>
void each_field(CmdTranslate& m, F& f) {
  f.field(m.x);
  f.field(m.y);
  f.field(m.z);
}

template <typename F>
void each_field(CmdRotate& m, F& f) {
  f.field(m.a);
  f.field(m.x);
  f.field(m.y);
  f.field(m.z);
}

}  // namespace playhouse::wire::graphics3d

namespace playhouse::wire::health {

template <typename F>
void each_field(Cpu& m, F& f) {
  f.field(m.idle);
  f.field(m.system);
  f.field(m.user);
}

template <typename F>
void each_field(Memory& m, F& f) {
  f.field(m.total);
  f.field(m.used);
  f.field(m.free);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.cpu_usage);
  f.field(m.mem);
  f.field(m.swap);
}

}  // namespace playhouse::wire::health

namespace playhouse::wire::imu {

template <typename F>
void each_field(DataState& m, F& f) {
  f.field(m.pose);
}

template <typename F>
void each_field(DataCalib& m, F& f) {
  f.field(m.accel_x);
  f.field(m.accel_y);
  f.field(m.accel_z);
  f.field(m.gyro_x);
  f.field(m.gyro_y);
  f.field(m.gyro_z);
  f.field(m.magn_x);
  f.field(m.magn_y);
  f.field(m.magn_z);
}

template <typename F>
void each_field(DataQuat& m, F& f) {
  f.field(m.calib_data);
  f.field(m.q0);
  f.field(m.q1);
  f.field(m.q2);
  f.field(m.q3);
}

template <typename F>
void each_field(DataEuler& m, F& f) {
  f.field(m.calib_data);
  f.field(m.orientation);
}

template <typename F>
void each_field(DataFullstate& m, F& f) {
  f.field(m.pose);
  f.field(m.vel);
  f.field(m.acc);
}

template <typename F>
void each_field(DatatypeConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(ResetOrientationConfig& m, F& f) {
  f.field(m.value);
}

template <typename F>
void each_field(ResetEulerConfig& m, F& f) {
  f.field(m.orientation);
}

}  // namespace playhouse::wire::imu

namespace playhouse::wire::pointcloud3d {

template <typename F>
void each_field(Element& m, F& f) {
  f.field(m.point);
  f.field(m.color);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.list(m.points, 838859);
}

}  // namespace playhouse::wire::pointcloud3d

namespace playhouse::wire::ranger {

template <typename F>
void each_field(Config& m, F& f) {
  f.field(m.min_angle);
  f.field(m.max_angle);
  f.field(m.angular_res);
  f.field(m.min_range);
  f.field(m.max_range);
  f.field(m.range_res);
  f.field(m.frequency);
}

template <typename F>
void each_field(Geom& m, F& f) {
  f.field(m.pose);
  f.field(m.size);
  f.list(m.element_poses, 699049);
  f.list(m.element_sizes, 1398099);
}

template <typename F>
void each_field(DataRange& m, F& f) {
  f.list(m.ranges, 4194299);
}

template <typename F>
void each_field(DataRangestamped& m, F& f) {
  f.field(m.data);
  f.field(m.have_geom);
  f.field(m.geom);
  f.field(m.have_config);
  f.field(m.config);
}

template <typename F>
void each_field(DataIntns& m, F& f) {
  f.list(m.intensities, 4194299);
}

template <typename F>
void each_field(DataIntnsstamped& m, F& f) {
  f.field(m.data);
  f.field(m.have_geom);
  f.field(m.geom);
  f.field(m.have_config);
  f.field(m.config);
}

template <typename F>
void each_field(PowerConfig& m, F& f) {
  f.field(m.state);
}

template <typename F>
void each_field(IntnsConfig& m, F& f) {
  f.field(m.state);
}

}  // namespace playhouse::wire::ranger

namespace playhouse::wire::vectormap {

template <typename F>
void each_field(FeatureData& m, F& f) {
  f.list(m.name, 33554392);
  f.list(m.wkb, 33554392);
  f.list(m.attrib, 33554392);
}

template <typename F>
void each_field(LayerInfo& m, F& f) {
  f.list(m.name, 33554392);
  f.field(m.extent);
}

template <typename F>
void each_field(LayerData& m, F& f) {
  f.list(m.name, 33554392);
  f.list(m.features, 1398099);
}

template <typename F>
void each_field(Info& m, F& f) {
  f.field(m.srid);
  f.list(m.layers, 838859);
  f.field(m.extent);
}

}  // namespace playhouse::wire::vectormap

namespace playhouse::wire::blackboard {

}  // namespace playhouse::wire::blackboard

namespace playhouse::wire::stereo {

template <typename F>
void each_field(Pointcloud3dStereoElement& m, F& f) {
  f.field(m.px);
  f.field(m.py);
  f.field(m.pz);
  f.field(m.red);
  f.field(m.green);
  f.field(m.blue);
}

template <typename F>
void each_field(Data& m, F& f) {
  f.field(m.left_channel);
  f.field(m.right_channel);
  f.field(m.disparity);
  f.list(m.points, 1398099);
  f.field(m.mode);
}

}  // namespace playhouse::wire::stereo

namespace playhouse::wire::coopobject {

template <typename F>
void each_field(Header& m, F& f) {
  f.field(m.origin);
  f.field(m.id);
  f.field(m.parent_id);
}

template <typename F>
void each_field(Rssi& m, F& f) {
  f.field(m.header);
  f.field(m.sender_id);
  f.field(m.rssi);
  f.field(m.stamp);
  f.field(m.nodeTimeHigh);
  f.field(m.nodeTimeLow);
  f.field(m.x);
  f.field(m.y);
  f.field(m.z);
}

template <typename F>
void each_field(Position& m, F& f) {
  f.field(m.header);
  f.field(m.x);
  f.field(m.y);
  f.field(m.z);
  f.field(m.status);
}

template <typename F>
void each_field(Sensor& m, F& f) {
  f.field(m.type);
  f.field(m.value);
}

template <typename F>
void each_field(DataSensor& m, F& f) {
  f.field(m.header);
  f.list(m.data, 4194299);
}

template <typename F>
void each_field(DataUserdefined& m, F& f) {
  f.field(m.header);
  f.field(m.type);
  f.list(m.data, 33554392);
}

template <typename F>
void each_field(Req& m, F& f) {
  f.field(m.header);
  f.field(m.request);
  f.list(m.parameters, 33554392);
}

template <typename F>
void each_field(Cmd& m, F& f) {
  f.field(m.header);
  f.field(m.command);
  f.list(m.parameters, 33554392);
}

}  // namespace playhouse::wire::coopobject

namespace playhouse::wire {

template <typename F>
void each_message(F& f) {
  f.template operator()<CapabilitiesReq>("universal.req.capabilities");
  f.template operator()<IntpropReq>("universal.req.get_intprop");
  f.template operator()<IntpropReq>("universal.req.set_intprop");
  f.template operator()<DblpropReq>("universal.req.get_dblprop");
  f.template operator()<DblpropReq>("universal.req.set_dblprop");
  f.template operator()<StrpropReq>("universal.req.get_strprop");
  f.template operator()<StrpropReq>("universal.req.set_strprop");
  f.template operator()<BoolpropReq>("universal.req.get_boolprop");
  f.template operator()<BoolpropReq>("universal.req.set_boolprop");
  f.template operator()<player::DeviceDevlist>("player.req.devlist");
  f.template operator()<player::DeviceDriverinfo>("player.req.driverinfo");
  f.template operator()<player::DeviceReq>("player.req.dev");
  f.template operator()<player::DeviceDatamodeReq>("player.req.datamode");
  f.template operator()<player::DeviceAuthReq>("player.req.auth");
  f.template operator()<player::DeviceNameserviceReq>("player.req.nameservice");
  f.template operator()<player::AddReplaceRuleReq>("player.req.add_replace_rule");
  f.template operator()<Uint32>("player.synch.overflow");
  f.template operator()<power::Data>("power.data.state");
  f.template operator()<power::ChargepolicyConfig>("power.req.set_charging_policy");
  f.template operator()<gripper::Data>("gripper.data.state");
  f.template operator()<gripper::Geom>("gripper.req.get_geom");
  f.template operator()<position2d::Geom>("position2d.req.get_geom");
  f.template operator()<position2d::PowerConfig>("position2d.req.motor_power");
  f.template operator()<position2d::VelocityModeConfig>("position2d.req.velocity_mode");
  f.template operator()<position2d::PositionModeReq>("position2d.req.position_mode");
  f.template operator()<position2d::SetOdomReq>("position2d.req.set_odom");
  f.template operator()<position2d::SpeedPidReq>("position2d.req.speed_pid");
  f.template operator()<position2d::PositionPidReq>("position2d.req.position_pid");
  f.template operator()<position2d::SpeedProfReq>("position2d.req.speed_prof");
  f.template operator()<position2d::Data>("position2d.data.state");
  f.template operator()<position2d::Geom>("position2d.data.geom");
  f.template operator()<position2d::CmdVel>("position2d.cmd.vel");
  f.template operator()<position2d::CmdPos>("position2d.cmd.pos");
  f.template operator()<position2d::CmdCar>("position2d.cmd.car");
  f.template operator()<position2d::CmdVelHead>("position2d.cmd.vel_head");
  f.template operator()<sonar::Geom>("sonar.req.get_geom");
  f.template operator()<sonar::PowerConfig>("sonar.req.power");
  f.template operator()<sonar::Data>("sonar.data.ranges");
  f.template operator()<sonar::Geom>("sonar.data.geom");
  f.template operator()<laser::Data>("laser.data.scan");
  f.template operator()<laser::DataScanpose>("laser.data.scanpose");
  f.template operator()<laser::DataScanangle>("laser.data.scanangle");
  f.template operator()<laser::Geom>("laser.req.get_geom");
  f.template operator()<laser::Config>("laser.req.set_config");
  f.template operator()<laser::Config>("laser.req.get_config");
  f.template operator()<laser::PowerConfig>("laser.req.power");
  f.template operator()<laser::GetIdConfig>("laser.req.get_id");
  f.template operator()<laser::SetFilterConfig>("laser.req.set_filter");
  f.template operator()<blobfinder::Data>("blobfinder.data.blobs");
  f.template operator()<blobfinder::ColorConfig>("blobfinder.req.set_color");
  f.template operator()<blobfinder::ImagerConfig>("blobfinder.req.set_imager_params");
  f.template operator()<blobfinder::ColorConfig>("blobfinder.req.get_color");
  f.template operator()<ptz::ReqGeneric>("ptz.req.generic");
  f.template operator()<ptz::ReqControlMode>("ptz.req.control_mode");
  f.template operator()<ptz::Geom>("ptz.req.geom");
  f.template operator()<ptz::ReqStatus>("ptz.req.status");
  f.template operator()<ptz::Data>("ptz.data.state");
  f.template operator()<ptz::Geom>("ptz.data.geom");
  f.template operator()<ptz::Cmd>("ptz.cmd.state");
  f.template operator()<audio::Wav>("audio.data.wav_rec");
  f.template operator()<audio::Seq>("audio.data.seq");
  f.template operator()<audio::MixerChannelList>("audio.data.mixer_channel");
  f.template operator()<audio::State>("audio.data.state");
  f.template operator()<audio::Wav>("audio.cmd.wav_play");
  f.template operator()<Bool>("audio.cmd.wav_stream_rec");
  f.template operator()<audio::SampleItem>("audio.cmd.sample_play");
  f.template operator()<audio::Seq>("audio.cmd.seq_play");
  f.template operator()<audio::MixerChannelList>("audio.cmd.mixer_channel");
  f.template operator()<audio::Wav>("audio.req.wav_rec");
  f.template operator()<audio::Sample>("audio.req.sample_load");
  f.template operator()<audio::Sample>("audio.req.sample_retrieve");
  f.template operator()<audio::SampleItem>("audio.req.sample_rec");
  f.template operator()<audio::MixerChannelListDetail>("audio.req.mixer_channel_list");
  f.template operator()<audio::MixerChannelList>("audio.req.mixer_channel_level");
  f.template operator()<fiducial::Data>("fiducial.data.scan");
  f.template operator()<fiducial::Geom>("fiducial.req.get_geom");
  f.template operator()<fiducial::Fov>("fiducial.req.get_fov");
  f.template operator()<fiducial::Fov>("fiducial.req.set_fov");
  f.template operator()<fiducial::Id>("fiducial.req.get_id");
  f.template operator()<fiducial::Id>("fiducial.req.set_id");
  f.template operator()<speech::Cmd>("speech.cmd.say");
  f.template operator()<gps::Data>("gps.data.state");
  f.template operator()<bumper::Data>("bumper.data.state");
  f.template operator()<bumper::Geom>("bumper.data.geom");
  f.template operator()<bumper::Geom>("bumper.req.get_geom");
  f.template operator()<dio::Data>("dio.data.values");
  f.template operator()<dio::Cmd>("dio.cmd.values");
  f.template operator()<aio::Cmd>("aio.cmd.state");
  f.template operator()<aio::Data>("aio.data.state");
  f.template operator()<ir::Pose>("ir.req.pose");
  f.template operator()<ir::PowerReq>("ir.req.power");
  f.template operator()<ir::Data>("ir.data.ranges");
  f.template operator()<wifi::MacReq>("wifi.req.mac");
  f.template operator()<wifi::IwspyAddrReq>("wifi.req.iwspy_add");
  f.template operator()<wifi::IwspyAddrReq>("wifi.req.iwspy_del");
  f.template operator()<wifi::IwspyAddrReq>("wifi.req.iwspy_ping");
  f.template operator()<wifi::Data>("wifi.data.state");
  f.template operator()<localize::Data>("localize.data.hypoths");
  f.template operator()<localize::SetPose>("localize.req.set_pose");
  f.template operator()<localize::GetParticles>("localize.req.get_particles");
  f.template operator()<position3d::Data>("position3d.data.state");
  f.template operator()<position3d::Geom>("position3d.data.geometry");
  f.template operator()<position3d::CmdVel>("position3d.cmd.set_vel");
  f.template operator()<position3d::CmdPos>("position3d.cmd.set_pos");
  f.template operator()<position3d::Geom>("position3d.req.get_geom");
  f.template operator()<position3d::PowerConfig>("position3d.req.motor_power");
  f.template operator()<position3d::VelocityModeConfig>("position3d.req.velocity_mode");
  f.template operator()<position3d::PositionModeReq>("position3d.req.position_mode");
  f.template operator()<position3d::SetOdomReq>("position3d.req.set_odom");
  f.template operator()<position3d::SpeedPidReq>("position3d.req.speed_pid");
  f.template operator()<position3d::PositionPidReq>("position3d.req.position_pid");
  f.template operator()<position3d::SpeedProfReq>("position3d.req.speed_prof");
  f.template operator()<simulation::Pose2dReq>("simulation.req.get_pose2d");
  f.template operator()<simulation::Pose2dReq>("simulation.req.set_pose2d");
  f.template operator()<simulation::Pose3dReq>("simulation.req.get_pose3d");
  f.template operator()<simulation::Pose3dReq>("simulation.req.set_pose3d");
  f.template operator()<simulation::PropertyReq>("simulation.req.get_property");
  f.template operator()<simulation::PropertyReq>("simulation.req.set_property");
  f.template operator()<blinkenlight::Data>("blinkenlight.data.state");
  f.template operator()<blinkenlight::Cmd>("blinkenlight.cmd.state");
  f.template operator()<blinkenlight::CmdPower>("blinkenlight.cmd.power");
  f.template operator()<blinkenlight::CmdColor>("blinkenlight.cmd.color");
  f.template operator()<blinkenlight::CmdFlash>("blinkenlight.cmd.flash");
  f.template operator()<camera::Data>("camera.data.state");
  f.template operator()<camera::Source>("camera.req.get_source");
  f.template operator()<camera::Source>("camera.req.set_source");
  f.template operator()<camera::Data>("camera.req.get_image");
  f.template operator()<map::Info>("map.data.info");
  f.template operator()<map::Info>("map.req.get_info");
  f.template operator()<map::Data>("map.req.get_data");
  f.template operator()<map::DataVector>("map.req.get_vector");
  f.template operator()<planner::Data>("planner.data.state");
  f.template operator()<planner::Cmd>("planner.cmd.goal");
  f.template operator()<planner::Cmd>("planner.cmd.start");
  f.template operator()<planner::WaypointsReq>("planner.req.get_waypoints");
  f.template operator()<planner::EnableReq>("planner.req.enable");
  f.template operator()<log::SetWriteState>("log.req.set_write_state");
  f.template operator()<log::SetReadState>("log.req.set_read_state");
  f.template operator()<log::GetState>("log.req.get_state");
  f.template operator()<log::SetFilename>("log.req.set_filename");
  f.template operator()<joystick::Data>("joystick.data.state");
  f.template operator()<speech_recognition::Data>("speech_recognition.data.string");
  f.template operator()<opaque::Data>("opaque.data.state");
  f.template operator()<opaque::Data>("opaque.cmd.data");
  f.template operator()<opaque::Data>("opaque.req.data");
  f.template operator()<position1d::Geom>("position1d.req.get_geom");
  f.template operator()<position1d::PowerConfig>("position1d.req.motor_power");
  f.template operator()<position1d::VelocityModeConfig>("position1d.req.velocity_mode");
  f.template operator()<position1d::PositionModeReq>("position1d.req.position_mode");
  f.template operator()<position1d::SetOdomReq>("position1d.req.set_odom");
  f.template operator()<position1d::ResetOdomConfig>("position1d.req.reset_odom");
  f.template operator()<position1d::SpeedPidReq>("position1d.req.speed_pid");
  f.template operator()<position1d::PositionPidReq>("position1d.req.position_pid");
  f.template operator()<position1d::SpeedProfReq>("position1d.req.speed_prof");
  f.template operator()<position1d::Data>("position1d.data.state");
  f.template operator()<position1d::Geom>("position1d.data.geom");
  f.template operator()<position1d::CmdVel>("position1d.cmd.vel");
  f.template operator()<position1d::CmdPos>("position1d.cmd.pos");
  f.template operator()<actarray::PowerConfig>("actarray.req.power");
  f.template operator()<actarray::BrakesConfig>("actarray.req.brakes");
  f.template operator()<actarray::Geom>("actarray.req.get_geom");
  f.template operator()<actarray::SpeedConfig>("actarray.req.speed");
  f.template operator()<actarray::AccelConfig>("actarray.req.accel");
  f.template operator()<actarray::PositionCmd>("actarray.cmd.pos");
  f.template operator()<actarray::MultiPositionCmd>("actarray.cmd.multi_pos");
  f.template operator()<actarray::SpeedCmd>("actarray.cmd.speed");
  f.template operator()<actarray::MultiSpeedCmd>("actarray.cmd.multi_speed");
  f.template operator()<actarray::HomeCmd>("actarray.cmd.home");
  f.template operator()<actarray::CurrentCmd>("actarray.cmd.current");
  f.template operator()<actarray::MultiCurrentCmd>("actarray.cmd.multi_current");
  f.template operator()<actarray::Data>("actarray.data.state");
  f.template operator()<limb::Data>("limb.data.state");
  f.template operator()<limb::SetposeCmd>("limb.cmd.setpose");
  f.template operator()<limb::SetpositionCmd>("limb.cmd.setposition");
  f.template operator()<limb::VecmoveCmd>("limb.cmd.vecmove");
  f.template operator()<limb::PowerReq>("limb.req.power");
  f.template operator()<limb::BrakesReq>("limb.req.brakes");
  f.template operator()<limb::GeomReq>("limb.req.geom");
  f.template operator()<limb::SpeedReq>("limb.req.speed");
  f.template operator()<graphics2d::CmdPoints>("graphics2d.cmd.points");
  f.template operator()<graphics2d::CmdPolyline>("graphics2d.cmd.polyline");
  f.template operator()<graphics2d::CmdPolygon>("graphics2d.cmd.polygon");
  f.template operator()<graphics2d::CmdMultiline>("graphics2d.cmd.multiline");
  f.template operator()<rfid::Data>("rfid.data.tags");
  f.template operator()<wsn::Data>("wsn.data.state");
  f.template operator()<wsn::Cmd>("wsn.cmd.devstate");
  f.template operator()<wsn::PowerConfig>("wsn.req.power");
  f.template operator()<wsn::DatatypeConfig>("wsn.req.datatype");
  f.template operator()<wsn::DatafreqConfig>("wsn.req.datafreq");
  f.template operator()<graphics3d::CmdDraw>("graphics3d.cmd.draw");
  f.template operator()<graphics3d::CmdTranslate>("graphics3d.cmd.translate");
  f.template operator()<graphics3d::CmdRotate>("graphics3d.cmd.rotate");
  f.template operator()<health::Data>("health.data.state");
  f.template operator()<imu::DataState>("imu.data.state");
  f.template operator()<imu::DataCalib>("imu.data.calib");
  f.template operator()<imu::DataQuat>("imu.data.quat");
  f.template operator()<imu::DataEuler>("imu.data.euler");
  f.template operator()<imu::DataFullstate>("imu.data.fullstate");
  f.template operator()<imu::DatatypeConfig>("imu.req.set_datatype");
  f.template operator()<imu::ResetOrientationConfig>("imu.req.reset_orientation");
  f.template operator()<imu::ResetEulerConfig>("imu.req.reset_euler");
  f.template operator()<pointcloud3d::Data>("pointcloud3d.data.state");
  f.template operator()<ranger::DataRange>("ranger.data.range");
  f.template operator()<ranger::DataRangestamped>("ranger.data.rangestamped");
  f.template operator()<ranger::DataIntns>("ranger.data.intns");
  f.template operator()<ranger::DataIntnsstamped>("ranger.data.intnsstamped");
  f.template operator()<ranger::Geom>("ranger.data.geom");
  f.template operator()<ranger::Geom>("ranger.req.get_geom");
  f.template operator()<ranger::PowerConfig>("ranger.req.power");
  f.template operator()<ranger::IntnsConfig>("ranger.req.intns");
  f.template operator()<ranger::Config>("ranger.req.set_config");
  f.template operator()<ranger::Config>("ranger.req.get_config");
  f.template operator()<vectormap::Info>("vectormap.req.get_map_info");
  f.template operator()<vectormap::LayerData>("vectormap.req.get_layer_data");
  f.template operator()<vectormap::LayerData>("vectormap.req.write_layer");
  f.template operator()<BlackboardEntry>("blackboard.req.subscribe_to_key");
  f.template operator()<BlackboardEntry>("blackboard.req.unsubscribe_from_key");
  f.template operator()<BlackboardEntry>("blackboard.req.set_entry");
  f.template operator()<BlackboardEntry>("blackboard.req.subscribe_to_group");
  f.template operator()<BlackboardEntry>("blackboard.req.unsubscribe_from_group");
  f.template operator()<BlackboardEntry>("blackboard.req.get_entry");
  f.template operator()<BlackboardEntry>("blackboard.data.update");
  f.template operator()<stereo::Data>("stereo.data.state");
  f.template operator()<coopobject::Header>("coopobject.data.health");
  f.template operator()<coopobject::Rssi>("coopobject.data.rssi");
  f.template operator()<coopobject::DataSensor>("coopobject.data.sensor");
  f.template operator()<coopobject::DataSensor>("coopobject.data.alarm");
  f.template operator()<coopobject::DataUserdefined>("coopobject.data.userdefined");
  f.template operator()<coopobject::Req>("coopobject.data.request");
  f.template operator()<coopobject::Cmd>("coopobject.data.command");
  f.template operator()<coopobject::Position>("coopobject.data.position");
  f.template operator()<coopobject::Cmd>("coopobject.cmd.standard");
  f.template operator()<coopobject::DataUserdefined>("coopobject.cmd.data");
  f.template operator()<coopobject::Position>("coopobject.cmd.position");
  f.template operator()<coopobject::Req>("coopobject.req.standard");
}

}  // namespace playhouse::wire
