// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/descriptor.hpp"

#include <utility>

#include <unistd.h>

namespace quadcut::io {

Descriptor::~Descriptor() {
    if (value_ >= 0) ::close(value_);
}

bool Descriptor::close() { return ::close(std::exchange(value_, -1)) == 0; }

}  // namespace quadcut::io
