// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/registry.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "io/nearest_word.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::formats {
namespace {

void add_some(io::FileBatch& batch, std::span<const Format> formats, const Result& result) {
    std::vector<std::vector<std::string>> contents(formats.size());
    parallel_for(result.executor(), formats.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            // The second, another picture of the same plan, last: it would wait for the first.
            const std::size_t place = i == 0 ? 0 : formats.size() - i;
            contents[place] = formats[place].write(result);
        }
    });
    for (std::size_t i = 0; i < formats.size(); ++i) {
        for (std::size_t file = 0; file < contents[i].size(); ++file) {
            batch.add(formats[i].files[file], contents[i][file]);
        }
    }
}

}  // namespace

// One a file of this folder.
Format picture_format();
Format svg_format();
Format labels_format();
Format geojson_format();
Format graph_format();
Format report_format();
Format map_format();
Format updates_format();
Format g2o_format();

std::span<const Format> all_formats() {
    // The picture first: it takes longest, and leaves threads to the others where it cannot use
    // them itself.
    static const std::array<Format, 9> formats{picture_format(), svg_format(),     labels_format(),
                                               geojson_format(), graph_format(),   report_format(),
                                               map_format(),     updates_format(), g2o_format()};
    return formats;
}

Formats formats_of(std::initializer_list<Part> parts) {
    Formats found;
    for (const Format& format : all_formats()) {
        if (std::find(parts.begin(), parts.end(), format.part) != parts.end()) {
            found.push_back(format);
        }
    }
    return found;
}

Formats find_formats(std::string_view names) {
    Formats found;
    std::vector<std::string_view> known;
    for (const Format& format : all_formats()) known.push_back(format.name);
    while (true) {
        const std::string_view name = names.substr(0, names.find(','));
        const auto at = std::find(known.begin(), known.end(), name);
        if (at == known.end()) {
            throw InputError("'" + std::string(name) + "' is no format, expected " +
                             io::either_of(known) + io::suggestion(name, known));
        }
        const Format& format = all_formats()[static_cast<std::size_t>(at - known.begin())];
        const bool is_new = std::none_of(found.begin(), found.end(), [&](const Format& other) {
            return other.name == format.name;
        });
        if (is_new) found.push_back(format);
        if (name.size() == names.size()) return found;
        names.remove_prefix(name.size() + 1);
    }
}

std::vector<std::string> files_of(const Formats& formats) {
    std::vector<std::string> files;
    for (const Format& format : formats) {
        files.insert(files.end(), format.files.begin(), format.files.end());
    }
    return files;
}

void add_files(io::FileBatch& batch, const Formats& formats, const Result& result) {
    const auto add_part = [&](const auto& is_meant) {
        Formats part;
        std::copy_if(formats.begin(), formats.end(), std::back_inserter(part), is_meant);
        add_some(batch, part, result);
    };
    // The bytes of a map are many, and gone before pictures take memory. A report says how long
    // all else took.
    add_part([](const Format& format) { return format.part == Part::map; });
    add_part([](const Format& format) {
        return format.part != Part::map && format.part != Part::report;
    });
    add_part([](const Format& format) { return format.part == Part::report; });
}

void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const io::RunInfo& info) {
    io::FileBatch batch(folder);
    add_files(batch, formats_of({Part::rooms, Part::report}), Result(map, segmentation, info));
    batch.commit();
}

}  // namespace quadcut::formats
