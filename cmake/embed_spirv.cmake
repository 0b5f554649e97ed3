# SPDX-License-Identifier: Apache-2.0
# cmake -DNAME=... -DSPIRV=file.spv -DHEADER=file.h -P embed_spirv.cmake: a module as an array of 32-bit words, a single 0
# if SPIRV is not given.
set(words 0)
if(SPIRV)
    file(READ ${SPIRV} bytes HEX)
    string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
endif()
file(WRITE ${HEADER}
"// Generated from ${NAME}.comp.
#pragma once
#include <cstdint>
namespace utsuri::kernels {
inline constexpr std::uint32_t ${NAME}[] = {${words}};
}  // namespace utsuri::kernels
")
