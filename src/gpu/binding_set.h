// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/spirv.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace utsuri {

/// Which buffer is bound at which binding number.
using Bindings = std::map<std::uint32_t, const Buffer*>;

/// Descriptor sets of every pipeline: the scene's buffers, and what a method adds.
inline constexpr std::uint32_t kDescriptorSets = 2;

/// Buffers bound for one pipeline, which must outlive this. Move-only.
class BindingSet {
  public:
    /// Extra entries of `buffers` are passed over, a missing one is a failed check.
    /// @param pipeline its name, for messages
    /// @param declared what its stages declare
    /// @param layouts of its kDescriptorSets sets
    /// @throws DeviceError if a buffer is larger than kernels can read of it that way
    BindingSet(const Device& device, const std::string& pipeline, std::span<const SpirvBinding> declared,
               std::span<const vk::DescriptorSetLayout> layouts, const Bindings& buffers);
    BindingSet(BindingSet&& other) noexcept;
    BindingSet& operator=(BindingSet&& other) noexcept;
    ~BindingSet();
    [[nodiscard]] std::vector<vk::DescriptorSet> handles() const;

  private:
    std::vector<vk::raii::BufferView> views_;  ///< of what is read as texels
    vk::raii::DescriptorPool pool_;
    std::vector<vk::raii::DescriptorSet> sets_;
};

}  // namespace utsuri
