// SPDX-License-Identifier: Apache-2.0
#ifndef UTSURI_INTEROP_WORKGROUP_H
#define UTSURI_INTEROP_WORKGROUP_H
#include "interop/prelude.h"
INTEROP_BEGIN

/// Invocations of a workgroup, in every kernel: two subgroups of 32, eight of 8.
INTEROP_CONSTANT WORKGROUP_SIZE = 64u;

INTEROP_END
#endif
