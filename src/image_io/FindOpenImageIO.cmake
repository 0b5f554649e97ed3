# SPDX-License-Identifier: Apache-2.0
# Finds OpenImageIO by its header and its library and defines OpenImageIO::OpenImageIO.
# The package's own configuration file is not used: on Debian 12 and Ubuntu 24.04 it stops the configuration unless
# the command line tools and the OpenCV headers are installed as well, and neither is needed here.
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY OpenImageIO)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util)

if(OpenImageIO_INCLUDE_DIR)
    file(STRINGS ${OpenImageIO_INCLUDE_DIR}/OpenImageIO/oiioversion.h lines
         REGEX "^#define OIIO_VERSION_(MAJOR|MINOR|PATCH) ")
    string(REGEX REPLACE ".*MAJOR ([0-9]+).*MINOR ([0-9]+).*PATCH ([0-9]+).*" "\\1.\\2.\\3"
           OpenImageIO_VERSION "${lines}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenImageIO
    REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY OpenImageIO_INCLUDE_DIR
    VERSION_VAR OpenImageIO_VERSION)
mark_as_advanced(OpenImageIO_INCLUDE_DIR OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY)

# Global, because a static library names it to whoever links that library, in any folder.
if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED GLOBAL)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
        IMPORTED_LOCATION ${OpenImageIO_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenImageIO_INCLUDE_DIR}
        INTERFACE_LINK_LIBRARIES ${OpenImageIO_Util_LIBRARY})
endif()
