// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/scene_buffers.h"

#include "interop/bindings.h"

#include <type_traits>

namespace utsuri {
namespace {

template <typename Record>
SceneBuffer of(const char* name, std::uint32_t binding, const std::vector<Record>& records,
               BindingKind kind = BindingKind::storage) {
    static_assert(std::is_trivially_copyable_v<Record>);
    return {name, binding, kind, sizeof(Record), std::as_bytes(std::span(records))};
}

}  // namespace

std::array<SceneBuffer, kSceneBuffers> scene_buffers(const SceneData& data) {
    return {of("BVH nodes", interop::BINDING_BVH_NODES, data.bvh.nodes, BindingKind::texels),
            of("BVH triangles", interop::BINDING_BVH_TRIANGLES, data.bvh.triangles, BindingKind::texels),
            of("triangle infos", interop::BINDING_TRIANGLE_INFOS, data.triangle_infos),
            of("normals", interop::BINDING_NORMALS, data.normals),
            of("texcoords", interop::BINDING_TEXCOORDS, data.texcoords),
            of("materials", interop::BINDING_MATERIALS, data.materials),
            of("lights", interop::BINDING_LIGHTS, data.lights),
            of("texels", interop::BINDING_TEXELS, data.texels),
            of("light tree", interop::BINDING_LIGHT_TREE, data.light_tree, BindingKind::texels)};
}

}  // namespace utsuri
