// SPDX-License-Identifier: Apache-2.0
#include "gpu/raster_pipeline.h"

#include "gpu/vulkan_call.h"

#include <array>
#include <bit>
#include <optional>
#include <vector>

namespace utsuri {
namespace {

std::vector<StageModule> modules(std::span<const std::uint32_t> vertex,
                                 std::span<const std::uint32_t> fragment) {
    std::vector<StageModule> result = {{vk::ShaderStageFlagBits::eVertex, vertex}};
    if (!fragment.empty()) result.push_back({vk::ShaderStageFlagBits::eFragment, fragment});
    return result;
}

vk::raii::Pipeline create_pipeline(const Device& device, const PipelineInterface& interface,
                                   std::span<const std::uint32_t> vertex,
                                   std::span<const std::uint32_t> fragment,
                                   const Specialization& specialization, const DepthState& depth_state,
                                   const ColourState& colour_state) {
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
    if (fragment_stage && colour_state.written)
        overwrite.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA;
    const std::vector blending(colour_state.formats.size(), overwrite);
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eClear, blending);
    const std::array dynamic = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic_state({}, dynamic);
    const vk::PipelineRenderingCreateInfo formats(0, colour_state.formats, kDepthFormat);
    vk::GraphicsPipelineCreateInfo info({}, stages, &pulled, &assembly, nullptr, &viewport, &rasterization,
                                        &single_sample, &depth, &blend, &dynamic_state, interface.layout());
    info.pNext = &formats;
    vk::raii::Pipeline pipeline = device.handle().createGraphicsPipeline(nullptr, info);
    name_pipeline(device, pipeline, interface.name());
    return pipeline;
}

PipelineRecipe recipe(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment,
                      const Specialization& specialization, std::uint32_t push_bytes, const DepthState& depth,
                      const ColourState& colour) {
    PipelineRecipe recipe;
    recipe.add(push_bytes)
        .add(static_cast<std::uint32_t>(depth.test))
        .add(std::bit_cast<std::uint32_t>(depth.behind))
        .add(colour.written ? 1 : 0)
        .add(static_cast<std::uint32_t>(colour.formats.size()))
        .add_stage(vertex, specialization)
        .add_stage(fragment, specialization);
    for (const vk::Format format : colour.formats)
        recipe.add(static_cast<std::uint32_t>(format));
    return recipe;
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

vk::ImageMemoryBarrier2 kept_from_before(const Attachment& attachment) {
    return {vk::PipelineStageFlagBits2::eAllCommands,
            vk::AccessFlagBits2::eMemoryWrite,
            vk::PipelineStageFlagBits2::eColorAttachmentOutput,
            vk::AccessFlagBits2::eColorAttachmentRead | vk::AccessFlagBits2::eColorAttachmentWrite,
            vk::ImageLayout::eAttachmentOptimal,
            vk::ImageLayout::eAttachmentOptimal,
            VK_QUEUE_FAMILY_IGNORED,
            VK_QUEUE_FAMILY_IGNORED,
            attachment.image(),
            {attachment.aspect(), 0, 1, 0, 1}};
}

vk::RenderingAttachmentInfo kept(const Attachment& attachment) {
    vk::RenderingAttachmentInfo info(attachment.view(), vk::ImageLayout::eAttachmentOptimal);
    info.loadOp = vk::AttachmentLoadOp::eLoad;
    info.storeOp = vk::AttachmentStoreOp::eStore;
    return info;
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
                               std::uint32_t push_bytes, const DepthState& depth, const ColourState& colour)
    : pipeline_(device.pipelines().find_or_make(
          recipe(vertex, fragment, specialization, push_bytes, depth, colour), [&] {
              PipelineInterface interface(device, name, modules(vertex, fragment), push_bytes);
              vk::raii::Pipeline pipeline = vulkan_call("create pipeline", name, [&] {
                  return create_pipeline(device, interface, vertex, fragment, specialization, depth, colour);
              });
              return Pipeline(std::move(interface), std::move(pipeline));
          })) {}

RasterPipeline::RasterPipeline(RasterPipeline&& other) noexcept = default;
RasterPipeline& RasterPipeline::operator=(RasterPipeline&& other) noexcept = default;
RasterPipeline::~RasterPipeline() = default;

void RasterPipeline::draw_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                                std::span<const std::byte> push, std::uint32_t first,
                                std::uint32_t triangles) const {
    if (triangles == 0) return;
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_->handle);
    pipeline_->interface.use(commands, vk::PipelineBindPoint::eGraphics, bindings, push);
    commands.draw(3 * triangles, 1, 3 * first, 0);
}

void RasterPipeline::draw_indirect_bytes(const vk::raii::CommandBuffer& commands, const BindingSet& bindings,
                                         std::span<const std::byte> push, const Buffer& arguments,
                                         std::uint32_t index) const {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_->handle);
    pipeline_->interface.use(commands, vk::PipelineBindPoint::eGraphics, bindings, push);
    commands.drawIndirect(arguments.handle(), index * sizeof(vk::DrawIndirectCommand), 1, 0);
}

void draw_into(const vk::raii::CommandBuffer& commands, std::span<const ColourTarget> colours,
               const Attachment& depth, const std::function<void()>& record) {
    const vk::MemoryBarrier2 after_previous(
        vk::PipelineStageFlagBits2::eAllCommands, vk::AccessFlagBits2::eMemoryWrite,
        vk::PipelineStageFlagBits2::eAllGraphics, vk::AccessFlagBits2::eMemoryRead);
    std::vector images = {discarded_before(depth)};
    std::vector<vk::RenderingAttachmentInfo> infos;
    for (const ColourTarget& colour : colours) {
        const Attachment& attachment = colour.attachment;
        images.push_back(colour.background ? discarded_before(attachment) : kept_from_before(attachment));
        infos.push_back(colour.background ? cleared(attachment, vk::ClearColorValue(*colour.background))
                                          : kept(attachment));
    }
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_previous, {}, images));
    const vk::RenderingAttachmentInfo depth_info = cleared(depth, vk::ClearDepthStencilValue(0.0f, 0));
    commands.beginRendering(
        vk::RenderingInfo({}, {{0, 0}, {depth.width(), depth.height()}}, 1, 0, infos, &depth_info));
    commands.setViewport(0, vk::Viewport(0.0f, 0.0f, static_cast<float>(depth.width()),
                                         static_cast<float>(depth.height()), 0.0f, 1.0f));
    limit_to(commands, {0, 0, depth.width(), depth.height()});
    record();
    commands.endRendering();
}

void limit_to(const vk::raii::CommandBuffer& commands, const PixelRect& rectangle) {
    commands.setScissor(
        0, vk::Rect2D({static_cast<std::int32_t>(rectangle.x), static_cast<std::int32_t>(rectangle.y)},
                      {rectangle.width, rectangle.height}));
}

void draw_into(const vk::raii::CommandBuffer& commands, const Attachment& colour, const Attachment& depth,
               const std::array<float, 4>& background, const std::function<void()>& record) {
    const ColourTarget target{colour, background};
    draw_into(commands, std::span(&target, 1), depth, record);
}

}  // namespace utsuri
