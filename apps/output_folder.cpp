// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/output_folder.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kOutputFlag = "--output";
constexpr std::string_view kForceFlag = "--force";

/// A project is read and written all the time: no result may take its place.
constexpr std::array<std::string_view, 3> kInputFlags{"--poses", "--map", "--project"};

std::vector<std::filesystem::path> inputs_of(const Arguments& arguments) {
    std::vector<std::filesystem::path> inputs(arguments.operands.begin(), arguments.operands.end());
    for (const std::string_view flag : kInputFlags) {
        if (const auto file = arguments.value(flag)) inputs.emplace_back(*file);
    }
    return inputs;
}

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

Flag force_flag() {
    return {std::string(kForceFlag), "", "",
            "writes over files of other programs in the folder, too; never over what is read"};
}

std::filesystem::path output_folder(const Arguments& arguments,
                                    const std::filesystem::path& otherwise) {
    const std::optional<std::string> given = arguments.value(kOutputFlag);
    return given ? std::filesystem::path(*given) : otherwise;
}

io::FileBatch begin_output(const Arguments& arguments, const std::vector<std::string>& files,
                           const std::filesystem::path& otherwise) {
    const std::filesystem::path folder = output_folder(arguments, otherwise);
    check_writable(folder);
    io::FileBatch batch(
        folder, {inputs_of(arguments),
                 arguments.has(kForceFlag) ? io::ForeignFiles::replace : io::ForeignFiles::refuse});
    batch.require_free(files);
    return batch;
}

}  // namespace quadcut
