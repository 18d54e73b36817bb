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

void run(const Arguments& arguments) {
    const io::LabelImage predicted = io::read_label_image(arguments.operands[0]);
    const io::LabelImage truth = io::read_label_image(arguments.operands[1]);
    std::optional<io::FreeMask> free_mask;
    if (arguments.operands.size() > 2) free_mask = io::read_free_mask(arguments.operands[2]);
    print_warnings(predicted.warnings);
    print_warnings(truth.warnings);
    if (free_mask) print_warnings(free_mask->warnings);
    std::cout << eval::to_json(eval::score_rooms(predicted, truth, free_mask)) << "\n";
}

}  // namespace

Command score_command() {
    CommandForm form;
    form.name = "score";
    form.text = "Compares two label images; with the map, only its free cells count as covered.";
    form.operands = {"PREDICTED.png", "TRUTH.png", "MAP.png"};
    form.num_optional = 1;
    form.examples = {"quadcut segment build/demo/simulation/map.yaml -o drawn",
                     "quadcut score drawn/rooms.png build/demo/simulation/rooms.png",
                     "quadcut score drawn/rooms.png build/demo/simulation/rooms.png "
                     "build/demo/simulation/map.pgm"};
    return {form, run};
}

}  // namespace quadcut
