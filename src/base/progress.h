// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace utsuri {

/// Where long work tells how far it is and asks whether to go on. The command line shows one line on a
/// terminal; tests and libraries may pass the silent base class.
class Progress {
  public:
    Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    virtual ~Progress() = default;

    /// Starts a stage, for example "reference, 64 spp". Ends the stage before it.
    virtual void begin(const std::string& /*stage*/) {}
    /// `done` and `total` in the same unit, for example samples; total > 0.
    virtual void update(double /*done*/, double /*total*/) {}
    /// True once the user has asked to stop; work ends at the next safe point.
    [[nodiscard]] virtual bool cancelled() const { return false; }
};

/// Tells nothing of its own, and stops when another does: for parts of work that another tells of.
class SilentProgress : public Progress {
  public:
    /// `other` must outlive this.
    explicit SilentProgress(const Progress& other) : other_(other) {}
    [[nodiscard]] bool cancelled() const override { return other_.cancelled(); }

  private:
    const Progress& other_;
};

/// Thrown by work that stops because Progress::cancelled() and has nothing worth keeping.
class Interrupted : public std::runtime_error {
  public:
    Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace utsuri
