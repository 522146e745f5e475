#include "playhouse/arena/ray_scene.h"

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"

namespace playhouse::arena {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Held = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

constexpr float kSkin = 5e-4f;  // m that rays are let through beyond their own solids: more than float rounds
constexpr unsigned kFixedScene = 0;  // first geometry of the top scene; instances follow

// Robust: watertight at edges between triangles.
const auto kFlags =
    static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);

Held<RTCGeometry> triangles_of(RTCDevice device, const Triangles& triangles) {
  Held<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* p = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), triangles.p.size()));
  auto* corner = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.corner.size()));
  PLAYHOUSE_ASSERT(p != nullptr && corner != nullptr);
  for (const geom::Vec3& v : triangles.p)
    for (const double x : {v.x, v.y, v.z}) *p++ = static_cast<float>(x);
  for (const auto& three : triangles.corner) corner = std::ranges::copy(three, corner).out;
  rtcCommitGeometry(geometry.get());
  return geometry;
}

Held<RTCGeometry> instance_of(RTCDevice device, RTCScene shape) {
  Held<RTCGeometry> geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(geometry.get(), shape);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

Held<RTCScene> make_scene(RTCDevice device, RTCSceneFlags flags) {
  Held<RTCScene> scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), flags);
  return scene;
}

/// Single-threaded build, so that the BVH is deterministic.
void commit_alone(RTCScene scene) {
  tbb::task_arena alone(1);
  alone.execute([scene] { rtcCommitScene(scene); });
}

}  // namespace

struct RayScene::Impl {
  struct Context;

  // Not "threads=1": that would limit TBB in the whole process.
  Held<RTCDevice> device{rtcNewDevice(nullptr)};
  Held<RTCScene> fixed, top;
  std::vector<Held<RTCScene>> shapes;
  std::vector<Held<RTCGeometry>> placed;       // instances
  std::vector<std::array<float, 9>> rotation;  // R_WM of each, column-major
  std::vector<Owner> fixed_owners;             // by triangle
  std::vector<Owner> owners;                   // by instance

  const Owner& owner(unsigned instance, unsigned triangle) const {
    return instance == kFixedScene ? fixed_owners[triangle] : owners[instance - 1];
  }
  float facing(const RTCRayHit16& both, std::size_t k) const;
  std::array<float, 3> normal(const RTCHit16& hit, std::size_t k) const;
  static void pass_own(const RTCFilterFunctionNArguments* hits);
};

/// Cosine between a ray and the normal of its hit, which Embree gives
/// in the instance's frame; negative if the ray comes from outside.
float RayScene::Impl::facing(const RTCRayHit16& both, std::size_t k) const {
  const RTCHit16& hit = both.hit;
  const float d[3] = {both.ray.dir_x[k], both.ray.dir_y[k], both.ray.dir_z[k]};
  const float n[3] = {hit.Ng_x[k], hit.Ng_y[k], hit.Ng_z[k]};
  const auto dot = [](const float* a, const float* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  float along = dot(d, n);
  if (hit.instID[0][k] != kFixedScene) {
    const float* R = rotation[hit.instID[0][k] - 1].data();
    along = n[0] * dot(R, d) + n[1] * dot(R + 3, d) + n[2] * dot(R + 6, d);
  }
  return along / std::sqrt(dot(n, n));
}

/// Unit normal of a hit, in W.
std::array<float, 3> RayScene::Impl::normal(const RTCHit16& hit, std::size_t k) const {
  const float n[3] = {hit.Ng_x[k], hit.Ng_y[k], hit.Ng_z[k]};
  std::array<float, 3> to = {n[0], n[1], n[2]};
  if (hit.instID[0][k] != kFixedScene) {
    const float* R = rotation[hit.instID[0][k] - 1].data();
    for (std::size_t i = 0; i < 3; ++i) to[i] = n[0] * R[i] + n[1] * R[3 + i] + n[2] * R[6 + i];
  }
  const float length = std::sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
  for (float& each : to) each /= length;
  return to;
}

/// Context passed by Embree to pass_own().
struct RayScene::Impl::Context {
  RTCIntersectContext embree;
  const Impl& scene;
  std::uint32_t group;
};

/// Intersection filter: rejects hits on the ray's own group.
void RayScene::Impl::pass_own(const RTCFilterFunctionNArguments* hits) {
  const auto& context = *reinterpret_cast<const Context*>(hits->context);
  for (unsigned k = 0; k < hits->N; ++k) {
    if (hits->valid[k] == 0) continue;
    const Owner& owner =
        context.scene.owner(RTCHitN_instID(hits->hit, hits->N, k, 0), RTCHitN_primID(hits->hit, hits->N, k));
    if (owner.group == context.group) hits->valid[k] = 0;
  }
}

RayScene::RayScene() : impl_(std::make_unique<Impl>()) {
  PLAYHOUSE_ASSERT(impl_->device != nullptr);
  set_fixed({}, {});
}
RayScene::~RayScene() = default;

void RayScene::set_fixed(std::span<const Triangles> fixed, std::span<const Owner> owners) {
  PLAYHOUSE_ASSERT(fixed.size() == owners.size());
  impl_->fixed = make_scene(impl_->device.get(), kFlags);
  Triangles all;
  impl_->fixed_owners.clear();
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(all.p.size());
    all.p.insert(all.p.end(), fixed[i].p.begin(), fixed[i].p.end());
    for (const auto& corner : fixed[i].corner)
      all.corner.push_back({first + corner[0], first + corner[1], first + corner[2]});
    impl_->fixed_owners.resize(all.corner.size(), owners[i]);
  }
  if (!all.empty()) rtcAttachGeometry(impl_->fixed.get(), triangles_of(impl_->device.get(), all).get());
  commit_alone(impl_->fixed.get());
  impl_->top.reset();
}

std::uint32_t RayScene::add_shape(const Triangles& triangles) {
  Held<RTCScene>& scene = impl_->shapes.emplace_back(make_scene(impl_->device.get(), kFlags));
  rtcAttachGeometry(scene.get(), triangles_of(impl_->device.get(), triangles).get());
  commit_alone(scene.get());
  return static_cast<std::uint32_t>(impl_->shapes.size() - 1);
}

void RayScene::set_instances(std::span<const Instance> instances) {
  impl_->placed.clear();
  impl_->owners.clear();
  impl_->rotation.assign(instances.size(), {1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (const Instance& instance : instances) {
    impl_->placed.push_back(instance_of(impl_->device.get(), impl_->shapes[instance.shape].get()));
    impl_->owners.push_back(instance.owner);
  }
  impl_->top.reset();
}

void RayScene::place(std::uint32_t instance, const geom::Vec3& p, const geom::Quaternion& q) {
  const geom::Vec3 x = q * geom::Vec3{1, 0, 0}, y = q * geom::Vec3{0, 1, 0}, z = q * geom::Vec3{0, 0, 1};
  float columns[12], *out = columns;
  for (const geom::Vec3& v : {x, y, z, p})
    for (const double c : {v.x, v.y, v.z}) *out++ = static_cast<float>(c);
  std::copy_n(columns, 9, impl_->rotation[instance].begin());
  RTCGeometry geometry = impl_->placed[instance].get();
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
  rtcCommitGeometry(geometry);
}

void RayScene::commit() {
  if (!impl_->top) {
    impl_->top = make_scene(impl_->device.get(), static_cast<RTCSceneFlags>(kFlags | RTC_SCENE_FLAG_DYNAMIC));
    rtcAttachGeometry(impl_->top.get(), instance_of(impl_->device.get(), impl_->fixed.get()).get());
    for (const auto& geometry : impl_->placed) rtcAttachGeometry(impl_->top.get(), geometry.get());
  }
  commit_alone(impl_->top.get());
}

void RayScene::cast(RayBatch& rays) const {
  static_assert(RayBatch::kMost == 16);
  alignas(64) RTCRayHit16 both;
  alignas(64) int valid[RayBatch::kMost];
  RTCRay16& ray = both.ray;
  for (std::size_t k = 0; k < RayBatch::kMost; ++k) {
    valid[k] = k < rays.count ? -1 : 0;
    ray.org_x[k] = rays.px[k];
    ray.org_y[k] = rays.py[k];
    ray.org_z[k] = rays.pz[k];
    ray.dir_x[k] = rays.dx[k];
    ray.dir_y[k] = rays.dy[k];
    ray.dir_z[k] = rays.dz[k];
    ray.tnear[k] = rays.inside[k] > 0 ? rays.inside[k] + kSkin : 0;
    ray.time[k] = 0;
    ray.tfar[k] = rays.range[k];
    ray.mask[k] = ~0u;
    ray.flags[k] = 0;
    both.hit.geomID[k] = both.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  Impl::Context context{{}, *impl_, rays.group};
  rtcInitIntersectContext(&context.embree);
  context.embree.flags =
      rays.is_narrow ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcIntersect16(valid, impl_->top.get(), &context.embree, &both);

  const auto owner = [&](std::size_t k) {
    return both.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID
               ? Owner{RayBatch::kNobody, RayBatch::kNobody}
               : impl_->owner(both.hit.instID[0][k], both.hit.primID[k]);
  };
  // A filter costs a call per hit, and few rays hit their own group: only those are cast again.
  // Likewise rays that leave a solid, since another may begin where they were let through.
  bool again = false;
  for (std::size_t k = 0; k < rays.count; ++k) {
    const Owner met = owner(k);
    valid[k] = 0;
    if (met.id == RayBatch::kNobody) continue;
    const bool is_own = met.group == rays.group;
    if (!is_own && (rays.inside[k] == 0 || impl_->facing(both, k) < 0)) continue;
    again = true;
    valid[k] = -1;
    ray.tnear[k] = 0;
    ray.tfar[k] = rays.range[k];
    both.hit.geomID[k] = both.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  if (again) {
    context.embree.filter = Impl::pass_own;
    rtcIntersect16(valid, impl_->top.get(), &context.embree, &both);
  }
  for (std::size_t k = 0; k < rays.count; ++k) {
    rays.range[k] = ray.tfar[k];
    rays.met[k] = owner(k).id;
    rays.facing[k] = rays.met[k] == RayBatch::kNobody ? 0 : std::fabs(impl_->facing(both, k));
    if (!rays.wants_normals || rays.met[k] == RayBatch::kNobody) continue;
    const std::array<float, 3> n = impl_->normal(both.hit, k);
    rays.nx[k] = n[0];
    rays.ny[k] = n[1];
    rays.nz[k] = n[2];
  }
}

}  // namespace playhouse::arena
