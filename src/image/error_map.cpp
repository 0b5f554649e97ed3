// SPDX-License-Identifier: Apache-2.0
#include "image/error_map.h"

#include "base/check.h"
#include "base/error.h"
#include "image/cielab.h"
#include "image/colour.h"
#include "image/metrics.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace utsuri {
namespace {

struct ControlPoint {
    float position;
    float a;  ///< CIELAB a*
    float b;  ///< CIELAB b*
};

/// Linear channels of the path through these points stay within [0, 0.97] at every position.
constexpr std::array<ControlPoint, 6> kPath{{{0.0f, 0.0f, 0.0f},
                                             {0.15f, 14.0f, -26.0f},
                                             {0.35f, 44.0f, -34.0f},
                                             {0.55f, 58.0f, 2.0f},
                                             {0.75f, 30.0f, 32.0f},
                                             {1.0f, -7.0f, 22.0f}}};
/// L* at the end of the path; white itself has no hue.
constexpr float kLightest = 97.0f;
constexpr std::size_t kTableSize = 1024;
constexpr glm::vec3 kNotANumberColour{0.0f, 1.0f, 0.0f};

glm::vec3 path_colour(float position, const XyzSpace& xyz) {
    std::size_t segment = 0;
    while (segment + 2 < kPath.size() && position > kPath[segment + 1].position)
        ++segment;
    const ControlPoint& from = kPath[segment];
    const ControlPoint& to = kPath[segment + 1];
    const float mix = (position - from.position) / (to.position - from.position);
    const glm::vec3 lab(kLightest * position, glm::mix(from.a, to.a, mix), glm::mix(from.b, to.b, mix));
    const glm::vec3 linear = xyz.to_linear * (relative_xyz_from_lab(lab) * xyz.white);
    return srgb_encode(glm::clamp(linear, glm::vec3(0.0f), glm::vec3(1.0f)));
}

/// The scale, made once a map.
class ColourTable {
  public:
    ColourTable() {
        const XyzSpace xyz;
        for (std::size_t i = 0; i < kTableSize; ++i)
            table_[i] = path_colour(static_cast<float>(i) / static_cast<float>(kTableSize - 1), xyz);
    }

    [[nodiscard]] glm::vec3 at(float fraction) const {
        if (std::isnan(fraction)) return kNotANumberColour;
        const float place = std::clamp(fraction, 0.0f, 1.0f) * static_cast<float>(kTableSize - 1);
        return table_[static_cast<std::size_t>(std::lround(place))];
    }

  private:
    std::array<glm::vec3, kTableSize> table_;
};

}  // namespace

glm::vec3 error_colour(float fraction) {
    return path_colour(std::clamp(fraction, 0.0f, 1.0f), XyzSpace());
}

Image error_map(const Plane& errors, float maximum) {
    UTSURI_CHECK_LT(0.0f, maximum);
    const ColourTable colours;
    Image display(errors.width, errors.height);
    std::transform(errors.values.begin(), errors.values.end(), display.pixels.begin(),
                   [&](float error) { return colours.at(error / maximum); });
    return display;
}

Image log_error_map(const Plane& errors, float least, float most) {
    UTSURI_CHECK_LT(0.0f, least);
    UTSURI_CHECK_LT(least, most);
    const ColourTable colours;
    Image display(errors.width, errors.height);
    std::transform(errors.values.begin(), errors.values.end(), display.pixels.begin(), [&](float error) {
        if (error < 0.0f) return kLeftOutColour;
        return colours.at(error <= least ? 0.0f : std::log(error / least) / std::log(most / least));
    });
    return display;
}

Plane relative_error(const Image& reference, const Image& test, double epsilon) {
    if (!reference.same_size(test)) {
        throw InputError("map errors", "",
                         fmt::format("the reference has {} x {} pixels, the test image {} x {}",
                                     reference.width, reference.height, test.width, test.height));
    }
    const double scale = normalisation(reference);
    Plane errors(reference.width, reference.height);
    for (std::size_t i = 0; i < errors.values.size(); ++i) {
        const glm::vec3& r = reference.pixels[i];
        const glm::vec3& t = test.pixels[i];
        if (!is_finite(r) || !is_finite(t)) {
            errors.values[i] = std::numeric_limits<float>::quiet_NaN();
            continue;
        }
        double sum = 0.0;
        for (int c = 0; c < 3; ++c) {
            const double d = (static_cast<double>(t[c]) - static_cast<double>(r[c])) * scale;
            sum += std::abs(d) / (std::abs(static_cast<double>(r[c])) * scale + epsilon);
        }
        errors.values[i] = static_cast<float>(sum / 3.0);
    }
    return errors;
}

}  // namespace utsuri
