// SPDX-License-Identifier: Apache-2.0
#include "renderers/reflection/raster/prediction_drawer.h"

#include "renderers/device_scene/scene_constants.h"
#include "renderers/reflection/raster/draw_list.h"
#include "renderers/reflection/raster/drawn_samples.h"
#include "renderers/reflection/raster/picture_pixels.h"

#include "interop/bindings.h"
#include "interop/specialization.h"
#include "kernels/draw_depth_vert.h"
#include "kernels/draw_predicted_reflectors_vert.h"
#include "kernels/measure_reflection_frag.h"
#include "kernels/predict_reflection_frag.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace utsuri {
namespace {

std::vector<std::uint32_t> numbers_below(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

template <typename Record>
std::vector<Record> records_of(const std::vector<glm::vec4>& pixels) {
    static_assert(sizeof(Record) == sizeof(glm::vec4));
    std::vector<Record> records(pixels.size());
    std::transform(pixels.begin(), pixels.end(), records.begin(),
                   [](const glm::vec4& pixel) { return std::bit_cast<Record>(pixel); });
    return records;
}

}  // namespace

PredictionDrawer::PredictionDrawer(Device& device, const SceneData& data, MapKind kind, std::size_t faces,
                                   const Specialization& specialization, const Bindings& bindings,
                                   const ReflectorDrawer& reflectors, std::uint32_t width,
                                   std::uint32_t height)
    : device_(device),
      info_(frame_info(data, width, height)),
      frame_(*bindings.at(interop::BINDING_FRAME)),
      colour_(device, width, height, kColourFormat, "errors of reflections"),
      depth_(device, width, height, kDepthFormat, "depth of errors of reflections"),
      triangles_(make_buffer<std::uint32_t>(device, plan_draws(data).triangles, "draw list of errors")),
      triangle_count_(static_cast<std::uint32_t>(plan_draws(data).triangles.size())),
      polygons_(make_buffer<std::uint32_t>(device, numbers_below(reflectors.polygon_count()),
                                           "polygons with errors")),
      polygon_count_(reflectors.polygon_count()),
      depth_pass_(device, "draw_depth", kernels::draw_depth_vert, {}, depth_constants(specialization),
                  sizeof(interop::ViewPush)),
      depth_bindings_(depth_pass_.bind([&] {
          Bindings all = bindings;
          all[interop::BINDING_DRAW_LIST] = &triangles_;
          return all;
      }())),
      predict_(make_stage("predict_reflection", kernels::predict_reflection_frag,
                          reflectors.specialise(specialization, kind, faces),
                          reflectors.with_polygons(bindings))),
      measure_(make_stage("measure_reflection", kernels::measure_reflection_frag,
                          reflectors.specialise(specialization, kind, faces),
                          reflectors.with_polygons(bindings))) {}

PredictionDrawer::Stage PredictionDrawer::make_stage(const char* name,
                                                     std::span<const std::uint32_t> fragment,
                                                     const Specialization& specialization,
                                                     Bindings bindings) const {
    Specialization constants = specialization;
    constants[interop::SPEC_EXCLUDES_INSTANCE] = 1;
    bindings[interop::BINDING_DRAWN_POLYGONS] = &polygons_;
    RasterPipeline pipeline(device_, name, kernels::draw_predicted_reflectors_vert, fragment, constants,
                            sizeof(interop::ViewPush));
    BindingSet set = pipeline.bind(bindings);
    return {std::move(pipeline), std::move(set)};
}

std::vector<glm::vec4> PredictionDrawer::draw(const Stage& stage, const interop::CameraInfo& camera,
                                              float tolerance) {
    interop::FrameInfo frame = info_;
    frame.tolerance = tolerance;
    interop::ViewPush push{};
    push.camera = camera;
    constexpr auto kNothing = std::bit_cast<std::array<float, 4>>(kNoReflection<PredictedError>);
    device_.run("draw errors of reflections", [&](const vk::raii::CommandBuffer& commands) {
        frame_.record_update(commands, std::as_bytes(std::span(&frame, 1)));
        draw_into(commands, colour_, depth_, kNothing, [&] {
            depth_pass_.draw(commands, depth_bindings_, push, 0, triangle_count_);
            stage.pipeline.draw(commands, stage.bindings, push, 0, polygon_count_);
        });
    });
    return picture_pixels(device_, colour_);
}

std::vector<PredictedError> PredictionDrawer::predict(const interop::CameraInfo& camera, float tolerance) {
    return records_of<PredictedError>(draw(predict_, camera, tolerance));
}

std::vector<MeasuredError> PredictionDrawer::measure(const interop::CameraInfo& camera, float tolerance) {
    return records_of<MeasuredError>(draw(measure_, camera, tolerance));
}

}  // namespace utsuri
