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

vk::raii::Buffer create_buffer(const Device& device, std::uint64_t bytes) {
    using Usage = vk::BufferUsageFlagBits;
    return device.handle().createBuffer({{},
                                         bytes,
                                         Usage::eStorageBuffer | Usage::eTransferSrc | Usage::eTransferDst,
                                         vk::SharingMode::eExclusive});
}

struct Allocation {
    vk::raii::DeviceMemory memory;
    std::uint64_t bytes;
    bool host_visible;
};

/// Takes the first kind of memory that the device has.
Allocation allocate(const Device& device, const vk::raii::Buffer& buffer,
                    std::initializer_list<vk::MemoryPropertyFlags> preferences) {
    const vk::MemoryRequirements needs = buffer.getMemoryRequirements();
    for (const vk::MemoryPropertyFlags wanted : preferences) {
        const auto type = device.memory_type(needs.memoryTypeBits, wanted);
        if (!type) continue;
        vk::raii::DeviceMemory memory = device.handle().allocateMemory({needs.size, *type});
        buffer.bindMemory(*memory, 0);
        const vk::MemoryPropertyFlags mappable = Memory::eHostVisible | Memory::eHostCoherent;
        return {std::move(memory), needs.size, (device.memory_type_flags(*type) & mappable) == mappable};
    }
    throw DeviceError("allocate memory", device.summary().name, "no memory type fits");
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

Buffer::Buffer(Device& device, std::uint64_t bytes, std::string name)
    : device_(&device), size_(bytes), name_(std::move(name)) {
    UTSURI_CHECK_LT(0u, bytes);
    const std::string object = fmt::format("'{}' of {} bytes on {}", name_, bytes, device.summary().name);
    if (bytes > device.summary().storage_range_bytes) {
        throw DeviceError(
            "create buffer", object,
            fmt::format("a kernel on this device can see at most {} bytes of a buffer; use a smaller "
                        "scene or picture, or another device",
                        device.summary().storage_range_bytes));
    }
    vulkan_call("create buffer", object, [&] {
        buffer_ = create_buffer(device, bytes);
        Allocation allocation = allocate(
            device, *buffer_,
            {Memory::eDeviceLocal | Memory::eHostVisible | Memory::eHostCoherent | Memory::eHostCached,
             Memory::eDeviceLocal, vk::MemoryPropertyFlags{}});
        memory_ = std::move(allocation.memory);
        allocated_ = allocation.bytes;
        host_visible_ = allocation.host_visible;
    });
    device.note_memory(static_cast<std::int64_t>(allocated_));
    device.set_name(vk::ObjectType::eBuffer,
                    reinterpret_cast<std::uint64_t>(static_cast<VkBuffer>(**buffer_)), name_);
}

Buffer::Buffer(Buffer&& other) noexcept
    : device_(other.device_),
      size_(other.size_),
      name_(std::move(other.name_)),
      buffer_(std::move(other.buffer_)),
      memory_(std::move(other.memory_)),
      allocated_(std::exchange(other.allocated_, 0)),
      host_visible_(other.host_visible_) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    if (this != &other) {
        release();
        device_ = other.device_;
        size_ = other.size_;
        name_ = std::move(other.name_);
        buffer_ = std::move(other.buffer_);
        memory_ = std::move(other.memory_);
        allocated_ = std::exchange(other.allocated_, 0);
        host_visible_ = other.host_visible_;
    }
    return *this;
}

Buffer::~Buffer() {
    release();
}

void Buffer::release() noexcept {
    if (allocated_ != 0) device_->note_memory(-static_cast<std::int64_t>(std::exchange(allocated_, 0)));
}

void Buffer::upload(std::span<const std::byte> bytes, std::uint64_t offset) {
    UTSURI_CHECK_LE(offset + bytes.size(), size_);
    if (bytes.empty()) return;
    vulkan_call("upload", name_, [&] {
        if (host_visible_) {
            void* target = memory_->mapMemory(offset, bytes.size());
            std::memcpy(target, bytes.data(), bytes.size());
            memory_->unmapMemory();
            return;
        }
        const std::uint64_t piece = std::min<std::uint64_t>(bytes.size(), kStagingBytes);
        const vk::raii::Buffer staging = create_buffer(*device_, piece);
        const Allocation memory = allocate(*device_, staging, {Memory::eHostVisible | Memory::eHostCoherent});
        for (std::uint64_t done = 0; done < bytes.size(); done += piece) {
            const std::uint64_t now = std::min<std::uint64_t>(piece, bytes.size() - done);
            std::memcpy(memory.memory.mapMemory(0, now), bytes.data() + done, now);
            memory.memory.unmapMemory();
            device_->run("upload", [&](const vk::raii::CommandBuffer& commands) {
                commands.copyBuffer(*staging, **buffer_, vk::BufferCopy(0, offset + done, now));
                barrier(commands);
            });
        }
    });
}

void Buffer::download(std::span<std::byte> bytes, std::uint64_t offset) const {
    UTSURI_CHECK_LE(offset + bytes.size(), size_);
    if (bytes.empty()) return;
    vulkan_call("read back", name_, [&] {
        if (host_visible_) {
            const void* source = memory_->mapMemory(offset, bytes.size());
            std::memcpy(bytes.data(), source, bytes.size());
            memory_->unmapMemory();
            return;
        }
        const std::uint64_t piece = std::min<std::uint64_t>(bytes.size(), kStagingBytes);
        const vk::raii::Buffer staging = create_buffer(*device_, piece);
        const Allocation memory =
            allocate(*device_, staging,
                     {Memory::eHostVisible | Memory::eHostCoherent | Memory::eHostCached,
                      Memory::eHostVisible | Memory::eHostCoherent});
        for (std::uint64_t done = 0; done < bytes.size(); done += piece) {
            const std::uint64_t now = std::min<std::uint64_t>(piece, bytes.size() - done);
            device_->run("read back", [&](const vk::raii::CommandBuffer& commands) {
                barrier(commands);
                commands.copyBuffer(**buffer_, *staging, vk::BufferCopy(offset + done, 0, now));
                barrier(commands);
            });
            std::memcpy(bytes.data() + done, memory.memory.mapMemory(0, now), now);
            memory.memory.unmapMemory();
        }
    });
}

void Buffer::fill_with_zero() {
    if (host_visible_) {
        vulkan_call("clear", name_, [&] {
            std::memset(memory_->mapMemory(0, size_), 0, size_);
            memory_->unmapMemory();
        });
        return;
    }
    device_->run("clear", [&](const vk::raii::CommandBuffer& commands) {
        commands.fillBuffer(**buffer_, 0, VK_WHOLE_SIZE, 0);
        barrier(commands);
    });
}

}  // namespace utsuri
