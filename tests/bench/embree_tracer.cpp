#include "embree_tracer.hpp"

#include "base/error.hpp"

#include <cstring>

#if AJAR_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace ajar::bench {
namespace {

// The two versions differ in how a query is configured; neither is configured here.
void intersect1(RTCScene scene, RTCRayHit& ray) {
#if AJAR_EMBREE_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

void occluded1(RTCScene scene, RTCRay& ray) {
#if AJAR_EMBREE_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

RTCRay make_ray(const glm::vec3& origin, const glm::vec3& direction, float limit) {
    RTCRay ray;
    ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = 0;
    ray.tfar = limit;
    ray.time = 0;
    ray.mask = 0xffffffffu;
    ray.id = 0;
    ray.flags = 0;
    return ray;
}

} // namespace

struct EmbreeTracer::Impl {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = nullptr;
    ~Impl() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

EmbreeTracer::EmbreeTracer(std::span<const shared::TriangleRecord> triangles)
    : impl_(std::make_unique<Impl>()) {
    if (impl_->device == nullptr) throw Error("embree: cannot create a device");
    impl_->scene = rtcNewScene(impl_->device);
    RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::size_t vertex = 3 * i + std::size_t(k);
            const glm::vec3 corner = bvh::record_vertex(triangles[i], k);
            std::memcpy(vertices + 3 * vertex, &corner, sizeof(corner));
            indices[vertex] = std::uint32_t(vertex);
        }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(impl_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(impl_->scene);
}

EmbreeTracer::~EmbreeTracer() = default;

void EmbreeTracer::intersect(std::span<const shared::PathState> rays, std::span<EmbreeHit> hits) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRayHit query;
        query.ray = make_ray(rays[i].origin, rays[i].direction, 3.0e38f);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        intersect1(impl_->scene, query);
        const bool hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        hits[i] = {query.ray.tfar, hit ? query.hit.primID : shared::NO_TRIANGLE};
    }
}

void EmbreeTracer::occluded(std::span<const shared::ShadowRay> rays, std::span<char> open) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRay query = make_ray(rays[i].origin, rays[i].direction, rays[i].reach);
        occluded1(impl_->scene, query);
        open[i] = query.tfar >= 0; // -inf: something is in the way
    }
}

} // namespace ajar::bench
