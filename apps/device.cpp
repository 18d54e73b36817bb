// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/device.hpp"

#include <optional>

#include "apps/message.hpp"
#include "io/option_text.hpp"

namespace quadcut {
namespace {

constexpr const char* kDeviceFlag = "--device";

}  // namespace

std::vector<OptionField> device_fields(DeviceKind& kind) {
    // The enumerators' order is the words' order.
    return {{"device", "", 0, 0,
             "what makes the graph of the preset paper and checks eigenpairs; auto: a GPU where it "
             "pays; the result does not depend on it",
             "", Choice{reinterpret_cast<std::uint8_t*>(&kind), {"cpu", "gpu", "auto"}},
             Decides::run}};
}

Flag device_flag() {
    DeviceKind kind = DeviceKind::cpu;
    return flag_of(device_fields(kind)[0], "NAME");
}

RunDevice::RunDevice(const Arguments& arguments, std::size_t num_threads)
    : notes_(std::make_unique<std::vector<std::string>>()) {
    if (const std::optional<std::string> text = arguments.value(kDeviceFlag)) {
        io::set_option(device_fields(kind_), "device", *text);
    }
    accelerator_ = make_accelerator(
        kind_, static_cast<int>(num_threads),
        [notes = notes_.get()](const std::string& reason) { notes->push_back(reason); });
}

void RunDevice::print_notes(const SegmentOptions& options) const {
    if (kind_ == DeviceKind::cpu) return;
    // Not having a GPU is as expected when nobody insists on one.
    const std::string start =
        kind_ == DeviceKind::gpu ? "warning: --device gpu: " : "--device auto: ";
    for (const std::string& note : *notes_) {
        print_error(start + note + "; the CPU does the work");
    }
    if (options.preset == Preset::rooms) {
        print_error(start + "plays no part in the preset rooms; see --preset paper");
    }
}

}  // namespace quadcut
