// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_interface.h"

#include "base/check.h"
#include "gpu/vulkan_call.h"

#include <array>
#include <map>

namespace utsuri {
namespace {

/// Buffers and the stages that declare them.
using StagesOfBindings = std::map<SpirvBinding, vk::ShaderStageFlags>;

StagesOfBindings stages_of_bindings(std::span<const StageModule> modules) {
    StagesOfBindings result;
    for (const StageModule& module : modules) {
        for (const SpirvBinding& binding : spirv_bindings(module.spirv)) {
            UTSURI_CHECK_LT(binding.set, kDescriptorSets);
            result[binding] |= module.stage;
        }
    }
    return result;
}

std::vector<SpirvBinding> declared_bindings(std::span<const StageModule> modules) {
    std::vector<SpirvBinding> bindings;
    for (const auto& [binding, stages] : stages_of_bindings(modules))
        bindings.push_back(binding);
    return bindings;
}

vk::ShaderStageFlags all_stages(std::span<const StageModule> modules) {
    vk::ShaderStageFlags stages;
    for (const StageModule& module : modules)
        stages |= module.stage;
    return stages;
}

std::vector<vk::raii::DescriptorSetLayout> create_set_layouts(const Device& device,
                                                              std::span<const StageModule> modules) {
    std::array<std::vector<vk::DescriptorSetLayoutBinding>, kDescriptorSets> entries;
    for (const auto& [binding, stages] : stages_of_bindings(modules))
        entries[binding.set].emplace_back(binding.number, descriptor_type(binding.kind), 1, stages);
    std::vector<vk::raii::DescriptorSetLayout> layouts;
    layouts.reserve(entries.size());
    for (const auto& set : entries)
        layouts.push_back(device.handle().createDescriptorSetLayout({{}, set}));
    return layouts;
}

std::vector<vk::DescriptorSetLayout> handles_of(const std::vector<vk::raii::DescriptorSetLayout>& layouts) {
    std::vector<vk::DescriptorSetLayout> handles;
    handles.reserve(layouts.size());
    for (const vk::raii::DescriptorSetLayout& layout : layouts)
        handles.push_back(*layout);
    return handles;
}

vk::raii::PipelineLayout create_layout(const Device& device,
                                       const std::vector<vk::raii::DescriptorSetLayout>& set_layouts,
                                       vk::ShaderStageFlags stages, std::uint32_t push_bytes) {
    const vk::PushConstantRange range(stages, 0, push_bytes);
    const std::vector<vk::DescriptorSetLayout> sets = handles_of(set_layouts);
    vk::PipelineLayoutCreateInfo info({}, sets);
    if (push_bytes > 0) info.setPushConstantRanges(range);
    return device.handle().createPipelineLayout(info);
}

}  // namespace

ShaderStage::ShaderStage(const Device& device, vk::ShaderStageFlagBits stage,
                         std::span<const std::uint32_t> spirv, const Specialization& specialization)
    : stage_(stage), module_(device.handle().createShaderModule({{}, spirv.size_bytes(), spirv.data()})) {
    for (const std::uint32_t id : spirv_specialization_ids(spirv)) {
        const auto found = specialization.find(id);
        if (found == specialization.end()) continue;
        entries_.emplace_back(id, static_cast<std::uint32_t>(values_.size() * sizeof(std::uint32_t)),
                              sizeof(std::uint32_t));
        values_.push_back(found->second);
    }
    constants_ = vk::SpecializationInfo(static_cast<std::uint32_t>(entries_.size()), entries_.data(),
                                        values_.size() * sizeof(std::uint32_t), values_.data());
}

vk::PipelineShaderStageCreateInfo ShaderStage::info() const {
    return {{}, stage_, *module_, "main", &constants_};
}

PipelineInterface::PipelineInterface(Device& device, std::string name, std::span<const StageModule> modules,
                                     std::uint32_t push_bytes)
    : device_(&device),
      name_(std::move(name)),
      stages_(all_stages(modules)),
      push_bytes_(push_bytes),
      declared_(declared_bindings(modules)),
      set_layouts_(
          vulkan_call("create pipeline", name_, [&] { return create_set_layouts(device, modules); })),
      layout_(vulkan_call("create pipeline", name_,
                          [&] { return create_layout(device, set_layouts_, stages_, push_bytes_); })) {}

PipelineInterface::PipelineInterface(PipelineInterface&& other) noexcept = default;
PipelineInterface& PipelineInterface::operator=(PipelineInterface&& other) noexcept = default;
PipelineInterface::~PipelineInterface() = default;

BindingSet PipelineInterface::bind(const Bindings& buffers) const {
    return vulkan_call("bind buffers of", name_, [&] {
        return BindingSet(*device_, name_, declared_, handles_of(set_layouts_), buffers);
    });
}

void PipelineInterface::use(const vk::raii::CommandBuffer& commands, vk::PipelineBindPoint point,
                            const BindingSet& bindings, std::span<const std::byte> push) const {
    UTSURI_CHECK_EQ(push.size(), push_bytes_);
    commands.bindDescriptorSets(point, *layout_, 0, bindings.handles(), {});
    if (push.empty()) return;
    commands.pushConstants<std::byte>(
        *layout_, stages_, 0,
        vk::ArrayProxy<const std::byte>(static_cast<std::uint32_t>(push.size()), push.data()));
}

void name_pipeline(const Device& device, const vk::raii::Pipeline& pipeline, const std::string& name) {
    device.set_name(vk::ObjectType::ePipeline,
                    reinterpret_cast<std::uint64_t>(static_cast<VkPipeline>(*pipeline)), name);
}

}  // namespace utsuri
