// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>

#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/reproduce.hpp"
#include "apps/run_flags.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut {
namespace {

/// What was typed, nearly: where the results go is of no interest to whoever reads them.
std::string command_of(const reproduce::Options& options) {
    std::string command = "quadcut reproduce -o DIR";
    if (options.data) command += " --data " + io::display_name(*options.data);
    command += " --threads " + std::to_string(options.num_threads) + " --seed " +
               std::to_string(options.seed);
    if (options.size == reproduce::Size::small) command += " --small";
    return command;
}

void print_story(const reproduce::Report& report, const std::string& folder) {
    for (const reproduce::Figure& figure : report.figures) {
        std::cout << "Fig " << figure.number << ": " << reproduce::verdict(figure.claims) << "\n";
    }
    for (const reproduce::Headline& line : report.headlines) {
        std::cout << line.what << ": " << reproduce::in_words(line.quadcut_ms) << " ms, the paper "
                  << reproduce::in_words(line.paper_ms) << " ms\n";
    }
    if (report.is_simulated) std::cout << "All worlds are simulated; --data DIR gives real ones.\n";
    std::cout << "Look at " << folder << "/index.html\n";
}

}  // namespace

void run_reproduce(const Arguments& arguments, const reproduce::Options& options) {
    const std::filesystem::path folder = output_folder(arguments);
    io::FileBatch output = begin_output(arguments, reproduce::main_files());
    if (options.data) reproduce::check_data(*options.data);
    reproduce::Options measured = options;
    measured.command = command_of(options);
    Progress progress(progress_style_of(arguments));
    const reproduce::Report report = reproduce::measure(
        measured, [&progress](std::string_view part, std::size_t num_done, std::size_t num_parts) {
            progress.begin(part);
            progress.update(num_done, num_parts);
        });
    {
        const Uninterrupted uninterrupted;
        reproduce::add_files(output, report);
        output.commit();
    }
    progress.wipe();
    const SummaryStyle style = summary_style_of(arguments);
    if (style == SummaryStyle::text) print_story(report, io::display_name(folder));
    if (style == SummaryStyle::json) std::cout << reproduce::to_json(report);
}

}  // namespace quadcut
