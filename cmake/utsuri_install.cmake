# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where: the program, the static libraries with their headers, and the package
# that find_package(utsuri) reads. utsuri::utsuri stands for all libraries.
include(CMakePackageConfigHelpers)

get_property(utsuri_libraries GLOBAL PROPERTY UTSURI_LIBRARIES)
add_library(utsuri_everything INTERFACE)
set_target_properties(utsuri_everything PROPERTIES EXPORT_NAME utsuri)
target_link_libraries(utsuri_everything INTERFACE ${utsuri_libraries})

set(utsuri_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/utsuri)
install(TARGETS ${utsuri_libraries} utsuri_everything EXPORT utsuriTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT utsuriTargets NAMESPACE utsuri:: DESTINATION ${utsuri_package_dir})
if(TARGET utsuri)
    install(TARGETS utsuri RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# Headers keep their folders, below one of our own: "geometry/bvh.h" is too plain for the include folder.
set(utsuri_header_dir ${CMAKE_INSTALL_INCLUDEDIR}/utsuri)
foreach(library ${utsuri_libraries})
    get_target_property(folder ${library} SOURCE_DIR)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR}/src ${folder})
    install(DIRECTORY ${folder}/ DESTINATION ${utsuri_header_dir}/${name} FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders/interop DESTINATION ${utsuri_header_dir}
        FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/src/base/generated/base/version.h DESTINATION ${utsuri_header_dir}/base)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/utsuriConfig.cmake.in
    ${PROJECT_BINARY_DIR}/utsuriConfig.cmake INSTALL_DESTINATION ${utsuri_package_dir})
# Before version 1.0 a minor version may change any interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/utsuriConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/utsuriConfig.cmake ${PROJECT_BINARY_DIR}/utsuriConfigVersion.cmake
        DESTINATION ${utsuri_package_dir})
if(NOT UTSURI_CORE_ONLY)
    install(FILES ${PROJECT_SOURCE_DIR}/src/image_io/FindOpenImageIO.cmake DESTINATION ${utsuri_package_dir})
endif()

install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/third_party_notes DESTINATION ${CMAKE_INSTALL_DOCDIR})
