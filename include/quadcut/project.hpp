// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

// A building that is followed, edited and kept in a file.
#include "project/project.hpp"
