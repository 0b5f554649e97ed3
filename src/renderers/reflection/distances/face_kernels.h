// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/reflection/distances/distance_levels.h"

#include "gpu/budgeted_run.h"

#include "interop/distance_map.h"

#include <cstdint>
#include <span>
#include <string>

namespace utsuri {

/// A kernel's name and SPIR-V.
struct KernelCode {
    const char* name;
    std::span<const std::uint32_t> spirv;
};

/// Measures the samples of a face about a capture point, and bounds them over blocks: the finest level first,
/// then each coarser one from that below.
class FaceKernels {
  public:
    /// @param bound makes the finest level, `reduce` each other
    /// @param specialization of `measure` and `bound`
    FaceKernels(Device& device, const KernelCode& measure, const KernelCode& bound, const KernelCode& reduce,
                const Specialization& specialization, const Bindings& bindings)
        : device_(device),
          measure_(device, measure.name, measure.spirv, specialization, sizeof(interop::MeasureFacePush)),
          bound_(device, bound.name, bound.spirv, specialization, sizeof(interop::BoundDistancesPush)),
          reduce_(device, reduce.name, reduce.spirv, {}, sizeof(interop::BoundDistancesPush)),
          measure_set_(measure_.bind(bindings)),
          bound_set_(bound_.bind(bindings)),
          reduce_set_(reduce_.bind(bindings)) {
        // Drivers may compile at the first dispatch; these have nothing to work on.
        device.run("compile kernels", [&](const vk::raii::CommandBuffer& commands) {
            measure_.dispatch(commands, measure_set_, interop::MeasureFacePush{}, 1);
            bound_.dispatch(commands, bound_set_, interop::BoundDistancesPush{}, 1);
            reduce_.dispatch(commands, reduce_set_, interop::BoundDistancesPush{}, 1);
        });
    }

    /// @param title of what is measured, for messages
    /// @param size texels along the edge of the face, a power of two
    /// @param first_bounds of the face, where they are stored
    /// @returns seconds on the device
    double run(const std::string& title, const interop::MeasureFacePush& push, std::uint32_t size,
               std::uint32_t first_bounds) {
        const double seconds = run_in_budget(device_, "measure " + title, measure_, measure_set_, push,
                                             samples_per_face(size), budget_);
        return seconds + device_.run("bound " + title, [&](const vk::raii::CommandBuffer& commands) {
            bound_.dispatch(commands, bound_set_,
                            interop::BoundDistancesPush{push.first_sample, first_bounds, size},
                            group_count(size * size));
            for (std::uint32_t level = 1; level < bound_levels(size); ++level) {
                const std::uint32_t edge = size >> level;
                const interop::BoundDistancesPush next{first_bounds + first_of_level(size, level - 1),
                                                       first_bounds + first_of_level(size, level), edge};
                reduce_.dispatch(commands, reduce_set_, next, group_count(edge * edge));
            }
        });
    }

  private:
    Device& device_;
    Kernel measure_;
    Kernel bound_;
    Kernel reduce_;
    BindingSet measure_set_;
    BindingSet bound_set_;
    BindingSet reduce_set_;
    DispatchBudget budget_;
};

}  // namespace utsuri
