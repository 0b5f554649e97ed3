// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel.h"
#include "gpu/probes.h"

#include <span>
#include <string>
#include <vector>

namespace utsuri::test {

/// The answers of a probe kernel to the queries, in their order.
template <typename Answer, typename Query>
std::vector<Answer> ask(Device& device, const std::string& name, std::span<const std::uint32_t> spirv,
                        const std::vector<Query>& queries) {
    const Kernel kernel(device, name, spirv, {}, sizeof(interop::ProbePush));
    const Buffer query_buffer = make_buffer<Query>(device, queries, name + " queries");
    const Buffer answer_buffer(device, queries.size() * sizeof(Answer), name + " answers");
    const BindingSet set =
        kernel.bind({{interop::PROBE_QUERIES, &query_buffer}, {interop::PROBE_ANSWERS, &answer_buffer}});
    const interop::ProbePush push{static_cast<std::uint32_t>(queries.size())};
    device.run("ask " + name, [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, push, group_count(push.count));
    });
    return answer_buffer.download_records<Answer>(queries.size());
}

}  // namespace utsuri::test
