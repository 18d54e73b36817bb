// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/reproduce.hpp"

#include <string>
#include <vector>

#include "apps/command.hpp"
#include "apps/output_folder.hpp"
#include "apps/run_flags.hpp"

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

void run(const Arguments& arguments) {
    reproduce::Options options;
    set_fields(arguments, reproduce_fields(options));
    options.data = arguments.value(kDataFlag);
    if (arguments.has(kSmallFlag)) options.size = reproduce::Size::small;
    run_reproduce(arguments, options);
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
