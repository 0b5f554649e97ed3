// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernel.h"

#include "support/test_device.h"

#include "base/check.h"
#include "gpu/pipeline_cache.h"
#include "gpu/probe.h"

#include "kernels/film_probe.h"
#include "kernels/numeric_probe.h"

#include <gmock/gmock.h>

#include <array>
#include <vector>

namespace utsuri {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using KernelOnDevice = DeviceTest;

TEST_F(KernelOnDevice, NamesTheBindingThatIsMissing) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer buffer(device(), 64, "queries");
    try {
        static_cast<void>(kernel.bind({{interop::PROBE_QUERIES, &buffer}}));
        FAIL() << "bound without answers";
    } catch (const CheckFailure& failure) {
        EXPECT_THAT(failure.what(), AllOf(HasSubstr("film_probe"), HasSubstr("binding 1")));
    }
}

TEST_F(KernelOnDevice, PassesOverBuffersItDoesNotUse) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {{77, 1}}, sizeof(interop::ProbePush));
    const Buffer buffer(device(), 64, "any");
    EXPECT_NO_THROW(static_cast<void>(kernel.bind({{0, &buffer}, {1, &buffer}, {20, &buffer}})));
}

TEST_F(KernelOnDevice, RefusesPushConstantsOfAnotherSize) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer buffer(device(), 64, "any");
    const BindingSet set = kernel.bind({{0, &buffer}, {1, &buffer}});
    const std::uint64_t wrong = 0;
    EXPECT_THROW(device().run("push too much",
                              [&](const vk::raii::CommandBuffer& commands) {
                                  kernel.dispatch(commands, set, wrong, 1);
                              }),
                 CheckFailure);
    // The device is still good for work.
    EXPECT_NO_THROW(device().run("nothing", [](const vk::raii::CommandBuffer&) {}));
}

TEST_F(KernelOnDevice, RefusesMoreGroupsThanEveryDeviceTakes) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer buffer(device(), 64, "any");
    const BindingSet set = kernel.bind({{0, &buffer}, {1, &buffer}});
    EXPECT_THROW(device().run("dispatch too much",
                              [&](const vk::raii::CommandBuffer& commands) {
                                  kernel.dispatch(commands, set, interop::ProbePush{0}, kMaxGroups + 1);
                              }),
                 CheckFailure);
    EXPECT_NO_THROW(device().run("nothing", [](const vk::raii::CommandBuffer&) {}));
}

TEST_F(KernelOnDevice, RunsAsManyGroupsAsABufferTells) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer queries = make_buffer<interop::FilmQuery>(
        device(), std::vector<interop::FilmQuery>{{1.0f, 5.0f, 2.0f, 0}}, "queries");
    const Buffer arguments(device(), 3 * sizeof(std::uint32_t), "arguments");
    for (const std::uint32_t groups : {0u, 1u}) {
        Buffer answers(device(), 64, "answers");
        answers.fill_with_zero();
        const BindingSet set = kernel.bind({{0, &queries}, {1, &answers}});
        const std::array<std::uint32_t, 3> told = {groups, 1, 1};
        device().run("an indirect dispatch", [&](const vk::raii::CommandBuffer& commands) {
            arguments.record_update(commands, std::as_bytes(std::span(told)));
            kernel.dispatch_indirect(commands, set, interop::ProbePush{1}, arguments);
        });
        // b + c, see film_probe.comp.
        const float sum = answers.download_records<interop::FilmAnswer>(1).front().sum;
        EXPECT_EQ(sum, groups == 0 ? 0.0f : 7.0f);
    }
}

TEST_F(KernelOnDevice, SeesWhatDispatchesBeforeItWrote) {
    // Each dispatch in turn reads what the one before wrote: query i of the next is answers 2i and 2i + 1.
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer queries = make_buffer<interop::FilmQuery>(
        device(), std::vector<interop::FilmQuery>{{0.0f, 1.0f, 0.0f, 0}, {0.0f, 5.0f, 2.0f, 0}}, "queries");
    const Buffer between(device(), 64, "between");
    const Buffer answers(device(), 64, "answers");
    const BindingSet first = kernel.bind({{0, &queries}, {1, &between}});
    const BindingSet second = kernel.bind({{0, &between}, {1, &answers}});
    device().run("two dispatches", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, first, interop::ProbePush{2}, 1);
        kernel.dispatch(commands, second, interop::ProbePush{1}, 1);
    });
    // The answers {1, 0} and {7, 0} read as a query are a = 1, b = 0, c = 7, repeats = 0: their sum is b + c.
    EXPECT_EQ(answers.download_records<interop::FilmAnswer>(1).front().sum, 7.0f);
}

TEST_F(KernelOnDevice, IsCompiledOnceForAllThatNeedIt) {
    const auto pipelines_after = [](const Specialization& specialization) {
        const Kernel kernel(device(), "film_probe", kernels::film_probe, specialization,
                            sizeof(interop::ProbePush));
        return device().pipelines().size();
    };
    const std::size_t once = pipelines_after({});
    EXPECT_EQ(pipelines_after({}), once);
    EXPECT_EQ(pipelines_after({{77, 1}}), once) << "for a constant that the kernel does not have";
    const Kernel another(device(), "numeric_probe", kernels::numeric_probe, {}, sizeof(interop::ProbePush));
    EXPECT_EQ(device().pipelines().size(), once + 1);
}

TEST_F(KernelOnDevice, TakesTimeOnTheDevice) {
    const Kernel kernel(device(), "film_probe", kernels::film_probe, {}, sizeof(interop::ProbePush));
    const Buffer queries = make_buffer<interop::FilmQuery>(
        device(), std::vector<interop::FilmQuery>{{1.0f, 0.0f, 0.0f, 4000000}}, "queries");
    const Buffer answers(device(), 64, "answers");
    const BindingSet set = kernel.bind({{0, &queries}, {1, &answers}});
    const double seconds = device().run("count", [&](const vk::raii::CommandBuffer& commands) {
        kernel.dispatch(commands, set, interop::ProbePush{1}, 1);
    });
    // Four million dependent sums take longer than any clock's tick and less than a minute.
    EXPECT_GT(seconds, 1e-6);
    EXPECT_LT(seconds, 60.0);
}

}  // namespace
}  // namespace utsuri
