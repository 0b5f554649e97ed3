# SPDX-License-Identifier: Apache-2.0
# utsuri_configure_test_target(TARGET): what all code of the tests has. They share precompiled headers, for which compilers
# want the same options.
function(utsuri_configure_test_target target)
    utsuri_configure_target(${target})
    if(NOT MSVC)
        # Tests are built more often than they run, and GCC 12's warnings about std::vector are wrong at -O3.
        target_compile_options(${target} PRIVATE -O1)
    endif()
endfunction()

# utsuri_add_test(NAME SOURCES ... LIBS ... [LABELS ...] [ENVIRONMENT ...] [TIMEOUT seconds])
# A GoogleTest program whose suites become one ctest entry each: a suite shares its device and its pipelines.
function(utsuri_add_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "SOURCES;LIBS;LABELS;ENVIRONMENT")
    add_executable(${name} ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gmock GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE
        UTSURI_SOURCE_DIR="${PROJECT_SOURCE_DIR}" UTSURI_BINARY_DIR="${CMAKE_BINARY_DIR}")
    utsuri_configure_test_target(${name})
    target_precompile_headers(${name} REUSE_FROM utsuri_test_support)
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 900)
    endif()
    foreach(source ${arg_SOURCES})
        file(STRINGS ${source} lines REGEX "^TEST(_F|_P)?\\(")
        foreach(line ${lines})
            string(REGEX REPLACE "^TEST(_F|_P)?\\(([A-Za-z0-9_]+),.*" "\\2" suite "${line}")
            list(APPEND suites ${suite})
        endforeach()
    endforeach()
    list(REMOVE_DUPLICATES suites)
    foreach(suite ${suites})
        add_test(NAME ${name}.${suite} COMMAND ${name} --gtest_filter=${suite}.*:*/${suite}.*)
        set_tests_properties(${name}.${suite} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT}
                             ENVIRONMENT "${arg_ENVIRONMENT}")
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${arg_SOURCES})
endfunction()
