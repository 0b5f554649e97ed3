// SPDX-License-Identifier: Apache-2.0
#include "import/document/layout.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace utsuri {
namespace {

using Json = nlohmann::json;

/// An accessor without a bufferView is all zeros and costs the file nothing: 2^24 elements are a mesh of the
/// size this program is made for, and less than a gigabyte.
constexpr std::uint64_t kMaxZeroElements = 1u << 24;

std::uint64_t size_of(const Json& object, const char* key) {
    return object.value(key, std::uint64_t{0});
}

/// Bytes from the start of the first element to the end of the last; all operands are at most 2^53, so the
/// product is checked by division.
std::optional<std::uint64_t> span_bytes(std::uint64_t count, std::uint64_t stride, std::uint64_t element) {
    if (count - 1 > std::numeric_limits<std::uint64_t>::max() / 2 / stride) return std::nullopt;
    return (count - 1) * stride + element;
}

struct Access {
    std::string place;
    std::size_t view = 0;
    std::uint64_t offset = 0;
    std::uint64_t count = 0;
    ElementLayout element;
    bool may_stride = false;
};

class LayoutChecker {
  public:
    LayoutChecker(const SourceFile& file, const Json& root) : file_(file), root_(root) {}

    void check_views() const {
        if (!root_.contains("bufferViews")) return;
        const Json& views = root_["bufferViews"];
        for (std::size_t i = 0; i < views.size(); ++i) {
            const std::size_t buffer = views[i]["buffer"];
            const std::uint64_t end = size_of(views[i], "byteOffset") + size_of(views[i], "byteLength");
            const std::uint64_t there = size_of(root_["buffers"][buffer], "byteLength");
            if (end > there) {
                file_.fail(fmt::format("bufferViews[{}].byteLength", i),
                           fmt::format("ends at byte {}; must end within the {} bytes of buffers[{}]", end,
                                       there, buffer));
            }
        }
    }

    void check_accessors() const {
        if (!root_.contains("accessors")) return;
        const Json& accessors = root_["accessors"];
        for (std::size_t i = 0; i < accessors.size(); ++i) {
            check_accessor(accessors[i], fmt::format("accessors[{}]", i));
        }
    }

  private:
    void check_accessor(const Json& accessor, const std::string& place) const {
        const ElementLayout element =
            element_layout(accessor["componentType"], accessor["type"].get<std::string>());
        const std::uint64_t count = size_of(accessor, "count");
        if (accessor.contains("bufferView")) {
            check_access({place + ".bufferView", accessor["bufferView"], size_of(accessor, "byteOffset"),
                          count, element, true});
        } else if (count > kMaxZeroElements) {
            file_.fail(place + ".count",
                       fmt::format("is {}; must be at most {} for an accessor without a bufferView", count,
                                   kMaxZeroElements));
        }
        if (accessor.contains("sparse")) check_sparse(accessor["sparse"], count, element, place + ".sparse");
    }

    void check_sparse(const Json& sparse, std::uint64_t count, ElementLayout element,
                      const std::string& place) const {
        const std::uint64_t replaced = size_of(sparse, "count");
        if (replaced > count) {
            file_.fail(place + ".count",
                       fmt::format("is {}; must be at most the accessor's count, {}", replaced, count));
        }
        const Json& indices = sparse["indices"];
        const Json& values = sparse["values"];
        check_access({place + ".indices.bufferView", indices["bufferView"], size_of(indices, "byteOffset"),
                      replaced, element_layout(indices["componentType"], "SCALAR"), false});
        check_access({place + ".values.bufferView", values["bufferView"], size_of(values, "byteOffset"),
                      replaced, element, false});
    }

    void check_access(const Access& access) const {
        const Json& view = root_["bufferViews"][access.view];
        const std::uint64_t size = access.element.size();
        std::uint64_t stride = size;
        // Some exporters write 0 where elements are packed.
        if (size_of(view, "byteStride") != 0 && access.may_stride) {
            stride = size_of(view, "byteStride");
            if (stride < size) {
                file_.fail(
                    fmt::format("bufferViews[{}].byteStride", access.view),
                    fmt::format("is {}; must be at least {}, the element of {}", stride, size, access.place));
            }
        }
        const std::uint64_t there = size_of(view, "byteLength");
        const auto needed = span_bytes(access.count, stride, size);
        if (!needed || access.offset > there || *needed > there - access.offset) {
            file_.fail(access.place,
                       fmt::format("{} elements of {} bytes, {} apart, from byte {} on do not fit; must end "
                                   "within the {} bytes of bufferViews[{}]",
                                   access.count, size, stride, access.offset, there, access.view));
        }
    }

    const SourceFile& file_;
    const Json& root_;
};

}  // namespace

ElementLayout element_layout(int component_type, std::string_view type) {
    ElementLayout layout;
    switch (component_type) {
        case 5120:  // byte
        case 5121:
            layout.component_size = 1;
            break;
        case 5122:  // short
        case 5123:
            layout.component_size = 2;
            break;
        default:
            layout.component_size = 4;
            break;
    }
    if (type == "SCALAR") {
        layout.components = 1;
    } else {
        const auto order = static_cast<std::size_t>(type.back() - '0');
        layout.components = type.starts_with("VEC") ? order : order * order;
    }
    return layout;
}

void check_layout(const SourceFile& file, const Json& root) {
    const LayoutChecker checker(file, root);
    checker.check_views();
    checker.check_accessors();
}

}  // namespace utsuri
