// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/pipeline_interface.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace utsuri {

/// A pipeline and what it reads.
struct Pipeline {
    PipelineInterface interface;
    vk::raii::Pipeline handle;

    Pipeline(PipelineInterface interface, vk::raii::Pipeline handle);
    Pipeline(Pipeline&& other) noexcept;
    ~Pipeline();
};

/// All that a pipeline is made of, in one list: what has an equal one is the same pipeline.
class PipelineRecipe {
  public:
    PipelineRecipe& add(std::uint32_t value);
    /// A stage's code, and the values of the constants that it declares.
    PipelineRecipe& add_stage(std::span<const std::uint32_t> spirv, const Specialization& specialization);

    // clang-tidy 14 takes the 0 that such a comparison is held against for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend auto operator<=>(const PipelineRecipe&, const PipelineRecipe&) = default;

  private:
    std::vector<std::uint32_t> words_;
};

/// Pipelines that a device keeps: more than all methods of a scene with everything in it take together
/// (tests/extremes/pipelines_test.cpp), so that what goes is of scenes before. Constants of pipelines follow
/// from scenes, such as the number of lights: without a bound each new one would leave its own behind.
inline constexpr std::size_t kMostPipelines = 256;

/// Pipelines of a device: what several renderers need, or one that is made anew as its scene changes, is
/// compiled once.
class PipelineCache {
  public:
    /// @param most pipelines kept; beyond that, those go that nothing else holds, first what was asked for
    /// longest ago
    explicit PipelineCache(std::size_t most = kMostPipelines);
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;
    ~PipelineCache();

    /// @param make is called if there is no pipeline of that recipe; what it throws is passed on
    std::shared_ptr<const Pipeline> find_or_make(const PipelineRecipe& recipe,
                                                 const std::function<Pipeline()>& make);
    [[nodiscard]] std::size_t size() const { return pipelines_.size(); }

  private:
    struct Kept {
        std::shared_ptr<const Pipeline> pipeline;
        std::uint64_t asked_for;  ///< at this count of calls
    };
    void drop_unheld();

    std::size_t most_;
    std::uint64_t calls_ = 0;
    std::map<PipelineRecipe, Kept> pipelines_;
};

}  // namespace utsuri
