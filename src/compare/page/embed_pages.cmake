# SPDX-License-Identifier: Apache-2.0
# Included: utsuri_embed_pages(TARGET) gives TARGET the header "compare/page/page_files.h", which holds the parts of
# the pages it writes. Run with -P: writes that header, in characters, since MSVC limits string literals to 16 KB.
# Files are named from src/compare.
set(UTSURI_PAGE_PARTS
    kPageStyle page/page.css kPageScript page/page.js
    kReportTemplate comparison/report_template.html kReportStyle comparison/report.css
    kReportViewer comparison/report_viewer.js kReportMaps comparison/report_maps.js kReportScript comparison/report.js
    kTradeTemplate trade/trade_template.html kTradeStyle trade/trade.css
    kTradeChart trade/trade_chart.js kTradeScript trade/trade.js)

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
    set(text "// Made by embed_pages.cmake.\n#pragma once\nnamespace utsuri::page_files {\n")
    while(UTSURI_PAGE_PARTS)
        list(POP_FRONT UTSURI_PAGE_PARTS name file)
        file(READ ${CMAKE_CURRENT_LIST_DIR}/../${file} bytes HEX)
        string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
        string(APPEND text "inline constexpr char ${name}[] = {\n${bytes}};\n")
    endwhile()
    file(WRITE ${HEADER} "${text}}  // namespace utsuri::page_files\n")
    return()
endif()

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH UTSURI_COMPARE_DIR)

function(utsuri_embed_pages target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/generated)
    set(header ${folder}/compare/page/page_files.h)
    set(rule ${UTSURI_COMPARE_DIR}/page/embed_pages.cmake)
    set(files ${UTSURI_PAGE_PARTS})
    list(FILTER files INCLUDE REGEX "\\.")
    list(TRANSFORM files PREPEND ${UTSURI_COMPARE_DIR}/)
    add_custom_command(
        OUTPUT ${header}
        COMMAND ${CMAKE_COMMAND} -DHEADER=${header} -P ${rule}
        DEPENDS ${rule} ${files}
        COMMENT "Embedding the pages"
        VERBATIM)
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${folder})
endfunction()
