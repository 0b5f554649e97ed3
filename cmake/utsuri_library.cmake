# SPDX-License-Identifier: Apache-2.0
# utsuri_configure_target(TARGET): the warnings and sanitizers that every target of the project has.
function(utsuri_configure_target target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 /permissive- /utf-8 $<$<BOOL:${UTSURI_WERROR}>:/WX>)
    else()
        # No contraction on the host: reference code must round as it is written.
        target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                               -Wold-style-cast -Wcast-qual -Woverloaded-virtual -Wdouble-promotion
                               -ffp-contract=off $<$<BOOL:${UTSURI_WERROR}>:-Werror>)
        # GCC 12 sees overflows in correct uses of std::string (its bug 105651).
        if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
            target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
        endif()
    endif()
    if(UTSURI_SANITIZE)
        target_compile_options(${target} PUBLIC -fsanitize=${UTSURI_SANITIZE} -fno-omit-frame-pointer
                               -fno-sanitize-recover=all)
        target_link_options(${target} PUBLIC -fsanitize=${UTSURI_SANITIZE})
        # GCC's own std::function, instrumented, looks uninitialized to it.
        target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
        get_target_property(type ${target} TYPE)
        if(type STREQUAL "EXECUTABLE")
            target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/keep_modules_loaded.cpp)
        endif()
    endif()
endfunction()

# utsuri_add_library(NAME SOURCES ... [PUBLIC libs ...] [PRIVATE libs ...])
# One folder under src is one static library utsuri_NAME, exported as utsuri::NAME. Headers are included as
# "folder/header.h", inside the project and from an installed package alike.
function(utsuri_add_library name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;PUBLIC;PRIVATE")
    set(target utsuri_${name})
    add_library(${target} STATIC ${arg_SOURCES})
    add_library(utsuri::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/utsuri>)
    target_link_libraries(${target} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    utsuri_configure_target(${target})
    set_property(GLOBAL APPEND PROPERTY UTSURI_LIBRARIES ${target})
endfunction()
