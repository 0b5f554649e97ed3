// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/cielab.h"
#include "image/flip_filters.h"
#include "image/image.h"
#include "image/plane.h"

#include <array>
#include <cstdint>
#include <vector>

namespace utsuri {

/// The fit of ACES that HDR-FLIP tone maps with (Narkowicz 2015, with its pre-exposure of 0.6 multiplied in):
/// (n2 x^2 + n1 x) / (d2 x^2 + d1 x + d0).
struct AcesFit {
    double n2, n1, d2, d1, d0;
};
inline constexpr AcesFit kAces{0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14};

/// The largest HyAB distance of two displayable colours after the Hunt adjustment: green to blue.
[[nodiscard]] float largest_hyab();

/// One way of showing the two pictures before they are compared.
struct FlipView {
    double scale = 1.0;
    bool tone_mapped = false;
};

/// The FLIP of a band of rows, with the memory that takes, used again for every band and view. Not for
/// sharing between threads.
class FlipBand {
  public:
    /// Bands have at most `max_rows` rows. The arguments outlive this object.
    FlipBand(const Image& reference, const Image& test, const FlipFilters& filters, std::uint32_t max_rows);

    /// Writes rows [first, first + rows) of `map`: per pixel the largest difference over the views.
    void compute(std::uint32_t first, std::uint32_t rows, const std::vector<FlipView>& views, Plane& map);

  private:
    /// What FLIP compares of one picture, per pixel of the band.
    struct Features {
        std::vector<glm::vec3> lab;  ///< filtered, Hunt adjusted
        std::vector<float> edge;     ///< edge strength, [0, sqrt 2]
        std::vector<float> point;    ///< point strength, [0, sqrt 2]
    };

    void analyse(bool of_reference, const FlipView& view, Features& features);
    void load_opponent(bool of_reference, const FlipView& view);
    void filter_colours(Features& features);
    void apply_gaussian(const std::vector<float>& channel, const CsfGaussian& gaussian,
                        std::vector<float>& out, bool accumulate);
    void detect(const Kernel<float>& derivative, std::vector<float>& strength);
    void along_rows(const std::vector<float>& channel, const Kernel<float>& kernel, std::vector<float>& out,
                    int vertical_reach);
    void along_columns(const std::vector<float>& in, const Kernel<float>& kernel, std::vector<float>& out,
                       bool accumulate);
    [[nodiscard]] float difference(std::size_t i) const;

    const Image& reference_;
    const Image& test_;
    const FlipFilters& filters_;
    XyzSpace xyz_;
    float largest_colour_difference_;
    std::uint32_t first_ = 0;
    std::uint32_t rows_ = 0;

    /// Linearised CIELAB of the band and its border of the filter radius.
    std::array<std::vector<float>, 3> opponent_;
    /// The same, filtered by contrast sensitivity, without the border.
    std::array<std::vector<float>, 3> filtered_;
    std::vector<float> row_filtered_;
    std::vector<float> gradient_x_;
    std::vector<float> gradient_y_;
    Features reference_features_;
    Features test_features_;
};

}  // namespace utsuri
