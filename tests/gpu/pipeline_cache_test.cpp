// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipeline_cache.h"

#include "support/test_device.h"

#include "base/error.h"
#include "gpu/probe.h"

#include "kernels/film_probe.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>

namespace utsuri {
namespace {

class PipelinesOfDevice : public DeviceTest {
  protected:
    using Held = std::shared_ptr<const Pipeline>;

    /// The pipeline of a number, which stands for all that tells pipelines apart. None is ever run.
    Held ask(PipelineCache& cache, std::uint32_t number) {
        return cache.find_or_make(PipelineRecipe().add(number), [&] {
            ++made_[number];
            const StageModule module{vk::ShaderStageFlagBits::eCompute, kernels::film_probe};
            return Pipeline(
                PipelineInterface(device(), "film_probe", std::span(&module, 1), sizeof(interop::ProbePush)),
                vk::raii::Pipeline(nullptr));
        });
    }

    std::map<std::uint32_t, int> made_;  ///< how often
};

TEST_F(PipelinesOfDevice, AreMadeOnce) {
    PipelineCache cache(2);
    const Held first = ask(cache, 1);
    EXPECT_EQ(ask(cache, 1), first);
    EXPECT_EQ(made_[1], 1);
    EXPECT_EQ(cache.size(), 1u);
}

TEST_F(PipelinesOfDevice, GoIfAskedForLongestAgo) {
    PipelineCache cache(2);
    for (const std::uint32_t number : {1u, 2u, 1u, 3u})
        ask(cache, number);
    EXPECT_EQ(cache.size(), 2u);
    ask(cache, 1);
    ask(cache, 3);
    EXPECT_EQ(made_, (std::map<std::uint32_t, int>{{1, 1}, {2, 1}, {3, 1}}));
    ask(cache, 2);
    EXPECT_EQ(made_[2], 2);
    EXPECT_EQ(cache.size(), 2u);
}

TEST_F(PipelinesOfDevice, StayAsLongAsTheyAreHeld) {
    PipelineCache cache(1);
    Held first = ask(cache, 1);
    for (const std::uint32_t number : {2u, 3u, 4u})
        ask(cache, number);
    EXPECT_EQ(cache.size(), 2u) << "the one that is held, and the last";
    EXPECT_EQ(ask(cache, 1), first);
    EXPECT_EQ(made_[1], 1);
    first.reset();
    ask(cache, 5);
    EXPECT_EQ(cache.size(), 1u);
    ask(cache, 1);
    EXPECT_EQ(made_[1], 2);
}

TEST_F(PipelinesOfDevice, LeaveNothingIfTheyCannotBeMade) {
    PipelineCache cache(2);
    const auto fail = []() -> Pipeline { throw DeviceError("create kernel", "'probe'", "out of memory"); };
    EXPECT_THROW(cache.find_or_make(PipelineRecipe().add(1), fail), DeviceError);
    EXPECT_EQ(cache.size(), 0u);
    EXPECT_NE(ask(cache, 1), nullptr);
    EXPECT_EQ(made_[1], 1);
}

}  // namespace
}  // namespace utsuri
