// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Pictures of results, truth beside result, and a page that shows them all; see docs/gallery.md.
//   gallery OUTPUT_FOLDER
#include <exception>
#include <filesystem>
#include <iostream>
#include <utility>
#include <vector>

#include "bench/gallery/shows.hpp"
#include "io/file.hpp"

namespace quadcut::gallery {
namespace {

int run(const std::filesystem::path& output) {
    std::vector<Section> sections;
    const auto add = [&](Section section) {
        std::cout << section.title << ": " << section.entries.size() << " pictures\n" << std::flush;
        sections.push_back(std::move(section));
    };
    const std::filesystem::path data = std::filesystem::path(QUADCUT_SHARED_DIR) / "data";
    if (std::filesystem::is_directory(data)) {
        add(show_true_maps(data, output));
        add(show_logs(data, output));
        add(show_other_maps(data, output));
    } else {
        std::cout << "no data beside the repository (../shared/data): only simulated buildings\n";
    }
    add(show_simulated(output));
    io::write_file_atomically(output / "index.html", index_page(std::move(sections)));
    std::cout << "Look at " << (output / "index.html").string() << "\n";
    return 0;
}

}  // namespace
}  // namespace quadcut::gallery

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: gallery OUTPUT_FOLDER\n";
        return 2;
    }
    try {
        return quadcut::gallery::run(argv[1]);
    } catch (const std::exception& error) {
        std::cerr << "gallery: " << error.what() << "\n";
        return 3;
    }
}
