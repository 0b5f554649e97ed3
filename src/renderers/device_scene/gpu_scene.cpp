// SPDX-License-Identifier: Apache-2.0
#include "renderers/device_scene/gpu_scene.h"

#include "renderers/device_scene/scene_buffers.h"
#include "renderers/device_scene/scene_constants.h"

#include "base/check.h"

#include <algorithm>
#include <array>

namespace utsuri {
namespace {

/// Whole texels, as which kernels read some of them. Without bytes there is one zeroed record, because Vulkan
/// has no empty buffers.
std::uint64_t size_on_device(const SceneBuffer& content) {
    const std::uint64_t bytes = std::max<std::uint64_t>(content.bytes.size(), content.record_bytes);
    return (bytes + kTexelBytes - 1) / kTexelBytes * kTexelBytes;
}

/// Fills a buffer of that size, with zeros where it is rounded up.
void fill(Buffer& buffer, const SceneBuffer& content) {
    if (content.bytes.empty()) {
        buffer.fill_with_zero();
    } else {
        constexpr std::array<std::byte, kTexelBytes> kZeros{};
        const std::uint64_t rest = buffer.size() - content.bytes.size();
        buffer.upload(std::array{Upload{0, content.bytes},
                                 Upload{content.bytes.size(), std::span(kZeros).first(rest)}});
    }
}

/// The previous buffer is given back first: there may not be room for both.
void make_anew(Device& device, std::optional<Buffer>& buffer, const SceneBuffer& content) {
    buffer.reset();
    buffer.emplace(device, size_on_device(content), content.name, content.kind);
    fill(*buffer, content);
}

void upload_ranges(Buffer& buffer, std::span<const std::byte> bytes, const std::vector<ByteRange>& ranges) {
    std::vector<Upload> uploads;
    uploads.reserve(ranges.size());
    for (const ByteRange& range : ranges)
        uploads.push_back({range.offset, bytes.subspan(range.offset, range.size)});
    buffer.upload(uploads);
}

}  // namespace

GpuScene::GpuScene(Device& device, const SceneData& data) : device_(&device) {
    for (const SceneBuffer& content : scene_buffers(data)) {
        buffers_.push_back({content.binding, std::nullopt});
        make_anew(device, buffers_.back().buffer, content);
    }
    describe(data);
}

void GpuScene::describe(const SceneData& data) {
    specialization_ = scene_constants(data);
    max_depth_ = data.requirements.max_depth;
    light_revision_ = data.light_revision;
    revision_ = data.revision;
}

void GpuScene::update(const SceneData& data) {
    const bool follows = revision_ && *revision_ + 1 == data.revision;
    if (follows) UTSURI_CHECK_EQ(data.changed_bytes.size(), kSceneBuffers);
    // Should this end early, some buffers are of another revision than others.
    revision_.reset();
    const auto contents = scene_buffers(data);
    for (std::size_t i = 0; i < kSceneBuffers; ++i) {
        std::optional<Buffer>& buffer = buffers_[i].buffer;
        if (!buffer || buffer->size() != size_on_device(contents[i])) {
            make_anew(*device_, buffer, contents[i]);
        } else if (!follows || data.changed_bytes[i].resized) {
            fill(*buffer, contents[i]);
        } else {
            upload_ranges(*buffer, contents[i].bytes, data.changed_bytes[i].ranges);
        }
    }
    describe(data);
}

Bindings GpuScene::bindings() const {
    Bindings result;
    for (const Held& held : buffers_)
        result[held.binding] = &held.buffer.value();
    return result;
}

}  // namespace utsuri
