// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

#include "quadcut/follow/options.hpp"

#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/device.hpp"
#include "apps/option_help.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/run_options.hpp"

namespace quadcut {
namespace {

/// How a field is set on the command line.
std::string usage_of(const OptionField& field, const CommandForm& form) {
    const Flag own = flag_of(field, "");
    for (const Flag& flag : form.flags) {
        if (flag.name == own.name) return flag.name + " " + flag.value;
    }
    return std::string(kSetFlag) + " " + std::string(field.name) + "=X";
}

std::string meaning_of(const OptionField& field) {
    return std::string(field.text) +
           (field.source.empty() ? "" : " (" + std::string(field.source) + ")");
}

std::string as_text(const std::vector<OptionField>& fields) {
    std::string page;
    for (const OptionField& field : fields) {
        page += std::string(field.name) + "  (" + facts_of(field) + ")\n    " + meaning_of(field) +
                "\n";
    }
    return page;
}

std::string as_markdown(const std::vector<OptionField>& fields, const CommandForm& form) {
    std::string page =
        "# Options\n\n"
        "Written by `quadcut options --markdown`.\n\n"
        "Most maps need none of them. The two knobs are `door_width` and `granularity`. Options\n"
        "without a flag of their own are given as `--set name=value`, which may be repeated. Those "
        "of\n"
        "scans count where a log is read (`map`, `segment`, `follow`), those of following for "
        "`follow`.\n"
        "What decides the result is kept in a project file, which goes on with the same.\n\n"
        "| option | command line | default | range | decides | meaning "
        "|\n|---|---|---|---|---|---|\n";
    for (const OptionField& field : fields) {
        page += "| `" + std::string(field.name) + "` | `" + usage_of(field, form) + "` | " +
                io::option_text(field) + " | " + range_of(field) + " | " +
                (field.decides == Decides::result ? "the result" : "the run") + " | " +
                meaning_of(field) + " |\n";
    }
    return page;
}

void run(const Arguments& arguments) {
    FollowOptions defaults;
    RunOptions run_options;
    std::vector<OptionField> fields = option_fields(defaults, run_options);
    DeviceKind kind = DeviceKind::cpu;
    for (OptionField& field : device_fields(kind)) fields.push_back(std::move(field));
    std::cout << (arguments.has("--markdown") ? as_markdown(fields, segment_command().form)
                                              : as_text(fields));
}

}  // namespace

Command options_command() {
    CommandForm form;
    form.name = "options";
    form.text = "All options of the method: defaults, units, ranges.";
    form.flags = {{"--markdown", "", "", "as a page of documentation"}};
    form.examples = {"quadcut options", "quadcut options --markdown"};
    return {form, run};
}

}  // namespace quadcut
