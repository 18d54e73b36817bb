// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Pictures of results, truth beside result, and a page that shows them all; see docs/gallery.md.
//   gallery OUTPUT_FOLDER [real]
// With "real": only the maps as robots scan them.
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "bench/gallery/shows.hpp"
#include "bench/shared_folder.hpp"
#include "io/file.hpp"

namespace quadcut::gallery {
namespace {

enum class Extent : std::uint8_t { all, real_maps };

int run(const std::filesystem::path& output, Extent extent) {
    std::vector<Section> sections;
    const auto add = [&](Section section) {
        std::cout << section.title << ": " << section.entries.size() << " pictures\n" << std::flush;
        sections.push_back(std::move(section));
    };
    const std::filesystem::path data = shared_path("data");
    const bool has_data = std::filesystem::is_directory(data);
    if (!has_data) {
        std::cout << "no data in " << data.string() << ": "
                  << (extent == Extent::all ? "only simulated buildings\n" : "nothing to draw\n");
    }
    if (!has_data && extent == Extent::real_maps) return 0;
    if (has_data) {
        add(show_real_maps("real", "Maps as robots scan them", output));
        add(show_real_maps("growing", "One of them, growing", output));
        add(show_real_maps("campus", "A large building, drawn", output));
    }
    if (has_data && extent == Extent::all) {
        add(show_true_maps(data, output));
        add(show_logs(data, output));
        add(show_other_maps(data, output));
    }
    if (extent == Extent::all) add(show_simulated(output));
    io::write_file_atomically(output / "index.html", index_page(std::move(sections)));
    std::cout << "Look at " << (output / "index.html").string() << "\n";
    return 0;
}

}  // namespace
}  // namespace quadcut::gallery

int main(int argc, char** argv) {
    const bool only_real = argc == 3 && std::string(argv[2]) == "real";
    if (argc != 2 && !only_real) {
        std::cerr << "usage: gallery OUTPUT_FOLDER [real]\n";
        return 2;
    }
    try {
        return quadcut::gallery::run(argv[1], only_real ? quadcut::gallery::Extent::real_maps
                                                        : quadcut::gallery::Extent::all);
    } catch (const std::exception& error) {
        std::cerr << "gallery: " << error.what() << "\n";
        return 3;
    }
}
