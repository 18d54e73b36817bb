// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/score.hpp"

#include <iostream>
#include <optional>

#include "apps/command.hpp"
#include "apps/message.hpp"
#include "io/label_image.hpp"

namespace quadcut {
namespace {

constexpr const char* kVoidFlag = "--void";

void run(const Arguments& arguments) {
    io::LabelImage predicted = io::read_label_image(arguments.operands[0]);
    const io::LabelImage truth = io::read_label_image(arguments.operands[1]);
    const bool has_map = arguments.operands.size() > 2;
    std::optional<io::FreeMask> free_mask;
    if (has_map) free_mask = io::read_free_mask(arguments.operands[2]);
    print_warnings(predicted.warnings);
    print_warnings(truth.warnings);
    if (free_mask) print_warnings(free_mask->warnings);
    if (arguments.has(kVoidFlag)) {
        std::optional<io::FreeMask> surely_free;
        if (has_map) surely_free = io::read_free_mask(arguments.operands[2], io::kSurelyFreeGrey);
        predicted = eval::without_void(predicted, truth, surely_free);
    }
    std::cout << eval::to_json(eval::score_rooms(predicted, truth, free_mask)) << "\n";
}

}  // namespace

Command score_command() {
    CommandForm form;
    form.name = "score";
    form.text = "Compares two label images; with the map, only its free cells count as covered.";
    form.operands = {"PREDICTED.png", "TRUTH.png", "MAP.png"};
    form.num_optional = 1;
    form.flags = {{kVoidFlag, "", "",
                   "of a map as robots scan it, whose truth leaves out what nobody can name: a "
                   "predicted region with more than half of its free cells there (those above 230 "
                   "in MAP, or else all) counts nowhere"}};
    form.examples = {"quadcut segment build/demo/simulation/map.yaml -o drawn",
                     "quadcut score drawn/rooms.png build/demo/simulation/rooms.png",
                     "quadcut score drawn/rooms.png build/demo/simulation/rooms.png "
                     "build/demo/simulation/map.pgm",
                     "quadcut score --void drawn/rooms.png build/demo/simulation/rooms.png"};
    return {form, run};
}

}  // namespace quadcut
