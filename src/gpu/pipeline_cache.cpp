// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_cache.h"

#include "gpu/spirv.h"

#include <utility>

namespace utsuri {

Pipeline::Pipeline(PipelineInterface read, vk::raii::Pipeline made)
    : interface(std::move(read)), handle(std::move(made)) {}

Pipeline::Pipeline(Pipeline&& other) noexcept = default;
Pipeline::~Pipeline() = default;

PipelineRecipe& PipelineRecipe::add(std::uint32_t value) {
    words_.push_back(value);
    return *this;
}

PipelineRecipe& PipelineRecipe::add_stage(std::span<const std::uint32_t> spirv,
                                          const Specialization& specialization) {
    // Lengths first, so that different lists never make equal ones when they are joined.
    add(static_cast<std::uint32_t>(spirv.size()));
    words_.insert(words_.end(), spirv.begin(), spirv.end());
    const std::size_t length = words_.size();
    add(0);
    for (const std::uint32_t id : spirv_specialization_ids(spirv)) {
        const auto found = specialization.find(id);
        if (found == specialization.end()) continue;
        add(id).add(found->second);
        ++words_[length];
    }
    return *this;
}

PipelineCache::PipelineCache() = default;
PipelineCache::~PipelineCache() = default;

std::shared_ptr<const Pipeline> PipelineCache::find_or_make(const PipelineRecipe& recipe,
                                                            const std::function<Pipeline()>& make) {
    std::shared_ptr<const Pipeline>& pipeline = pipelines_[recipe];
    if (!pipeline) pipeline = std::make_shared<const Pipeline>(make());
    return pipeline;
}

}  // namespace utsuri
