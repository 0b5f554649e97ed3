# SPDX-License-Identifier: Apache-2.0
find_program(GLSLANG_VALIDATOR glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)
find_program(SPIRV_VAL spirv-val REQUIRED)

# utsuri_add_kernels(TARGET file ...): compiles kernels/FILE of the current folder, ROOM/NAME.comp, .vert or .frag,
# validates the SPIR-V and embeds it in a header of TARGET, an interface library: NAME.comp as `utsuri::kernels::NAME` in
# "kernels/NAME.h", NAME.vert as NAME_vert, NAME.frag as NAME_frag, whatever its room. It is compiled again when a file it
# includes changes (depfile). The same with names is NAME.spv in the folder UTSURI_SPIRV_FOLDER for each NAME of
# UTSURI_KERNELS, two properties of TARGET. With UTSURI_EMPTY_KERNELS nothing is compiled and the headers hold no code, for
# tools that only read the C++ files.
function(utsuri_add_kernels target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
    file(MAKE_DIRECTORY ${folder}/kernels)
    set(headers)
    set(names)
    # Names are for those who debug kernels: without them drivers read a fifth less at every start.
    set(strip_names $<$<NOT:$<CONFIG:Debug>>:--strip-debug>)
    foreach(file ${ARGN})
        set(source ${CMAKE_CURRENT_SOURCE_DIR}/kernels/${file})
        cmake_path(GET file FILENAME name)
        string(REPLACE ".comp" "" name ${name})
        string(REPLACE "." "_" name ${name})
        list(APPEND names ${name})
        set(spirv ${folder}/kernels/${name}.spv)
        set(header ${folder}/kernels/${name}.h)
        if(UTSURI_EMPTY_KERNELS)
            set(NAME ${name})
            set(HEADER ${header})
            include(${PROJECT_SOURCE_DIR}/cmake/embed_spirv.cmake)
            continue()
        endif()
        add_custom_command(
            OUTPUT ${spirv}
            COMMAND ${GLSLANG_VALIDATOR} -V --quiet --target-env vulkan1.3 -I${CMAKE_CURRENT_SOURCE_DIR} -I${PROJECT_SOURCE_DIR}/shaders
                    --depfile ${spirv}.d -o ${spirv} ${source}
            COMMAND ${SPIRV_VAL} --target-env vulkan1.3 --scalar-block-layout ${spirv}
            MAIN_DEPENDENCY ${source}
            DEPFILE ${spirv}.d
            COMMENT "Compiling kernel ${name}"
            VERBATIM)
        add_custom_command(
            OUTPUT ${header}
            COMMAND ${SPIRV_OPT} ${strip_names} ${spirv} -o ${folder}/kernels/${name}.embedded
            COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DSPIRV=${folder}/kernels/${name}.embedded -DHEADER=${header}
                    -P ${PROJECT_SOURCE_DIR}/cmake/embed_spirv.cmake
            DEPENDS ${spirv} ${PROJECT_SOURCE_DIR}/cmake/embed_spirv.cmake
            COMMENT "Embedding kernel ${name}"
            COMMAND_EXPAND_LISTS
            VERBATIM)
        list(APPEND headers ${header})
    endforeach()
    add_custom_target(${target}_headers DEPENDS ${headers})
    add_library(${target} INTERFACE)
    add_dependencies(${target} ${target}_headers)
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${folder}>)
    set_target_properties(${target} PROPERTIES
        UTSURI_SPIRV_FOLDER ${folder}/kernels
        UTSURI_KERNELS "${names}")
endfunction()
