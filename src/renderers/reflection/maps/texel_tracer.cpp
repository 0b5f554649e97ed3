// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/maps/texel_tracer.h"

#include "base/progress.h"

#include "interop/bindings.h"
#include "interop/reflection.h"
#include "interop/specialization.h"
#include "kernels/resolve_map.h"
#include "kernels/trace_kept.h"

namespace utsuri {
namespace {

Specialization tracing_constants(const GpuScene& scene, std::uint32_t projection) {
    Specialization constants = scene.specialization();
    constants[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    constants[interop::SPEC_PROJECTION] = projection;
    return constants;
}

Bindings tracing_bindings(const GpuScene& scene, const SurfaceLight& light) {
    Bindings bindings = scene.bindings();
    bindings.merge(light.bindings());
    return bindings;
}

}  // namespace

TexelTracer::TexelTracer(Device& device, const GpuScene& scene, const SurfaceLight& light,
                         std::uint32_t projection)
    : device_(device),
      tracer_(device, "trace_kept", kernels::trace_kept, tracing_constants(scene, projection),
              tracing_bindings(scene, light)),
      resolver_(device, "resolve_map", kernels::resolve_map, {}, sizeof(interop::ResolveMapPush)) {}

void TexelTracer::warm_up(Film& film, const Buffer& texels) {
    tracer_.warm_up(film);
    const BindingSet set = bind_resolver(film.bands().front(), texels);
    device_.run("compile a kernel", [&](const vk::raii::CommandBuffer& commands) {
        resolver_.dispatch(commands, set, interop::ResolveMapPush{}, 1);
    });
}

FrameCounts TexelTracer::trace(Film& film, const FrameSettings& frame, std::uint32_t samples,
                               const Buffer& texels, std::uint32_t first_texel) {
    film.clear();
    Progress silent;
    FrameCounts counts = tracer_.add_samples(film, frame, samples, silent);
    for (const Film::Band& band : film.bands()) {
        const BindingSet set = bind_resolver(band, texels);
        const interop::ResolveMapPush push{film.width() * band.rows,
                                           first_texel + band.first_row * film.width(), samples};
        counts.gpu_seconds += device_.run("resolve a map", [&](const vk::raii::CommandBuffer& commands) {
            resolver_.dispatch(commands, set, push, group_count(push.texels));
        });
    }
    return counts;
}

BindingSet TexelTracer::bind_resolver(const Film::Band& band, const Buffer& texels) const {
    return resolver_.bind({{interop::BINDING_FILM, &band.pixels}, {interop::BINDING_MAP_TEXELS, &texels}});
}

}  // namespace utsuri
