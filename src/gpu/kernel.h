// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "gpu/device.h"

#include <map>
#include <span>
#include <string>

namespace utsuri {

/// Values of specialization constants by id; ids a kernel does not declare are passed over.
using Specialization = std::map<std::uint32_t, std::uint32_t>;

/// Which buffer is bound at which binding number.
using Bindings = std::map<std::uint32_t, const Buffer*>;

/// A set of buffers bound for one kernel. The buffers must outlive it.
class BindingSet {
  public:
    BindingSet(vk::raii::DescriptorPool pool, vk::raii::DescriptorSet set);
    BindingSet(BindingSet&& other) noexcept;
    BindingSet& operator=(BindingSet&& other) noexcept;
    ~BindingSet();
    [[nodiscard]] vk::DescriptorSet handle() const { return *set_; }

  private:
    vk::raii::DescriptorPool pool_;
    vk::raii::DescriptorSet set_;
};

/// A compute pipeline made from embedded SPIR-V. Its layout follows from the module: storage buffers in set
/// 0, one push constant block. Move-only.
class Kernel {
  public:
    /// @param push_bytes size of the push constant block, 0 for none, at most 128
    Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
           const Specialization& specialization, std::uint32_t push_bytes);
    Kernel(Kernel&& other) noexcept;
    Kernel& operator=(Kernel&& other) noexcept;
    ~Kernel();

    /// Binds buffers; extra entries are passed over, a missing one is a failed check.
    [[nodiscard]] BindingSet bind(const Bindings& buffers) const;

    /// Records a dispatch of `groups` workgroups, ordered after everything recorded or run before.
    template <typename Push>
    void dispatch(const vk::raii::CommandBuffer& commands, const BindingSet& bindings, const Push& push,
                  std::uint32_t groups) const {
        dispatch_bytes(commands, bindings, std::as_bytes(std::span(&push, 1)), groups);
    }

  private:
    void dispatch_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                        std::span<const std::byte> push, std::uint32_t groups) const;

    Device* device_;
    std::string name_;
    std::uint32_t push_bytes_;
    std::vector<std::uint32_t> binding_numbers_;
    vk::raii::DescriptorSetLayout set_layout_;
    vk::raii::PipelineLayout layout_;
    vk::raii::Pipeline pipeline_;
};

}  // namespace utsuri
