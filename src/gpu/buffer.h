// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/binding_kind.h"
#include "gpu/device_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace utsuri {

/// Bytes that go into a buffer at an offset.
struct Upload {
    std::uint64_t offset = 0;
    std::span<const std::byte> bytes;
};

/// A buffer with its own memory, in device memory where there is some. Kernels may read it in any way that it
/// is not too large for; it can also hold the arguments of indirect draws. Move-only.
class Buffer {
  public:
    /// @param bytes at least 1; at most what kernels can read of it in the way named last
    /// @param name shown in messages and debuggers
    /// @throws DeviceError naming the buffer and its size if it cannot be had
    Buffer(Device& device, std::uint64_t bytes, std::string name, BindingKind kind = BindingKind::storage);
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    [[nodiscard]] vk::Buffer handle() const { return *buffer_; }
    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    void upload(std::span<const std::byte> bytes, std::uint64_t offset = 0);
    /// Many at once, which must not overlap, cost about as much as one of their bytes together.
    void upload(std::span<const Upload> uploads);
    void download(std::span<std::byte> bytes, std::uint64_t offset = 0) const;
    void fill_with_zero();
    /// Records that bytes at the front are replaced, ordered against what is recorded before and after: what
    /// kernels of one submission read that changes from one to the next.
    /// @param bytes a multiple of 4, at most 65536
    void record_update(const vk::raii::CommandBuffer& commands, std::span<const std::byte> bytes) const;

    /// `count` records from the front.
    template <typename Record>
    [[nodiscard]] std::vector<Record> download_records(std::size_t count) const {
        static_assert(std::is_trivially_copyable_v<Record>);
        std::vector<Record> records(count);
        download(std::as_writable_bytes(std::span(records)));
        return records;
    }

  private:
    /// Through host memory of `staging_bytes`, filled as often as it takes.
    void upload_staged(std::span<const Upload> uploads, std::uint64_t staging_bytes);

    Device* device_;
    std::uint64_t size_;
    std::string name_;
    vk::raii::Buffer buffer_;
    DeviceMemory memory_;
};

/// A buffer that holds the given records. Without records it holds one zeroed record, because Vulkan has no
/// empty buffers.
template <typename Record>
Buffer make_buffer(Device& device, std::span<const Record> records, std::string name,
                   BindingKind kind = BindingKind::storage) {
    static_assert(std::is_trivially_copyable_v<Record>);
    Buffer buffer(device, std::max<std::uint64_t>(records.size_bytes(), sizeof(Record)), std::move(name),
                  kind);
    if (records.empty()) {
        buffer.fill_with_zero();
    } else {
        buffer.upload(std::as_bytes(records));
    }
    return buffer;
}

}  // namespace utsuri
