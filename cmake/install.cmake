# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
# What `cmake --install` installs: the program, the libraries, the headers, and what
# find_package(quadcut COMPONENTS core|io|project) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/quadcut)
set(headers_dir ${CMAKE_INSTALL_INCLUDEDIR}/quadcut)
set(quadcut_components core)
set(headers_left_out PATTERN io.hpp EXCLUDE PATTERN project.hpp EXCLUDE)
if(NOT QUADCUT_ONLY_CORE)
    list(APPEND quadcut_components io project)
    set(headers_left_out "")
    install(TARGETS quadcut)
    install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindLibYaml.cmake DESTINATION ${package_dir})
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The public headers, and those of the core, which they include.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/quadcut/ DESTINATION ${headers_dir}
    FILES_MATCHING PATTERN *.hpp ${headers_left_out})
install(FILES ${PROJECT_BINARY_DIR}/include/quadcut/version.hpp DESTINATION ${headers_dir})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/quadcut/ DESTINATION ${headers_dir}
    FILES_MATCHING PATTERN *.hpp)
# Those of src/project, too. They say "project/...", and lie in quadcut/project now.
if(NOT QUADCUT_ONLY_CORE)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/project DESTINATION ${headers_dir}
        FILES_MATCHING PATTERN *.hpp)
    install(CODE "set(headers_dir ${headers_dir})")
    install(CODE [[
        set(headers_dir $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${headers_dir})
        file(GLOB headers ${headers_dir}/project/*.hpp)
        foreach(header IN LISTS headers ITEMS ${headers_dir}/project.hpp)
            file(READ ${header} text)
            string(REPLACE "#include \"project/" "#include \"quadcut/project/" text "${text}")
            file(WRITE ${header} "${text}")
        endforeach()]])
endif()

# One file of targets a component, so that who asks for one needs what that one links, no more.
foreach(component IN LISTS quadcut_components)
    set_target_properties(quadcut_${component} PROPERTIES EXPORT_NAME ${component})
    install(TARGETS quadcut_${component} EXPORT quadcut_${component}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT quadcut_${component} NAMESPACE quadcut:: DESTINATION ${package_dir}
        FILE quadcut_${component}.cmake)
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/quadcutConfig.cmake.in
    ${PROJECT_BINARY_DIR}/quadcutConfig.cmake INSTALL_DESTINATION ${package_dir}
    NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/quadcutConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/quadcutConfig.cmake
    ${PROJECT_BINARY_DIR}/quadcutConfigVersion.cmake DESTINATION ${package_dir})
