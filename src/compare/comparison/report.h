// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison/comparison.h"

#include <string>

namespace utsuri {

/// One HTML5 page that shows a comparison: pictures side by side, error maps, tables of cost and error, and
/// how it was made. UTF-8. Style, script, data and pictures (PNG at the comparison's exposure) are all
/// inside; nothing is fetched when it is shown. The element with id "data" holds the JSON of
/// comparison_to_json() and, under "pictures", the pictures as data URIs.
std::string make_report(const Comparison& comparison);

}  // namespace utsuri
