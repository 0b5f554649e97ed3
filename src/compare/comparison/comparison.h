// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/reflection_errors.h"
#include "renderers/light/light_settings.h"
#include "renderers/methods/method.h"

#include "base/error.h"
#include "gpu/device_selection.h"
#include "image/image.h"
#include "image/metrics.h"
#include "image/plane.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace utsuri {

/// One picture, what it took, and, for a method, how wrong it is.
struct MethodResult {
    Method method;
    std::uint32_t samples = 0;        ///< per pixel
    std::optional<MapSettings> maps;  ///< for methods that use maps
    double prepare_seconds = 0.0;     ///< light and maps before the first frame, pipelines excluded
    double compile_seconds = 0.0;     ///< pipelines
    double frame_seconds = 0.0;       ///< wall time of all samples
    double gpu_seconds = 0.0;         ///< of that, by the device's clock
    std::uint64_t peak_bytes = 0;     ///< device memory, scene included
    std::uint64_t rays = 0;           ///< of the frame
    std::uint64_t prepare_rays = 0;
    std::uint32_t map_count = 0;       ///< reflection maps, captured or not
    std::uint32_t captured_maps = 0;   ///< of those, that some pixel looked up
    std::uint32_t least_map_size = 0;  ///< texels along an edge
    std::uint32_t largest_map_size = 0;
    double traced_fraction = 0.0;     ///< of the specular lookups, those that followed a ray; 0 without any
    std::uint64_t nonfinite = 0;      ///< samples left out
    double truncated_fraction = 0.0;  ///< of the specular lookups, those cut at the depth bound
    Image image;
    std::string image_file;  ///< name of the .exr in the output folder; its .png lies beside it
    // For methods only:
    Plane flip;                  ///< per-pixel FLIP against the reference
    std::string error_map_file;  ///< name of the .png
    Metrics metrics;
    Metrics metrics_reflective;                         ///< over pixels whose first hit is reflective
    std::optional<ReflectionErrors> reflection_errors;  ///< where asked for, and the method tells them
};

/// A method, or its predictions, that could not be carried out here: its maps are too large for the device,
/// say.
struct MethodFailure {
    Method method;
    std::string message;
    ExitCode exit_code = ExitCode::device;
};

/// Methods held against a reference.
struct Comparison {
    std::string scene;    ///< path as given
    std::string command;  ///< the command line that made it
    DeviceSummary device;
    RenderSettings settings;
    const LightMethod* light = &light_methods().front();
    LightSettings light_settings;  ///< of the light kept on surfaces
    double exposure = 0.0;         ///< stops, of the display images
    double import_seconds = 0.0;
    double build_seconds = 0.0;     ///< BVH
    std::uint64_t scene_bytes = 0;  ///< device memory of the scene
    std::uint64_t triangles = 0;
    MethodResult reference;
    /// Relative standard error of the reference's pixels (NoiseEstimate); not a number where an interruption
    /// left an odd number of samples, which cannot be halved.
    double reference_noise = 0.0;
    double reference_noise_mse = 0.0;  ///< in the unit of Metrics::mse
    /// Mean of every other sample of the reference; see Film::resolve_half().
    Image reference_half;
    std::vector<MethodResult> methods;
    std::vector<MethodFailure> failures;  ///< what is missing for a reason
    Mask reflective;
    std::uint64_t reflective_pixels = 0;
    std::vector<std::string> notes;  ///< what was ignored, dropped or added on the way in
    bool interrupted = false;        ///< some methods are missing or have fewer samples
};

}  // namespace utsuri
