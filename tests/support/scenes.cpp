// SPDX-License-Identifier: Apache-2.0
#include "support/scenes.h"

#include "renderers/methods/method.h"
#include "renderers/methods/ray_tracer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <map>

namespace utsuri::test {

Material lambert(glm::vec3 albedo) {
    Material material;
    material.base_colour = albedo;
    material.metallic = 0.0f;
    material.specular = 0.0f;
    return material;
}

Material mirror() {
    Material material;
    material.roughness = 0.0f;
    return material;
}

Material emitter(glm::vec3 radiance, glm::vec3 albedo) {
    Material material = lambert(albedo);
    material.emissive = radiance;
    return material;
}

Material glossy_metal(float roughness, glm::vec3 f0) {
    Material material;
    material.base_colour = f0;
    material.roughness = roughness;
    return material;
}

Mesh quad(glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
    Mesh mesh;
    mesh.positions = {corner, corner + u, corner + u + v, corner + v};
    mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
    mesh.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Mesh icosphere(glm::vec3 centre, float radius, int level) {
    const float golden = 1.61803398875f;
    std::vector<glm::vec3> points;
    for (const float a : {-1.0f, 1.0f}) {
        for (const float b : {-golden, golden}) {
            points.insert(points.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
        }
    }
    std::vector<glm::uvec3> faces;
    for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t j = i + 1; j < 12; ++j) {
            for (std::uint32_t k = j + 1; k < 12; ++k) {
                const auto near = [&](std::uint32_t p, std::uint32_t q) {
                    return glm::length(points[p] - points[q]) < 2.1f;  // edges have length 2
                };
                if (!near(i, j) || !near(j, k) || !near(i, k)) continue;
                const bool out =
                    glm::dot(glm::cross(points[j] - points[i], points[k] - points[i]), points[i]) > 0;
                faces.push_back(out ? glm::uvec3(i, j, k) : glm::uvec3(i, k, j));
            }
        }
    }
    for (glm::vec3& point : points)
        point = glm::normalize(point);
    for (int l = 0; l < level; ++l) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, added] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
            if (added) points.push_back(glm::normalize(points[a] + points[b]));
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& f : faces) {
            const glm::uvec3 m(middle(f.x, f.y), middle(f.y, f.z), middle(f.z, f.x));
            finer.insert(finer.end(), {{f.x, m.x, m.z}, {m.x, f.y, m.y}, {m.z, m.y, f.z}, {m.x, m.y, m.z}});
        }
        faces = std::move(finer);
    }
    Mesh mesh;
    mesh.normals = points;
    for (const glm::vec3& point : points)
        mesh.positions.push_back(centre + radius * point);
    mesh.triangles = std::move(faces);
    return mesh;
}

Mesh room(glm::vec3 lower, glm::vec3 upper) {
    Mesh mesh;
    const glm::vec3 size = upper - lower;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 u(0.0f);
        glm::vec3 v(0.0f);
        u[(axis + 1) % 3] = size[(axis + 1) % 3];
        v[(axis + 2) % 3] = size[(axis + 2) % 3];
        for (const bool far : {false, true}) {
            glm::vec3 corner = lower;
            if (far) corner[axis] = upper[axis];
            const Mesh wall = far ? quad(corner, v, u) : quad(corner, u, v);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(), wall.positions.begin(), wall.positions.end());
            mesh.normals.insert(mesh.normals.end(), wall.normals.begin(), wall.normals.end());
            mesh.texcoords.insert(mesh.texcoords.end(), wall.texcoords.begin(), wall.texcoords.end());
            for (const glm::uvec3& triangle : wall.triangles)
                mesh.triangles.push_back(triangle + first);
        }
    }
    return mesh;
}

std::uint32_t add(Scene& scene, Mesh mesh, const Material& material) {
    scene.meshes.push_back(std::move(mesh));
    scene.materials.push_back(material);
    scene.instances.push_back({"", static_cast<std::uint32_t>(scene.meshes.size() - 1),
                               static_cast<std::uint32_t>(scene.materials.size() - 1), glm::dmat4(1.0)});
    return static_cast<std::uint32_t>(scene.instances.size() - 1);
}

Camera look_at(glm::dvec3 eye, glm::dvec3 target, double vertical_fov) {
    Camera camera;
    camera.position = eye;
    camera.forward = glm::normalize(target - eye);
    const glm::dvec3 up = std::abs(camera.forward.y) > 0.999 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    camera.right = glm::normalize(glm::cross(camera.forward, up));
    camera.up = glm::cross(camera.right, camera.forward);
    camera.vertical_fov = vertical_fov;
    return camera;
}

Scene scaled(const Scene& scene, double factor) {
    Scene result = scene;
    for (Instance& instance : result.instances) {
        instance.world_from_object =
            glm::scale(glm::dmat4(1.0), glm::dvec3(factor)) * instance.world_from_object;
    }
    for (Light& light : result.lights) {
        light.position *= factor;
        light.range *= factor;
        if (light.type != LightType::directional) light.intensity *= static_cast<float>(factor * factor);
    }
    for (Camera& camera : result.cameras)
        camera.position *= factor;
    return result;
}

std::unique_ptr<RayTracer> make_tracer(Device& device, const SceneData& data, const GpuScene& gpu_scene,
                                       const Camera& camera, const RenderSettings& settings) {
    const LightMethod& light = light_methods().front();
    KeptLight unused(device, data, gpu_scene, light, {});
    return std::make_unique<RayTracer>(RendererInput{device, data, gpu_scene, light, unused, camera},
                                       settings);
}

Traced trace(Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings,
             std::uint32_t samples) {
    const SceneData data = prepare_scene_data(scene);
    const GpuScene gpu_scene(device, data);
    const std::unique_ptr<RayTracer> tracer = make_tracer(device, data, gpu_scene, camera, settings);
    Film film(device, settings.width, settings.height, "test film");
    Progress progress;
    tracer->prepare(progress);
    tracer->add_samples(film, samples, progress);
    return {film.resolve(), tracer->statistics()};
}

}  // namespace utsuri::test
