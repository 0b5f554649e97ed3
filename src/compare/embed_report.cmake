# SPDX-License-Identifier: Apache-2.0
# Included: utsuri_embed_report(TARGET) gives TARGET the header "compare/report_files.h", which holds the
# parts of the report page. Run with -P: writes that header, in characters, since MSVC limits string literals
# to 16 KB.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    set(text "// Made by embed_report.cmake.\n#pragma once\nnamespace utsuri::report {\n")
    foreach(part "kTemplate;report_template.html" "kStyle;report.css" "kViewer;report_viewer.js"
            "kScript;report.js")
        list(GET part 0 name)
        list(GET part 1 file)
        file(READ ${CMAKE_CURRENT_LIST_DIR}/${file} bytes HEX)
        string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
        string(APPEND text "inline constexpr char ${name}[] = {\n${bytes}};\n")
    endforeach()
    file(WRITE ${HEADER} "${text}}  // namespace utsuri::report\n")
    return()
endif()

set(UTSURI_REPORT_DIR ${CMAKE_CURRENT_LIST_DIR})

function(utsuri_embed_report target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
    set(header ${folder}/compare/report_files.h)
    set(rule ${UTSURI_REPORT_DIR}/embed_report.cmake)
    add_custom_command(
        OUTPUT ${header}
        COMMAND ${CMAKE_COMMAND} -DHEADER=${header} -P ${rule}
        DEPENDS ${rule} ${UTSURI_REPORT_DIR}/report_template.html ${UTSURI_REPORT_DIR}/report.css
                ${UTSURI_REPORT_DIR}/report_viewer.js ${UTSURI_REPORT_DIR}/report.js
        COMMENT "Embedding the report page"
        VERBATIM)
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()
