// SPDX-License-Identifier: Apache-2.0
#include "renderers/methods/mapped_view.h"

#include "renderers/film/frame_camera.h"

#include "base/error.h"

namespace utsuri {
namespace {

template <typename Errors>
std::vector<Errors> no_reflections(const RenderSettings& settings) {
    return std::vector<Errors>(std::size_t{settings.width} * settings.height, kNoReflection<Errors>);
}

}  // namespace

MappedView::MappedView(Device& device, const SceneData& data, const PreparedMaps& maps, MapKind kind,
                       const RenderSettings& settings, const MapSettings& map_settings)
    : device_(device),
      data_(data),
      maps_(maps),
      kind_(kind),
      settings_(settings),
      map_settings_(map_settings),
      reflectors_(make_reflectors()),
      drawer_(device, data, kind, maps.specialization(), maps.bindings(), reflectors_.get(), settings.width,
              settings.height) {}

std::unique_ptr<ReflectorDrawer> MappedView::make_reflectors() const {
    const ReflectionMaps& maps = maps_.maps();
    if (maps.reflectors().triangles.empty()) return nullptr;
    return std::make_unique<ReflectorDrawer>(device_, data_, maps.reflectors(), kind_, maps.faces(),
                                             map_settings_.most_cut_pieces, map_settings_.tolerance.of,
                                             maps_.specialization(), maps_.bindings());
}

void MappedView::warm_up() {
    drawer_.warm_up();
    prepare_view();
}

interop::CameraInfo MappedView::camera_info() const {
    return make_camera_info(camera_, data_.origin, settings_.width, settings_.height);
}

void MappedView::set_camera(const Camera& camera) {
    camera_ = camera;
    has_moved_ = true;
}

double MappedView::prepare_view() {
    if (!has_moved_) return 0.0;
    has_moved_ = false;
    if (!reflectors_) return 0.0;
    interop::ReflectVerticesPush eye{};
    eye.eye = glm::vec3(camera_.position - data_.origin);
    eye.right = glm::vec3(camera_.right);
    eye.up = glm::vec3(camera_.up);
    eye.forward = glm::vec3(camera_.forward);
    return reflectors_->set_eye(eye);
}

void MappedView::record(const vk::raii::CommandBuffer& commands, const interop::FrameInfo& frame) const {
    drawer_.record(commands, camera_info(), frame);
}

PredictionDrawer& MappedView::prediction_drawer() {
    if (!maps_.has_distances()) {
        throw UsageError("predict errors", "of a method that keeps no distances",
                         "set MapSettings::predicts_errors before it is prepared");
    }
    prepare_view();
    if (!prediction_drawer_) {
        prediction_drawer_.emplace(device_, data_, kind_, maps_.maps().faces().size(), maps_.specialization(),
                                   maps_.bindings(), *reflectors_, settings_.width, settings_.height);
    }
    return *prediction_drawer_;
}

float MappedView::searching_tolerance() const {
    const Tolerance& tolerance = map_settings_.tolerance;
    const bool skips_search = kind_ == MapKind::hybrid && tolerance.of == Tolerance::Of::place;
    return skips_search ? static_cast<float>(tolerance.most) : 0.0f;
}

std::vector<PredictedError> MappedView::predict_errors() {
    if (!reflectors_) return no_reflections<PredictedError>(settings_);
    return prediction_drawer().predict(camera_info(), searching_tolerance());
}

std::vector<MeasuredError> MappedView::measure_errors() {
    if (!reflectors_) return no_reflections<MeasuredError>(settings_);
    return prediction_drawer().measure(camera_info(), searching_tolerance());
}

}  // namespace utsuri
