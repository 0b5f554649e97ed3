// SPDX-License-Identifier: Apache-2.0
#include "gpu/raster_pipeline.h"

#include "gpu/vulkan_call.h"

#include <array>
#include <optional>
#include <vector>

namespace utsuri {
namespace {

constexpr vk::ShaderStageFlags kStages =
    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

std::vector<std::span<const std::uint32_t>> modules(std::span<const std::uint32_t> vertex,
                                                    std::span<const std::uint32_t> fragment) {
    if (fragment.empty()) return {vertex};
    return {vertex, fragment};
}

vk::raii::Pipeline create_pipeline(const Device& device, const PipelineInterface& interface,
                                   std::span<const std::uint32_t> vertex,
                                   std::span<const std::uint32_t> fragment,
                                   const Specialization& specialization, const DepthState& depth_state) {
    const ShaderStage vertex_stage(device, vk::ShaderStageFlagBits::eVertex, vertex, specialization);
    std::vector stages = {vertex_stage.info()};
    std::optional<ShaderStage> fragment_stage;
    if (!fragment.empty()) {
        fragment_stage.emplace(device, vk::ShaderStageFlagBits::eFragment, fragment, specialization);
        stages.push_back(fragment_stage->info());
    }
    const vk::PipelineVertexInputStateCreateInfo pulled;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.cullMode = vk::CullModeFlagBits::eNone;
    rasterization.lineWidth = 1.0f;
    rasterization.depthBiasEnable = depth_state.behind != 0.0f ? VK_TRUE : VK_FALSE;
    rasterization.depthBiasConstantFactor = -depth_state.behind;
    const vk::PipelineMultisampleStateCreateInfo single_sample({}, vk::SampleCountFlagBits::e1);
    const bool nearer = depth_state.test == DepthTest::nearer;
    const vk::PipelineDepthStencilStateCreateInfo depth(
        {}, VK_TRUE, nearer ? VK_TRUE : VK_FALSE, nearer ? vk::CompareOp::eGreater : vk::CompareOp::eEqual);
    using Channel = vk::ColorComponentFlagBits;
    vk::PipelineColorBlendAttachmentState overwrite;
    if (fragment_stage) overwrite.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA;
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eClear, overwrite);
    const std::array dynamic = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic_state({}, dynamic);
    const vk::PipelineRenderingCreateInfo formats(0, kColourFormat, kDepthFormat);
    vk::GraphicsPipelineCreateInfo info({}, stages, &pulled, &assembly, nullptr, &viewport, &rasterization,
                                        &single_sample, &depth, &blend, &dynamic_state, interface.layout());
    info.pNext = &formats;
    vk::raii::Pipeline pipeline = device.handle().createGraphicsPipeline(nullptr, info);
    name_pipeline(device, pipeline, interface.name());
    return pipeline;
}

vk::ImageMemoryBarrier2 discarded_before(const Attachment& attachment) {
    // Its old contents are of no use, but whoever drew or read them has to be done.
    return {vk::PipelineStageFlagBits2::eAllCommands,
            vk::AccessFlagBits2::eMemoryWrite,
            vk::PipelineStageFlagBits2::eColorAttachmentOutput |
                vk::PipelineStageFlagBits2::eEarlyFragmentTests |
                vk::PipelineStageFlagBits2::eLateFragmentTests,
            vk::AccessFlagBits2::eColorAttachmentWrite | vk::AccessFlagBits2::eDepthStencilAttachmentRead |
                vk::AccessFlagBits2::eDepthStencilAttachmentWrite,
            vk::ImageLayout::eUndefined,
            vk::ImageLayout::eAttachmentOptimal,
            VK_QUEUE_FAMILY_IGNORED,
            VK_QUEUE_FAMILY_IGNORED,
            attachment.image(),
            {attachment.aspect(), 0, 1, 0, 1}};
}

vk::RenderingAttachmentInfo cleared(const Attachment& attachment, const vk::ClearValue& value) {
    vk::RenderingAttachmentInfo info(attachment.view(), vk::ImageLayout::eAttachmentOptimal);
    info.loadOp = vk::AttachmentLoadOp::eClear;
    info.storeOp = vk::AttachmentStoreOp::eStore;
    info.clearValue = value;
    return info;
}

}  // namespace

RasterPipeline::RasterPipeline(Device& device, const std::string& name, std::span<const std::uint32_t> vertex,
                               std::span<const std::uint32_t> fragment, const Specialization& specialization,
                               std::uint32_t push_bytes, const DepthState& depth)
    : interface_(device, name, modules(vertex, fragment), kStages, push_bytes),
      pipeline_(vulkan_call("create pipeline", name, [&] {
          return create_pipeline(device, interface_, vertex, fragment, specialization, depth);
      })) {}

RasterPipeline::RasterPipeline(RasterPipeline&& other) noexcept = default;
RasterPipeline& RasterPipeline::operator=(RasterPipeline&& other) noexcept = default;
RasterPipeline::~RasterPipeline() = default;

void RasterPipeline::draw_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                                std::span<const std::byte> push, std::uint32_t first,
                                std::uint32_t triangles) const {
    if (triangles == 0) return;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    interface_.use(commands, vk::PipelineBindPoint::eGraphics, bindings, push);
    commands.draw(3 * triangles, 1, 3 * first, 0);
}

void RasterPipeline::draw_indirect_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                                         std::span<const std::byte> push, const Buffer& arguments,
                                         std::uint32_t index) const {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    interface_.use(commands, vk::PipelineBindPoint::eGraphics, bindings, push);
    commands.drawIndirect(arguments.handle(), index * sizeof(vk::DrawIndirectCommand), 1, 0);
}

void draw_into(const vk::raii::CommandBuffer& commands, const Attachment& colour, const Attachment& depth,
               const std::array<float, 4>& background, const std::function<void()>& record) {
    const vk::MemoryBarrier2 after_previous(
        vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
        vk::PipelineStageFlagBits2::eAllGraphics, vk::AccessFlagBits2::eMemoryRead);
    const std::array images = {discarded_before(colour), discarded_before(depth)};
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_previous, {}, images));
    const vk::RenderingAttachmentInfo colour_info = cleared(colour, vk::ClearColorValue(background));
    const vk::RenderingAttachmentInfo depth_info = cleared(depth, vk::ClearDepthStencilValue(0.0f, 0));
    const vk::Rect2D area({0, 0}, {colour.width(), colour.height()});
    commands.beginRendering(vk::RenderingInfo({}, area, 1, 0, colour_info, &depth_info));
    commands.setViewport(0, vk::Viewport(0.0f, 0.0f, static_cast<float>(colour.width()),
                                         static_cast<float>(colour.height()), 0.0f, 1.0f));
    commands.setScissor(0, area);
    record();
    commands.endRendering();
}

}  // namespace utsuri
