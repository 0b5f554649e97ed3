// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace utsuri {

/// A JSON path such as accessors[3].bufferView, as a chain on the stack: spelled out only when a message
/// needs it.
class Place {
  public:
    Place() = default;
    [[nodiscard]] Place member(std::string_view key) const { return Place(this, key, 0); }
    [[nodiscard]] Place element(std::size_t index) const { return Place(this, {}, index); }
    [[nodiscard]] std::string text() const {
        if (parent_ == nullptr) return "";
        std::string before = parent_->text();
        if (key_.data() == nullptr) return before + "[" + std::to_string(index_) + "]";
        if (!before.empty()) before += ".";
        return before.append(key_);
    }

  private:
    Place(const Place* parent, std::string_view key, std::size_t index)
        : parent_(parent), key_(key), index_(index) {}

    const Place* parent_ = nullptr;
    std::string_view key_;  // a null view marks an element of an array
    std::size_t index_ = 0;
};

}  // namespace utsuri
