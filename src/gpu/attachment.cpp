// SPDX-License-Identifier: Apache-2.0
#include "gpu/attachment.h"

#include "base/check.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>

namespace utsuri {
namespace {

vk::raii::Image create_image(const Device& device, std::uint32_t width, std::uint32_t height,
                             vk::Format format) {
    using Usage = vk::ImageUsageFlagBits;
    vk::ImageCreateInfo info;
    info.imageType = vk::ImageType::e2D;
    info.format = format;
    info.extent = vk::Extent3D(width, height, 1);
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.usage = format == kDepthFormat ? vk::ImageUsageFlags(Usage::eDepthStencilAttachment)
                                        : Usage::eColorAttachment | Usage::eTransferSrc | Usage::eTransferDst;
    return device.handle().createImage(info);
}

DeviceMemory bind_memory(Device& device, const vk::raii::Image& image) {
    DeviceMemory memory(device, image.getMemoryRequirements(),
                        {vk::MemoryPropertyFlagBits::eDeviceLocal, vk::MemoryPropertyFlags{}});
    image.bindMemory(*memory.handle(), 0);
    return memory;
}

vk::raii::ImageView create_view(const Device& device, const vk::raii::Image& image, vk::Format format,
                                vk::ImageAspectFlags aspect) {
    return device.handle().createImageView(
        {{}, *image, vk::ImageViewType::e2D, format, {}, {aspect, 0, 1, 0, 1}});
}

/// @throws DeviceError if the device has no images of this size
std::uint32_t checked_width(const Device& device, std::uint32_t width, std::uint32_t height) {
    const std::uint32_t limit = device.summary().image_size;
    if (width > limit || height > limit) {
        throw DeviceError("create image",
                          fmt::format("of {} x {} pixels on {}", width, height, device.summary().name),
                          fmt::format("this device draws into at most {} pixels on a side", limit));
    }
    return width;
}

}  // namespace

Attachment::Attachment(Device& device, std::uint32_t width, std::uint32_t height, vk::Format format,
                       std::string name)
    : width_(checked_width(device, width, height)),
      height_(height),
      name_(std::move(name)),
      aspect_(format == kDepthFormat ? vk::ImageAspectFlagBits::eDepth : vk::ImageAspectFlagBits::eColor),
      image_(vulkan_call("create image", name_, [&] { return create_image(device, width, height, format); })),
      memory_(vulkan_call("create image", name_, [&] { return bind_memory(device, image_); })),
      view_(
          vulkan_call("create image", name_, [&] { return create_view(device, image_, format, aspect_); })) {
    device.set_name(vk::ObjectType::eImage, reinterpret_cast<std::uint64_t>(static_cast<VkImage>(*image_)),
                    name_);
}

Attachment::Attachment(Attachment&& other) noexcept = default;
Attachment& Attachment::operator=(Attachment&& other) noexcept = default;
Attachment::~Attachment() = default;

void Attachment::copy(const vk::raii::CommandBuffer& commands, vk::AccessFlags2 access,
                      vk::ImageLayout layout, const std::function<void()>& record) const {
    using Stage = vk::PipelineStageFlagBits2;
    using Access = vk::AccessFlagBits2;
    const auto change_layout = [&](Stage from, vk::AccessFlags2 done, vk::ImageLayout before, Stage to,
                                   vk::AccessFlags2 next, vk::ImageLayout after) {
        const vk::ImageMemoryBarrier2 barrier(from, done, to, next, before, after, VK_QUEUE_FAMILY_IGNORED,
                                              VK_QUEUE_FAMILY_IGNORED, *image_, {aspect_, 0, 1, 0, 1});
        commands.pipelineBarrier2(vk::DependencyInfo({}, {}, {}, barrier));
    };
    // Whoever wrote or read the buffer has to be done.
    const vk::MemoryBarrier2 after_others(Stage::eAllCommands, Access::eMemoryWrite, Stage::eCopy,
                                          Access::eTransferRead | Access::eTransferWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, after_others));
    change_layout(Stage::eAllCommands, Access::eMemoryWrite, vk::ImageLayout::eAttachmentOptimal,
                  Stage::eCopy, access, layout);
    record();
    change_layout(Stage::eCopy, access, layout, Stage::eAllCommands,
                  Access::eMemoryRead | Access::eMemoryWrite, vk::ImageLayout::eAttachmentOptimal);
}

vk::BufferImageCopy Attachment::whole_rows(std::uint32_t first_row, std::uint32_t rows,
                                           const Buffer& buffer) const {
    UTSURI_CHECK_LE(std::uint64_t{width_} * rows * 16, buffer.size());
    return {0, 0, 0, {aspect_, 0, 0, 1}, {0, static_cast<std::int32_t>(first_row), 0}, {width_, rows, 1}};
}

void Attachment::copy_rows(const vk::raii::CommandBuffer& commands, std::uint32_t first_row,
                           std::uint32_t rows, const Buffer& target) const {
    constexpr vk::ImageLayout kSource = vk::ImageLayout::eTransferSrcOptimal;
    copy(commands, vk::AccessFlagBits2::eTransferRead, kSource, [&] {
        commands.copyImageToBuffer(*image_, kSource, target.handle(), whole_rows(first_row, rows, target));
    });
}

void Attachment::replace_rows(const vk::raii::CommandBuffer& commands, std::uint32_t first_row,
                              std::uint32_t rows, const Buffer& source) const {
    constexpr vk::ImageLayout kTarget = vk::ImageLayout::eTransferDstOptimal;
    copy(commands, vk::AccessFlagBits2::eTransferWrite, kTarget, [&] {
        commands.copyBufferToImage(source.handle(), *image_, kTarget, whole_rows(first_row, rows, source));
    });
}

}  // namespace utsuri
