// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/output_folder.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <unistd.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kOutputFlag = "--output";

void check_writable(const std::filesystem::path& folder) {
    const std::string name = io::display_name(folder);
    std::filesystem::path existing = std::filesystem::absolute(folder);
    std::error_code error;
    while (existing.has_relative_path() && !std::filesystem::exists(existing, error)) {
        existing = existing.parent_path();
    }
    if (!std::filesystem::is_directory(existing, error)) {
        throw InputError(name + ": cannot be the output folder: " + io::display_name(existing) +
                         " is not a folder");
    }
    if (::access(existing.c_str(), W_OK | X_OK) != 0) {
        throw InputError(name + ": cannot be the output folder: " + io::display_name(existing) +
                         ": " + std::strerror(errno));
    }
}

}  // namespace

Flag output_flag() {
    return {std::string(kOutputFlag), "-o", "DIR",
            "the folder for the results; made if it is not there", true};
}

std::filesystem::path output_folder(const Arguments& arguments) {
    std::filesystem::path folder = arguments.value(kOutputFlag).value();
    check_writable(folder);
    return folder;
}

std::filesystem::path output_folder(const Arguments& arguments,
                                    const std::filesystem::path& otherwise) {
    if (arguments.has(kOutputFlag)) return output_folder(arguments);
    check_writable(otherwise);
    return otherwise;
}

}  // namespace quadcut
