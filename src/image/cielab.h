// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace utsuri {

/// CIE XYZ of the linear Rec.709 primaries (BT.709-6) with the white point D65, whose Y is one. The white is
/// x = 0.31271, y = 0.32902 (CIE 15, 2 degree observer), five digits as in the FLIP papers.
struct XyzSpace {
    glm::mat3 from_linear;  ///< XYZ = from_linear * linear
    glm::mat3 to_linear;
    glm::vec3 white;  ///< XYZ of linear (1, 1, 1)

    XyzSpace();
};

/// CIE 1976 L* a* b* of XYZ / white (CIE 15); L* is 100 at white.
[[nodiscard]] glm::vec3 lab_from_relative_xyz(const glm::vec3& relative);

/// The inverse of lab_from_relative_xyz.
[[nodiscard]] glm::vec3 relative_xyz_from_lab(const glm::vec3& lab);

}  // namespace utsuri
