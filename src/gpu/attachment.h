// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "gpu/device_memory.h"

#include <functional>
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
    /// Records a copy from or to a buffer, ordered against all that is recorded before and after.
    /// @param access to the image, in a layout that allows it
    void copy(const vk::raii::CommandBuffer& commands, vk::AccessFlags2 access, vk::ImageLayout layout,
              const std::function<void()>& record) const;
    [[nodiscard]] vk::BufferImageCopy whole_rows(std::uint32_t first_row, std::uint32_t rows,
                                                 const Buffer& buffer) const;

    std::uint32_t width_;
    std::uint32_t height_;
    std::string name_;
    vk::ImageAspectFlags aspect_;
    vk::raii::Image image_;
    DeviceMemory memory_;
    vk::raii::ImageView view_;
};

}  // namespace utsuri
