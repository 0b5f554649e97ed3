// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/pipeline_cache.h"

#include "interop/workgroup.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace utsuri {

/// Every Vulkan device takes this many workgroups in a dispatch.
inline constexpr std::uint32_t kMaxGroups = 65535;

/// The least number of workgroups that have so many invocations together.
constexpr std::uint32_t group_count(std::uint32_t invocations) {
    return invocations / interop::WORKGROUP_SIZE + (invocations % interop::WORKGROUP_SIZE != 0 ? 1 : 0);
}

/// A compute pipeline made from embedded SPIR-V. Its layout follows from the module: buffers of every
/// BindingKind in kDescriptorSets sets, one push constant block. Move-only. The pipeline itself is the
/// device's: see PipelineCache.
class Kernel {
  public:
    /// @param push_bytes size of the push constant block, 0 for none, at most 128
    Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
           const Specialization& specialization, std::uint32_t push_bytes);
    Kernel(Kernel&& other) noexcept;
    Kernel& operator=(Kernel&& other) noexcept;
    ~Kernel();

    /// Binds buffers; extra entries are passed over, a missing one is a failed check.
    [[nodiscard]] BindingSet bind(const Bindings& buffers) const {
        return pipeline_->interface.bind(buffers);
    }

    /// Records a dispatch of `groups` workgroups, ordered after everything recorded or run before.
    /// @param groups at most kMaxGroups
    template <typename Push>
    void dispatch(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, const Push& push,
                  std::uint32_t groups) const {
        dispatch_bytes(commands, bindings, std::as_bytes(std::span(&push, 1)), groups);
    }

    /// Records a dispatch whose VkDispatchIndirectCommand a kernel has left at the front of a buffer.
    template <typename Push>
    void dispatch_indirect(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                           const Push& push, const Buffer& arguments) const {
        prepare(commands, bindings, std::as_bytes(std::span(&push, 1)));
        commands.dispatchIndirect(arguments.handle(), 0);
    }

    /// Records as many dispatches as it takes to work on `count` invocations; none for 0.
    /// @param push its `begin` and `end` tell the kernel which of them a dispatch is for: [begin, end)
    /// @param most_groups of a dispatch, in [1, kMaxGroups]; how the work is cut changes no result
    template <typename Push>
    void dispatch_over(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, Push push,
                       std::uint32_t count, std::uint32_t most_groups = kMaxGroups) const {
        for (push.begin = 0; push.begin < count; push.begin = push.end) {
            push.end = push.begin + std::min(count - push.begin, most_groups * interop::WORKGROUP_SIZE);
            dispatch(commands, bindings, push, group_count(push.end - push.begin));
        }
    }

  private:
    /// Records all of a dispatch but itself.
    void prepare(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                 std::span<const std::byte> push) const;
    void dispatch_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                        std::span<const std::byte> push, std::uint32_t groups) const;

    std::shared_ptr<const Pipeline> pipeline_;
};

}  // namespace utsuri
