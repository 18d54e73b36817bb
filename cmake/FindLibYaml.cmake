# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
# LibYaml::LibYaml; installed too, since whoever links quadcut::io links it.
include(FindPackageHandleStandardArgs)
find_path(LibYaml_INCLUDE_DIR yaml.h)
find_library(LibYaml_LIBRARY yaml)
mark_as_advanced(LibYaml_INCLUDE_DIR LibYaml_LIBRARY)
find_package_handle_standard_args(LibYaml REQUIRED_VARS LibYaml_LIBRARY LibYaml_INCLUDE_DIR)
if(LibYaml_FOUND AND NOT TARGET LibYaml::LibYaml)
    add_library(LibYaml::LibYaml UNKNOWN IMPORTED)
    set_target_properties(LibYaml::LibYaml PROPERTIES
        IMPORTED_LOCATION "${LibYaml_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${LibYaml_INCLUDE_DIR}")
    if(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
        set_property(TARGET LibYaml::LibYaml PROPERTY IMPORTED_GLOBAL ON)
    endif()
endif()
