// SPDX-License-Identifier: Apache-2.0
#include "renderers/scene/gpu_scene.h"

#include "base/check.h"

#include "interop/bindings.h"
#include "interop/specialization.h"

namespace utsuri {
namespace {

template <typename Record>
Buffer upload(Device& device, const std::vector<Record>& records, const char* name) {
    return make_buffer<Record>(device, records, name);
}

/// Puts as many records in the place of those that a buffer was made of.
template <typename Record>
void replace(Buffer& buffer, const std::vector<Record>& records) {
    if (!records.empty()) buffer.upload(std::as_bytes(std::span(records)));
}

Specialization specialise(const SceneData& data) {
    const Requirements& needs = data.requirements;
    return {{interop::SPEC_STACK_SIZE, data.bvh.depth},
            {interop::SPEC_HAS_TEXTURES, needs.textures > 0 ? 1 : 0},
            {interop::SPEC_HAS_TRIANGLE_LIGHTS, needs.emissive_triangles > 0 ? 1 : 0},
            {interop::SPEC_HAS_PUNCTUAL_LIGHTS, needs.punctual_lights > 0 ? 1 : 0},
            {interop::SPEC_ENVIRONMENT_LIGHT, data.environment_light().value_or(interop::NONE)},
            {interop::SPEC_HAS_GLOSSY, needs.glossy ? 1 : 0},
            {interop::SPEC_HAS_SPECULAR, needs.specular ? 1 : 0},
            {interop::SPEC_LIGHT_COUNT, static_cast<std::uint32_t>(data.lights.size())}};
}

}  // namespace

GpuScene::GpuScene(Device& device, const SceneData& data)
    : specialization_(specialise(data)),
      max_depth_(data.requirements.max_depth),
      light_revision_(data.light_revision),
      nodes_(upload(device, data.bvh.nodes, "BVH nodes")),
      triangles_(upload(device, data.bvh.triangles, "BVH triangles")),
      triangle_infos_(upload(device, data.triangle_infos, "triangle infos")),
      normals_(upload(device, data.normals, "normals")),
      texcoords_(upload(device, data.texcoords, "texcoords")),
      materials_(upload(device, data.materials, "materials")),
      lights_(upload(device, data.lights, "lights")),
      light_table_(upload(device, data.light_table, "light table")),
      texture_headers_(upload(device, data.texture_headers, "texture headers")),
      texels_(upload(device, data.texels, "texels")) {}

void GpuScene::update(const SceneData& data) {
    UTSURI_CHECK(specialise(data) == specialization_);
    max_depth_ = data.requirements.max_depth;
    light_revision_ = data.light_revision;
    replace(nodes_, data.bvh.nodes);
    replace(triangles_, data.bvh.triangles);
    replace(triangle_infos_, data.triangle_infos);
    replace(normals_, data.normals);
    replace(texcoords_, data.texcoords);
    replace(materials_, data.materials);
    replace(lights_, data.lights);
    replace(light_table_, data.light_table);
    replace(texture_headers_, data.texture_headers);
    replace(texels_, data.texels);
}

Bindings GpuScene::bindings() const {
    return {{interop::BINDING_BVH_NODES, &nodes_},
            {interop::BINDING_BVH_TRIANGLES, &triangles_},
            {interop::BINDING_TRIANGLE_INFOS, &triangle_infos_},
            {interop::BINDING_NORMALS, &normals_},
            {interop::BINDING_TEXCOORDS, &texcoords_},
            {interop::BINDING_MATERIALS, &materials_},
            {interop::BINDING_LIGHTS, &lights_},
            {interop::BINDING_LIGHT_TABLE, &light_table_},
            {interop::BINDING_TEXTURE_HEADERS, &texture_headers_},
            {interop::BINDING_TEXELS, &texels_}};
}

}  // namespace utsuri
