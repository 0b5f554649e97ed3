// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernel.h"

#include "base/check.h"
#include "gpu/spirv.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>

namespace utsuri {
namespace {

vk::raii::DescriptorSetLayout create_set_layout(const Device& device,
                                                const std::vector<std::uint32_t>& bindings) {
    std::vector<vk::DescriptorSetLayoutBinding> entries;
    entries.reserve(bindings.size());
    for (const std::uint32_t binding : bindings) {
        entries.emplace_back(binding, vk::DescriptorType::eStorageBuffer, 1,
                             vk::ShaderStageFlagBits::eCompute);
    }
    return device.handle().createDescriptorSetLayout({{}, entries});
}

vk::raii::PipelineLayout create_layout(const Device& device, const vk::raii::DescriptorSetLayout& set_layout,
                                       std::uint32_t push_bytes) {
    const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, push_bytes);
    vk::PipelineLayoutCreateInfo info({}, *set_layout);
    if (push_bytes > 0) info.setPushConstantRanges(range);
    return device.handle().createPipelineLayout(info);
}

vk::raii::Pipeline create_pipeline(const Device& device, const std::string& name,
                                   std::span<const std::uint32_t> spirv, const Specialization& specialization,
                                   const vk::raii::PipelineLayout& layout) {
    std::vector<vk::SpecializationMapEntry> entries;
    std::vector<std::uint32_t> values;
    for (const std::uint32_t id : spirv_specialization_ids(spirv)) {
        const auto found = specialization.find(id);
        if (found == specialization.end()) continue;
        entries.emplace_back(id, static_cast<std::uint32_t>(values.size() * sizeof(std::uint32_t)),
                             sizeof(std::uint32_t));
        values.push_back(found->second);
    }
    const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                           values.size() * sizeof(std::uint32_t), values.data());
    const vk::raii::ShaderModule module =
        device.handle().createShaderModule({{}, spirv.size_bytes(), spirv.data()});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main",
                                                  &constants);
    vk::raii::Pipeline pipeline = device.handle().createComputePipeline(nullptr, {{}, stage, *layout});
    device.set_name(vk::ObjectType::ePipeline,
                    reinterpret_cast<std::uint64_t>(static_cast<VkPipeline>(*pipeline)), name);
    return pipeline;
}

}  // namespace

BindingSet::BindingSet(vk::raii::DescriptorPool pool, vk::raii::DescriptorSet set)
    : pool_(std::move(pool)), set_(std::move(set)) {}

BindingSet::BindingSet(BindingSet&& other) noexcept = default;
BindingSet& BindingSet::operator=(BindingSet&& other) noexcept = default;
BindingSet::~BindingSet() = default;

Kernel::Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
               const Specialization& specialization, std::uint32_t push_bytes)
    : device_(&device),
      name_(std::move(name)),
      push_bytes_(push_bytes),
      binding_numbers_(spirv_bindings(spirv)),
      set_layout_(
          vulkan_call("create kernel", name_, [&] { return create_set_layout(device, binding_numbers_); })),
      layout_(vulkan_call("create kernel", name_,
                          [&] { return create_layout(device, set_layout_, push_bytes); })),
      pipeline_(vulkan_call("create kernel", name_,
                            [&] { return create_pipeline(device, name_, spirv, specialization, layout_); })) {
}

Kernel::Kernel(Kernel&& other) noexcept = default;
Kernel& Kernel::operator=(Kernel&& other) noexcept = default;
Kernel::~Kernel() = default;

BindingSet Kernel::bind(const Bindings& buffers) const {
    return vulkan_call("bind buffers of kernel", name_, [&] {
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
                           fmt::format("kernel {} has no buffer for binding {}", name_, binding));
            }
            infos.emplace_back(found->second->handle(), 0, VK_WHOLE_SIZE);
            writes.emplace_back(*sets.front(), binding, 0, 1, vk::DescriptorType::eStorageBuffer, nullptr,
                                &infos.back());
        }
        device_->handle().updateDescriptorSets(writes, {});
        return BindingSet(std::move(pool), std::move(sets.front()));
    });
}

void Kernel::dispatch_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                            std::span<const std::byte> push, std::uint32_t groups) const {
    UTSURI_CHECK_EQ(push.size(), push_bytes_);
    const vk::MemoryBarrier2 after_previous(
        vk::PipelineStageFlagBits2::eComputeShader | vk::PipelineStageFlagBits2::eTransfer,
        vk::AccessFlagBits2::eMemoryWrite, vk::PipelineStageFlagBits2::eComputeShader,
        vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_previous));
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, bindings.handle(), {});
    commands.pushConstants<std::byte>(
        *layout_, vk::ShaderStageFlagBits::eCompute, 0,
        vk::ArrayProxy<const std::byte>(static_cast<std::uint32_t>(push.size()), push.data()));
    commands.dispatch(groups, 1, 1);
}

}  // namespace utsuri
