// SPDX-License-Identifier: Apache-2.0
#include "import/document/buffers.h"

#include "import/document/uri.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <set>
#include <string>

namespace utsuri {

Buffers::Buffers(const Document& document) : document_(document) {
    const std::size_t count = document.json.contains("buffers") ? document.json["buffers"].size() : 0;
    storage_.resize(count);
    contents_.resize(count);
}

std::span<const std::byte> Buffers::view(std::size_t buffer_view) {
    const tinygltf::BufferView& view = document_.model.bufferViews[buffer_view];
    return buffer(static_cast<std::size_t>(view.buffer)).subspan(view.byteOffset, view.byteLength);
}

std::span<const std::byte> Buffers::buffer(std::size_t index) {
    if (!contents_[index]) contents_[index] = read_buffer(index);
    return *contents_[index];
}

std::span<const std::byte> Buffers::read_buffer(std::size_t index) {
    const nlohmann::json& buffer = document_.json["buffers"][index];
    const std::string place = fmt::format("buffers[{}]", index);
    std::span<const std::byte> bytes;
    if (buffer.contains("uri")) {
        storage_[index] =
            read_uri(document_.file, buffer["uri"].get_ref<const std::string&>(), place + ".uri");
        bytes = storage_[index];
    } else if (index == 0 && !document_.container.bin.empty()) {
        bytes = document_.container.bin;
    } else if (const std::string extensions = extensions_on(index); !extensions.empty()) {
        document_.fail(place + ".uri",
                       fmt::format("missing; its contents are left to {}, which is not supported: must be "
                                   "exported without",
                                   extensions));
    } else {
        document_.fail(place + ".uri", "missing; only buffers[0] of a .glb with a BIN chunk may lack it");
    }
    const std::uint64_t length = buffer["byteLength"];
    if (bytes.size() < length) {
        document_.fail(
            place + ".byteLength",
            fmt::format("is {}, but there are {} bytes; must be at most that", length, bytes.size()));
    }
    return bytes;
}

std::string Buffers::extensions_on(std::size_t index) const {
    std::set<std::string> names;
    const auto add = [&](const nlohmann::json& object) {
        const nlohmann::json extensions = object.value("extensions", nlohmann::json::object());
        for (const auto& [name, contents] : extensions.items())
            names.insert(name);
    };
    add(document_.json["buffers"][index]);
    for (const nlohmann::json& view : document_.json["bufferViews"]) {
        if (view["buffer"] == index) add(view);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace utsuri
