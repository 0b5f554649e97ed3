// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/scene/scene_data.h"

#include "gpu/buffer.h"
#include "gpu/kernel.h"

namespace utsuri {

/// A scene on the device, with what kernels need to know about it before they are compiled.
class GpuScene {
  public:
    /// @throws DeviceError if the scene does not fit
    GpuScene(Device& device, const SceneData& data);
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    /// Takes over a change of the scene: update_scene_data().
    /// @param data of as many records as before
    void update(const SceneData& data);
    /// SceneData::light_revision.
    [[nodiscard]] std::uint32_t light_revision() const { return light_revision_; }

    /// Binding numbers of the scene's buffers. Buffers the scene does not require stand in as one zeroed
    /// record.
    [[nodiscard]] Bindings bindings() const;
    /// Values of the constants that follow from the scene.
    [[nodiscard]] const Specialization& specialization() const { return specialization_; }
    /// Most specular reflections that a ray can meet: Requirements::max_depth. What a kernel need not
    /// follow leaves room for more samples in a dispatch.
    [[nodiscard]] std::uint32_t max_depth() const { return max_depth_; }

  private:
    Specialization specialization_;
    std::uint32_t max_depth_;
    std::uint32_t light_revision_;
    Buffer nodes_;
    Buffer triangles_;
    Buffer triangle_infos_;
    Buffer normals_;
    Buffer texcoords_;
    Buffer materials_;
    Buffer lights_;
    Buffer light_table_;
    Buffer texture_headers_;
    Buffer texels_;
};

}  // namespace utsuri
