// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "gpu/device_memory.h"

#include <string>

namespace utsuri {

/// Radiance, float32 in each of four channels: no value that a kernel can compute is out of its range.
inline constexpr vk::Format kColourFormat = vk::Format::eR32G32B32A32Sfloat;
/// Four 32-bit words.
inline constexpr vk::Format kWordsFormat = vk::Format::eR32G32B32A32Uint;
inline constexpr vk::Format kDepthFormat = vk::Format::eD32Sfloat;

/// An image that a raster pipeline draws into. Move-only.
class Attachment {
  public:
    /// @param format kColourFormat, kWordsFormat or kDepthFormat
    /// @throws DeviceError naming the image and its size if it cannot be had
    Attachment(Device& device, std::uint32_t width, std::uint32_t height, vk::Format format,
               std::string name);
    Attachment(Attachment&& other) noexcept;
    Attachment& operator=(Attachment&& other) noexcept;
    ~Attachment();

    [[nodiscard]] std::uint32_t width() const { return width_; }
    [[nodiscard]] std::uint32_t height() const { return height_; }
    [[nodiscard]] vk::Image image() const { return *image_; }
    [[nodiscard]] vk::ImageView view() const { return *view_; }
    [[nodiscard]] vk::ImageAspectFlags aspect() const { return aspect_; }

    /// Records that whole rows of a colour attachment, drawn before, are copied to the front of a buffer, a
    /// vec4 a pixel.
    void copy_rows(const vk::raii::CommandBuffer& commands, std::uint32_t first_row, std::uint32_t rows,
                   const Buffer& target) const;
    /// Records the reverse: rows are replaced by what a kernel has left at the front of a buffer.
    void replace_rows(const vk::raii::CommandBuffer& commands, std::uint32_t first_row, std::uint32_t rows,
                      const Buffer& source) const;

  private:
    /// Records that what a stage does with the image comes before what another does with it.
    void hand_over(const vk::raii::CommandBuffer& commands, vk::PipelineStageFlags2 from,
                   vk::AccessFlags2 done, vk::ImageLayout old_layout, vk::PipelineStageFlags2 to,
                   vk::AccessFlags2 next, vk::ImageLayout new_layout) const;
    [[nodiscard]] vk::BufferImageCopy whole_rows(std::uint32_t first_row, std::uint32_t rows) const;

    std::uint32_t width_;
    std::uint32_t height_;
    std::string name_;
    vk::ImageAspectFlags aspect_;
    vk::raii::Image image_;
    DeviceMemory memory_;
    vk::raii::ImageView view_;
};

}  // namespace utsuri
