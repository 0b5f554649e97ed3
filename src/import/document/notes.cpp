// SPDX-License-Identifier: Apache-2.0
#include "import/document/notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace utsuri {

void FeatureNotes::add(const std::string& feature, const std::string& place) {
    constexpr std::size_t kPlacesShown = 3;  // as many as fit on a line of the terminal
    const auto [position, is_new] = positions_.try_emplace(feature, features_.size());
    if (is_new) features_.push_back({feature, {}, 0});
    Feature& entry = features_[position->second];
    if (entry.places.size() < kPlacesShown) {
        entry.places.push_back(place);
    } else {
        ++entry.more;
    }
}

Notes FeatureNotes::lines() const {
    Notes lines;
    for (const Feature& feature : features_) {
        std::string line = fmt::format("{}: {}", feature.text, fmt::join(feature.places, ", "));
        if (feature.more > 0) line += fmt::format(" and {} more", feature.more);
        lines.push_back(line);
    }
    return lines;
}

}  // namespace utsuri
