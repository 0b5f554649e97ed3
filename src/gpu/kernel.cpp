// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernel.h"

#include "base/check.h"
#include "gpu/vulkan_call.h"

namespace utsuri {
namespace {

Pipeline create_pipeline(Device& device, std::string name, std::span<const std::uint32_t> spirv,
                         const Specialization& specialization, std::uint32_t push_bytes) {
    const StageModule module{vk::ShaderStageFlagBits::eCompute, spirv};
    PipelineInterface interface(device, std::move(name), std::span(&module, 1), push_bytes);
    return vulkan_call("create kernel", interface.name(), [&] {
        const ShaderStage stage(device, vk::ShaderStageFlagBits::eCompute, spirv, specialization);
        vk::raii::Pipeline pipeline =
            device.handle().createComputePipeline(nullptr, {{}, stage.info(), interface.layout()});
        name_pipeline(device, pipeline, interface.name());
        return Pipeline(std::move(interface), std::move(pipeline));
    });
}

}  // namespace

Kernel::Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
               const Specialization& specialization, std::uint32_t push_bytes)
    : pipeline_(device.pipelines().find_or_make(
          PipelineRecipe().add(push_bytes).add_stage(spirv, specialization),
          [&] { return create_pipeline(device, std::move(name), spirv, specialization, push_bytes); })) {}

Kernel::Kernel(Kernel&& other) noexcept = default;
Kernel& Kernel::operator=(Kernel&& other) noexcept = default;
Kernel::~Kernel() = default;

void Kernel::prepare(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                     std::span<const std::byte> push) const {
    const vk::MemoryBarrier2 after_previous(
        vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
        vk::PipelineStageFlagBits2::eComputeShader | vk::PipelineStageFlagBits2::eDrawIndirect,
        vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_previous));
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_->handle);
    pipeline_->interface.use(commands, vk::PipelineBindPoint::eCompute, bindings, push);
}

void Kernel::dispatch_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                            std::span<const std::byte> push, std::uint32_t groups) const {
    UTSURI_CHECK_LE(groups, kMaxGroups);
    prepare(commands, bindings, push);
    commands.dispatch(groups, 1, 1);
}

}  // namespace utsuri
