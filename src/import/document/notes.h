// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace utsuri {

/// Collects the places where a feature occurs and tells them in one line each.
class FeatureNotes {
  public:
    /// To be called once a place. `feature` says what is not used and how that shows, for example "normal
    /// textures (surfaces look smooth)".
    void add(const std::string& feature, const std::string& place);
    /// One line a feature in the order of first appearance, with the first few places and the number of the
    /// others.
    [[nodiscard]] Notes lines() const;

  private:
    struct Feature {
        std::string text;
        std::vector<std::string> places;  ///< the first few
        std::size_t more = 0;             ///< the number of the others
    };
    std::vector<Feature> features_;
    std::map<std::string, std::size_t> positions_;
};

}  // namespace utsuri
