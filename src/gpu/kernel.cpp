// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernel.h"

#include "gpu/vulkan_call.h"

namespace utsuri {
namespace {

vk::raii::Pipeline create_pipeline(const Device& device, const PipelineInterface& interface,
                                   std::span<const std::uint32_t> spirv,
                                   const Specialization& specialization) {
    const ShaderStage stage(device, vk::ShaderStageFlagBits::eCompute, spirv, specialization);
    vk::raii::Pipeline pipeline =
        device.handle().createComputePipeline(nullptr, {{}, stage.info(), interface.layout()});
    name_pipeline(device, pipeline, interface.name());
    return pipeline;
}

}  // namespace

Kernel::Kernel(Device& device, std::string name, std::span<const std::uint32_t> spirv,
               const Specialization& specialization, std::uint32_t push_bytes)
    : interface_(device, std::move(name), std::span(&spirv, 1), vk::ShaderStageFlagBits::eCompute,
                 push_bytes),
      pipeline_(vulkan_call("create kernel", interface_.name(),
                            [&] { return create_pipeline(device, interface_, spirv, specialization); })) {}

Kernel::Kernel(Kernel&& other) noexcept = default;
Kernel& Kernel::operator=(Kernel&& other) noexcept = default;
Kernel::~Kernel() = default;

void Kernel::dispatch_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                            std::span<const std::byte> push, std::uint32_t groups) const {
    const vk::MemoryBarrier2 after_previous(
        vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
        vk::PipelineStageFlagBits2::eComputeShader,
        vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_previous));
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
    interface_.use(commands, vk::PipelineBindPoint::eCompute, bindings, push);
    commands.dispatch(groups, 1, 1);
}

}  // namespace utsuri
