// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/methods/mapped_view.h"
#include "renderers/methods/method.h"
#include "renderers/methods/raster_renderer.h"
#include "support/scenes.h"

namespace utsuri::test {

/// All ways to look reflections up in maps.
inline constexpr MapKind kMapKinds[] = {MapKind::polygon, MapKind::sphere,   MapKind::cube,
                                        MapKind::proxy,   MapKind::distance, MapKind::hybrid};

/// A method that draws: how it looks reflections up, and whether it draws what plane mirrors show.
struct DrawnMethod : RasterMethod {
    DrawnMethod(MapKind k, bool images = false) : RasterMethod{k, images} {}
};
std::ostream& operator<<(std::ostream& stream, const DrawnMethod& method);

/// All of them.
std::vector<DrawnMethod> drawn_methods();

/// Light at points that are spaced evenly, wherever it changes.
constexpr LightSettings evenly_kept(double spacing, std::uint32_t samples, std::uint32_t seed) {
    LightSettings settings;
    settings.spacing = spacing;
    settings.samples = samples;
    settings.seed = seed;
    settings.refinement = 1.0;
    return settings;
}

/// Light kept on the surfaces of a scene.
KeptLight kept_light(Device& device, const SceneData& data, const GpuScene& scene,
                     const LightSettings& settings);

/// A renderer of a method. What it is made from must outlive it.
RasterRenderer make_raster(Device& device, const SceneData& data, const GpuScene& scene, KeptLight& light,
                           const Camera& camera, const DrawnMethod& method, const RenderSettings& settings,
                           const MapSettings& maps);

/// What draws the reflectors of a method that draws no images; none where nothing is reflective.
const ReflectorDrawer* reflectors_of(const RasterRenderer& renderer);

/// A scene on the device with light for all methods: coarse, where it does not matter how diffuse surfaces
/// look.
class DrawnScene {
  public:
    DrawnScene(Device& device, const Scene& scene);

    [[nodiscard]] std::unique_ptr<Renderer> renderer(const DrawnMethod& method, const Camera& camera,
                                                     const RenderSettings& settings, const MapSettings& maps);
    /// @param samples of each pixel
    Traced render(const DrawnMethod& method, const Camera& camera, const RenderSettings& settings,
                  const MapSettings& maps, std::uint32_t samples);

  private:
    Device& device_;
    SceneData data_;
    GpuScene gpu_scene_;
    KeptLight light_;
};

/// One picture of a scene: see DrawnScene.
Traced render_with_maps(Device& device, const Scene& scene, const Camera& camera,
                        const RenderSettings& settings, const DrawnMethod& method, const MapSettings& maps,
                        std::uint32_t samples);

/// A room of textured and plain walls with an emissive panel, a point, a spot and a directional light, a
/// mirror ball, a plane mirror and a rough metal ball: every kind of light and surface there is, in 700
/// triangles.
Scene everything_scene();
Camera everything_camera();

}  // namespace utsuri::test
