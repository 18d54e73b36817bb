# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
# What programs beside the product (tests, fuzz targets, benchmarks) have in common.
function(quadcut_program name)
    add_executable(${name} ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_definitions(${name} PRIVATE
        QUADCUT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        QUADCUT_SHARED_DIR="${QUADCUT_SHARED_DIR}"
        QUADCUT_PYTHON="/usr/bin/python3")
    target_link_libraries(${name} PRIVATE quadcut_apps quadcut_flags)
    # Oracles and readers of our own output use these directly.
    target_link_libraries(${name} PRIVATE Eigen3::Eigen PNG::PNG ZLIB::ZLIB TIFF::TIFF
        nlohmann_json::nlohmann_json)
endfunction()

# The same of those that run the product.
function(quadcut_runs_program name)
    target_compile_definitions(${name} PRIVATE QUADCUT_BINARY="$<TARGET_FILE:quadcut>")
    add_dependencies(${name} quadcut)
endfunction()
