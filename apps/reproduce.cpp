// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/reproduce.hpp"

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "apps/command.hpp"
#include "apps/output_folder.hpp"
#include "apps/progress.hpp"
#include "apps/run_flags.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut {
namespace {

constexpr std::string_view kDataFlag = "--data";
constexpr std::string_view kSmallFlag = "--small";

std::vector<OptionField> reproduce_fields(reproduce::Options& options) {
    static_assert(std::is_same_v<std::uint64_t, std::size_t>);
    return {{"threads", "", 1, 256, "threads; figures but times do not depend on it", "",
             &options.num_threads, Decides::run},
            {"seed", "", 0, 1e15, "other simulated worlds for each seed", "", &options.seed}};
}

/// The data that was asked for; checked first, so that a mistake shows at once.
std::optional<std::filesystem::path> data_of(const Arguments& arguments) {
    const std::optional<std::string> folder = arguments.value(kDataFlag);
    if (!folder) return std::nullopt;
    reproduce::check_data(*folder);
    return *folder;
}

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

void run(const Arguments& arguments) {
    const std::filesystem::path folder = output_folder(arguments);
    io::FileBatch output = begin_output(arguments, reproduce::main_files());
    reproduce::Options options;
    set_fields(arguments, reproduce_fields(options));
    options.data = data_of(arguments);
    if (arguments.has(kSmallFlag)) options.size = reproduce::Size::small;
    options.command = command_of(options);
    Progress progress(progress_style_of(arguments));
    const reproduce::Report report = reproduce::measure(
        options, [&progress](std::string_view part, std::size_t num_done, std::size_t num_parts) {
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

}  // namespace

Command reproduce_command() {
    reproduce::Options defaults;
    const std::vector<OptionField> fields = reproduce_fields(defaults);
    CommandForm form;
    form.name = "reproduce";
    form.text = "Measures the paper's experiments again: an HTML page of figures and tables.";
    form.flags = {output_flag(),
                  force_flag(),
                  {std::string(kDataFlag), "", "DIR",
                   "the folder with logs and rooms; simulated worlds if not given"},
                  {std::string(kSmallFlag), "", "", "small worlds: seconds, for a first look"},
                  flag_of(fields, "threads", "N"),
                  flag_of(fields, "seed", "S"),
                  json_flag(),
                  quiet_flag()};
    form.examples = {"quadcut reproduce -o paper --small",
                     "quadcut reproduce -o paper2 --small --seed 2"};
    return {form, run};
}

}  // namespace quadcut
