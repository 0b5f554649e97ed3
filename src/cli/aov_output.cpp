// SPDX-License-Identifier: Apache-2.0
#include "cli/aov_output.h"

#include "cli/options.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace utsuri {
namespace {

using interop::AovPixel;

struct Aov {
    std::string name;
    std::vector<std::string> channels;
    std::function<void(const AovPixel&, const SceneData&, float*)> extract;
};

constexpr const char* kPredicted = "predicted";
constexpr const char* kMeasured = "measured";
constexpr const char* kTraced = "traced";

bool holds(const AovSelection& selection, const std::string& name) {
    return std::find(selection.begin(), selection.end(), name) != selection.end();
}

void put(const glm::vec3& value, float* out) {
    std::copy_n(&value.x, 3, out);
}

float number(std::uint32_t index) {
    return index == interop::NONE ? -1.0f : static_cast<float>(index);
}

const std::vector<Aov>& all_aovs() {
    static const std::vector<Aov> aovs = {
        {"depth", {"depth.Z"}, [](const AovPixel& p, const SceneData&, float* out) { out[0] = p.depth; }},
        {"position",
         {"position.X", "position.Y", "position.Z"},
         [](const AovPixel& p, const SceneData& scene, float* out) {
             put(p.triangle == interop::NONE ? glm::vec3(0.0f)
                                             : glm::vec3(glm::dvec3(p.position) + scene.origin),
                 out);
         }},
        {"normal",
         {"normal.X", "normal.Y", "normal.Z"},
         [](const AovPixel& p, const SceneData&, float* out) { put(p.shading_normal, out); }},
        {"geometric-normal",
         {"geometricNormal.X", "geometricNormal.Y", "geometricNormal.Z"},
         [](const AovPixel& p, const SceneData&, float* out) { put(p.geometric_normal, out); }},
        {"albedo",
         {"albedo.R", "albedo.G", "albedo.B"},
         [](const AovPixel& p, const SceneData&, float* out) { put(p.albedo, out); }},
        {"uv",
         {"uv.U", "uv.V"},
         [](const AovPixel& p, const SceneData&, float* out) { std::copy_n(&p.texcoord.x, 2, out); }},
        {"triangle",
         {"triangle.I"},
         [](const AovPixel& p, const SceneData& scene, float* out) {
             out[0] = p.triangle == interop::NONE ? -1.0f : number(scene.bvh.order[p.triangle]);
         }},
        {"instance",
         {"instance.I"},
         [](const AovPixel& p, const SceneData&, float* out) { out[0] = number(p.instance); }},
        {"material",
         {"material.I"},
         [](const AovPixel& p, const SceneData&, float* out) { out[0] = number(p.material); }},
        {"reflective", {"reflective.I"}, [](const AovPixel& p, const SceneData&, float* out) {
             out[0] = static_cast<float>(p.mirror);
         }}};
    return aovs;
}

}  // namespace

std::string aov_names() {
    std::string names;
    for (const Aov& aov : all_aovs())
        names += aov.name + ", ";
    return names + kPredicted + ", " + kMeasured + ", " + kTraced;
}

AovSelection parse_aovs(const std::string& text) {
    AovSelection selection = split_list(text);
    for (const std::string& name : selection) {
        const auto same = [&](const Aov& aov) { return aov.name == name; };
        if (name == kPredicted || name == kMeasured || name == kTraced) continue;
        if (std::none_of(all_aovs().begin(), all_aovs().end(), same)) {
            throw UsageError("use --aov", fmt::format("'{}'", name),
                             fmt::format("there are: {}", aov_names()));
        }
    }
    return selection;
}

std::vector<ExrChannels> AovPlanes::channels() const {
    std::vector<ExrChannels> result;
    for (const Plane& plane : planes)
        result.push_back({plane.names, plane.values.data()});
    return result;
}

bool wants_reflection_errors(const AovSelection& selection) {
    return holds(selection, kPredicted) || holds(selection, kMeasured);
}

bool wants_traced_pixels(const AovSelection& selection) {
    return holds(selection, kTraced);
}

void add_reflection_data(AovPlanes& planes, Picture& picture, const AovSelection& selection) {
    if (holds(selection, kPredicted)) {
        AovPlanes::Plane plane{
            {"predicted.parallax", "predicted.interpolation", "predicted.texel", "predicted.pixels"}, {}};
        for (const PredictedError& e : picture.predict_errors())
            plane.values.insert(plane.values.end(), {e.parallax, e.interpolation, e.texel, e.pixels});
        planes.planes.push_back(std::move(plane));
    }
    if (holds(selection, kMeasured)) {
        AovPlanes::Plane plane{{"measured.angle", "measured.pixels", "measured.distance", "measured.seen"},
                               {}};
        for (const MeasuredError& e : picture.measure_errors())
            plane.values.insert(plane.values.end(), {e.angle, e.pixels, e.distance, e.seen});
        planes.planes.push_back(std::move(plane));
    }
    if (holds(selection, kTraced)) planes.planes.push_back({{"traced.I"}, picture.traced_pixels()});
}

AovPlanes extract_aovs(const std::vector<AovPixel>& pixels, const AovSelection& selection,
                       const SceneData& scene) {
    AovPlanes result;
    for (const Aov& aov : all_aovs()) {
        if (!holds(selection, aov.name)) continue;
        AovPlanes::Plane plane{aov.channels, std::vector<float>(pixels.size() * aov.channels.size())};
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            aov.extract(pixels[i], scene, &plane.values[i * aov.channels.size()]);
        }
        result.planes.push_back(std::move(plane));
    }
    return result;
}

}  // namespace utsuri
