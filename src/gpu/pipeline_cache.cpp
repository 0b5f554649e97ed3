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

PipelineCache::PipelineCache(std::size_t most) : most_(most) {}
PipelineCache::~PipelineCache() = default;

std::shared_ptr<const Pipeline> PipelineCache::find_or_make(const PipelineRecipe& recipe,
                                                            const std::function<Pipeline()>& make) {
    ++calls_;
    if (const auto found = pipelines_.find(recipe); found != pipelines_.end()) {
        found->second.asked_for = calls_;
        return found->second.pipeline;
    }
    auto made = std::make_shared<const Pipeline>(make());
    pipelines_.emplace(recipe, Kept{made, calls_});
    drop_unheld();
    return made;
}

void PipelineCache::drop_unheld() {
    while (pipelines_.size() > most_) {
        auto oldest = pipelines_.end();
        for (auto it = pipelines_.begin(); it != pipelines_.end(); ++it) {
            if (it->second.pipeline.use_count() > 1) continue;
            if (oldest == pipelines_.end() || it->second.asked_for < oldest->second.asked_for) oldest = it;
        }
        if (oldest == pipelines_.end()) return;
        pipelines_.erase(oldest);
    }
}

}  // namespace utsuri
