// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "renderers/device_scene/scene_data.h"
#include "renderers/light/light_settings.h"

#include "base/progress.h"
#include "gpu/device.h"
#include "gpu/device_selection.h"
#include "gpu/vulkan_instance.h"
#include "scene/camera.h"
#include "scene/scene.h"

#include "interop/frame.h"
#include "session/picture.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace utsuri {

/// What a session is opened with.
struct SessionSettings {
    std::string device;  ///< index or part of a name; of the fastest kind if empty
    Validation validation = Validation::off;
    LightSettings light;
};

/// What Session::set_scene() did with a scene, beside the one before it.
struct SceneUpdate {
    enum class Kind {
        unchanged,  ///< nothing: it is the same
        updated,    ///< what the change touches was made anew: things moved, lights and colours took other
                    ///< values
        rebuilt     ///< all that is kept about the scene is made anew, when it is next needed
    };
    Kind kind = Kind::unchanged;
    /// Why all is made anew, for messages: "it now has 3 lights that shine where it had 2". Empty unless
    /// rebuilt.
    std::string reason;
};

/// A device and a scene on it, pictures of which are rendered by any method: the library's front door. One
/// thread at a time. One that was moved from may only be assigned to or destroyed. All calls that use the
/// device throw DeviceError if it fails.
///
///     Session session;
///     session.set_scene(scene);
///     Picture picture = session.make_picture({find_method("direct", "hybrid"), scene.cameras.front()});
///     picture.add_samples(16);
///     Image image = picture.image();
class Session {
  public:
    /// @throws DeviceError if there is no such device, or none at all
    /// @throws UsageError if the light settings are out of their ranges
    explicit Session(const SessionSettings& settings = {});
    Session(Session&& other) noexcept;
    Session& operator=(Session&& other) noexcept;
    ~Session();

    /// Gives the scene, or the scene as it is now: only what differs goes to the device. Pictures forget
    /// their samples unless nothing has changed, and follow; so does the light kept on surfaces, if some
    /// picture reads it. The scene need not outlive the call.
    /// @returns what it did, and why if it is all made anew
    /// @throws InputError if the scene is not valid (check_scene()); the session keeps the scene it had,
    /// pictures their samples
    /// @throws DeviceError if the scene does not fit: the session then has none. If only the light kept on
    /// surfaces does not, it has the new one, and all that is kept about it is made anew when it is next
    /// needed. The next scene may be given after either.
    /// @throws Interrupted if progress says so; as if the light did not fit
    SceneUpdate set_scene(const Scene& scene, Progress& progress);
    SceneUpdate set_scene(const Scene& scene);

    /// A picture without samples, of the scene as it is and as it becomes.
    /// @param settings the camera need not be one of the scene's
    /// @throws UsageError without a scene, if a setting is out of its range, or if the settings do not fit
    /// the scene or the device
    /// @throws DeviceError if what it needs does not fit
    [[nodiscard]] Picture make_picture(const PictureSettings& settings);

    /// First hits through the pixel centres, row-major, top row first. Positions are relative to
    /// SceneData::origin, in metres.
    /// @param width, height pixels, [1, kLargestPictureEdge]
    /// @throws UsageError without a scene, or if the camera or the size is out of its range
    [[nodiscard]] std::vector<interop::AovPixel> first_hits(const Camera& camera, std::uint32_t width,
                                                            std::uint32_t height) const;
    /// The scene as it was prepared; valid until the next call that is not const.
    /// @throws UsageError without a scene
    [[nodiscard]] const SceneData& scene() const;

    /// Valid as long as the session or a picture of it.
    [[nodiscard]] const DeviceSummary& device() const;
    /// Of the device, by the scene, kept light and all pictures.
    [[nodiscard]] MemoryUsage memory() const;
    /// The peak becomes what is held now.
    void reset_peak_memory();
    /// What the validation layer said since it was last asked; nothing unless SessionSettings::validation is
    /// on.
    [[nodiscard]] std::vector<std::string> take_validation_messages();

  private:
    std::shared_ptr<SessionState> state_;
};

}  // namespace utsuri
