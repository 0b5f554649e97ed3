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

/// What is read as texels comes four words at a time, and buffers of it are whole texels: CPUs gather them
/// for all lanes of a subgroup at once, where they load other buffers word by word.
inline constexpr std::uint64_t kTexelBytes = 16;

/// What descriptors of a kind of binding are.
vk::DescriptorType descriptor_type(BindingKind kind);

/// Buffers bound for one pipeline, which must outlive this. Move-only.
class BindingSet {
  public:
    /// Extra entries of `buffers` are passed over, a missing one is a failed check.
    /// @param pipeline its name, for messages
    /// @param declared what its stages declare
    /// @param layouts of its kDescriptorSets sets
    /// @throws DeviceError if a buffer that is read as texels has more of them than the device can see
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
