// SPDX-License-Identifier: Apache-2.0
#include "support/embree_oracle.h"

#include <fmt/format.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

namespace utsuri {
namespace {

/// Calls work(first, last) for equal parts of [0, count) on `threads` threads.
template <typename Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < threads; ++t) {
        workers.emplace_back([=] { work(count * t / threads, count * (t + 1) / threads); });
    }
}

RTCRay embree_ray(const interop::RayInfo& info) {
    RTCRay ray{};
    ray.org_x = info.origin.x;
    ray.org_y = info.origin.y;
    ray.org_z = info.origin.z;
    ray.dir_x = info.direction.x;
    ray.dir_y = info.direction.y;
    ray.dir_z = info.direction.z;
    ray.tfar = info.t_max;
    ray.mask = ~0u;
    return ray;
}

void intersect(RTCScene scene, RTCRayHit& query) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &query);
#endif
}

void occluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace

struct EmbreeOracle::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
};

EmbreeOracle::EmbreeOracle(std::span<const interop::BvhTriangle> triangles, Mode mode)
    : state_(std::make_unique<State>()) {
    state_->device = rtcNewDevice(nullptr);
    state_->scene = rtcNewScene(state_->device);
    if (mode == Mode::robust) rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(state_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
    auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.size()));
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        positions[3 * i] = triangles[i].v0;
        positions[3 * i + 1] = triangles[i].v1;
        positions[3 * i + 2] = triangles[i].v2;
        indices[i] = glm::uvec3(3 * i, 3 * i + 1, 3 * i + 2);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(state_->scene);
    if (rtcGetDeviceError(state_->device) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree failed to build");
}

EmbreeOracle::~EmbreeOracle() {
    rtcReleaseScene(state_->scene);
    rtcReleaseDevice(state_->device);
}

std::vector<interop::HitInfo> EmbreeOracle::closest_hits(std::span<const interop::RayInfo> rays,
                                                         unsigned threads) const {
    std::vector<interop::HitInfo> hits(rays.size());
    in_parallel(rays.size(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            RTCRayHit query{};
            query.ray = embree_ray(rays[i]);
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            intersect(state_->scene, query);
            const bool hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            hits[i] =
                hit ? interop::HitInfo{query.ray.tfar, query.hit.primID, query.hit.u, query.hit.v}
                    : interop::HitInfo{std::numeric_limits<float>::infinity(), interop::NONE, 0.0f, 0.0f};
        }
    });
    return hits;
}

std::vector<std::uint8_t> EmbreeOracle::occlusions(std::span<const interop::RayInfo> rays,
                                                   unsigned threads) const {
    std::vector<std::uint8_t> result(rays.size());
    in_parallel(rays.size(), threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            RTCRay ray = embree_ray(rays[i]);
            occluded(state_->scene, ray);
            result[i] = ray.tfar < 0.0f ? 1 : 0;  // Embree marks a hit with minus infinity
        }
    });
    return result;
}

std::string EmbreeOracle::version() {
    return RTC_VERSION_STRING;
}

}  // namespace utsuri
