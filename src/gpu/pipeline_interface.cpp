// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_interface.h"

#include "base/check.h"
#include "gpu/spirv.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>

#include <map>

namespace utsuri {
namespace {

/// Binding numbers and the stages that declare them.
using StagesOfBindings = std::map<std::uint32_t, vk::ShaderStageFlags>;

StagesOfBindings stages_of_bindings(std::span<const StageModule> modules) {
    StagesOfBindings result;
    for (const StageModule& module : modules) {
        for (const std::uint32_t number : spirv_bindings(module.spirv))
            result[number] |= module.stage;
    }
    return result;
}

std::vector<std::uint32_t> binding_numbers(std::span<const StageModule> modules) {
    std::vector<std::uint32_t> numbers;
    for (const auto& [number, stages] : stages_of_bindings(modules))
        numbers.push_back(number);
    return numbers;
}

vk::ShaderStageFlags all_stages(std::span<const StageModule> modules) {
    vk::ShaderStageFlags stages;
    for (const StageModule& module : modules)
        stages |= module.stage;
    return stages;
}

vk::raii::DescriptorSetLayout create_set_layout(const Device& device, std::span<const StageModule> modules) {
    std::vector<vk::DescriptorSetLayoutBinding> entries;
    for (const auto& [number, stages] : stages_of_bindings(modules))
        entries.emplace_back(number, vk::DescriptorType::eStorageBuffer, 1, stages);
    return device.handle().createDescriptorSetLayout({{}, entries});
}

vk::raii::PipelineLayout create_layout(const Device& device, const vk::raii::DescriptorSetLayout& set_layout,
                                       vk::ShaderStageFlags stages, std::uint32_t push_bytes) {
    const vk::PushConstantRange range(stages, 0, push_bytes);
    vk::PipelineLayoutCreateInfo info({}, *set_layout);
    if (push_bytes > 0) info.setPushConstantRanges(range);
    return device.handle().createPipelineLayout(info);
}

}  // namespace

BindingSet::BindingSet(vk::raii::DescriptorPool pool, vk::raii::DescriptorSet set)
    : pool_(std::move(pool)), set_(std::move(set)) {}

BindingSet::BindingSet(BindingSet&& other) noexcept = default;
BindingSet& BindingSet::operator=(BindingSet&& other) noexcept = default;
BindingSet::~BindingSet() = default;

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
      binding_numbers_(binding_numbers(modules)),
      set_layout_(vulkan_call("create pipeline", name_, [&] { return create_set_layout(device, modules); })),
      layout_(vulkan_call("create pipeline", name_,
                          [&] { return create_layout(device, set_layout_, stages_, push_bytes_); })) {}

PipelineInterface::PipelineInterface(PipelineInterface&& other) noexcept = default;
PipelineInterface& PipelineInterface::operator=(PipelineInterface&& other) noexcept = default;
PipelineInterface::~PipelineInterface() = default;

BindingSet PipelineInterface::bind(const Bindings& buffers) const {
    return vulkan_call("bind buffers of", name_, [&] {
        const vk::DescriptorPoolSize size(vk::DescriptorType::eStorageBuffer,
                                          static_cast<std::uint32_t>(binding_numbers_.size()));
        vk::raii::DescriptorPool pool = device_->handle().createDescriptorPool(
            {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size});
        vk::raii::DescriptorSets sets(device_->handle(), {*pool, *set_layout_});
        std::vector<vk::DescriptorBufferInfo> infos;
        infos.reserve(binding_numbers_.size());
        std::vector<vk::WriteDescriptorSet> writes;
        for (const std::uint32_t binding : binding_numbers_) {
            const auto found = buffers.find(binding);
            if (found == buffers.end()) {
                fail_check(__FILE__, __LINE__,
                           fmt::format("{} has no buffer for binding {}", name_, binding));
            }
            infos.emplace_back(found->second->handle(), 0, VK_WHOLE_SIZE);
            writes.emplace_back(*sets.front(), binding, 0, 1, vk::DescriptorType::eStorageBuffer, nullptr,
                                &infos.back());
        }
        device_->handle().updateDescriptorSets(writes, {});
        return BindingSet(std::move(pool), std::move(sets.front()));
    });
}

void PipelineInterface::use(const vk::raii::CommandBuffer& commands, vk::PipelineBindPoint point,
                            const BindingSet& bindings, std::span<const std::byte> push) const {
    UTSURI_CHECK_EQ(push.size(), push_bytes_);
    commands.bindDescriptorSets(point, *layout_, 0, bindings.handle(), {});
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
