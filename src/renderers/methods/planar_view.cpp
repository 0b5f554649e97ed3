// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/planar_view.h"

#include "renderers/device_scene/scene_triangles.h"
#include "renderers/film/frame_camera.h"
#include "renderers/reflection/raster/drawn_samples.h"
#include "renderers/reflection/raster/picture_pixels.h"

#include "geometry/reference_intersection.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace utsuri {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// Triangles that are drawn in the time in which a pixel is traced: a view with more triangles than pixels in
/// its window costs more than rays through the window do. On lavapipe both take 1.3 us or more; a rough guess
/// is good enough, as both are right.
constexpr std::uint64_t kTrianglesPerRay = 1;

/// Whether the eye sees a plane mirror at a pixel, by the state that lib/pixel_state.glsl describes.
bool shows_plane_mirror(float state) {
    return state < 0.0f || std::fmod(state, interop::DRAWN_RAY) >= interop::DRAWN_LOOKED_UP + 0.5f;
}

/// Whether it sees the mirror's view, whatever that shows.
bool shows_mirrored_view(float state) {
    return state < 0.0f || std::fmod(state, interop::DRAWN_RAY) >= interop::DRAWN_LOOKED_UP + 1.0f;
}

/// How far the rays go that a plane mirror reflects from the centre of a pixel, metres; infinity where they
/// meet nothing.
float mirrored_distance(const SceneData& data, const interop::CameraInfo& camera, const glm::vec2& position) {
    const glm::dvec3 eye = camera.origin;
    const glm::dvec3 direction = camera.forward + position.x * camera.right + position.y * camera.up;
    const double far = std::numeric_limits<double>::infinity();
    const auto mirror = closest_hit_reference(data.bvh, eye, direction, far);
    if (!mirror) return kInfinity;
    const glm::dvec3 normal = glm::normalize(doubled_area(corners_of(data, mirror->triangle)));
    const auto hit = closest_hit_reference(
        data.bvh, eye + mirror->t * direction, glm::normalize(glm::reflect(direction, normal)), far,
        [&](std::uint32_t triangle) { return triangle != mirror->triangle; });
    return hit ? static_cast<float>(hit->t) : kInfinity;
}

}  // namespace

std::vector<std::uint32_t> curved_instances(const SceneData& data, const PlaneMirrors& mirrors) {
    std::vector<std::uint32_t> instances;
    for (const std::uint32_t triangle : mirrors.others)
        instances.push_back(data.triangle_infos[triangle].instance);
    std::sort(instances.begin(), instances.end());
    instances.erase(std::unique(instances.begin(), instances.end()), instances.end());
    return instances;
}

PlanarView::PlanarView(Device& device, const SceneData& data, const PreparedMaps& maps, PlaneMirrors mirrors,
                       MapKind kind, const RenderSettings& settings, const MapSettings& map_settings)
    : device_(device),
      data_(data),
      maps_(maps),
      mirrors_(std::move(mirrors)),
      kind_(kind),
      settings_(settings),
      map_settings_(map_settings),
      drawer_(device, data, mirrors_, maps.maps().reflectors(), kind, maps.maps().faces(),
              maps.specialization(), maps.bindings(), settings.width, settings.height) {}

interop::CameraInfo PlanarView::camera_info() const {
    return make_camera_info(camera_, data_.origin, settings_.width, settings_.height);
}

void PlanarView::set_camera(const Camera& camera) {
    camera_ = camera;
    Camera in_scene = camera;
    in_scene.position -= data_.origin;
    const std::uint64_t least_window =
        kind_ == MapKind::hybrid ? data_.bvh.triangles.size() / kTrianglesPerRay : 0;
    views_ = plan_mirrored_views(mirrors_.mirrors, in_scene, settings_.width, settings_.height,
                                 static_cast<double>(near_plane(data_)), settings_.max_depth, least_window);
}

void PlanarView::record(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const {
    drawer_.record(commands, views_, frame);
}

PredictionDrawer& PlanarView::prediction_drawer() {
    if (!prediction_drawer_) {
        const ReflectionMaps& maps = maps_.maps();
        curved_.emplace(device_, data_, maps.reflectors(), kind_, maps.faces(), std::nullopt,
                        map_settings_.tolerance.of, maps_.specialization(), maps_.bindings());
        prediction_drawer_.emplace(device_, data_, kind_, maps.faces().size(), maps_.specialization(),
                                   maps_.bindings(), *curved_, settings_.width, settings_.height);
    }
    return *prediction_drawer_;
}

template <typename Errors, typename Tell>
std::vector<Errors> PlanarView::find_errors(const std::vector<glm::vec4>& pixels, const Errors& of_view,
                                            const Errors& without_view, Tell tell) {
    std::vector<Errors> errors = maps_.has_distances()
                                     ? tell(prediction_drawer(), camera_info())
                                     : std::vector<Errors>(pixels.size(), kNoReflection<Errors>);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (shows_mirrored_view(pixels[i].w)) {
            errors[i] = of_view;
        } else if (shows_plane_mirror(pixels[i].w)) {
            errors[i] = without_view;
        } else if (pixels[i].w == interop::DRAWN_PLAIN) {
            errors[i] = kNoReflection<Errors>;  // what is curved is behind it
        }
    }
    return errors;
}

std::vector<PredictedError> PlanarView::predict_errors() {
    const auto tolerance = static_cast<float>(map_settings_.tolerance.most);
    return find_errors<PredictedError>(picture_pixels(device_, picture()), {0.0f, 0.0f, 0.0f, 0.0f},
                                       {std::numbers::pi_v<float>, 0.0f, 0.0f, kInfinity},
                                       [&](PredictionDrawer& drawer, const interop::CameraInfo& camera) {
                                           return drawer.predict(camera, tolerance);
                                       });
}

std::vector<MeasuredError> PlanarView::measure_errors() {
    const auto tolerance = static_cast<float>(map_settings_.tolerance.most);
    constexpr MeasuredError kOfPlaneMirror = {0.0f, 0.0f, 0.0f, 1.0f};  // distances follow
    const std::vector<glm::vec4> pixels = picture_pixels(device_, picture());
    std::vector<MeasuredError> errors =
        find_errors<MeasuredError>(pixels, kOfPlaneMirror, kOfPlaneMirror,
                                   [&](PredictionDrawer& drawer, const interop::CameraInfo& camera) {
                                       return drawer.measure(camera, tolerance);
                                   });
    const interop::CameraInfo camera = camera_info();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!shows_plane_mirror(pixels[i].w)) continue;
        const std::size_t column = i % settings_.width;
        const std::size_t row = i / settings_.width;
        const glm::vec2 centre(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
        const glm::vec2 size(settings_.width, settings_.height);
        errors[i].distance =
            mirrored_distance(data_, camera, glm::vec2(2, -2) * centre / size + glm::vec2(-1, 1));
    }
    return errors;
}

}  // namespace utsuri
