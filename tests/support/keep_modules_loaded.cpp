// SPDX-License-Identifier: Apache-2.0
// Linked into programs under the address sanitizer only. Leaks are looked for at exit, when the Vulkan loader
// would have closed the driver: its frames would have no module, and its leaks could not be told from ours
// (driver_leaks.supp).
extern "C" int dlclose(void*);
extern "C" int dlclose(void*) {
    return 0;
}
