// SPDX-License-Identifier: Apache-2.0
#include "gpu/buffer.h"

#include "base/check.h"
#include "gpu/vulkan_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace utsuri {
namespace {

using Memory = vk::MemoryPropertyFlagBits;

/// Copies go through host memory in pieces, so that a large scene does not need twice its memory.
constexpr std::uint64_t kStagingBytes = 32ull << 20;

std::string describe(const Device& device, std::uint64_t bytes, const std::string& name) {
    return fmt::format("'{}' of {} bytes on {}", name, bytes, device.summary().name);
}

vk::raii::Buffer create_buffer(const Device& device, std::uint64_t bytes) {
    using Usage = vk::BufferUsageFlagBits;
    return device.handle().createBuffer({{},
                                         bytes,
                                         Usage::eStorageBuffer | Usage::eUniformBuffer |
                                             Usage::eUniformTexelBuffer | Usage::eIndirectBuffer |
                                             Usage::eTransferSrc | Usage::eTransferDst,
                                         vk::SharingMode::eExclusive});
}

DeviceMemory bind_memory(Device& device, const vk::raii::Buffer& buffer,
                         std::initializer_list<vk::MemoryPropertyFlags> preferences) {
    DeviceMemory memory(device, buffer.getMemoryRequirements(), preferences);
    buffer.bindMemory(*memory.handle(), 0);
    return memory;
}

/// @throws DeviceError if no kernel could see all of the buffer
std::uint64_t checked_size(const Device& device, std::uint64_t bytes, const std::string& name,
                           BindingKind kind) {
    UTSURI_CHECK_LT(0u, bytes);
    const std::uint64_t most = most_bytes(device.summary(), kind);
    if (bytes > most) {
        throw DeviceError(
            "create buffer", describe(device, bytes, name),
            fmt::format("a kernel on this device can see at most {} bytes of a buffer; use a smaller "
                        "scene or picture, or another device",
                        most));
    }
    return bytes;
}

/// Orders a transfer against the kernels before and after it.
void barrier(const vk::raii::CommandBuffer& commands) {
    const vk::MemoryBarrier2 everything(vk::PipelineStageFlagBits2::eAllCommands,
                                        vk::AccessFlagBits2::eMemoryWrite,
                                        vk::PipelineStageFlagBits2::eAllCommands,
                                        vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.pipelineBarrier2(vk::DependencyInfo({}, everything));
}

}  // namespace

Buffer::Buffer(Device& device, std::uint64_t bytes, std::string name, BindingKind kind)
    : device_(&device),
      size_(checked_size(device, bytes, name, kind)),
      name_(std::move(name)),
      buffer_(vulkan_call("create buffer", describe(device, bytes, name_),
                          [&] { return create_buffer(device, bytes); })),
      memory_(vulkan_call("create buffer", describe(device, bytes, name_), [&] {
          return bind_memory(
              device, buffer_,
              {Memory::eDeviceLocal | Memory::eHostVisible | Memory::eHostCoherent | Memory::eHostCached,
               Memory::eDeviceLocal, vk::MemoryPropertyFlags{}});
      })) {
    device.set_name(vk::ObjectType::eBuffer, reinterpret_cast<std::uint64_t>(static_cast<VkBuffer>(*buffer_)),
                    name_);
}

Buffer::Buffer(Buffer&& other) noexcept = default;
Buffer& Buffer::operator=(Buffer&& other) noexcept = default;
Buffer::~Buffer() = default;

void Buffer::upload(std::span<const std::byte> bytes, std::uint64_t offset) {
    const Upload only{offset, bytes};
    upload(std::span(&only, 1));
}

void Buffer::upload(std::span<const Upload> uploads) {
    std::uint64_t bytes = 0;
    for (const Upload& upload : uploads) {
        UTSURI_CHECK_LE(upload.offset + upload.bytes.size(), size_);
        bytes += upload.bytes.size();
    }
    if (bytes == 0) return;
    vulkan_call("upload", name_, [&] {
        if (memory_.host_visible()) {
            auto* const target = static_cast<std::byte*>(memory_.handle().mapMemory(0, size_));
            for (const Upload& upload : uploads)
                std::copy(upload.bytes.begin(), upload.bytes.end(), target + upload.offset);
            memory_.handle().unmapMemory();
        } else {
            upload_staged(uploads, std::min(bytes, kStagingBytes));
        }
    });
    device_->note_upload(bytes);
}

void Buffer::upload_staged(std::span<const Upload> uploads, std::uint64_t staging_bytes) {
    const vk::raii::Buffer staging = create_buffer(*device_, staging_bytes);
    const DeviceMemory memory =
        bind_memory(*device_, staging, {Memory::eHostVisible | Memory::eHostCoherent});
    auto* const staged = static_cast<std::byte*>(memory.handle().mapMemory(0, staging_bytes));
    std::vector<vk::BufferCopy> copies;
    std::uint64_t filled = 0;
    const auto flush = [&] {
        device_->run("upload", [&](const vk::raii::CommandBuffer& commands) {
            commands.copyBuffer(*staging, *buffer_, copies);
            barrier(commands);
        });
        copies.clear();
        filled = 0;
    };
    for (const Upload& upload : uploads) {
        for (std::uint64_t done = 0; done < upload.bytes.size();) {
            if (filled == staging_bytes) flush();
            const std::uint64_t now =
                std::min<std::uint64_t>(staging_bytes - filled, upload.bytes.size() - done);
            std::memcpy(staged + filled, upload.bytes.data() + done, now);
            copies.emplace_back(filled, upload.offset + done, now);
            filled += now;
            done += now;
        }
    }
    flush();
    memory.handle().unmapMemory();
}

void Buffer::download(std::span<std::byte> bytes, std::uint64_t offset) const {
    UTSURI_CHECK_LE(offset + bytes.size(), size_);
    if (bytes.empty()) return;
    vulkan_call("read back", name_, [&] {
        if (memory_.host_visible()) {
            const void* source = memory_.handle().mapMemory(offset, bytes.size());
            std::memcpy(bytes.data(), source, bytes.size());
            memory_.handle().unmapMemory();
            return;
        }
        const std::uint64_t piece = std::min<std::uint64_t>(bytes.size(), kStagingBytes);
        const vk::raii::Buffer staging = create_buffer(*device_, piece);
        const DeviceMemory memory =
            bind_memory(*device_, staging,
                        {Memory::eHostVisible | Memory::eHostCoherent | Memory::eHostCached,
                         Memory::eHostVisible | Memory::eHostCoherent});
        for (std::uint64_t done = 0; done < bytes.size(); done += piece) {
            const std::uint64_t now = std::min<std::uint64_t>(piece, bytes.size() - done);
            device_->run("read back", [&](const vk::raii::CommandBuffer& commands) {
                barrier(commands);
                commands.copyBuffer(*buffer_, *staging, vk::BufferCopy(offset + done, 0, now));
                barrier(commands);
            });
            std::memcpy(bytes.data() + done, memory.handle().mapMemory(0, now), now);
            memory.handle().unmapMemory();
        }
    });
}

void Buffer::record_update(const vk::raii::CommandBuffer& commands, std::span<const std::byte> bytes) const {
    UTSURI_CHECK_LE(bytes.size(), size_);
    barrier(commands);
    commands.updateBuffer<std::byte>(
        *buffer_, 0, vk::ArrayProxy<const std::byte>(static_cast<std::uint32_t>(bytes.size()), bytes.data()));
    barrier(commands);
}

void Buffer::fill_with_zero() {
    if (memory_.host_visible()) {
        vulkan_call("clear", name_, [&] {
            std::memset(memory_.handle().mapMemory(0, size_), 0, size_);
            memory_.handle().unmapMemory();
        });
        return;
    }
    device_->run("clear", [&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(*buffer_, 0, VK_WHOLE_SIZE, 0);
        barrier(commands);
    });
}

}  // namespace utsuri
