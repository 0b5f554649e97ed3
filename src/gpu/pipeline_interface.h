// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/binding_set.h"
#include "gpu/device.h"
#include "gpu/spirv.h"

#include <map>
#include <span>
#include <string>
#include <vector>

namespace utsuri {

/// Values of specialization constants by id; ids a shader does not declare are passed over.
using Specialization = std::map<std::uint32_t, std::uint32_t>;

/// One stage of a pipeline: embedded SPIR-V and what of the constants it declares.
class ShaderStage {
  public:
    ShaderStage(const Device& device, vk::ShaderStageFlagBits stage, std::span<const std::uint32_t> spirv,
                const Specialization& specialization);
    ShaderStage(const ShaderStage&) = delete;
    ShaderStage& operator=(const ShaderStage&) = delete;

    /// Refers to this object.
    [[nodiscard]] vk::PipelineShaderStageCreateInfo info() const;

  private:
    vk::ShaderStageFlagBits stage_;
    vk::raii::ShaderModule module_;
    std::vector<vk::SpecializationMapEntry> entries_;
    std::vector<std::uint32_t> values_;
    vk::SpecializationInfo constants_;
};

/// The SPIR-V of one stage.
struct StageModule {
    vk::ShaderStageFlagBits stage;
    std::span<const std::uint32_t> spirv;
};

/// What a pipeline reads: buffers, found from its SPIR-V, and one push constant
/// block. Move-only.
class PipelineInterface {
  public:
    /// Each buffer is bound for the stages that declare it: devices bound how many one stage may see.
    /// @param push_bytes size of the push constant block that all stages see, 0 for none, at most 128
    PipelineInterface(Device& device, std::string name, std::span<const StageModule> modules,
                      std::uint32_t push_bytes);
    PipelineInterface(PipelineInterface&& other) noexcept;
    PipelineInterface& operator=(PipelineInterface&& other) noexcept;
    ~PipelineInterface();

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] vk::PipelineLayout layout() const { return *layout_; }

    /// Binds buffers; extra entries are passed over, a missing one is a failed check.
    [[nodiscard]] BindingSet bind(const Bindings& buffers) const;

    /// Records what the next dispatch or draw reads.
    void use(const vk::raii::CommandBuffer& commands, vk::PipelineBindPoint point, const BindingSet& bindings,
             std::span<const std::byte> push) const;

  private:
    Device* device_;
    std::string name_;
    vk::ShaderStageFlags stages_;
    std::uint32_t push_bytes_;
    std::vector<SpirvBinding> declared_;
    std::vector<vk::raii::DescriptorSetLayout> set_layouts_;
    vk::raii::PipelineLayout layout_;
};

/// Gives a pipeline its debug name.
void name_pipeline(const Device& device, const vk::raii::Pipeline& pipeline, const std::string& name);

}  // namespace utsuri
