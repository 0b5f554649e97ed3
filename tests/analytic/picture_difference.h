// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "support/estimate.h"

#include "image/image.h"

#include <cmath>

namespace utsuri::test {

/// Mean over the channels of all pixels of |picture - reference| over the reference's mean.
inline double mean_difference(const Image& picture, const Image& reference) {
    double difference = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double expected = static_cast<double>(reference.pixels[i][c]);
            difference += std::abs(static_cast<double>(picture.pixels[i][c]) - expected);
            sum += expected;
        }
    }
    return difference / sum;
}

/// A traced picture, and by how much its noise changes a mean_difference() from it at most.
struct TracedPicture {
    Image image;
    double noise = 0.0;
};

/// The mean of two pictures of different samples: it is off the truth by half of what these differ by, in the
/// mean.
inline TracedPicture trace_twice(Observer& observer, const Camera& camera, RenderSettings settings,
                                 std::uint32_t samples_each) {
    settings.seed = 1;
    const Image first = observer.picture(camera, settings, samples_each);
    settings.seed = 2;
    TracedPicture result{observer.picture(camera, settings, samples_each), 0.0};
    for (std::size_t i = 0; i < first.pixels.size(); ++i)
        result.image.pixels[i] = 0.5f * (result.image.pixels[i] + first.pixels[i]);
    result.noise = mean_difference(first, result.image);
    return result;
}

}  // namespace utsuri::test
