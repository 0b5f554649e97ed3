// SPDX-License-Identifier: Apache-2.0
#include "probe.h"

#include "renderers/device_scene/gpu_scene.h"

#include "kernels/sampler_probe.h"

#include <random>

namespace utsuri::test {

std::vector<glm::vec2> random_pairs(std::size_t count, std::uint32_t seed) {
    std::mt19937 engine(seed);
    // The generator's 24 upper bits: the standard distributions may round to 1.
    const auto number = [&] { return static_cast<float>(engine() >> 8) * 0x1p-24f; };
    std::vector<glm::vec2> pairs(count);
    for (glm::vec2& pair : pairs) {
        pair.x = number();
        pair.y = number();
    }
    return pairs;
}

std::vector<interop::ProbeOutput> probe(Device& device, const SceneData& data, std::uint32_t sampler,
                                        interop::ProbePush push, std::span<const glm::vec2> inputs) {
    const GpuScene scene(device, data);
    const Buffer input_buffer = make_buffer(device, inputs, "probe inputs");
    const Buffer outputs(device, inputs.size() * sizeof(interop::ProbeOutput), "probe outputs");
    Specialization specialization = scene.specialization();
    specialization[interop::PROBE_SPEC_SAMPLER] = sampler;
    const Kernel kernel(device, "sampler_probe", kernels::sampler_probe, specialization, sizeof(push));
    Bindings bindings = scene.bindings();
    bindings[interop::PROBE_BINDING_INPUTS] = &input_buffer;
    bindings[interop::PROBE_BINDING_OUTPUTS] = &outputs;
    const BindingSet set = kernel.bind(bindings);
    push.count = static_cast<std::uint32_t>(inputs.size());
    device.run("probe a sampler", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, push, group_count(push.count));
    });
    return outputs.download_records<interop::ProbeOutput>(inputs.size());
}

}  // namespace utsuri::test
