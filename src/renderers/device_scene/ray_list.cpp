// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/ray_list.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/trace_rays.h"

#include <algorithm>

namespace utsuri {
namespace {

Specialization with_query(Specialization specialization, RayQuery query) {
    specialization[interop::SPEC_ANY_HIT] = query == RayQuery::any_hit ? 1 : 0;
    return specialization;
}

/// Rays of one dispatch: some tens of milliseconds in software, and less than the workgroups a dispatch may
/// have.
constexpr std::uint32_t kRaysPerDispatch = 1u << 18;

}  // namespace

RayList::RayList(Device& device, const GpuScene& scene, RayQuery query)
    : device_(device),
      scene_(scene),
      kernel_(device, "trace_rays", kernels::trace_rays, with_query(scene.specialization(), query),
              sizeof(interop::TraceRaysPush)) {}

void RayList::upload(std::span<const interop::RayInfo> rays) {
    count_ = static_cast<std::uint32_t>(rays.size());
    rays_ = make_buffer(device_, rays, "rays");
    hits_.emplace(device_, std::max<std::uint64_t>(1, rays.size()) * sizeof(interop::HitInfo), "hits");
}

double RayList::trace() {
    if (count_ == 0) return 0.0;
    Bindings bindings = scene_.bindings();
    bindings[interop::BINDING_RAYS] = &*rays_;
    bindings[interop::BINDING_HITS] = &*hits_;
    const BindingSet set = kernel_.bind(bindings);
    double seconds = 0.0;
    for (std::uint32_t first = 0; first < count_; first += kRaysPerDispatch) {
        const interop::TraceRaysPush push{first, std::min(kRaysPerDispatch, count_ - first)};
        seconds += device_.run("trace rays", [&](const vk::raii::CommandBuffer& commands) {
            kernel_.dispatch(commands, set, push, group_count(push.count));
        });
    }
    return seconds;
}

std::vector<interop::HitInfo> RayList::hits() const {
    return hits_->download_records<interop::HitInfo>(count_);
}

}  // namespace utsuri
