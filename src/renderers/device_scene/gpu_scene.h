// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"

#include "gpu/buffer.h"
#include "gpu/kernel.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace utsuri {

/// A scene on the device, with what kernels need to know about it before they are compiled.
class GpuScene {
  public:
    /// @throws DeviceError if the scene does not fit
    GpuScene(Device& device, const SceneData& data);
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    /// Takes over a change of the scene, after update_scene_data(): uploads what differs, or all where a
    /// change was left out. If the change was SceneChange::rebuilt, some buffers may be others: what was
    /// bound must be bound anew, and kernels with other constants compiled anew.
    /// @param data what this was made of
    /// @throws DeviceError if the scene does not fit any more; then only another update() or the end of its
    /// life may follow
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
    struct Held {
        std::uint32_t binding;
        std::optional<Buffer> buffer;  ///< none only while it is made anew
    };
    void describe(const SceneData& data);

    Device* device_;
    Specialization specialization_;
    std::uint32_t max_depth_ = 0;
    std::uint32_t light_revision_ = 0;
    std::optional<std::uint32_t> revision_;  ///< SceneData::revision that all buffers are of
    std::vector<Held> buffers_;              ///< in the order of scene_buffers()
};

}  // namespace utsuri
